// SPDX-License-Identifier: Apache-2.0
#pragma once

// Water in joints between solids as part of a step: for the sources of this folder only.

#include <cstdint>
#include <span>
#include <vector>

#include "riprap/body/loads.hpp"
#include "riprap/coupling/fluid_scene.hpp"
#include "riprap/coupling/joints/joint_pressure.hpp"
#include "riprap/coupling/particle_walls/particle_fluid.hpp"

namespace riprap::coupling {

struct ParticleScratch;

/// Buffers of the water in joints: Scratch.
struct JointScratch {
    JointPressure pressure;
    fluid::WaterAtWalls water;
    std::vector<Vec3> slopes;        ///< of solid_slopes, of all samples [1/m]
    std::vector<Vec3> sample_force;  ///< on each sample near; empty where no joint is wet [N]
    body::Loads loads;               ///< on each body
    std::vector<double> radius;      ///< of the samples of each body about its centre of mass [m]
    std::size_t bytes() const;
};

/// Tells whether water in joints is asked for and some body may feel it.
bool has_joints(const ParticleFluid& water, std::span<const std::uint8_t> is_loose);

/// Returns the distance from a loose body within which samples may have to do with its joints [m]; 0 where there are
/// none.
double reach_of_joints(const ParticleFluid& water, const body::BodySet& bodies, std::span<const std::uint8_t> is_loose);

/// Adds the loads of water in joints to scratch.held_loads: bodies where scratch.motion says, after begin_forces.
void add_joint_loads(const ParticleFluid& water, ParticleScratch& scratch, const Vec3& gravity);

/// Returns the power of the joint loads on all bodies [W].
double joint_power(const ParticleScratch& scratch);

/// Appends places on the faces of loose bodies: solids near these may make a joint, however far the water is.
void add_places_of_joints(const ParticleFluid& water, std::span<const std::uint8_t> is_loose,
                          const body::Motion& motion, std::vector<Vec3>& places);

/// Returns the highest speed of the faces of loose bodies [m/s]; 0 without loose bodies.
double speed_of_joints(const ParticleFluid& water, std::span<const std::uint8_t> is_loose, const body::BodySet& bodies,
                       const body::BodyState& state, JointScratch& joints);

}  // namespace riprap::coupling
