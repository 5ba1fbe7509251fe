// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "riprap/body/motion.hpp"
#include "riprap/coupling/particle_walls/particle_scratch.hpp"

namespace riprap::coupling {

/// Adds to the accelerations of bodies what Newton's method asks for after a force pass of the fluid. False, and
/// nothing changed, where the scheme offers no such step (fluid::SolvesForBodies), or found none.
/// @param is_sought  per body: its acceleration follows from its loads
/// @param residual   what the loads last found accelerate bodies by, less what they were taken to
bool correct(const ParticleFluid& water, const body::BodySet& bodies, const body::BodyKinematics& kinematics,
             std::span<const std::uint8_t> is_sought, std::span<const body::Acceleration> residual,
             const ParticleScratch& scratch, std::vector<body::Acceleration>& guess);

}  // namespace riprap::coupling
