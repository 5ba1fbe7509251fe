// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "riprap/geometry/polyhedra/convex_view.hpp"

// Ways out of a convex part from a point in it. Internal faces are none: the end of a prism, the next part.

namespace riprap::solid::sphere_dem {

/// A way out of a part, through one of its faces.
struct WayOut {
    std::int32_t face{-1};
    double depth{0};  ///< of the point below it [m]
};

/// Finds the way out of a part from a point, shortest but for one face.
WayOut next_way_out(const geometry::ConvexView& shape, const Vec3& local, std::int32_t but);

/// A way out between several faces.
struct MiddleWay {
    Vec3 outward{};    ///< unit vector [-]
    double length{0};  ///< to the nearest of the faces, 0 = there is no such way [m]
};

/// Finds the way out between faces that are all as near as the one given, within a millionth of the inscribed radius:
/// a tip that meets an aligned tip goes straight back, while either face alone would throw it to its side. None where
/// no other face is as near, or where faces as near look away from each other.
MiddleWay middle_way_out(const geometry::ConvexView& shape, const Vec3& local, std::int32_t face);

}  // namespace riprap::solid::sphere_dem
