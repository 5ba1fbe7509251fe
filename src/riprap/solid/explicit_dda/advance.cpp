// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/explicit_dda/advance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/core/sum.hpp"
#include "riprap/core/timer.hpp"
#include "riprap/solid/affine/bonds.hpp"
#include "riprap/solid/explicit_dda/contact_forces.hpp"
#include "riprap/solid/explicit_dda/critical_step.hpp"
#include "riprap/solid/explicit_dda/failure.hpp"

namespace riprap::solid::explicit_dda {

using affine::BlockSystem, affine::rows_at;

namespace {

void drift_all(const BlockSystem& system, const Settings& settings, double h, affine::BlockState& state) {
    parallel::for_each_uneven(system.size(), 256, [&](std::int64_t b) {
        drift(system, settings.form, h, static_cast<std::int32_t>(b), state);
    });
}

/// The stable step of blocks and contacts as they are, by Gershgorin's theorem.
double stable_step_now(const BlockSystem& system, const affine::BlockState& state, const Scratch& scratch) {
    const auto one = [&](std::int64_t i) {
        const auto b = at(i);
        if (system.is_fixed[b] != 0) {
            return std::numeric_limits<double>::infinity();
        }
        const Mat3 f = rows_at(state.deformation, b);
        const affine::Shape& shape = system.shapes[b];
        const double strain = strain_frequency_squared(system.elasticity, shape.volume * determinant(f),
                                                       f * system.inertia[b] * transpose(f));
        return step_of(strain + scratch.squared[b], scratch.damping[b]);
    };
    return parallel::reduce(system.size(), std::numeric_limits<double>::infinity(), one,
                            [](double x, double y) { return std::min(x, y); });
}

/// Kicks every free block and adds up the energies of the mid-step pose.
struct KickSums {
    affine::BlockSums sums;
    double strain{0}, damping_loss{0}, external_work{0};

    template <class By>
    static void join(KickSums& a, const KickSums& b, const By& by) {
        by.add(a.sums, b.sums);
        by.add(a.strain, b.strain);
        by.add(a.damping_loss, b.damping_loss);
        by.add(a.external_work, b.external_work);
    }
};

KickSums kick_one(const BlockSystem& system, const Settings& settings, double dt, const affine::BlockLoads& external,
                  const BlockForce& contact_load, std::int32_t block, affine::BlockState& state) {
    const auto b = at(block);
    KickSums result;
    if (system.is_fixed[b] != 0) {
        return result;
    }
    BlockForce load = contact_load;
    const Mat3 given = affine::dipole(external, b);
    const Vec3 force = external.force.empty() ? Vec3{} : external.force[b];
    load.force += force;
    load.dipole = load.dipole + given;
    const Vec3 old_velocity = state.velocity[b];
    const Mat3 old_gradient = rows_at(state.velocity_gradient, b);
    kick(system, settings.form, load, dt, settings.mass_damping, block, state);
    const Vec3 middle = 0.5 * (old_velocity + state.velocity[b]);
    const Mat3 gradient = 0.5 * (old_gradient + rows_at(state.velocity_gradient, b));
    const Mat3 f = rows_at(state.deformation, b);
    const Mat3 inertia = f * system.inertia[b] * transpose(f);
    const auto contract = [](const Mat3& p, const Mat3& q) {
        return dot(p.row[0], q.row[0]) + dot(p.row[1], q.row[1]) + dot(p.row[2], q.row[2]);
    };
    const Mat3 after = rows_at(state.velocity_gradient, b);
    // As in the kick of rigid bodies: the energy that leapfrog keeps, and half of the work of loads in the step is
    // booked before the kick.
    const Vec3 gained = middle - old_velocity, drag = (settings.mass_damping * system.mass[b]) * state.velocity[b];
    const Mat3 gained_gradient = gradient - old_gradient;
    const double early =
        0.5 * dt *
            (dot(force - drag, gained) + contract(given - settings.mass_damping * (after * inertia), gained_gradient)) -
        0.5 * (system.mass[b] * norm_squared(gained) + contract(gained_gradient * inertia, gained_gradient));
    const double kinetic =
        0.5 * (system.mass[b] * norm_squared(middle) + contract(gradient * inertia, gradient)) + early;
    result.sums = {system.mass[b], kinetic, -system.mass[b] * dot(system.gravity, state.position[b]),
                   system.mass[b] * middle,
                   system.mass[b] * cross(state.position[b], middle) + affine::angular_momentum(inertia, gradient)};
    result.strain = strain_energy(system, settings.form, state, block);
    // The drag is c m v with the velocity after the kick: v_new (1 + c dt) = v_old + a dt.
    result.damping_loss = settings.mass_damping * dt *
                          (system.mass[b] * dot(state.velocity[b], middle) + contract(after * inertia, gradient));
    result.external_work = dt * (dot(force, middle) + contract(given, gradient));
    return result;
}

}  // namespace

Outcome advance(const BlockSystem& system, const Settings& settings, double dt, const affine::BlockLoads& external,
                State& state, Scratch& scratch, StepReport& report) {
    report = {};
    Laps laps;
    drift_all(system, settings, 0.5 * dt, state.blocks);
    place_blocks(system, state.blocks, scratch.placed);
    laps.end(scratch.times.move_bodies);
    std::swap(scratch.old, state.contacts);
    // Contacts that are apart take part where bonds hold them.
    const bool has_bonds = !scratch.old.bonded.empty() || has_intact(scratch.old);
    const double reach = has_bonds ? std::max(affine::largest_bond_length(system), affine::tearing_gap(system)) : 0;
    scratch.finder.find(system, state.blocks, scratch.placed, scratch.old, reach);
    laps.end(scratch.times.find_contacts);
    evaluate_contacts(system, settings, state.blocks, 0.5 * (state.last_dt + dt), scratch);
    sum_and_remember(system, state.blocks, dt, scratch, state.contacts, report);
    laps.end(scratch.times.contact_loads);
    book_lost_contacts(scratch, state.contacts, dt, report);
    report.stable_step = stable_step_now(system, state.blocks, scratch);
    laps.end(scratch.times.measure);
    const KickSums sums = parallel::sum(
        system.size(),
        [&](std::int64_t b) {
            return kick_one(system, settings, dt, external, scratch.loads[at(b)], static_cast<std::int32_t>(b),
                            state.blocks);
        },
        256);
    report.sums = sums.sums;
    report.strain = sums.strain;
    report.damping_loss = sums.damping_loss;
    report.external_work = sums.external_work;
    report.dashpot_loss = dashpot_work(system, scratch, state.blocks, dt);
    drift_all(system, settings, 0.5 * dt, state.blocks);
    state.last_dt = dt;
    laps.end(scratch.times.move_bodies);
    if (const auto& [block, what] = find_failure(system, settings, state.blocks); block >= 0) {
        return {fmt::format("block {} {}", block, what), 0.5};
    }
    return {};
}

}  // namespace riprap::solid::explicit_dda
