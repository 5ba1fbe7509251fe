// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/sph/forces.hpp"

#include "riprap/fluid/particle/linear_law.hpp"

namespace riprap::fluid {

void find_pressure(const SphSettings& settings, const ParticleState& state, SphScratchData& scratch) {
    scratch.pressure.resize(state.density.size());
    scratch.volume.resize(state.density.size());
    const PressureLaw pressure_at(settings);
    parallel::for_each(state.size(), [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        scratch.pressure[i] = pressure_at(state.density[i]);
        scratch.volume[i] = settings.particle_mass / state.density[i];
    });
}

void find_pressure_tensors(SphScratchData& s) {
    s.pressure_tensor.resize(s.correction.size());
    parallel::for_each(static_cast<std::int64_t>(s.pressure_tensor.size()), [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        for (std::size_t k = 0; k < s.pressure_tensor[i].size(); ++k) {
            s.pressure_tensor[i][k] = s.pressure[i] * s.correction[i][k];
        }
    });
}

void make_room_for_forces(std::size_t particles, SphScratchData& s) {
    s.force.resize(particles);
    s.heat.resize(particles);
    s.wall_heat.resize(particles);
    s.wall_hold.resize(particles);
    s.wall_hold_power.resize(particles);
    s.surface_direction.resize(particles);
}

}  // namespace riprap::fluid
