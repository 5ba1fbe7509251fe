// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/sph/forces.hpp"

#include "riprap/fluid/particle/linear_law.hpp"

namespace riprap::fluid {

void find_pressure(const SphSettings& settings, const ParticleState& state, WaterFields& water) {
    water.pressure.resize(state.density.size());
    water.volume.resize(state.density.size());
    const PressureLaw pressure_at(settings);
    parallel::for_each(state.owned(), [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        water.pressure[i] = pressure_at(state.density[i]);
        water.volume[i] = settings.particle_mass / state.density[i];
    });
}

void find_pressure_tensors(WaterFields& water) {
    water.pressure_tensor.resize(water.correction.size());
    parallel::for_each(static_cast<std::int64_t>(water.pressure_tensor.size()), [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        for (std::size_t k = 0; k < water.pressure_tensor[i].size(); ++k) {
            water.pressure_tensor[i][k] = water.pressure[i] * water.correction[i][k];
        }
    });
}

void make_room_for_forces(std::size_t particles, ForceSums& forces) {
    forces.force.resize(particles);
    forces.heat.resize(particles);
    forces.wall_heat.resize(particles);
    forces.wall_hold.resize(particles);
    forces.wall_hold_power.resize(particles);
    forces.surface_direction.resize(particles);
}

}  // namespace riprap::fluid
