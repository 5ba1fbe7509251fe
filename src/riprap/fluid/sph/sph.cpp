// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/sph/sph.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/core/parallel.hpp"
#include "riprap/core/sum.hpp"
#include "riprap/fluid/particle/state_equation.hpp"

namespace riprap::fluid {

FluidTimeStep Sph::limit(const ParticleState& state) const {
    struct Fastest {
        double speed_squared{0}, density{0};
    };
    const auto one = [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        return Fastest{norm_squared(state.velocity[i]), state.density[i]};
    };
    const Fastest fastest = parallel::reduce(
        state.blocks(), Fastest{0, settings_.rest_density}, one, [](const Fastest& a, const Fastest& b) {
            return Fastest{std::max(a.speed_squared, b.speed_squared), std::max(a.density, b.density)};
        });
    const double h = settings_.smoothing_length(), none = std::numeric_limits<double>::infinity();
    const double nu = settings_.viscosity.visit([&](const auto& law) { return law.kinematic(settings_, 0); });
    FluidTimeStep step{};
    step.acoustic =
        settings_.courant * h / (sound_speed_of(settings_, fastest.density) + std::sqrt(fastest.speed_squared));
    step.force = state.max_acceleration > 0 ? 0.25 * std::sqrt(h / state.max_acceleration) : none;
    step.viscous = nu > 0 ? 0.125 * h * h / nu : none;
    step.limit = std::min({step.acoustic, step.force, step.viscous});
    step.reason = step.limit == step.acoustic ? "sound in water"
                  : step.limit == step.force  ? "acceleration of water"
                                              : "viscosity of water";
    return step;
}

void Sph::book_kick(std::int64_t count, const Vec3& gravity, double dt, const KickSums& sums,
                    FluidReport& report) const {
    report.kinetic = sums.kinetic;
    book_potential(gravity, sums.mass_moment, settings_.domain, report);
    report.dissipated_viscous = dt * sums.heat;
    report.wall_exchange = dt * sums.exchange;
    report.earlier_exchange = dt * sums.earlier_exchange;
    report.work_external = dt * sums.external;
    report.momentum = sums.momentum;
    report.mass = settings_.particle_mass * static_cast<double>(count);
    report.impulse = dt * (report.mass * gravity + sums.extra);
    report.max_speed = std::sqrt(sums.speed_squared);
    report.max_acceleration = std::sqrt(sums.acceleration_squared);
}

void Sph::book_compression(const ParticleState& state, FluidReport& report) const {
    const auto energy_of = [&](std::int64_t i) {
        return settings_.particle_mass * internal_energy_of(settings_, state.density[static_cast<std::size_t>(i)]);
    };
    report.internal = parallel::sum(state.blocks(), energy_of);
}

}  // namespace riprap::fluid
