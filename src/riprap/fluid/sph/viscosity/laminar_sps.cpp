// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/sph/viscosity/laminar_sps.hpp"

#include "riprap/core/key.hpp"
#include "riprap/fluid/sph/transposed_stress.hpp"

namespace riprap::fluid {

KeyList<LaminarSps> LaminarSps::keys() {
    return {key::number(&LaminarSps::kinematic_viscosity, "kinematic_viscosity", dimension::kinematic_viscosity,
                        key::non_negative(), "Kinematic viscosity of water."),
            key::number(&LaminarSps::smagorinsky, "smagorinsky", dimension::plain, key::between(0, 1),
                        "Constant of the turbulence model of laminar_sps.")};
}

void LaminarSps::add_stress(const SphSettings& settings, const ParticleState& state, const BoundaryParticles& walls,
                            SphScratchData& scratch) const {
    find_transposed_stress(settings, state, walls, scratch);
    add_transposed_forces(settings, state, scratch);
}

void LaminarSps::add_stress_on_walls(const SphSettings& settings, const ParticleState& state, BoundaryParticles& walls,
                                     SphScratchData& scratch) const {
    add_transposed_forces_on_walls(settings, state, walls, scratch);
}

void LaminarSps::add_stress_from_walls(const SphSettings& settings, const ParticleState& state,
                                       const BoundaryParticles& walls, SphScratchData& scratch) const {
    add_transposed_forces_from_walls(settings, state, walls, scratch);
}

}  // namespace riprap::fluid
