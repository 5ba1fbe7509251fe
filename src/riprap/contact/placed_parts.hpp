// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "riprap/body/body_set.hpp"
#include "riprap/contact/broadphase/broadphase.hpp"

namespace riprap::contact {

/// Every part where its body is, as searches for contact see it: Scratch. One entry per part.
struct PlacedParts {
    std::vector<Frame> frames;
    std::vector<Vec3> centers;            ///< of the bounding spheres: the origins of the frames [m]
    std::vector<double> radii;            ///< of the bounding spheres [m]
    std::vector<std::int32_t> body;       ///< that the part belongs to
    std::vector<std::uint8_t> is_mobile;  ///< the body is free or will be released
    std::vector<Giant> giants;            ///< see choose_giants
    double median_radius{0};              ///< of the finite ones [m]
    std::uint64_t scene{0};               ///< see PartBounds
    std::vector<std::int32_t>
        restless;  ///< mobile parts, and those of bodies that have moved since they were described

    /// A body that has stayed where it was when its parts were described.
    struct Resting {
        std::int32_t body;
        Pose pose;
    };
    std::vector<Resting> resting;

    PartBounds bounds() const { return {centers, radii, body, is_mobile, scene, restless}; }
    std::size_t bytes() const;
};

/// Puts every part where its body is; those of a body that has not moved stay, so that a large ground costs nothing.
/// Reads what does not change only when the number of parts does: a PlacedParts belongs to one scene.
/// @param left_out  per body, empty for none: its pairs with others of these and with what is fixed are not sought
void place_parts(const geometry::ShapeSet& shapes, const body::BodySet& bodies, const body::BodyState& state,
                 PlacedParts& placed, std::span<const std::uint8_t> left_out = {});

}  // namespace riprap::contact
