// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/implicit_dda/advance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/core/timer.hpp"
#include "riprap/solid/affine/bonds.hpp"
#include "riprap/solid/affine/step_update.hpp"
#include "riprap/solid/implicit_dda/stages.hpp"

namespace riprap::solid::implicit_dda {

using affine::BlockSystem, affine::rows_at;

namespace {

double smallest_block(const BlockSystem& system) {
    double size = std::numeric_limits<double>::infinity();
    for (std::int32_t b = 0; b < system.size(); ++b) {
        size = system.is_fixed[at(b)] == 0 ? std::min(size, system.shape_of(b).size) : size;
    }
    return std::isfinite(size) ? size : 1;
}

/// Largest approach of two corners in a step [m].
double way_of_step(const BlockSystem& system, const affine::BlockState& state, double dt) {
    const double speed = parallel::reduce(
        system.size(), 0.0,
        [&](std::int64_t i) {
            const Mat3 l = rows_at(state.velocity_gradient, at(i));
            const double turn = std::sqrt(norm_squared(l.row[0]) + norm_squared(l.row[1]) + norm_squared(l.row[2]));
            return norm(state.velocity[at(i)]) + turn * system.shapes[at(i)].circumradius;
        },
        [](double x, double y) { return std::max(x, y); });
    return 2 * (speed * dt + 0.5 * norm(system.gravity) * dt * dt);
}

void number_rows(const BlockSystem& system, Scratch& scratch) {
    scratch.row.assign(at(system.size()), -1);
    scratch.block.clear();
    for (std::int32_t b = 0; b < system.size(); ++b) {
        if (system.is_fixed[at(b)] == 0) {
            scratch.row[at(b)] = static_cast<std::int32_t>(scratch.block.size());
            scratch.block.push_back(b);
        }
    }
}

/// Largest motion of a corner, for the limit of a step.
double largest_displacement(const BlockSystem& system, const affine::BlockState& state, const Scratch& scratch) {
    return parallel::reduce(
        static_cast<std::int64_t>(scratch.block.size()), 0.0,
        [&](std::int64_t row) {
            const std::int32_t block = scratch.block[at(row)];
            const double* d = &scratch.equations.solution[at(row) * 12];
            const Mat3 g = gradient_of(d) * rows_at(state.deformation, at(block));
            double most = 0;
            for (const Vec3& x : system.shape_of(block).vertices) {
                most = std::max(most, norm_squared(Vec3{d[0], d[1], d[2]} + g * x));
            }
            return std::sqrt(most);
        },
        [](double x, double y) { return std::max(x, y); });
}

/// Moves the blocks by the solution: exact rotation, stress, velocities V = 2 D/dt - V(0).
void move_blocks(const BlockSystem& system, const Settings& settings, double dt, const Scratch& scratch,
                 affine::BlockState& state) {
    parallel::for_each_uneven(system.size(), 64, [&](std::int64_t i) {
        const auto b = at(i);
        const auto block = static_cast<std::int32_t>(i);
        if (scratch.row[b] < 0) {
            state.position[b] += dt * state.velocity[b];
            affine::update_block(system, block, dt * rows_at(state.velocity_gradient, b), state);
            return;
        }
        const double* d = &scratch.equations.solution[at(scratch.row[b]) * 12];
        const Vec3 moved{d[0], d[1], d[2]};
        const Mat3 gradient = gradient_of(d);
        state.position[b] += moved;
        state.velocity[b] = (2 / dt) * moved - settings.dynamic * state.velocity[b];
        affine::set_rows(state.velocity_gradient, b,
                         (2 / dt) * gradient - settings.dynamic * rows_at(state.velocity_gradient, b));
        update_block(system, block, gradient, state);
    });
}

}  // namespace

Outcome advance(const BlockSystem& system, const Settings& settings, double dt, const affine::BlockLoads& external,
                State& state, Scratch& scratch, StepReport& report) {
    report = {};
    Laps laps;
    const double size = smallest_block(system);
    const bool has_bonds = !state.contacts.bonded.empty() || has_intact(state.contacts);
    const double bonded = has_bonds ? std::max(affine::largest_bond_length(system), affine::tearing_gap(system)) : 0;
    const double reach =
        std::max(settings.reach * size, bonded) + std::min(way_of_step(system, state.blocks, dt), size);
    number_rows(system, scratch);
    place_blocks(system, state.blocks, scratch.placed);
    const auto& found = scratch.finder.find(system, state.blocks, scratch.placed, state.contacts, reach);
    scratch.contacts.resize(found.size());
    parallel::for_each_uneven(static_cast<std::int64_t>(found.size()), 64, [&](std::int64_t i) {
        scratch.contacts[at(i)] = make_term(system, settings, state, scratch, found[at(i)], dt);
    });
    laps.end(scratch.times.find_contacts);
    fill_blocks(system, settings, dt, external, state.blocks, scratch);
    link_rows(static_cast<std::int64_t>(scratch.block.size()), scratch.contacts, scratch.equations);
    const Outcome outcome = iterate(settings, scratch, report);
    laps.end(scratch.times.contact_loads);
    if (!outcome.ok()) {
        return outcome;
    }
    report.largest_displacement = largest_displacement(system, state.blocks, scratch);
    const double ratio = report.largest_displacement / (settings.max_displacement * size);
    if (!(ratio <= 1)) {
        return {fmt::format("a corner moves {:.3g} m in one step", report.largest_displacement),
                std::isfinite(ratio) ? std::min(0.9, 1 / ratio) : settings.cut};
    }
    book_blocks(system, external, state.blocks, scratch, report);
    if (settings.dynamic != 1) {
        report.static_loss = (1 - settings.dynamic * settings.dynamic) * measure(system, state.blocks).kinetic;
    }
    remember(scratch, state.contacts, report);
    laps.end(scratch.times.measure);
    move_blocks(system, settings, dt, scratch, state.blocks);
    laps.end(scratch.times.move_bodies);
    report.sums = measure(system, state.blocks);
    laps.end(scratch.times.measure);
    return {};
}

}  // namespace riprap::solid::implicit_dda
