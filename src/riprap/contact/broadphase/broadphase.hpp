// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "riprap/contact/contact_set.hpp"
#include "riprap/contact/frame.hpp"
#include "riprap/geometry/convex_view.hpp"

namespace riprap::contact {

/// Bounds of every part, as a broadphase sees them. One entry per part.
struct PartBounds {
    std::span<const Vec3> center;             ///< of the bounding sphere, world [m]
    std::span<const double> radius;           ///< of the bounding sphere [m]; infinity for half-spaces
    std::span<const std::int32_t> body;       ///< parts of one body never meet
    std::span<const std::uint8_t> is_mobile;  ///< two immobile (fixed or driven) parts never meet
};

/// A part too large for the grid (ground, wall, platform): tested by its planes against bounding spheres.
struct Giant {
    std::int32_t part;
    geometry::ConvexView shape;
    Frame frame;
};

}  // namespace riprap::contact
