// SPDX-License-Identifier: Apache-2.0
#include "riprap/sim/ledger_account.hpp"

#include <algorithm>
#include <array>
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
    ranges = reference_angular_momentum + 3,
    ranges_end = ranges + 2 * 5,
    water_is_started = ranges_end,
    water_viscous,
    water_diffusion,
    water_shifted,
    water_on_solids,
    water_exchange,
    water_external,
    water_absorbed,
    water_flow_work,
    water_transported,
    water_gap,
    water_impulse,
    water_reference_energy = water_impulse + 3,
    water_reference_momentum,
    water_kinetic_low = water_reference_momentum + 3,
    water_kinetic_high,
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

/// How far each of a step's energies has ranged since the start, the widest of them. Kept as low, high, low, high, ...
template <std::size_t count>
double widest_range(std::vector<double>& totals, const std::array<double, count>& values, bool is_first) {
    static_assert(ranges + 2 * count == ranges_end);
    double widest = 0;
    for (std::size_t i = 0; i < count; ++i) {
        double &low = totals[ranges + 2 * i], &high = totals[ranges + 2 * i + 1];
        low = is_first ? values[i] : std::min(low, values[i]);
        high = is_first ? values[i] : std::max(high, values[i]);
        widest = std::max(widest, high - low);
    }
    return widest;
}

}  // namespace

void reset(LedgerState& state) { state.totals.assign(total_count, 0.0); }

Ledger account(const solid::SolidReport& step, LedgerState& state) {
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
    ledger.has_energy = step.has_stored;
    if (is_first) {
        totals[is_started] = 1;
        totals[reference_energy] = closure;
        put(totals, reference_momentum, ledger.momentum - ledger.impulse);
        put(totals, reference_angular_momentum, ledger.angular_momentum - ledger.angular_impulse);
    }
    ledger.residual = step.has_stored ? closure - totals[reference_energy] : 0;
    // The potential counts from the origin, and so does the work of whoever turns gravity or releases a body: only
    // together do they say what the bodies gave to contacts, drivers, damping and loads.
    const double mechanical = ledger.kinetic + ledger.potential - ledger.work_gravity_change - ledger.work_released;
    const double range = widest_range(
        totals, std::array{ledger.kinetic, mechanical, ledger.shear, ledger.work_driven, ledger.work_external},
        is_first);
    ledger.turnover = std::max({range, stored, dissipated});
    ledger.momentum_residual = ledger.momentum - ledger.impulse - get(totals, reference_momentum);
    ledger.angular_momentum_residual =
        ledger.angular_momentum - ledger.angular_impulse - get(totals, reference_angular_momentum);
    return ledger;
}

void account_water(const WaterLedgerStep& all, LedgerState& state, Ledger& ledger) {
    const fluid::FluidReport& step = all.step.fluid;
    std::vector<double>& totals = state.totals;
    const bool is_first = totals[water_is_started] == 0;
    WaterLedger& water = ledger.water;
    water.kinetic = step.kinetic;
    water.potential = step.potential;
    water.internal = step.internal;
    // Density diffuses before the kick, so its loss counts whole; what happens at the kick counts half on either side.
    water.dissipated_diffusion = totals[water_diffusion] += is_first ? 0 : step.dissipated_diffusion;
    water.dissipated_viscous = add_across(totals[water_viscous], step.dissipated_viscous);
    totals[water_shifted] += step.shifted;  // before the kick, so the potential energy at the kick knows it
    water.shifted = totals[water_shifted];
    water.work_on_solids = add_across(totals[water_on_solids], step.work_on_solids - all.step.flow_work);
    water.wall_exchange = add_across(totals[water_exchange], step.wall_exchange);
    water.work_external = add_across(totals[water_external], step.work_external + all.step.absorbed);
    water.absorbed = add_across(totals[water_absorbed], all.step.absorbed);
    water.flow_work = add_across(totals[water_flow_work], all.step.flow_work);
    water.transported = totals[water_transported];
    water.coupling_gap = add_across(totals[water_gap], all.work_given - all.work_seen);
    put(totals, water_impulse, get(totals, water_impulse) + step.impulse);
    water.momentum = step.momentum;
    water.mass = step.mass;
    const double lost = water.dissipated_viscous + water.dissipated_diffusion + water.shifted + water.wall_exchange;
    const double sum = water.kinetic + water.potential + water.internal + lost + water.work_on_solids -
                       water.work_external + water.absorbed + water.flow_work - water.transported;
    if (is_first) {
        totals[water_is_started] = 1;
        totals[water_reference_energy] = sum;
        put(totals, water_reference_momentum, step.momentum - step.impulse);
        totals[water_kinetic_low] = totals[water_kinetic_high] = water.kinetic;
    }
    totals[water_kinetic_low] = std::min(totals[water_kinetic_low], water.kinetic);
    totals[water_kinetic_high] = std::max(totals[water_kinetic_high], water.kinetic);
    water.residual = sum - totals[water_reference_energy];
    water.momentum_residual = water.momentum - get(totals, water_impulse) - get(totals, water_reference_momentum);
    ledger.residual += ledger.has_energy ? water.residual + water.coupling_gap : 0;
    ledger.turnover = std::max({ledger.turnover, totals[water_kinetic_high] - totals[water_kinetic_low], std::abs(lost),
                                std::abs(water.work_on_solids), std::abs(water.absorbed), std::abs(water.flow_work)});
}

void account_passage(const fluid::Passage& passage, LedgerState& state) {
    std::vector<double>& totals = state.totals;
    totals[water_transported] += passage.energy;
    put(totals, water_impulse, get(totals, water_impulse) + passage.momentum);
}

}  // namespace riprap::sim
