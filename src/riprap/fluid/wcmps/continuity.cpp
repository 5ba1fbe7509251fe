// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/wcmps/continuity.hpp"

#include <algorithm>
#include <cmath>

#include "riprap/core/parallel.hpp"
#include "riprap/fluid/wcmps/pair_sums.hpp"

namespace riprap::fluid::wcmps {
namespace {

// C of water and walls that stand still from which sound is damped, and from which wholly: two rows at surfaces and at
// bodies are not.
constexpr double damped_from = 0.92, damped_whole = 0.97;

/// Finds g of walls: zero where they mirror each particle or have a pressure of their own.
void share_openings(const WcmpsSettings& settings, const ParticleState& state, const BoundaryParticles& walls,
                    WcmpsScratchData& s) {
    if (settings.wall_pressure == MpsWallPressure::mirrored) {
        s.walls.openings.share.assign(walls.position.size(), 0);
        s.walls.openings.slip.assign(walls.position.size(), 0);
        return;
    }
    const OpeningSides sides{walls.position, walls.velocity, walls.normal,         s.walls.share,
                             state.position, state.velocity, s.water.concentration};
    find_openings(
        settings.weight(), sides, [&](std::size_t w) { return s.walls.is_given[w] == 0; },
        [&](const auto& pair, const auto& targets, const auto& candidates, const auto& sums, bool is_among_walls) {
            add_pair_sums(settings, pair, targets, candidates, sums,
                          is_among_walls ? s.lists.walls_walls : s.lists.walls_fluid);
        },
        s.walls.openings);
}

/// The sums of NumberContinuity and NumberContinuityAtWalls.
void sum_continuity(const WcmpsSettings& settings, const ParticleState& state, const BoundaryParticles& walls,
                    const Vec3& gravity, WcmpsScratchData& s) {
    const auto count = state.density.size();
    for (std::vector<double>* sums : {&s.continuity.rate, &s.continuity.stir, &s.continuity.diffusion,
                                      &s.continuity.crowding, &s.continuity.neighbours, &s.continuity.slip}) {
        clear(*sums, count);
    }
    clear(s.continuity.normal, count);
    const Vec3 head = settings.diffuses_hydrostatic ? Vec3{} : settings.rest_density * gravity;
    const auto v = [&](int axis) { return component(state.velocity, axis); };
    const auto n = [&](int axis) { return sink_component(s.continuity.normal, axis); };
    add_pair_sums_within(settings, NumberContinuity{settings.weight(), {head.x, head.y, head.z}},
                         {state.position, {v(0), v(1), v(2), field(s.water.pressure), field(s.water.concentration)}},
                         {sink(s.continuity.rate), sink(s.continuity.diffusion), sink(s.continuity.crowding),
                          sink(s.continuity.neighbours), n(0), n(1), n(2), sink(s.continuity.stir)},
                         s.lists.fluid_fluid);
    s.continuity.damped = s.continuity.crowding;
    const auto v_w = [&](int axis) { return component(walls.velocity, axis); };
    share_openings(settings, state, walls, s);
    add_pair_sums(settings, NumberContinuityAtWalls{settings.weight()},
                  {state.position, {v(0), v(1), v(2), field(s.water.concentration)}},
                  {walls.position,
                   {v_w(0), v_w(1), v_w(2), field(s.walls.share), field(s.walls.mirrors), field(s.walls.openings.share),
                    field(s.walls.stands_still), field(s.walls.openings.slip)}},
                  {sink(s.continuity.rate), sink(s.continuity.crowding), sink(s.continuity.neighbours), n(0), n(1),
                   n(2), sink(s.continuity.damped), sink(s.continuity.slip)},
                  s.lists.fluid_walls);
}

/// x after water has torn: splashes hold no pressure, and what neighbours leave on one side holds no tension.
double after_tearing(const MpsLattice& lattice, double crowding, double neighbours, double concentration) {
    if (crowding < splash_limit) {
        return 1;
    }
    const bool is_bare = crowding <= surface_limit && neighbours < neighbour_limit * lattice.neighbours;
    return is_bare ? std::max(1.0, concentration) : concentration;
}

/// s: ratio of what C lacks to |sum W d/r|/n_0 in the second row of water under a flat surface, so that
/// C + s |sum W d/r|/n_0 is 1 there [-].
double surface_slope(const WcmpsSettings& settings) {
    const int reach = static_cast<int>(std::ceil(settings.support_ratio())),
              reach_z = settings.domain.dimension == 3 ? reach : 0;
    double lacking = 0, outward = 0;
    for (int up = 2; up <= reach; ++up) {
        for (int x = -reach; x <= reach; ++x) {
            for (int z = -reach_z; z <= reach_z; ++z) {
                const double r = std::sqrt(up * up + x * x + z * z);
                const double weight = lattice_weight(settings.weight_law, settings.support_ratio(), r);
                lacking += weight;
                outward += weight * up / r;
            }
        }
    }
    return outward > 0 ? lacking / outward : 1;
}

/// s of damp_sound, from C of the water and of walls that stand still.
double damped_share(double standing) {
    return std::clamp((standing - damped_from) / (damped_whole - damped_from), 0.0, 1.0);
}

struct Losses {
    double diffusion{0}, heat{0}, exchange{0};
};

/// The second half of the last shift, which so is made half before and half after the density that both forces beside
/// it meet: a shift made at once would take energy from one side only. Returns the energy of place that it takes [J].
double finish_shift(const WcmpsSettings& settings, ParticleState& state, const Vec3& gravity) {
    const Vec3 downward = without_periodic(gravity, settings.domain);
    const double taken = parallel::reduce(
        static_cast<std::int64_t>(state.shift.size()), 0.0,
        [&](std::int64_t entry) {
            const auto i = static_cast<std::size_t>(entry);
            state.position[i] += state.shift[i];
            return settings.particle_mass * dot(downward, state.shift[i]);
        },
        [](double a, double b) { return a + b; });
    state.shift.clear();
    return taken;
}

}  // namespace

void find_pressure(const WcmpsSettings& settings, const ParticleState& state, WcmpsWater& water) {
    for (std::vector<double>* values : {&water.concentration, &water.pressure, &water.pressure_over_concentration}) {
        values->resize(state.density.size());
    }
    parallel::for_each(state.owned(), [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        water.concentration[i] = state.density[i] / settings.rest_density;
        water.pressure[i] = pressure_of(settings, water.concentration[i]);
        water.pressure_over_concentration[i] = water.pressure[i] / water.concentration[i];
    });
}

double resistance_to_sound(const WcmpsSettings& settings) {
    return settings.acoustic_damping * settings.smoothing_length() * settings.rest_density * settings.sound_speed;
}

void damp_sound(const WcmpsSettings& settings, const WcmpsContinuity& continuity, WcmpsWater& water) {
    const double resistance = resistance_to_sound(settings);
    parallel::for_each(static_cast<std::int64_t>(water.pressure.size()), [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        water.pressure[i] += resistance * continuity.damped[i];
        water.pressure_over_concentration[i] = water.pressure[i] / water.concentration[i];
    });
}

void find_wall_shares(const WcmpsSettings& settings, const BoundaryParticles& walls, WcmpsWalls& seen) {
    seen.share.resize(walls.position.size());
    seen.is_given.resize(walls.position.size());
    seen.mirrors.resize(walls.position.size());
    seen.stands_still.resize(walls.position.size());
    const double per_volume = 1 / std::pow(settings.spacing, settings.domain.dimension);
    const bool is_mirrored = settings.wall_pressure == MpsWallPressure::mirrored;
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

void update_density(const WcmpsSettings& settings, ParticleState& state, const BoundaryParticles& walls,
                    const Vec3& gravity, double dt, WcmpsScratchData& s, FluidReport& report) {
    s.lists.place({settings.support_radius(), settings.domain}, state.position, walls.position);
    find_pressure(settings, state, s.water);
    find_wall_shares(settings, walls, s.walls);
    sum_continuity(settings, state, walls, gravity, s);
    report.shifted = finish_shift(settings, state, gravity);
    const MpsLattice lattice = settings.lattice();
    const double slope = surface_slope(settings) / lattice.number_density;
    const double rate = dt * volume_return / settings.spacing;
    // c_0^2 dt of the source with dt of the Courant number, so that what else shortens a step changes nothing
    const double diffusivity = settings.density_diffusion * settings.courant * settings.sound_speed * settings.spacing;
    const double spread_factor =
        lattice.second_order() * diffusivity / (settings.rest_density * settings.sound_speed * settings.sound_speed);
    const double resistance = resistance_to_sound(settings),
                 per_density = settings.particle_mass / settings.rest_density;
    const auto advance_one = [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        s.continuity.crowding[i] /= lattice.number_density;
        s.continuity.stir[i] = std::sqrt(s.continuity.stir[i] / lattice.number_density);
        const double returned = rate * s.continuity.stir[i];
        const double length = norm(s.continuity.normal[i]);
        s.continuity.normal[i] *= length > 0 ? 1 / length : 0;
        const double before = s.water.concentration[i];
        const double spread = dt * spread_factor * s.continuity.diffusion[i];
        const double flown = before - dt * lattice.first_order() * s.continuity.rate[i] + spread;
        const double standing = s.continuity.damped[i] / lattice.number_density;
        const double squeezed = -lattice.first_order() * s.continuity.rate[i] / before;
        s.continuity.slip[i] *= -lattice.first_order() / before;
        s.continuity.damped[i] = damped_share(standing) * squeezed;
        // the other half of the last kick
        const double heat = per_density * resistance * state.dilution[i] * (squeezed - s.continuity.slip[i]);
        state.dilution[i] = 0;
        const double crowding = s.continuity.crowding[i];
        const double closer = flown + returned * (crowding + slope * length - before);
        const double bound = crowding > surface_limit ? closer : std::max(closer, std::min(1.0, flown));
        const double after = after_tearing(lattice, crowding, s.continuity.neighbours[i], bound);
        state.density[i] = settings.rest_density * after;
        // what leaves compression, m/rho_0 p/x dx, halfway between the values that forces see
        const double mean = 0.5 * (before + after);
        const double per_concentration = per_density * pressure_of(settings, mean) / mean;
        return Losses{-per_concentration * (spread + after - flown), heat,
                      -per_concentration * dt * before * s.continuity.slip[i]};
    };
    const Losses losses = parallel::reduce(state.owned(), Losses{}, advance_one, [](const Losses& a, const Losses& b) {
        return Losses{a.diffusion + b.diffusion, a.heat + b.heat, a.exchange + b.exchange};
    });
    report.dissipated_diffusion = losses.diffusion;
    report.earlier_heat = losses.heat;
    report.earlier_exchange = losses.exchange;
}

}  // namespace riprap::fluid::wcmps
