// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/planar_dda/move_blocks.hpp"

#include <cmath>

#include "riprap/core/index.hpp"
#include "riprap/solid/planar_dda/submatrices.hpp"

namespace riprap::solid::planar_dda {

namespace {

struct Symmetric {
    double xx, yy, xy;
};

/// R(angle) A R(angle)^T.
Symmetric turned(const Symmetric& a, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * c * a.xx - 2 * c * s * a.xy + s * s * a.yy, s * s * a.xx + 2 * c * s * a.xy + c * c * a.yy,
            c * s * (a.xx - a.yy) + (c * c - s * s) * a.xy};
}

/// U <- stretch of (I + strain) U, the rest of it a turn that joins the angle; strain in the axes of U.
void stretch_block(const Symmetric& strain, std::int32_t block, State& state) {
    const std::size_t b = at(block);
    const double ux = state.stretch_xx[b], uy = state.stretch_yy[b], u = state.stretch_xy[b];
    const double m11 = (1 + strain.xx) * ux + strain.xy * u, m12 = (1 + strain.xx) * u + strain.xy * uy;
    const double m21 = strain.xy * ux + (1 + strain.yy) * u, m22 = strain.xy * u + (1 + strain.yy) * uy;
    const double turn = std::atan2(m21 - m12, m11 + m22), c = std::cos(turn), s = std::sin(turn);
    state.stretch_xx[b] = c * m11 + s * m21;
    state.stretch_yy[b] = -s * m12 + c * m22;
    state.stretch_xy[b] = 0.5 * (c * m12 + s * m22 - s * m11 + c * m21);
    state.angle[b] += turn;
}

}  // namespace

void move_block(const Model& model, double dt, const Unknowns& d, std::int32_t block, State& state) {
    const std::size_t b = at(block);
    const Elasticity elasticity = elasticity_of(model.elasticity, model.plane);
    const Stress added = stress_of(elasticity, d);
    const Symmetric stress =
        turned({state.stress_x[b] + added.x, state.stress_y[b] + added.y, state.stress_xy[b] + added.xy}, d[2]);
    state.stress_x[b] = stress.xx;
    state.stress_y[b] = stress.yy;
    state.stress_xy[b] = stress.xy;
    state.x[b] += d[0];
    state.y[b] += d[1];
    if (d[3] != 0 || d[4] != 0 || d[5] != 0) {
        stretch_block(turned({d[3], d[4], 0.5 * d[5]}, -state.angle[b]), block, state);
    }
    state.angle[b] += d[2];
    double* rates = &state.rates[6 * b];
    for (std::size_t k = 0; k < 6; ++k) {
        rates[k] = 2 / dt * d[k] - rates[k];
    }
    const Symmetric strain_rate = turned({rates[3], rates[4], 0.5 * rates[5]}, d[2]);
    rates[3] = strain_rate.xx;
    rates[4] = strain_rate.yy;
    rates[5] = 2 * strain_rate.xy;
}

void drive_block(double dt, const Unknowns& d, std::int32_t block, State& state) {
    const std::size_t b = at(block);
    state.x[b] += d[0];
    state.y[b] += d[1];
    state.angle[b] += d[2];
    for (std::size_t k = 0; k < 6; ++k) {
        state.rates[6 * b + k] = k < 3 ? d[k] / dt : 0;
    }
}

void keep_contact(const Contact& contact, const Trial& trial, double lock, State& state) {
    state.contact_corner.push_back(contact.corner);
    state.contact_edge.push_back(contact.edge);
    state.contact_mode.push_back(static_cast<std::uint8_t>(trial.mode));
    state.contact_is_bonded.push_back(trial.is_bonded ? 1 : 0);
    state.contact_lock.push_back(lock);
    state.contact_share.push_back(contact.share);
    state.contact_multiplier.push_back(trial.multiplier);
    state.contact_plastic_slip.push_back(trial.is_bonded ? trial.plastic_slip : 0);
    state.contact_force.push_back(trial.normal);
}

void keep_contacts(const Scratch& scratch, State& state) {
    clear_contacts(state);
    for (std::size_t k = 0; k < scratch.contacts.size(); ++k) {
        const Contact& contact = scratch.contacts[k];
        const Trial& trial = scratch.trials[k];
        if (trial.mode == Mode::open && !trial.is_bonded) {
            continue;
        }
        double lock = contact.lock;
        if (contact.is_round) {
            lock = trial.mode == Mode::sliding ? trial.kept / contact.joint.shear_stiffness : trial.slip;
        } else if (trial.mode == Mode::sliding) {
            // s = foot - lock along the edge shall be the elastic slip of the friction
            lock += (trial.slip - trial.kept / contact.joint.shear_stiffness) / contact.edge_length;
        }
        keep_contact(contact, trial, lock, state);
    }
}

}  // namespace riprap::solid::planar_dda
