// SPDX-License-Identifier: Apache-2.0
#include "riprap/sim/ledger_account.hpp"

#include <algorithm>
#include <limits>

namespace riprap::sim {

namespace {

/// Entries of LedgerState::totals. Vectors take three.
enum Total : std::size_t {
    is_started,
    friction,
    contact_damping,
    body_damping,
    driven_work,
    external_work,
    gravity_change,
    released,
    impulse,
    angular_impulse = impulse + 3,
    mass_moment = angular_impulse + 3,
    gravity = mass_moment + 3,
    reference_energy = gravity + 3,
    reference_momentum,
    reference_angular_momentum = reference_momentum + 3,
    kinetic_low = reference_angular_momentum + 3,
    kinetic_high,
    total_count
};

Vec3 get(const std::vector<double>& totals, std::size_t first) {
    return {totals[first], totals[first + 1], totals[first + 2]};
}
void put(std::vector<double>& totals, std::size_t first, const Vec3& value) {
    totals[first] = value.x;
    totals[first + 1] = value.y;
    totals[first + 2] = value.z;
}

/// Adds a rate's half before the kick, reads the value there, adds the half after it.
double add_across(double& total, double step) {
    const double at_kick = total + 0.5 * step;
    total += step;
    return at_kick;
}
Vec3 add_across(std::vector<double>& totals, std::size_t first, const Vec3& step) {
    const Vec3 before = get(totals, first);
    put(totals, first, before + step);
    return before + 0.5 * step;
}

}  // namespace

void reset(LedgerState& state) { state.totals.assign(total_count, 0.0); }

Ledger account(const LedgerStep& step, LedgerState& state) {
    std::vector<double>& totals = state.totals;
    const solid::KickReport& kick = step.kick;
    const bool is_first = totals[is_started] == 0;

    Ledger ledger;
    ledger.time = step.kick_time;
    ledger.kinetic = kick.kinetic;
    ledger.potential = kick.potential;
    ledger.elastic = step.elastic;
    ledger.shear = step.shear;
    ledger.mass = kick.mass;
    if (!is_first) {
        // The kinetic energy gained between kicks is (g_old + g_new)/2 . (X_new - X_old), X = sum m x; what the
        // potential changes beyond that was done by whoever turned gravity.
        const Vec3 old_moment = get(totals, mass_moment) + kick.released_mass_moment;
        totals[gravity_change] -= 0.5 * dot(step.gravity - get(totals, gravity), kick.mass_moment + old_moment);
        totals[released] += kick.released_energy;
        totals[friction] += step.friction_loss;
    }
    put(totals, mass_moment, kick.mass_moment);
    put(totals, gravity, step.gravity);
    ledger.dissipated_friction = totals[friction];
    ledger.dissipated_contact = add_across(totals[contact_damping], step.damping_loss);
    ledger.dissipated_damping = add_across(totals[body_damping], kick.damping_loss);
    ledger.work_driven = add_across(totals[driven_work], kick.work_driven);
    ledger.work_external = add_across(totals[external_work], kick.external_work);
    ledger.work_gravity_change = totals[gravity_change];
    ledger.work_released = totals[released];
    ledger.momentum = kick.momentum;
    ledger.angular_momentum = kick.angular_momentum;
    ledger.impulse = add_across(totals, impulse, kick.impulse);
    ledger.angular_impulse = add_across(totals, angular_impulse, kick.angular_impulse);
    if (!is_first) {
        put(totals, impulse, get(totals, impulse) + kick.released_momentum);
        put(totals, angular_impulse, get(totals, angular_impulse) + kick.released_angular_momentum);
        ledger.impulse += kick.released_momentum;
        ledger.angular_impulse += kick.released_angular_momentum;
    }

    const double work = ledger.work_driven + ledger.work_external + ledger.work_gravity_change + ledger.work_released;
    const double dissipated = ledger.dissipated_friction + ledger.dissipated_contact + ledger.dissipated_damping;
    const double stored = ledger.elastic + ledger.shear;
    const double closure = ledger.kinetic + ledger.potential + stored + dissipated - work;
    ledger.has_energy = step.has_elastic;
    if (is_first) {
        totals[is_started] = 1;
        totals[reference_energy] = closure;
        put(totals, reference_momentum, ledger.momentum - ledger.impulse);
        put(totals, reference_angular_momentum, ledger.angular_momentum - ledger.angular_impulse);
        totals[kinetic_low] = totals[kinetic_high] = ledger.kinetic;
    }
    totals[kinetic_low] = std::min(totals[kinetic_low], ledger.kinetic);
    totals[kinetic_high] = std::max(totals[kinetic_high], ledger.kinetic);
    ledger.residual = step.has_elastic ? closure - totals[reference_energy] : 0;
    ledger.turnover =
        std::max({totals[kinetic_high] - totals[kinetic_low], stored, std::abs(dissipated), std::abs(work)});
    ledger.momentum_residual = ledger.momentum - ledger.impulse - get(totals, reference_momentum);
    ledger.angular_momentum_residual =
        ledger.angular_momentum - ledger.angular_impulse - get(totals, reference_angular_momentum);
    return ledger;
}

}  // namespace riprap::sim
