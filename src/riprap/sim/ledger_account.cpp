// SPDX-License-Identifier: Apache-2.0
#include "riprap/sim/ledger_account.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

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
    fluid_is_started = ranges_end,
    fluid_on_solids,
    fluid_external,
    fluid_transported,
    fluid_gap,
    fluid_impulse,
    fluid_reference_energy = fluid_impulse + 3,
    fluid_reference_momentum,
    fluid_kinetic_low = fluid_reference_momentum + 3,
    fluid_kinetic_high,
    own_accounts  ///< of the solid method, then those of the fluid, then Late
};

/// Entries behind the own accounts: a ledger written before there were these begins like one with them.
enum Late : std::size_t {
    rest_highest,
    rest_rise,
    residual_of_first_steps,
    fluid_turnover,
    fluid_gravity,
    fluid_mass_moment = fluid_gravity + 3,
    has_fluid_moment = fluid_mass_moment + 3,
    late_count
};

std::size_t late(const Accounts& accounts, Late entry) {
    return own_accounts + accounts.solid.size() + accounts.fluid.size() + entry;
}

Vec3 get(const std::vector<double>& totals, std::size_t first) {
    return {totals[first], totals[first + 1], totals[first + 2]};
}
void put(std::vector<double>& totals, std::size_t first, const Vec3& value) {
    totals[first] = value.x;
    totals[first + 1] = value.y;
    totals[first + 2] = value.z;
}

/// Adds the share of a step before the kick, reads the value there, adds the rest.
double add_across(double& total, double step, double share = 0.5) {
    const double at_kick = total + share * step;
    total += step;
    return at_kick;
}
Vec3 add_across(std::vector<double>& totals, std::size_t first, const Vec3& step, double share = 0.5) {
    const Vec3 before = get(totals, first);
    put(totals, first, before + step);
    return before + share * step;
}

/// Sums over the own accounts of a method, by their side of the balance [J].
struct OwnSums {
    double stored{0}, lost{0}, given{0}, gained{0};
    double largest_given{0};  ///< largest size of a given one
    double artificial{0};     ///< sizes of the artificial ones
    double closure() const { return stored + lost + given - gained; }
};

/// Books the amounts of a step and returns the values at the kick; `share` of the step lies before the kick, and all of
/// `earlier`.
std::vector<double> book(std::span<const Account> accounts, const std::vector<double>& amounts,
                         const std::vector<double>& earlier, double* totals, bool is_first, double share) {
    std::vector<double> values(accounts.size(), 0.0);
    for (std::size_t i = 0; i < accounts.size(); ++i) {
        totals[i] += !is_first && i < earlier.size() ? earlier[i] : 0;
        const double amount = i < amounts.size() ? amounts[i] : 0;
        switch (accounts[i].booking) {
            case Booking::at_kick:
                values[i] = amount;
                break;
            case Booking::since_kick:
                values[i] = totals[i] += is_first ? 0 : amount;
                break;
            case Booking::across_kick:
                values[i] = add_across(totals[i], amount, share);
                break;
        }
    }
    return values;
}

OwnSums add_up(std::span<const Account> accounts, const std::vector<double>& values) {
    OwnSums sums;
    for (std::size_t i = 0; i < accounts.size(); ++i) {
        const double value = values[i];
        switch (accounts[i].entry) {
            case Balance::stored:
                sums.stored += value;
                break;
            case Balance::lost:
                sums.lost += value;
                break;
            case Balance::gained:
                sums.gained += value;
                break;
            case Balance::given:
                sums.given += value;
                sums.largest_given = std::max(sums.largest_given, std::abs(value));
                break;
            case Balance::aside:
                break;
        }
        sums.artificial += accounts[i].is_artificial ? std::abs(value) : 0;
    }
    return sums;
}

/// Returns the widest range of a step's energies since the start. Kept as low, high, low, high, ...
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

std::ptrdiff_t fluid_account(const Accounts& accounts, std::string_view name) {
    const auto found = std::ranges::find(accounts.fluid, name, &Account::name);
    return found == accounts.fluid.end() ? -1 : found - accounts.fluid.begin();
}

void reset(const Accounts& accounts, LedgerState& state) { state.totals.assign(late(accounts, late_count), 0.0); }

double largest_rise(const Accounts& accounts, const LedgerState& state) {
    return state.totals[late(accounts, rest_rise)];
}

void keep_first_residual(double residual, const Accounts& accounts, LedgerState& state) {
    state.totals[late(accounts, residual_of_first_steps)] = residual;
}

