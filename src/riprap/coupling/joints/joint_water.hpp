// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "riprap/coupling/joints/joint_sums.hpp"

namespace riprap::coupling {

/// Water about a sample at a joint (docs/theory/coupling.md, 6). G_own, G_others and G_water are the sums of V grad W
/// over its own solid, over others and of V B grad W over the water.
struct JointWater {
    Vec3 rim{};            ///< t, the part of G_own + G_others along the face [1/m]
    double covered{0};     ///< -t . G_water/t^2, how much of what is open along the face is water; no less than 0
    double dry_share{1};   ///< u, how much of the room in the joint water has left, 0 to 1
    double felt{0};        ///< pressure on the wall there, f p [Pa]
    double weight{0};      ///< omega, of `felt` in means [m^(D-2)]; 0 = no water
    bool is_first{false};  ///< of the first layer of its solid
};

/// Marks the solids that water stands at.
struct WetSolids {
    std::vector<std::uint8_t> is_wet;          ///< each solid, from still_solid on
    std::vector<std::uint8_t> is_wet_partner;  ///< each partner of joints, likewise
    std::vector<std::uint8_t> meets_wet;       ///< each solid that is wet or near a wet one

    static std::size_t entry(std::int32_t solid) { return at(solid - still_solid); }
};
WetSolids find_wet_solids(const JointPairs& pairs, std::size_t bodies, const fluid::WaterAtWalls& water);

/// Finds the water about all members that are at a joint; nothing for others, and for those of solids that water stands
/// neither at nor near: where all of these are dry, all of the rim is, and the joint presses nothing apart.
/// @param slopes   of solid_slopes, for each sample of the set that `near` looks at
/// @param water    at each sample of `near`
/// @param around   receives one for each slot, of those that are marked so
/// @param marks    receives one SlotMark for each slot
/// @param found    receives one for each sample of each of pairs.fours(); its memory is reused
template <class Real>
void find_joint_water(const JointPairs& pairs, const JointSums<Real>& sums, const SampleView& near,
                      std::span<const Vec3> slopes, const body::Motion& motion, const fluid::WaterAtWalls& water,
                      const fluid::ParticleSettings& settings, const WetSolids& wet,
                      std::vector<AroundSlot<Real>>& around, std::vector<std::uint8_t>& marks,
                      std::vector<JointWater>& found);

/// Share of what is open at a wall that moving water fills with particles, at least.
inline constexpr double well_filled = 0.85;

}  // namespace riprap::coupling
