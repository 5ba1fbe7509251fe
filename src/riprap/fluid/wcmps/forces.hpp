// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/wcmps/wcmps_scratch.hpp"

// Forces between particles, and between particles and walls.

namespace riprap::fluid::wcmps {

/// Sums of MpsMomentum and what of the sums at walls does not depend on how walls move.
void begin_forces(const WcmpsSettings& settings, const ParticleState& state, const BoundaryParticles& walls,
                  WcmpsScratchData& scratch);

/// Pressure of walls, the velocity mirrored in them, and loads on them.
void load_walls(const WcmpsSettings& settings, const ParticleState& state, BoundaryParticles& walls,
                const Vec3& gravity, WcmpsScratchData& scratch);

/// Adds the sums of MpsMomentumFromWalls and makes forces [N], heat [W] and grad C [1/m] of all sums.
void add_walls(const WcmpsSettings& settings, const ParticleState& state, const BoundaryParticles& walls,
               WcmpsScratchData& scratch);

}  // namespace riprap::fluid::wcmps
