// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/planar_dda/assemble.hpp"

#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/solid/planar_dda/plane.hpp"

namespace riprap::solid::planar_dda {

namespace {

Vec2 center_of(const State& state, std::int32_t block) { return {state.x[at(block)], state.y[at(block)]}; }

/// Adds k (a, b)(a, b)^T to the rows of two blocks, fixed ones left out.
void add_spring(Scratch& scratch, std::int32_t block_a, std::int32_t block_b, double stiffness, const Linear& length) {
    const std::int32_t a = scratch.row[at(block_a)], b = scratch.row[at(block_b)];
    if (a >= 0) {
        scratch.equations.add_outer(a, a, stiffness, length.a, length.a);
    }
    if (b >= 0) {
        scratch.equations.add_outer(b, b, stiffness, length.b, length.b);
    }
    if (a >= 0 && b >= 0) {
        scratch.equations.add_outer(a, b, stiffness, length.a, length.b);
    }
}

/// Adds a force along a length to both rows, and -stiffness times what the motion of a fixed block adds to the length.
void add_force(Scratch& scratch, std::int32_t block_a, std::int32_t block_b, double force, double stiffness,
               const Linear& length) {
    const std::int32_t a = scratch.row[at(block_a)], b = scratch.row[at(block_b)];
    const double given = (a < 0 ? dot(length.a, scratch.motion[at(block_a)]) : 0) +
                         (b < 0 ? dot(length.b, scratch.motion[at(block_b)]) : 0);
    const double total = force - stiffness * given;
    if (a >= 0) {
        add(scratch.right[at(a)], total, length.a);
    }
    if (b >= 0) {
        add(scratch.right[at(b)], total, length.b);
    }
}

}  // namespace

void number_rows(const Model& model, Scratch& scratch) {
    scratch.row.assign(at(model.block_count()), -1);
    scratch.block_of_row.clear();
    for (std::int32_t b = 0; b < model.block_count(); ++b) {
        if (!model.is_fixed[at(b)]) {
            scratch.row[at(b)] = static_cast<std::int32_t>(scratch.block_of_row.size());
            scratch.block_of_row.push_back(b);
        }
    }
    scratch.couplings.clear();
    const auto couple = [&scratch](std::int32_t a, std::int32_t b) {
        if (scratch.row[at(a)] >= 0 && scratch.row[at(b)] >= 0) {
            scratch.couplings.emplace_back(scratch.row[at(a)], scratch.row[at(b)]);
        }
    };
    for (const Contact& contact : scratch.contacts) {
        couple(contact.a, contact.b);
    }
    for (const body::Bolt& bolt : model.bolts) {
        couple(bolt.first.value, bolt.second.value);
    }
}

void assemble_blocks(const Model& model, const State& state, const Step& step, Scratch& scratch) {
    const auto count = static_cast<std::int64_t>(scratch.block_of_row.size());
    scratch.stiffness.resize(at(count));
    scratch.force.resize(at(count));
    const Elasticity elasticity = elasticity_of(model.elasticity, model.plane);
    parallel::for_each(count, [&](std::int64_t row) {
        const std::int32_t b = scratch.block_of_row[at(row)];
        const double volume = volume_of(model, state, b);
        Block6 K = elastic_block(elasticity, volume);
        const Block6 M = mass_block(model.mass[at(b)], spread_of(model, state, b));
        Unknowns F = stress_force({state.stress_x[at(b)], state.stress_y[at(b)], state.stress_xy[at(b)]}, volume);
        for (std::size_t k = 0; k < 36; ++k) {
            K[k] += 2 / (step.dt * step.dt) * M[k];
        }
        add(F, 2 / step.dt, multiply(M, rates_of(state, b)));
        F[0] += model.mass[at(b)] * step.gravity.x;
        F[1] += model.mass[at(b)] * step.gravity.y;
        if (!step.loads.empty()) {
            add(F, 1, step.loads[at(b)]);
        }
        scratch.stiffness[at(row)] = K;
        scratch.force[at(row)] = F;
    });
    for (const body::FixedPoint& point : model.fixed_points) {
        const std::int32_t block = point.body.value;
        if (const std::int32_t row = scratch.row[at(block)]; row >= 0) {
            const Vec2 r = offset_of(state, block, flat(point.point));
            const Block6 K = fixed_point_block(r, point.stiffness);
            for (std::size_t k = 0; k < 36; ++k) {
                scratch.stiffness[at(row)][k] += K[k];
            }
            add(scratch.force[at(row)], point.stiffness,
                force_at(r, flat(point.place) - (center_of(state, block) + r)));
        }
    }
}

Linear bolt_length(const State& state, const body::Bolt& bolt) {
    const std::int32_t first = bolt.first.value, second = bolt.second.value;
    return length_of(place_of(state, first, flat(bolt.first_point)), center_of(state, first),
                     place_of(state, second, flat(bolt.second_point)), center_of(state, second));
}

void assemble_matrix(const Model& model, const State& state, double dt, Scratch& scratch) {
    scratch.equations.set_zero();
    for (std::size_t row = 0; row < scratch.stiffness.size(); ++row) {
        scratch.equations.add_diagonal(static_cast<std::int32_t>(row), scratch.stiffness[row]);
    }
    for (const body::Bolt& bolt : model.bolts) {
        add_spring(scratch, bolt.first.value, bolt.second.value, bolt.stiffness, bolt_length(state, bolt));
    }
    for (std::size_t k = 0; k < scratch.contacts.size(); ++k) {
        const Contact& contact = scratch.contacts[k];
        const Mode mode = scratch.trials[k].mode;
        if (mode != Mode::open) {
            add_spring(scratch, contact.a, contact.b, contact.joint.normal_stiffness + contact.dashpot / dt,
                       contact.gap);
        }
        if (mode == Mode::locked) {
            add_spring(scratch, contact.a, contact.b, contact.joint.shear_stiffness, contact.slip);
        }
    }
}

void assemble_right_side(const Model& model, const State& state, double dt, Scratch& scratch) {
    scratch.right = scratch.force;
    for (const body::Bolt& bolt : model.bolts) {
        const Linear length = bolt_length(state, bolt);
        add_force(scratch, bolt.first.value, bolt.second.value, -bolt.stiffness * (length.value - bolt.rest_length),
                  bolt.stiffness, length);
    }
    for (std::size_t k = 0; k < scratch.contacts.size(); ++k) {
        const Contact& contact = scratch.contacts[k];
        const Trial& trial = scratch.trials[k];
        if (trial.mode == Mode::open) {
            continue;
        }
        const double p = contact.joint.normal_stiffness, dashpot = contact.dashpot / dt;
        const double normal =
            trial.multiplier - p * contact.gap.value - dashpot * (contact.gap.value - trial.gap_before);
        add_force(scratch, contact.a, contact.b, normal, p + dashpot, contact.gap);
        if (trial.mode == Mode::locked) {
            const double ps = contact.joint.shear_stiffness;
            add_force(scratch, contact.a, contact.b, -ps * trial.slip_start, ps, contact.slip);
        } else {
            add_force(scratch, contact.a, contact.b, -trial.friction, 0, contact.slip);
        }
    }
}

}  // namespace riprap::solid::planar_dda
