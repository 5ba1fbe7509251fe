// SPDX-License-Identifier: Apache-2.0
// Terms of the equations of one step: of contact points, and of blocks by themselves.
#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/solid/affine/bonds.hpp"
#include "riprap/solid/affine/plane.hpp"
#include "riprap/solid/implicit_dda/stages.hpp"

namespace riprap::solid::implicit_dda {

using affine::BlockSystem, affine::rows_at;

namespace {

ContactSprings springs_of(const affine::Surface& surface, double area) {
    const double factor = surface.factor(area);
    return {factor * surface.normal_stiffness, factor * surface.shear_stiffness, surface.friction,
            surface.cohesion * area,           surface.tension * area,           0};
}

/// Motion in the step of a point of a block that loads do not move.
Vec3 prescribed_motion(const BlockSystem& system, const affine::BlockState& state, std::int32_t block,
                       const Vec3& point, double dt) {
    const auto b = at(block);
    if (system.is_fixed[b] == 0) {
        return {};
    }
    return dt * (state.velocity[b] + rows_at(state.velocity_gradient, b) * (point - state.position[b]));
}

}  // namespace

ContactTerm make_term(const BlockSystem& system, const Settings& settings, const State& state, const Scratch& scratch,
                      const affine::BlockContact& found, double dt) {
    ContactTerm c{};
    c.row_a = scratch.row[at(found.a)];
    c.row_b = scratch.row[at(found.b)];
    c.arm_a = found.on_a - state.blocks.position[at(found.a)];
    c.arm_b = found.on_b - state.blocks.position[at(found.b)];
    c.normal = found.normal;
    c.springs = springs_of(system.surface_of(found.a, found.b), found.area);
    const bool has_strength = c.springs.cohesion > 0 || c.springs.tension > 0;
    c.springs.bond_length = has_strength ? affine::bond_length(system, found.a, found.b) : 0;
    c.prescribed = prescribed_motion(system, state.blocks, found.a, found.on_a, dt) -
                   prescribed_motion(system, state.blocks, found.b, found.on_b, dt);
    c.gap = found.gap - dot(found.normal, c.prescribed);
    ContactTrial& trial = c.trial;
    trial.gap = found.gap;
    trial.is_intact = found.old < 0 && begins_bonded(state.contacts, found.a, found.b);
    const bool is_tied = trial.is_intact && c.springs.normal * found.gap <= c.springs.tension;
    trial.mode = found.gap < 0 || is_tied ? ContactMode::lock : ContactMode::open;
    if (found.old >= 0) {
        const affine::BlockContactHistory& history = state.contacts;
        const auto row = at(found.old);
        const auto mode = static_cast<ContactMode>(history.mode[row]);
        trial.mode = mode != ContactMode::open || found.gap >= 0 ? mode : ContactMode::lock;
        trial.is_intact = history.is_intact[row] != 0;
        trial.plastic_slip = history.plastic_slip[row];
        trial.slip_before = affine::turn_with_plane(history.slip[row], history.normal[row], found.normal);
        trial.slip_before -= dot(trial.slip_before, found.normal) * found.normal;
        const double size = norm(trial.slip_before);
        trial.direction = size > 0 ? trial.slip_before / size : Vec3{};
        trial.friction = strength(settings.joint_law, c.springs, trial);
        trial.across = c.springs.shear;
    }
    return c;
}

void fill_blocks(const BlockSystem& system, const Settings& settings, double dt, const affine::BlockLoads& external,
                 const affine::BlockState& state, Scratch& scratch) {
    Equations& equations = scratch.equations;
    equations.is_planar = system.is_planar;
    equations.diagonal.resize(scratch.block.size());
    equations.given.resize(scratch.block.size());
    equations.solution.resize(scratch.block.size() * 12);
    parallel::for_each_uneven(static_cast<std::int64_t>(scratch.block.size()), 64, [&](std::int64_t row) {
        const std::int32_t block = scratch.block[at(row)];
        const auto b = at(block);
        const Mat3 f = rows_at(state.deformation, b);
        const double volume = system.shape_of(block).volume * determinant(f);
        const Matrix12 inertia = inertia_matrix(system.mass[b], f * system.inertia[b] * transpose(f));
        const Vector12 velocity = unknowns_of(state.velocity[b], rows_at(state.velocity_gradient, b));
        const Vector12 momentum = times(inertia, velocity);
        const Vec3 force = external.force.empty() ? Vec3{} : external.force[b];
        Vector12 given = load_vector(force + system.mass[b] * system.gravity, dipole(external, b));
        add_initial_stress(rows_at(state.stress, b), volume, given);
        Matrix12& k = equations.diagonal[at(row)];
        for (std::size_t i = 0; i < 144; ++i) {
            k[i] = 2 / (dt * dt) * inertia[i];
        }
        add_elastic(system.elasticity, volume, k);
        for (std::size_t i = 0; i < 12; ++i) {
            given[i] += settings.dynamic * 2 / dt * momentum[i];
            equations.solution[at(row) * 12 + i] = settings.dynamic * dt * velocity[i];
        }
        for (const std::size_t i : affine::out_of_plane) {
            equations.solution[at(row) * 12 + i] *= system.is_planar ? 0 : 1;
        }
        equations.given[at(row)] = given;
    });
    for (const body::FixedPoint& point : system.fixed_points) {
        const auto block = at(point.body.value);
        const std::int32_t row = scratch.row[block];
        if (row >= 0) {
            const Vec3 arm = rows_at(state.deformation, block) * point.point;
            const DisplacementMatrix t = displacement_matrix(arm);
            add_springs(t, t, point.stiffness * Mat3::identity(), 1, equations.diagonal[at(row)].data());
            add_force(t, point.stiffness * (point.place - state.position[block] - arm),
                      equations.given[at(row)].data());
        }
    }
}

}  // namespace riprap::solid::implicit_dda
