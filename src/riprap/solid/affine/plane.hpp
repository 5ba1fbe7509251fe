// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "riprap/core/mat3.hpp"

// Plane scenes. A block of such a scene is a prism that loads move and strain within the x-y plane alone. Out of it
// nothing holds it: contact points lie on both faces of the prism, and what their forces miss by round-off grows like
// the tilt of a pencil. So w, the turns about x and y and the shears yz and zx are no unknowns there. The strain along
// z stays one, as the stress along z is nought.

namespace riprap::solid::affine {

/// Returns a gradient, deformation or dipole without what leaves the plane.
constexpr Mat3 in_plane(const Mat3& m) { return {{{m(0, 0), m(0, 1), 0}, {m(1, 0), m(1, 1), 0}, {0, 0, m(2, 2)}}}; }

/// Unknowns out of the plane, of the twelve of a block: w, alpha, beta, g_yz and g_zx.
inline constexpr std::array<std::size_t, 5> out_of_plane{2, 3, 4, 10, 11};

}  // namespace riprap::solid::affine
