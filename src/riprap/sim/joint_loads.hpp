// SPDX-License-Identifier: Apache-2.0
#pragma once

// Water in joints between solids as part of a step: for the sources of this folder only.

#include <cstdint>
#include <span>
#include <vector>

#include "riprap/coupling/joint_pressure.hpp"
#include "riprap/sim/model.hpp"

namespace riprap::sim {

struct WaterScratch;

/// Buffers of the water in joints: Scratch.
struct JointScratch {
    coupling::JointPressure pressure;
    fluid::WaterAtWalls water;
    std::vector<Vec3> slopes;         ///< of solid_slopes, of all samples [1/m]
    std::vector<Vec3> sample_force;   ///< on each sample near; empty where no joint is wet [N]
    body::Loads loads;                ///< on each body
    std::vector<double> radius;       ///< of the samples of each body about its centre of mass [m]
    std::size_t bytes() const;
};

/// Whether water in joints is asked for and some body may feel it.
bool has_joints(const Model& model, std::span<const std::uint8_t> is_loose);

/// Distance from a loose body within which samples may have to do with its joints [m]; 0 where there are none.
double reach_of_joints(const Model& model, std::span<const std::uint8_t> is_loose);

/// Adds the loads of water in joints to scratch.held_loads: bodies where scratch.motion says, after begin_forces.
void add_joint_loads(const Model& model, WaterScratch& scratch, const Vec3& gravity);

/// What they do to all bodies as scratch.motion says [W].
double joint_power(const WaterScratch& scratch);

/// Appends where loose bodies have faces: solids near these may make a joint, however far the water is.
void add_places_of_joints(const Model& model, std::span<const std::uint8_t> is_loose,
                          const body::Motion& motion, std::vector<Vec3>& places);

/// The fastest that such a place moves [m/s]; 0 where there are none.
double speed_of_joints(const Model& model, std::span<const std::uint8_t> is_loose, const body::BodyState& bodies,
                       JointScratch& joints);

}  // namespace riprap::sim
