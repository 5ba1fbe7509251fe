// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/sph/forces.hpp"

#include "riprap/fluid/particle/linear_law.hpp"

namespace riprap::fluid {

void find_pressure(const SphSettings& settings, const ParticleState& state, WaterFields& water) {
    water.pressure.resize(state.density.size(), settings.is_plain);
    water.volume.resize(state.density.size(), settings.is_plain);
    const PressureLaw pressure_at(settings);
    parallel::for_each(state.owned(), [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        water.pressure.set(i, pressure_at(state.density[i]));
        water.volume.set(i, settings.particle_mass / state.density[i]);
    });
}

void make_room_for_forces(const SphSettings& settings, std::size_t particles, ForceSums& forces) {
    forces.pushes.resize(particles, settings.is_plain);
    forces.wall_hold.resize(particles, settings.is_plain);
    for (Numbers<1>* numbers : {&forces.heat, &forces.wall_heat, &forces.wall_hold_power}) {
        numbers->resize(particles, settings.is_plain);
    }
}

}  // namespace riprap::fluid
