// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/core/parallel.hpp"
#include "riprap/fluid/particle/state_equation.hpp"
#include "riprap/fluid/sph/sph_step.hpp"

namespace riprap::fluid {

FluidTimeStep choose_fluid_time_step(const SphSettings& settings, const ParticleState& state) {
    struct Fastest {
        double speed_squared{0}, density{0};
    };
    const auto one = [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        return Fastest{norm_squared(state.velocity[i]), state.density[i]};
    };
    const Fastest fastest =
        parallel::reduce(state.owned(), Fastest{0, settings.rest_density}, one, [](const Fastest& a, const Fastest& b) {
            return Fastest{std::max(a.speed_squared, b.speed_squared), std::max(a.density, b.density)};
        });
    const double h = settings.smoothing_length(), none = std::numeric_limits<double>::infinity();
    const double nu = settings.viscosity.visit([&](const auto& law) { return law.kinematic(settings, 0); });
    FluidTimeStep step{};
    step.acoustic =
        settings.courant * h / (sound_speed_of(settings, fastest.density) + std::sqrt(fastest.speed_squared));
    step.force = state.max_acceleration > 0 ? 0.25 * std::sqrt(h / state.max_acceleration) : none;
    step.viscous = nu > 0 ? 0.125 * h * h / nu : none;
    step.limit = std::min({step.acoustic, step.force, step.viscous});
    step.reason = step.limit == step.acoustic ? "sound in water"
                  : step.limit == step.force  ? "acceleration of water"
                                              : "viscosity of water";
    return step;
}

}  // namespace riprap::fluid
