// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "riprap/contact/contact_set.hpp"
#include "riprap/contact/frame.hpp"
#include "riprap/geometry/polyhedra/convex_view.hpp"

namespace riprap::contact {

/// Bounds of every part, as a broadphase sees them. One entry per part.
struct PartBounds {
    std::span<const Vec3> center;             ///< of the bounding sphere, world [m]
    std::span<const double> radius;           ///< of the bounding sphere [m]; infinity for half-spaces
    std::span<const std::int32_t> body;       ///< parts of one body never meet
    std::span<const std::uint8_t> is_mobile;  ///< two immobile (fixed or driven) parts never meet; one value per body
    /// Number of a scene whose radii, bodies and mobility stay as they are, and whose other parts than the `restless`
    /// ones have not moved since it got that number. 0 = not known.
    std::uint64_t scene{0};
    std::span<const std::int32_t> restless{};

    std::int32_t size() const { return static_cast<std::int32_t>(radius.size()); }
};

/// A part too large for the grid (ground, wall, platform): tested by its planes against bounding spheres.
struct Giant {
    std::int32_t part;
    geometry::ConvexView shape;
    Frame frame;
};

/// May parts i and j ever make a pair? Not within one body, and not when neither can move freely.
inline bool may_pair(const PartBounds& bounds, std::size_t i, std::size_t j) {
    return bounds.body[i] != bounds.body[j] && (bounds.is_mobile[i] != 0 || bounds.is_mobile[j] != 0);
}

/// Bounding spheres closer than the skin: |x_a - x_b| < R_a + R_b + skin. All searches use this one expression, whose
/// value does not change when a and b change places, so that their pair sets agree to the last bit.
inline bool spheres_within(const Vec3& center_a, double radius_a, const Vec3& center_b, double radius_b, double skin) {
    const double reach = radius_a + radius_b + skin;
    return norm_squared(center_a - center_b) < reach * reach;
}

}  // namespace riprap::contact
