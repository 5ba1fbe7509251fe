// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/affine/body_bridge.hpp"

#include <cmath>
#include <utility>

#include "riprap/body/drives.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/solid/affine/bonds.hpp"
#include "riprap/solid/affine/make_blocks.hpp"

namespace riprap::solid::affine {

namespace {

Sym3 to_sym(const Mat3& m) {
    return {m(0, 0), m(1, 1), m(2, 2), 0.5 * (m(0, 1) + m(1, 0)), 0.5 * (m(0, 2) + m(2, 0)), 0.5 * (m(1, 2) + m(2, 1))};
}
Mat3 to_mat(const Sym3& s) { return {{{s.xx, s.xy, s.xz}, {s.xy, s.yy, s.yz}, {s.xz, s.yz, s.zz}}}; }

/// U = sqrt(F^T F) and its inverse.
std::pair<Mat3, Mat3> stretch_of(const Mat3& f) {
    const SymmetricEigen eigen = symmetric_eigen(transpose(f) * f);
    const Vec3 root{std::sqrt(eigen.values.x), std::sqrt(eigen.values.y), std::sqrt(eigen.values.z)};
    const auto back = [&](const Vec3& values) { return eigen.axes * Mat3::diagonal(values) * transpose(eigen.axes); };
    return {back(root), back({1 / root.x, 1 / root.y, 1 / root.z})};
}

}  // namespace

void start_stretching(body::BodyState& bodies) {
    if (!bodies.deforms()) {
        bodies.stretch.assign(at(bodies.size()), {1, 1, 1, 0, 0, 0});
        bodies.stretch_rate.assign(at(bodies.size()), {});
    }
}

void read_bodies(const body::BodyState& bodies, const body::BodySet& set, BlockState& blocks) {
    blocks = {};
    for (std::int32_t b = 0; b < bodies.size(); ++b) {
        const auto i = at(b);
        const Mat3 turn = to_matrix(bodies.orientation[i]);
        const Mat3 f = bodies.deforms() ? turn * to_mat(bodies.stretch[i]) : turn;
        Mat3 gradient =
            set.principal_moments[i].x > 0 ? cross_matrix(body::angular_velocity(set, bodies, BodyId{b})) : Mat3{};
        gradient = bodies.deforms() ? gradient + to_mat(bodies.stretch_rate[i]) : gradient;
        blocks.position.push_back(bodies.position[i]);
        blocks.velocity.push_back(bodies.velocity[i]);
        const Mat3 zero{};
        blocks.deformation.insert(blocks.deformation.end(), f.row, f.row + 3);
        blocks.velocity_gradient.insert(blocks.velocity_gradient.end(), gradient.row, gradient.row + 3);
        blocks.stress.insert(blocks.stress.end(), zero.row, zero.row + 3);
    }
}

void drive_blocks(const SolidScene& scene, const TimeSpan& span, const body::BodyState& bodies, BlockSystem& system,
                  BlockState& blocks) {
    for (std::int32_t b = 0; b < system.size(); ++b) {
        const auto i = at(b);
        const BodyId id{b};
        system.is_fixed[i] = is_free(scene.bodies, id, span.time) ? 0 : 1;
        if (system.is_fixed[i] == 0) {
            continue;
        }
        blocks.velocity[i] = {};
        set_rows(blocks.velocity_gradient, i, Mat3{});
        if (scene.bodies.drive[i] == body::Drive::driven) {
            const Pose here = driven_state(scene.bodies, id, span.time).pose;
            const Pose there = driven_state(scene.bodies, id, span.end()).pose;
            const Vec3 turn = to_rotation_vector(there.orientation * conjugate(here.orientation));
            const Vec3 correction = bodies.drive_rate.empty() ? Vec3{} : bodies.drive_rate[i];
            blocks.velocity[i] = (there.position - here.position) / span.dt + correction;
            set_rows(blocks.velocity_gradient, i, cross_matrix(turn / span.dt));
        }
    }
}

void begin(const SolidScene& scene, const Elasticity& elasticity, body::BodyState& bodies, BlockState& blocks,
           BlockContactHistory& contacts, SceneBlocks& scratch) {
    if (scratch.system.size() != scene.bodies.size()) {
        scratch.problem = make_blocks(scene, elasticity, scratch.system);
    }
    renew_strengths(scene.materials, scene.strength_divisor, scratch.system.surfaces);
    start_stretching(bodies);
    if (blocks.size() != scene.bodies.size()) {
        read_bodies(bodies, scene.bodies, blocks);
        contacts.bonded = bonded_pairs(scratch.system, blocks);
    }
}

Piece begin_piece(const SolidScene& scene, const TimeSpan& span, const body::LoadView& given, double previous_dt,
                  body::BodyState& bodies, BlockState& blocks, SceneBlocks& scratch) {
    const body::LoadView loads = scratch.point_loads.add(scene.point_loads, bodies, span.middle(), given);
    scratch.pull.clear();
    for (const Sym3& p : loads.pull) {
        scratch.pull.push_back(to_mat(p));
    }
    scratch.system.gravity = scene.gravity.at(span.middle());
    drive_blocks(scene, span, bodies, scratch.system, blocks);
    body::advance_corrections(bodies, span.dt);
    return {loads, {loads.force, loads.torque, scratch.pull}, released_blocks(scene.bodies, span, previous_dt, blocks)};
}

void write_bodies(const BlockSystem& system, const BlockState& blocks, body::BodyState& bodies) {
    const auto count = at(system.size());
    bodies.stretch.resize(count);
    bodies.stretch_rate.resize(count);
    parallel::for_each_uneven(system.size(), 64, [&](std::int64_t b) {
        const auto i = at(b);
        const Mat3 f = rows_at(blocks.deformation, i), gradient = rows_at(blocks.velocity_gradient, i);
        const auto [stretch, shrink] = stretch_of(f);
        bodies.position[i] = blocks.position[i];
        bodies.velocity[i] = blocks.velocity[i];
        bodies.orientation[i] = normalized(from_matrix(f * shrink));
        bodies.stretch[i] = to_sym(stretch);
        bodies.stretch_rate[i] = to_sym(symmetric_part(gradient));
        bodies.angular_momentum[i] = affine::angular_momentum(f * system.inertia[i] * transpose(f), gradient);
    });
}

}  // namespace riprap::solid::affine