double first_residual(const Accounts& accounts, const LedgerState& state) {
    return state.totals[late(accounts, residual_of_first_steps)];
}

bool take_up_old_totals(const Accounts& accounts, LedgerState& state) {
    if (const std::ptrdiff_t first = fluid_account(accounts, first_young_account); first >= 0) {
        const std::size_t young = accounts.fluid.size() - static_cast<std::size_t>(first);
        for (const Late missing : {rest_highest, fluid_turnover, late_count}) {
            if (state.totals.size() + young == late(accounts, missing)) {
                const auto end_of_old = static_cast<std::ptrdiff_t>(late(accounts, rest_highest) - young);
                state.totals.insert(state.totals.begin() + end_of_old, young, 0.0);
            }
        }
    }
    for (const Late end_of_older : {rest_highest, fluid_turnover}) {
        if (state.totals.size() == late(accounts, end_of_older)) {
            state.totals.resize(late(accounts, late_count), 0.0);
        }
    }
    return state.totals.size() == late(accounts, late_count);
}

Ledger account(const solid::SolidReport& step, const Accounts& accounts, LedgerState& state) {
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
        // The kinetic energy gained between kicks is (g_old + g_new)/2 . (X_new - X_old), X = sum m x, where energies
        // hold in the middle of a piece, and g_new . (X_new - X_old) where they hold at its end; any other change
        // of the potential is work of what turns gravity.
        const Vec3 old_moment = get(totals, mass_moment) + kick.released_mass_moment;
        const Vec3 moment = (1 - step.kick_share) * kick.mass_moment + step.kick_share * old_moment;
        totals[gravity_change] -= dot(step.gravity - get(totals, gravity), moment);
        totals[released] += kick.released_energy;
        totals[friction] += step.friction_loss;
    }
    put(totals, mass_moment, kick.mass_moment);
    put(totals, gravity, step.gravity);
    ledger.friction = totals[friction];
    ledger.contact_damping = add_across(totals[contact_damping], step.damping_loss, step.kick_share);
    ledger.damping = add_across(totals[body_damping], kick.damping_loss, step.kick_share);
    ledger.driven = add_across(totals[driven_work], kick.work_driven, step.kick_share);
    ledger.external = add_across(totals[external_work], kick.external_work, step.kick_share);
    ledger.gravity_change = totals[gravity_change];
    ledger.released = totals[released];
    ledger.momentum = kick.momentum;
    ledger.angular_momentum = kick.angular_momentum;
    ledger.impulse = add_across(totals, impulse, kick.impulse, step.kick_share);
    ledger.angular_impulse = add_across(totals, angular_impulse, kick.angular_impulse, step.kick_share);
    if (!is_first) {
        put(totals, impulse, get(totals, impulse) + kick.released_momentum);
        put(totals, angular_impulse, get(totals, angular_impulse) + kick.released_angular_momentum);
        ledger.impulse += kick.released_momentum;
        ledger.angular_impulse += kick.released_angular_momentum;
    }

    ledger.own = book(accounts.solid, step.own, {}, totals.data() + own_accounts, is_first, step.kick_share);
    const OwnSums own = add_up(accounts.solid, ledger.own);
    const double work = ledger.driven + ledger.external + ledger.gravity_change + ledger.released;
    const double lost = ledger.friction + ledger.contact_damping + ledger.damping + own.lost;
    const double stored = ledger.elastic + ledger.shear + own.stored;
    const double closure = ledger.kinetic + ledger.potential + stored + lost + own.given - own.gained - work;
    ledger.has_energy = step.has_stored;
    if (is_first) {
        totals[is_started] = 1;
        totals[reference_energy] = closure;
        put(totals, reference_momentum, ledger.momentum - ledger.impulse);
        put(totals, reference_angular_momentum, ledger.angular_momentum - ledger.angular_impulse);
    }
    ledger.residual = step.has_stored ? closure - totals[reference_energy] : 0;
    // The potential and the work of turning gravity or releasing a body both depend on the place of the origin; their
    // sum does not: the energy that bodies gave to contacts, drivers, damping and loads.
    const double mechanical = ledger.kinetic + ledger.potential - ledger.gravity_change - ledger.released;
    const double range = widest_range(
        totals, std::array{ledger.kinetic, mechanical, ledger.shear, ledger.driven, ledger.external}, is_first);
    ledger.turnover = std::max({range, stored, lost});
    ledger.momentum_residual = ledger.momentum - ledger.impulse - get(totals, reference_momentum);
    ledger.angular_momentum_residual =
        ledger.angular_momentum - ledger.angular_impulse - get(totals, reference_angular_momentum);
    return ledger;
}

