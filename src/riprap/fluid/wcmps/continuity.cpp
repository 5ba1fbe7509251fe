// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "riprap/core/parallel.hpp"
#include "riprap/core/sum.hpp"
#include "riprap/fluid/particle/pair_sums.hpp"
#include "riprap/fluid/particle/sweep/zeros.hpp"
#include "riprap/fluid/wcmps/continuity_pairs.hpp"
#include "riprap/fluid/wcmps/surface_limits.hpp"
#include "riprap/fluid/wcmps/wcmps.hpp"

namespace riprap::fluid {

using wcmps::NumberContinuity;
using wcmps::NumberContinuityAtWalls;

namespace {

/// kappa: rate, over u/l_0, at which x returns to the concentration that the places of particles have [-].
constexpr double volume_return = 1;

// C of water and walls that stand still from which sound is damped, and from which wholly: two rows at surfaces and at
// bodies are not.
constexpr double damped_from = 0.92, damped_whole = 0.97;

/// x after water has torn: splashes hold no pressure, and what neighbours leave on one side holds no tension.
double after_tearing(const MpsLattice& lattice, double crowding, double neighbours, double concentration) {
    if (crowding < wcmps::splash_limit) {
        return 1;
    }
    const bool is_bare = crowding <= wcmps::surface_limit && neighbours < wcmps::neighbour_limit * lattice.neighbours;
    return is_bare ? std::max(1.0, concentration) : concentration;
}

/// s of damp_sound, from C of the water and of walls that stand still.
double damped_share(double standing) {
    return std::clamp((standing - damped_from) / (damped_whole - damped_from), 0.0, 1.0);
}

struct DensityUpdate {
    DensityLosses losses;
    double heat{0}, exchange{0};
    FlowWork flow;
    VolumeBook volume;

