// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/contact/narrowphase/foot_patch.hpp"

namespace riprap::contact {

/// Mean arm of the pressure of an even field about its centre [m]: friction of a face that spins on another is mu F
/// times it. Over the closed part of the patch, d > 0, with r from the centre of pressure c and d = d_c + g . r,
///
///     arm = int d |r| dA / int d dA,
///
/// exact by triangles from c to each edge. With h the distance of the edge, n its normal, t its direction, s along it
/// from the foot of c, R^2 = h^2 + s^2, and [ ] the difference of both ends,
///
///     int |r| dA         = h/6 [s R + h^2 asinh(s/h)],
///     int (g . r)|r| dA  = (g . n) h^2/8 [s R + h^2 asinh(s/h)] + (g . t) h/12 [R^3].
///
/// An evenly pressed square of side a gives a (sqrt 2 + asinh 1)/6 = 0.3826 a, a disc 2/3 of its radius.
double spin_arm(const FootPatch& patch);

}  // namespace riprap::contact
