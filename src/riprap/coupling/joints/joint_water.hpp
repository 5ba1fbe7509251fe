// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "riprap/coupling/joints/joint_pairs.hpp"

namespace riprap::coupling {

/// Water about a member of a joint (docs/theory/coupling.md, 6). G_own, G_others and G_water are the sums
/// of V grad W over its own solid, over others and of V B grad W over the water.
struct JointWater {
    bool may_be_there{false};  ///< some joint about the member may hold water; else nothing below is found
    Vec3 rim;                  ///< t, the part of G_own + G_others along the face [1/m]
    double covered;            ///< -t . G_water/t^2, how much of what is open along the face is water; no less than 0
    double dry_share;          ///< u, how much of the room in the joint water has left, 0 to 1
    double felt;               ///< what a wall feels of the water there [Pa]
    double weight;             ///< of that in means [m^(D-2)]; 0 = nothing is felt
    std::vector<std::int32_t> others;  ///< loose solids that it shares a joint with, still_solid for all others
};

/// Finds the water about all members; nothing for those that are not at a joint, or only at such between solids that no
/// water stands at.
/// @param slopes    of solid_slopes, for each sample of the set that `near` looks at
/// @param water     at each sample of `near`
/// @param found  receives one for each member; its memory is reused
void find_joint_water(const JointPairs& pairs, const SampleView& near, std::span<const Vec3> slopes,
                      const body::Motion& motion, const fluid::WaterAtWalls& water,
                      const fluid::ParticleSettings& settings, std::vector<JointWater>& found);

}  // namespace riprap::coupling
