// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "riprap/core/vec3.hpp"

namespace riprap::fluid {

/// The box that particles may be in. A particle that leaves through a side that is not periodic is reported, never
/// dropped in silence. In two dimensions z is ignored.
struct Domain {
    Vec3 low{};                         ///< [m]
    Vec3 high{};                        ///< [m]
    std::array<bool, 3> is_periodic{};  ///< per axis
    int dimension{3};                   ///< 2 or 3

    /// Tells whether x lies between low and high, both included; what is not finite does not.
    bool holds(const Vec3& x) const { return is_between(x, false); }

    /// Tells whether a particle may be at x: the same, but along periodic axes every place has its image in the box.
    bool admits(const Vec3& x) const { return is_between(x, true); }

 private:
    bool is_between(const Vec3& x, bool leaves_out_periodic) const {
        for (int axis = 0; axis < dimension; ++axis) {
            const bool counts = !(leaves_out_periodic && is_periodic[static_cast<std::size_t>(axis)]);
            if (counts && !(x[axis] >= low[axis] && x[axis] <= high[axis])) {
                return false;
            }
        }
        return true;
    }
};

/// Returns a without what leaves the plane of a planar scene.
inline Vec3 in_plane(const Vec3& a, const Domain& domain) { return domain.dimension == 2 ? Vec3{a.x, a.y, 0} : a; }

/// Returns the part of gravity that has a potential: without its components along periodic axes [m/s^2].
inline Vec3 without_periodic(const Vec3& gravity, const Domain& domain) {
    Vec3 g = gravity;
    for (int axis = 0; axis < domain.dimension; ++axis) {
        g[axis] = domain.is_periodic[static_cast<std::size_t>(axis)] ? 0 : g[axis];
    }
    return g;
}

}  // namespace riprap::fluid
