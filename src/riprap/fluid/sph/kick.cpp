// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/sph/kick.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/core/parallel.hpp"
#include "riprap/fluid/particle/state_equation.hpp"

namespace riprap::fluid {
namespace {

struct Sums {
    double kinetic{0}, potential{0}, internal{0}, heat{0}, exchange{0}, external{0};
    double speed_squared{0}, acceleration_squared{0};
    Vec3 momentum{}, extra{};
};

Sums operator+(Sums a, const Sums& b) {
    a.kinetic += b.kinetic;
    a.potential += b.potential;
    a.internal += b.internal;
    a.heat += b.heat;
    a.exchange += b.exchange;
    a.external += b.external;
    a.speed_squared = std::max(a.speed_squared, b.speed_squared);
    a.acceleration_squared = std::max(a.acceleration_squared, b.acceleration_squared);
    a.momentum += b.momentum;
    a.extra += b.extra;
    return a;
}

/// The lowest id among particles that are not sound, or -1
template <class IsSound>
std::int64_t first_unsound(const ParticleState& state, const IsSound& is_sound) {
    constexpr auto none = std::numeric_limits<std::int64_t>::max();
    const std::int64_t entry_none = none;
    const auto look = [&](std::int64_t i) {
        return is_sound(static_cast<std::size_t>(i)) ? entry_none
                                                     : static_cast<std::int64_t>(state.id[static_cast<std::size_t>(i)]);
    };
    const std::int64_t first = parallel::reduce(state.owned(), entry_none, look,
                                                [](std::int64_t a, std::int64_t b) { return std::min(a, b); });
    return first == none ? -1 : first;
}

void describe(const ParticleState& state, std::int64_t id, double time, const char* what, FluidReport& report) {
    if (id < 0) {
        return;
    }
    const auto entry = static_cast<std::size_t>(std::find(state.id.begin(), state.id.end(), id) - state.id.begin());
    const Vec3 x = state.position[entry], v = state.velocity[entry];
    report.worst_particle = id;
    report.problem = fmt::format(
        "fluid particle {} {} at t = {:.6g} s: position ({:.6g}, {:.6g}, {:.6g}) m, velocity ({:.6g}, {:.6g}, {:.6g}) "
        "m/s, density {:.6g} kg/m^3",
        id, what, time, x.x, x.y, x.z, v.x, v.y, v.z, state.density[entry]);
}

}  // namespace

void kick(const ParticleSettings& settings, ParticleState& state, const Vec3& gravity, double dt,
          const Numbers<1>& volume, const ForceSums& found, const SparseVectors& extra_force, FluidReport& report) {
    const double m = settings.particle_mass;
    const Vec3 downward = without_periodic(gravity, settings.domain), along = gravity - downward;
    const auto kick_one = [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        const Vec3 extra = extra_force[i];
        const double v = volume[i];
        const Vec3 acceleration = (v * found.pushes.vector(i, ForceSums::at_force) + extra) / m + gravity;
        const Vec3 before = state.velocity[i], after = before + dt * acceleration;
        state.velocity[i] = after;
        Sums sums;
        sums.kinetic = 0.5 * m * dot(before, after);
        sums.potential = -m * dot(downward, state.position[i]);
        sums.internal = m * internal_energy_of(settings, state.density[i]);
        sums.heat = v * (0.5 * found.heat[i] + found.wall_heat[i]);
        sums.exchange = 0.5 * dot(v * found.wall_hold.vector(i), before + after) - v * found.wall_hold_power[i];
        sums.external = 0.5 * dot(extra + m * along, before + after);
        sums.speed_squared = norm_squared(after);
        sums.acceleration_squared = norm_squared(acceleration);
        sums.momentum = m * after;
        sums.extra = extra;
        return sums;
    };
    const Sums sums =
        parallel::reduce(state.owned(), Sums{}, kick_one, [](const Sums& a, const Sums& b) { return a + b; });
    report.kinetic = sums.kinetic;
    report.potential = sums.potential;
    report.internal = sums.internal;
    report.dissipated_viscous = dt * sums.heat;
    report.wall_exchange = dt * sums.exchange;
    report.work_external = dt * sums.external;
    report.momentum = sums.momentum;
    report.mass = m * static_cast<double>(state.size());
    report.impulse = dt * (report.mass * gravity + sums.extra);
    report.max_speed = std::sqrt(sums.speed_squared);
    report.max_acceleration = std::sqrt(sums.acceleration_squared);
    state.max_acceleration = report.max_acceleration;
}

void book_walls(const BoundaryParticles& walls, double dt, FluidReport& report) {
    struct Push {
        Vec3 force{};
        double power{0};
    };
    const auto one = [&](std::int64_t entry) {
        const auto w = static_cast<std::size_t>(entry);
        const Vec3 force = walls.pressure_force[w] + walls.viscous_force[w];
        return Push{force, dot(force, walls.velocity[w])};
    };
    const Push push = parallel::reduce(walls.size(), Push{}, one, [](const Push& a, const Push& b) {
        return Push{a.force + b.force, a.power + b.power};
    });
    report.impulse -= dt * push.force;
    report.work_on_solids = dt * push.power;
}

void find_lost_particle(const ParticleSettings& settings, const ParticleState& state, double time,
                        FluidReport& report) {
    describe(state,
             first_unsound(state,
                           [&](std::size_t i) {
                               return is_finite(state.position[i]) && std::isfinite(state.density[i]) &&
                                      state.density[i] > 0;
                           }),
             time, "has no finite place or no density", report);
    if (report.problem.empty()) {
        describe(state, first_unsound(state, [&](std::size_t i) { return settings.domain.admits(state.position[i]); }),
                 time, "has left the domain", report);
        if (!report.problem.empty()) {
            report.remedy =
                "a wall there holds the water, an [[fluid.outflow]] lets it go and counts it, and where "
                "walls move, fluid.domain has to hold all of their way";
        }
    }
}

void find_wild_particle(const ParticleSettings& settings, const ParticleState& state, double time,
                        FluidReport& report) {
    const double limit = settings.sound_speed * settings.sound_speed;
    describe(state, first_unsound(state, [&](std::size_t i) { return norm_squared(state.velocity[i]) <= limit; }), time,
             "is faster than the sound speed of the model", report);
}

}  // namespace riprap::fluid