namespace {

/// Work of what changed gravity since the kick before, from g to g': the potential -g.X of the first moment X changes
/// by
/// -(g'.X' - g.X), of which the fluid gave its kinetic energy (g + g')/2.(X' - X).
double work_of_gravity_change(const fluid::FluidBalance& step, const Accounts& accounts, std::vector<double>& totals) {
    const std::size_t g = late(accounts, fluid_gravity), moment = late(accounts, fluid_mass_moment);
    double& is_known = totals[late(accounts, has_fluid_moment)];
    const double work =
        is_known == 0 ? 0 : -0.5 * dot(step.gravity - get(totals, g), step.mass_moment + get(totals, moment));
    put(totals, g, step.gravity);
    put(totals, moment, step.mass_moment);
    is_known = 1;
    return work;
}

}  // namespace

void account_fluid(const FluidLedgerStep& all, const Accounts& accounts, LedgerState& state, Ledger& ledger) {
    const fluid::FluidBalance& step = all.step.balance;
    std::vector<double>& totals = state.totals;
    const bool is_first = totals[fluid_is_started] == 0;
    FluidLedger& fluid = ledger.fluid;
    fluid.kinetic = step.kinetic;
    fluid.potential = step.potential;
    fluid.internal = step.internal;
    fluid.work_on_solids = add_across(totals[fluid_on_solids], step.work_on_solids);
    totals[fluid_external] += work_of_gravity_change(step, accounts, totals);
    fluid.work_external = add_across(totals[fluid_external], step.work_external);
    fluid.own = book(accounts.fluid, all.step.own, all.step.earlier,
                     totals.data() + own_accounts + accounts.solid.size(), is_first, 0.5);
    OwnSums own = add_up(accounts.fluid, fluid.own);
    fluid.artificial = own.artificial;
    fluid.transported = totals[fluid_transported];
    fluid.coupling_gap = add_across(totals[fluid_gap], all.work_given - all.work_seen);
    put(totals, fluid_impulse, get(totals, fluid_impulse) + step.impulse);
    fluid.momentum = step.momentum;
    fluid.mass = step.mass;
    double sum = fluid.kinetic + fluid.potential + fluid.internal + own.closure() + fluid.work_on_solids -
                 fluid.work_external - fluid.transported;
    if (const std::ptrdiff_t rest = rest_account(accounts); rest >= 0 && !is_first) {
        // Amounts of steps miss what the energy jumps by from the end of one to the beginning of the next, where bodies
        // go on with other velocities than were foreseen.
        const double missed = totals[fluid_reference_energy] - sum;
        fluid.own[static_cast<std::size_t>(rest)] += missed;
        own.lost += missed;
        sum += missed;
        const double dissipated = fluid.own[static_cast<std::size_t>(rest)];
        double& highest = totals[late(accounts, rest_highest)];
        double& rise = totals[late(accounts, rest_rise)];
        highest = std::max(highest, dissipated);
        rise = std::max(rise, highest - dissipated);
    }
    double &low = totals[fluid_kinetic_low], &high = totals[fluid_kinetic_high];
    if (is_first) {
        totals[fluid_is_started] = 1;
        totals[fluid_reference_energy] = sum;
        put(totals, fluid_reference_momentum, step.momentum - step.impulse);
        low = high = fluid.kinetic;
    }
    low = std::min(low, fluid.kinetic);
    high = std::max(high, fluid.kinetic);
    fluid.residual = sum - totals[fluid_reference_energy];
    fluid.momentum_residual = fluid.momentum - get(totals, fluid_impulse) - get(totals, fluid_reference_momentum);
    ledger.residual += ledger.has_energy ? fluid.residual + fluid.coupling_gap : 0;
    // Water gives and takes: what it has lost in sum, or done to solids, may come back to nothing, and was turned over.
    double& turnover = totals[late(accounts, fluid_turnover)];
    turnover = std::max({turnover, high - low, std::abs(own.lost), std::abs(fluid.work_on_solids), own.largest_given});
    ledger.turnover = std::max(ledger.turnover, turnover);
}

void account_transport(const coupling::Transported& transported, LedgerState& state) {
    std::vector<double>& totals = state.totals;
    totals[fluid_transported] += transported.energy;
    put(totals, fluid_impulse, get(totals, fluid_impulse) + transported.momentum);
}

}  // namespace riprap::sim
