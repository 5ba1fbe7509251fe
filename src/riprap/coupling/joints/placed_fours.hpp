// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "riprap/body/motion.hpp"
#include "riprap/coupling/joints/joint_lanes.hpp"
#include "riprap/coupling/samples/sample_set.hpp"
#include "riprap/fluid/particle/boundary_particles.hpp"
#include "riprap/fluid/particle/sweep/fixed_point.hpp"

namespace riprap::coupling {

inline constexpr std::int32_t still_solid = -1;  ///< all bodies that never move
inline constexpr std::int32_t no_solid = -2;

/// Four samples that follow each other, some of which may be no members of joints.
struct JointFour {
    std::int32_t number;                           ///< the first sample is four_size times that
    std::array<std::int32_t, four_size> solid;     ///< numbers of bodies, still_solid or no_solid
    std::array<std::uint8_t, four_size> is_loose;  ///< and whether forces move it

    std::size_t sample(std::size_t lane) const { return at(number) * four_size + lane; }
    bool has(std::size_t lane) const { return solid[lane] != no_solid; }
    /// Joints are between these: a loose solid, or all that is not loose.
    std::int32_t partner(std::size_t lane) const { return is_loose[lane] != 0 ? solid[lane] : still_solid; }
};

/// Where they are. What lanes hold that are no members means nothing.
template <class Real>
struct PlacedFour {
    std::array<Four<std::int32_t>, 3> place;  ///< whole numbers of FixedPoint's length
    Four3<Real> normal;                       ///< world [-]
    Four<Real> depth, volume;                 ///< [m], [m^3]
};

/// Gives an array so many entries of any value, without the room beyond them that grows with it.
template <class T>
void make_room(std::vector<T>& array, std::size_t count) {
    if (array.capacity() < count) {
        std::vector<T>().swap(array);
    }
    array.resize(count);
}

/// Places some fours of the samples `near` where walls are.
template <class Real>
void place_fours(std::span<const JointFour> fours, const SampleView& near, const body::Motion& motion,
                 const fluid::BoundaryParticles& walls, const fluid::FixedPoint& fixed,
                 std::vector<PlacedFour<Real>>& placed);

}  // namespace riprap::coupling
