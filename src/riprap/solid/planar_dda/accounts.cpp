// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/planar_dda/accounts.hpp"

#include <algorithm>
#include <tuple>

#include "riprap/core/index.hpp"
#include "riprap/solid/planar_dda/assemble.hpp"
#include "riprap/solid/planar_dda/plane.hpp"
#include "riprap/solid/planar_dda/round_touch.hpp"

namespace riprap::solid::planar_dda {

namespace {

double half_square(double stiffness, double length) { return 0.5 * stiffness * length * length; }

double strain_energy(const Model& model, const State& state) {
    const Elasticity elasticity = elasticity_of(model.elasticity, model.plane);
    double sum = 0;
    for (std::int32_t b = 0; b < model.block_count(); ++b) {
        sum += volume_of(model, state, b) *
               energy_density(elasticity, {state.stress_x[at(b)], state.stress_y[at(b)], state.stress_xy[at(b)]});
    }
    return sum;
}

Vec2 distance_of(const body::FixedPoint& point, const State& state) {
    return flat(point.place) - place_of(state, point.body.value, flat(point.point));
}

double point_energy(const Model& model, const State& state) {
    double sum = 0;
    for (const body::FixedPoint& point : model.fixed_points) {
        sum += half_square(point.stiffness, norm(distance_of(point, state)));
    }
    return sum;
}

double bolt_energy(const Model& model, const State& state) {
    double sum = 0;
    for (const body::Bolt& bolt : model.bolts) {
        sum += half_square(bolt.stiffness, bolt_length(state, bolt).value - bolt.rest_length);
    }
    return sum;
}

/// Strain, fixed points and bolts over the step; returns what they store at its end.
double book_springs(const Model& model, const State& state, const Scratch& scratch, Accounts& accounts) {
    const Elasticity elasticity = elasticity_of(model.elasticity, model.plane);
    double stored = 0;
    for (const std::int32_t b : scratch.block_of_row) {
        const double volume = volume_of(model, state, b);
        const Stress added = stress_of(elasticity, scratch.motion[at(b)]);
        accounts.newmark_loss += volume * energy_density(elasticity, added);
        stored += volume * energy_density(elasticity, {state.stress_x[at(b)] + added.x, state.stress_y[at(b)] + added.y,
                                                       state.stress_xy[at(b)] + added.xy});
    }
    for (const body::FixedPoint& point : model.fixed_points) {
        const std::int32_t block = point.body.value;
        const Vec2 moved = displacement_at(offset_of(state, block, flat(point.point)), scratch.motion[at(block)]);
        accounts.newmark_loss += half_square(point.stiffness, norm(moved));
        stored += half_square(point.stiffness, norm(distance_of(point, state) - moved));
    }
    for (const body::Bolt& bolt : model.bolts) {
        const Linear length = bolt_length(state, bolt);
        const double after = length.after(scratch.motion[at(bolt.first.value)], scratch.motion[at(bolt.second.value)]);
        accounts.newmark_loss += half_square(bolt.stiffness, after - length.value);
        stored += half_square(bolt.stiffness, after - bolt.rest_length);
    }
    return stored;
}

/// Books one contact; returns what it stores at the end of the step.
double book_contact(const Contact& contact, const Trial& trial, const Scratch& scratch, double dt, Accounts& accounts) {
    const double p = contact.joint.normal_stiffness, ps = contact.joint.shear_stiffness;
    const bool was_closed = contact.mode != Mode::open, is_closed = trial.mode != Mode::open;
    const double opened = trial.gap - contact.gap.value, slipped = trial.slip - trial.slip_start;
    double& loss = trial.has_broken && !is_closed ? accounts.bond_loss : accounts.newmark_loss;
    double stored = 0, force = 0, shear = 0;
    if (is_closed) {
        const double spring = -p * trial.gap, dashpot = -contact.dashpot / dt * (trial.gap - trial.gap_before);
        stored = half_square(p, trial.gap);
        force = spring + dashpot + trial.multiplier;
        // A dashpot below nothing gives back what the integration takes.
        (contact.dashpot < 0 ? loss : accounts.dashpot_loss) -= dashpot * opened;
        accounts.constraint_work += trial.multiplier * opened;
        loss -= spring * opened;
    }
    loss += (was_closed ? half_square(p, contact.gap.value) : 0) - stored;
    double slip_stored = 0;
    if (trial.mode == Mode::locked) {
        shear = -ps * trial.slip;
        slip_stored = half_square(ps, trial.slip);
    } else if (trial.mode == Mode::sliding) {
        shear = -trial.friction;
        slip_stored = half_square(ps, trial.kept / ps);
    }
    const double slip_held = was_closed ? half_square(ps, contact.slip.value) : 0;
    // a bond that slides gives up what its shear spring held above friction
    const bool is_sheared = trial.has_broken && trial.mode == Mode::sliding;
    const double fracture = is_sheared ? std::max(0.0, slip_held - slip_stored) : 0;
    accounts.bond_loss += fracture;
    double& slip_loss = trial.mode == Mode::sliding ? accounts.friction_loss : loss;
    slip_loss += slip_held - slip_stored - fracture - shear * slipped;
    for (const auto& [block, gap, slip] : {std::tuple{contact.a, &contact.gap.a, &contact.slip.a},
                                           std::tuple{contact.b, &contact.gap.b, &contact.slip.b}}) {
        if (scratch.row[at(block)] < 0) {
            accounts.work_driven -=  // who drives the block pushes against the contact
                force * dot(*gap, scratch.motion[at(block)]) + shear * dot(*slip, scratch.motion[at(block)]);
        }
    }
    return stored + slip_stored;
}

}  // namespace

double kinetic_energy(const Model& model, const State& state) {
    double sum = 0;
    for (std::int32_t b = 0; b < model.block_count(); ++b) {
        if (!model.is_fixed[at(b)]) {
            const Unknowns rates = rates_of(state, b);
            sum += 0.5 * dot(rates, multiply(mass_block(model.mass[at(b)], spread_of(model, state, b)), rates));
        }
    }
    return sum;
}

double contact_energy(const Model& model, const State& state, const std::vector<Vec2>& corners) {
    double sum = 0;
    for (std::size_t k = 0; k < state.contact_corner.size(); ++k) {
        const std::int32_t corner = state.contact_corner[k], edge = state.contact_edge[k];
        if (state.contact_mode[k] == static_cast<std::uint8_t>(Mode::open)) {
            continue;
        }
        const std::int32_t a = model.corner_block[at(corner)], b = model.corner_block[at(edge)];
        const affine::Surface& joint = model.joint(a, b);
        if (is_round(model, corner)) {
            sum += half_square(joint.normal_stiffness, touch_round(model, state, corners, corner, edge).gap) +
                   half_square(joint.shear_stiffness, state.contact_lock[k]);
            continue;
        }
        const CornerAndEdge where{corners[at(corner)],
                                  corners[at(edge)],
                                  corners[at(model.corner_next[at(edge)])],
                                  {state.x[at(a)], state.y[at(a)]},
                                  {state.x[at(b)], state.y[at(b)]}};
        sum +=
            state.contact_share[k] * (half_square(joint.normal_stiffness, gap_of(where).value) +
                                      half_square(joint.shear_stiffness, slip_of(where, state.contact_lock[k]).value));
    }
    return sum;
}

double remembered_energy(const Scratch& scratch) {
    double sum = 0;
    for (const Contact& contact : scratch.contacts) {
        if (contact.mode != Mode::open) {
            sum += half_square(contact.joint.normal_stiffness, contact.gap.value) +
                   half_square(contact.joint.shear_stiffness, contact.slip.value);
        }
    }
    return sum;
}

double stored_energy(const Model& model, const State& state, const std::vector<Vec2>& corners) {
    return strain_energy(model, state) + contact_energy(model, state, corners) + point_energy(model, state) +
           bolt_energy(model, state);
}

double book_step(const Model& model, const Step& step, const State& state, const Scratch& scratch, Accounts& accounts) {
    for (const std::int32_t b : scratch.block_of_row) {
        const Unknowns& d = scratch.motion[at(b)];
        accounts.work_gravity += model.mass[at(b)] * (step.gravity.x * d[0] + step.gravity.y * d[1]);
        if (!step.loads.empty()) {
            accounts.work_loads += dot(step.loads[at(b)], d);
        }
    }
    double stored = book_springs(model, state, scratch, accounts);
    for (std::size_t k = 0; k < scratch.contacts.size(); ++k) {
        stored += book_contact(scratch.contacts[k], scratch.trials[k], scratch, step.dt, accounts);
    }
    return stored;
}

Energies energies_of(const Model& model, const State& state) {
    std::vector<Vec2> corners;
    place_corners(model, state, corners);
    return {kinetic_energy(model, state), strain_energy(model, state), contact_energy(model, state, corners),
            point_energy(model, state), bolt_energy(model, state)};
}

}  // namespace riprap::solid::planar_dda
