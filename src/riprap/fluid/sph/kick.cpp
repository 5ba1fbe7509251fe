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

void book_kick(const ParticleSettings& settings, std::int64_t count, const Vec3& gravity, double dt,
               const KickSums& sums, FluidReport& report) {
    report.kinetic = sums.kinetic;
    report.potential = sums.potential;
    report.dissipated_viscous = dt * sums.heat;
    report.wall_exchange = dt * sums.exchange;
    report.earlier_exchange = dt * sums.earlier_exchange;
    report.work_external = dt * sums.external;
    report.momentum = sums.momentum;
    report.mass = settings.particle_mass * static_cast<double>(count);
    report.impulse = dt * (report.mass * gravity + sums.extra);
    report.max_speed = std::sqrt(sums.speed_squared);
    report.max_acceleration = std::sqrt(sums.acceleration_squared);
}

void book_compression(const ParticleSettings& settings, const ParticleState& state, FluidReport& report) {
    const auto energy_of = [&](std::int64_t i) {
        return settings.particle_mass * internal_energy_of(settings, state.density[static_cast<std::size_t>(i)]);
    };
    report.internal = parallel::reduce(state.owned(), 0.0, energy_of, [](double a, double b) { return a + b; });
}

namespace {
/// Extra forces of the host.
struct SparseExtra {
    const SparseVectors* force;
    Vec3 operator[](std::size_t i) const { return (*force)[i]; }
};
}  // namespace

void kick(const ParticleSettings& settings, ParticleState& state, const Vec3& gravity, double dt,
          SphNumbers<parallel::Host>& found, const SparseVectors& extra_force, FluidReport& report) {
    kick_particles(settings, columns_of(state), gravity, dt, found, SparseExtra{&extra_force}, report);
    book_compression(settings, state, report);
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
