// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/contact/narrowphase/hull.hpp"

namespace riprap::contact {

/// Largest radius of a hull over that across its longest way [-]. A square rod reaches it at 14 times its breadth.
constexpr double most_slenderness = 5;

/// Size of which tolerances of contacts are shares: the radius about the centre, and at most five times the largest
/// distance of a corner from the line through the centre and the farthest corner. Those of a rod follow its breadth,
/// and those of a section of millimetres follow it, not the metre by which prisms of planar scenes are thick; plates
/// and wide sections keep their radius. Without bound for a half-space [m].
inline double size_of(const PlacedHull& hull) {
    if (hull.is_half_space()) {
        return std::numeric_limits<double>::infinity();
    }
    Vec3 farthest{};
    for (const Vec3& x : hull.vertices) {
        farthest = norm_squared(x - hull.centre) > norm_squared(farthest) ? x - hull.centre : farthest;
    }
    const double square = norm_squared(farthest);
    double across = 0;
    for (const Vec3& x : hull.vertices) {
        across = std::max(across, norm_squared(cross(x - hull.centre, farthest)));
    }
    return std::sqrt(std::min(square, most_slenderness * most_slenderness * across / square));
}

}  // namespace riprap::contact
