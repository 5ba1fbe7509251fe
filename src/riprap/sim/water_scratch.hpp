// SPDX-License-Identifier: Apache-2.0
#pragma once

// What a step of the water works in: for the sources of this folder only.

#include <cstdint>
#include <vector>

#include "riprap/coupling/penalty_walls.hpp"
#include "riprap/coupling/rigid_map.hpp"
#include "riprap/fluid/sph/sph_step.hpp"
#include "riprap/sim/joint_loads.hpp"
#include "riprap/sim/model.hpp"
#include "riprap/solid/explicit_dem.hpp"

namespace riprap::sim {

/// Buffers of the water: Scratch.
struct WaterScratch {
    fluid::SphScratch sph;
    fluid::BoundaryParticles walls;
    std::vector<std::int32_t> near_numbers;  ///< a copy of the State's near_samples: those that `walls` stand for
    coupling::PenaltyWalls penalty;
    body::Motion motion;      ///< of all bodies, where the samples were placed last
    coupling::FluidLoads loads;       ///< at the last kick
    coupling::FluidLoads held_loads;  ///< of particles pressed against faces and of water in joints, part of `loads`
    JointScratch joints;
    std::vector<Vec3> force, torque;  ///< pressure and viscosity together
    std::vector<Vec3> extra_force;    ///< of penalty walls on particles [N]
    fluid::SpongeWork sponge;
    std::vector<Vec3> correction;        ///< acceleration of driven bodies beyond their motion; may be empty [m/s^2]
    body::BodyState middle;              ///< bodies at mid-step, as predicted
    body::BodyKinematics kinematics;     ///< ... there
    std::vector<double> kappa, inertia;  ///< of bodies, for the added-mass iteration
    std::vector<std::uint8_t> is_still;  ///< bodies that never move
    std::vector<std::uint8_t> is_loose;  ///< bodies that forces move, now or once they are released
    std::vector<double> guard_share;     ///< of the guard's stiffness, per body

    std::size_t bytes() const;
};

/// The samples that the water may feel in this step.
inline coupling::SampleView samples_near_water(const Model& model, const WaterScratch& scratch) {
    return {model.fluid->samples, scratch.near_numbers};
}

}  // namespace riprap::sim
