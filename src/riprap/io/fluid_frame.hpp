// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/particle/particle_state.hpp"
#include "riprap/fluid/sph/sph_settings.hpp"
#include "riprap/io/vtp.hpp"

namespace riprap::io {

/// Particles of a fluid as points. Point arrays: id, velocity [m/s], speed [m/s], density [kg/m^3] (half a step behind
/// the places), pressure [Pa] at that density. Field array: spacing [m] of the particles at the start.
PolyData draw_fluid(const fluid::SphSettings& settings, const fluid::ParticleState& particles);

}  // namespace riprap::io