    template <class By>
    static void join(DensityUpdate& a, const DensityUpdate& b, const By& by) {
        by.add(a.losses, b.losses);
        by.add(a.heat, b.heat);
        by.add(a.exchange, b.exchange);
        by.add(a.flow, b.flow);
        by.add(a.volume, b.volume);
    }
};

}  // namespace

void Wcmps::share_openings(const ParticleState& state, const BoundaryParticles& walls) {
    if (settings_.wall_pressure == MpsWallPressure::mirrored) {
        walls_.openings.share.assign(walls.position.size(), 0);
        walls_.openings.slip.assign(walls.position.size(), 0);
        return;
    }
    const MpsOpeningSides sides{walls.position, walls.velocity, walls.normal,        walls_.share,
                                state.position, state.velocity, water_.concentration};
    find_wall_openings(
        weight_, sides, [&](std::size_t w) { return walls_.is_given[w] == 0; },
        [&](const auto& pair, const auto& targets, const auto& candidates, const auto& sums, bool is_among_walls) {
            add_pair_sums(settings_, pair, targets, candidates, sums,
                          is_among_walls ? lists_.walls_walls : lists_.walls_fluid);
        },
        walls_.openings);
}

WcmpsDensitySums Wcmps::sum_continuity(const ParticleState& state, const BoundaryParticles& walls,
                                       const Vec3& gravity) {
    const std::size_t count = state.density.size();
    stage_.resize(count, true, WcmpsForceSums::places);
    const WcmpsDensitySums s = lend_wcmps_density_sums(stage_);
    continuity_.rate.resize(count);
    continuity_.neighbours.resize(count);
    const EvenCount even(settings_.support_radius(), settings_.weight_law);
    const Vec3 head = settings_.diffuses_hydrostatic ? Vec3{} : settings_.rest_density * gravity;
    add_pair_sums_within(
        settings_, NumberContinuity{weight_, even, {head.x, head.y, head.z}},
        side(state.position, state.velocity, water_.pressure, water_.concentration),
        fresh(sinks(continuity_.rate, s.diffusion, s.weight, continuity_.neighbours, s.outward, s.stir, s.even)),
        lists_.fluid_fluid);
    parallel::for_each(state.blocks(), [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        s.standing.set(i, s.weight[i]);
    });
    share_openings(state, walls);
    add_pair_sums(settings_, NumberContinuityAtWalls{weight_, even},
                  side(state.position, state.velocity, water_.concentration),
                  side(walls.position, walls.velocity, walls_.share, walls_.mirrors, walls_.openings.share,
                       walls_.stands_still, walls_.openings.slip),
                  joined(sinks(continuity_.rate, s.weight, continuity_.neighbours, s.outward, s.standing),
                         fresh(sinks(s.slip)), sinks(s.even)),
                  lists_.fluid_walls);
    return s;
}

double Wcmps::finish_shift(ParticleState& state, const Vec3& gravity) const {
    const Vec3 downward = without_periodic(gravity, settings_.domain);
    if (state.shift.empty()) {
        return 0;
    }
    const double taken = parallel::sum(state.blocks(), [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        state.position[i] += state.shift[i];
        return settings_.particle_mass * dot(downward, state.shift[i]);
    });
    state.shift.clear();
    return taken;
}

void Wcmps::find_pressure(const ParticleState& state) {
    for (std::vector<double>* values : {&water_.concentration, &water_.pressure, &water_.pressure_over_concentration}) {
        values->resize(state.density.size());
    }
    parallel::for_each(state.blocks(), [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        water_.concentration[i] = state.density[i] / settings_.rest_density;
        water_.pressure[i] = pressure_of(settings_, water_.concentration[i]);
        water_.pressure_over_concentration[i] = water_.pressure[i] / water_.concentration[i];
    });
}

double Wcmps::resistance_to_sound() const {
    return settings_.acoustic_damping * settings_.smoothing_length() * settings_.rest_density * settings_.sound_speed;
}

void Wcmps::damp_sound() {
    const double resistance = resistance_to_sound();
    parallel::for_each(static_cast<std::int64_t>(water_.pressure.size()), [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        water_.pressure[i] += resistance * continuity_.damped[i];
        water_.pressure_over_concentration[i] = water_.pressure[i] / water_.concentration[i];
    });
}

void Wcmps::find_wall_shares(const BoundaryParticles& walls) {
    WcmpsWalls& seen = walls_;
    seen.share.resize(walls.position.size());
    seen.is_given.resize(walls.position.size());
    seen.mirrors.resize(walls.position.size());
    seen.stands_still.resize(walls.position.size());
    const double per_volume = 1 / std::pow(settings_.spacing, settings_.domain.dimension);
    const bool is_mirrored = settings_.wall_pressure == MpsWallPressure::mirrored;
    parallel::for_each(walls.size(), [&](std::int64_t entry) {
        const auto w = static_cast<std::size_t>(entry);
        const bool is_given = !walls.given_pressure.empty() && walls.given_pressure[w] >= 0;
        seen.share[w] = walls.volume[w] * per_volume;
        seen.is_given[w] = is_given ? 1 : 0;
        seen.mirrors[w] = is_mirrored && !is_given ? 1 : 0;
        const bool is_still = norm_squared(walls.velocity[w]) + norm_squared(walls.acceleration[w]) == 0;
        seen.stands_still[w] = is_still && !is_given ? 1 : 0;
    });
}

void Wcmps::update_density(ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity, double dt,
                           ParticleReport& report) {
    const Vec3 pull = in_plane(gravity, settings_.domain);
    lists_.place(reach_of(settings_), state.blocks(), state.position, walls.position);
    find_pressure(state);
    find_wall_shares(walls);
    const WcmpsDensitySums s = sum_continuity(state, walls, pull);
    report.shifted = finish_shift(state, pull);
    const EvenLattice even_all =
        even_lattice(settings_.weight_law, settings_.support_ratio(), settings_.domain.dimension);
    const double rate = dt * volume_return / settings_.spacing;
    // c_0^2 dt of the source with dt of the Courant number, so that what else shortens a step changes nothing
    const double diffusivity =
        settings_.density_diffusion * settings_.courant * settings_.sound_speed * settings_.spacing;
    const double spread_factor = lattice_.second_order() * diffusivity /
                                 (settings_.rest_density * settings_.sound_speed * settings_.sound_speed);
    const double resistance = resistance_to_sound(), per_density = settings_.particle_mass / settings_.rest_density;
    WcmpsContinuity& made = continuity_;
    for (std::vector<double>* values : {&made.crowding, &made.stir, &made.damped, &made.slip}) {
        values->resize(state.density.size());
    }
    made.normal.resize(state.density.size());
    const auto advance_one = [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        made.crowding[i] = s.weight[i] / lattice_.number_density;
        made.stir[i] = std::sqrt(s.stir[i] / lattice_.number_density);
        const double returned = rate * made.stir[i];
        const Vec3 outward = s.outward.vector(i);
        const double length = norm(outward);
        made.normal[i] = (length > 0 ? 1 / length : 0) * outward;
        const double before = water_.concentration[i];
        const double spread = dt * spread_factor * s.diffusion[i];
        const double flown = before - dt * lattice_.first_order() * made.rate[i] + spread;
        const double standing = s.standing[i] / lattice_.number_density;
        const double squeezed = -lattice_.first_order() * made.rate[i] / before;
        made.slip[i] = s.slip[i] * (-lattice_.first_order() / before);
        made.damped[i] = damped_share(standing) * squeezed;
        // the other half of the last kick
        const double heat = per_density * resistance * state.dilution[i] * (squeezed - made.slip[i]);
        state.dilution[i] = 0;
        const double crowding = made.crowding[i];
        const double even_crowding = s.even[i] / even_all.full + even_all.lack(length / lattice_.number_density);
        const double closer = flown + returned * (even_crowding - before);
        const double bound = crowding > wcmps::surface_limit ? closer : std::max(closer, std::min(1.0, flown));
        const double after = after_tearing(lattice_, crowding, made.neighbours[i], bound);
        state.density[i] = settings_.rest_density * after;
        // what leaves compression, m/rho_0 p/x dx, halfway between the values that forces see
        const double mean = 0.5 * (before + after);
        const double per_concentration = per_density * pressure_of(settings_, mean) / mean;
        const double conjugate = before * (squeezed - made.slip[i]);
        DensityUpdate update{
            {-per_concentration * spread, -per_concentration * (after - bound), 0,
             -per_concentration * (bound - flown)},
            heat,
            -per_concentration * dt * before * made.slip[i],
            {per_concentration * dt * conjugate, per_density * water_.pressure_over_concentration[i] * conjugate,
             per_density * pressure_of(settings_, after) / after * conjugate},
            {}};
        VolumeBook& volume = update.volume;
        const double per_gain = -per_density / (before * after);
        volume.diffusion = per_gain * spread;
        volume.tearing = per_gain * (after - bound);
        volume.returned = per_gain * (bound - flown);
        volume.flow = per_gain * (after - before) - volume.sum();
        return update;
    };
    const DensityUpdate update = parallel::sum(state.blocks(), advance_one);
    report.by_density = update.losses;
    report.earlier_heat = update.heat;
    report.earlier_exchange = update.exchange;
    report.volume = update.volume;
    flow_ = update.flow;
    flow_time_ = dt;
}

}  // namespace riprap::fluid
