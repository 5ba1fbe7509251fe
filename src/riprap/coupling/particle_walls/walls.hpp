// SPDX-License-Identifier: Apache-2.0
#pragma once

// The boundary particles of a step of the water, and the bodies that carry them: for the sources of this folder only.

#include <string>

#include "riprap/coupling/fluid_scene.hpp"
#include "riprap/coupling/particle_walls/particle_scratch.hpp"

namespace riprap::coupling {

/// Finds what stays the same over a run: who never moves, and the share of a body's mass that its wall treatment feeds
/// back: twice the water that its first layer would hold, as pressure is carried over about two spacings into the wall.
WallBodies describe_bodies(const body::BodySet& bodies, const ParticleFluid& water);

/// Finds what loads of still walls are handed over in corners.
CornerLoads find_corners(const FluidScene& scene, const ParticleFluid& water, const body::BodyState& bodies);

/// Notes in the State, and in the Scratch, which samples the water may feel in a step of `dt` from bodies that move as
/// scratch.motion says. They are found anew when water may have come farther than the margin that was left the last
/// time, which follows from the State alone.
/// @param lasts  how long they are to stay; 0: as they are [s]
void find_near_samples(const FluidScene& scene, const ParticleFluid& water, const FluidState& state, double dt,
                       double lasts, ParticleScratch& scratch);

/// Takes the samples that the State notes.
void take_near_samples(const CouplingState& coupling, ParticleScratch& scratch);

/// Places boundary particles of bodies that move as scratch.motion says, and behind openings.
/// @param time   of the motion [s]
/// @param ahead  by how much it is ahead of the State [s]
void place_walls(const FluidScene& scene, const ParticleFluid& water, const fluid::OpenState& open, double time,
                 double ahead, ParticleScratch& scratch);

/// Gathers the loads that the water has put on boundary particles, per body.
void gather_wall_loads(const FluidScene& scene, const ParticleFluid& water, const ParticleScratch& scratch,
                       FluidLoads& loads);

/// Returns the power of these loads beyond that of the forces on boundary particles as they were told to move [W].
double power_at_seams(const FluidScene& scene, const ParticleFluid& water, const ParticleScratch& scratch);

/// Names a body that moves and has boundary particles among the layers of an opening; empty where there is none.
/// Bodies that stay are looked at when the case is read.
std::string find_intruder(const body::BodySet& bodies, const ParticleFluid& water, const ParticleScratch& scratch);

}  // namespace riprap::coupling
