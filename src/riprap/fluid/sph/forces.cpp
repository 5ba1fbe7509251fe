// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/sph/forces.hpp"

#include "riprap/fluid/particle/state_equation.hpp"

namespace riprap::fluid {

void find_pressure(const SphSettings& settings, const ParticleState& state, SphScratchData& scratch) {
    scratch.pressure.resize(state.density.size());
    scratch.volume.resize(state.density.size());
    parallel::for_each(state.size(), [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        scratch.pressure[i] = pressure_of(settings, state.density[i]);
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

void clear_forces(std::size_t particles, SphScratchData& s) {
    make_zero(s.force, particles);
    make_zero(s.heat, particles);
    make_zero(s.wall_heat, particles);
    make_zero(s.wall_hold, particles);
    make_zero(s.wall_hold_power, particles);
    make_zero(s.surface_direction, particles);
}

void scale_by_volume(SphScratchData& s) {
    parallel::for_each(static_cast<std::int64_t>(s.force.size()), [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        s.force[i] *= s.volume[i];
        s.heat[i] = s.volume[i] * (0.5 * s.heat[i] + s.wall_heat[i]);
        s.wall_hold[i] *= s.volume[i];
        s.wall_hold_power[i] *= s.volume[i];
    });
}

}  // namespace riprap::fluid
