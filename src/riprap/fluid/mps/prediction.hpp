// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/mps/mps_scratch.hpp"

namespace riprap::fluid::mps {

/// u* = v_n + dt (viscosity + gravity): velocities, viscous loads on walls.
void predict(const MpsSettings& settings, ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity,
             double dt, MpsScratchData& scratch);

/// Parts particles that approach below the collision distance, and turns back those that meet walls [Amaro2021, eqs. 11
/// to 13]: pairs share (1 + alpha_2)/2 of their approach, against walls particles turn by all of 1 + alpha_2. Where a
/// particle is in several pairs, each takes its part, so that energy cannot grow. Reactions are loads on walls.
void collide(const MpsSettings& settings, ParticleState& state, const BoundaryParticles& walls, double dt,
             MpsScratchData& scratch);

}  // namespace riprap::fluid::mps
