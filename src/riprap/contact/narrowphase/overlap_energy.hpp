// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/contact/narrowphase/surface_in_field.hpp"

namespace riprap::contact {

/// Integral of phi of the field body over the overlap [m^3], after integrate_surface of the same side.
///
/// In the cell of face j phi is linear and vanishes at any apex c_j in that face's plane, so div(phi (x - c_j)) = 4 phi
/// and the cell's share is a quarter of the sum, over the polygons that bound it, of (distance of c_j below the
/// polygon's plane) x (integral of phi over the polygon). The polygons are pieces of surface faces, known already,
/// walls to other cells and internal faces of the field body. The wall between j and l counts for both:
///
///     int_W phi dS * [phi_l(c_j) + phi_j(c_l)] / |w_j n_j - w_l n_l|,
///
/// which is nothing where both cells share a corner of the body as apex. Apexes are chosen so that few walls are left;
/// a contact at one corner or edge of the field body has none.
///
/// c_j is the apex chosen for face j, n_j its outward normal and w_j = 1/r_j the weight of its depth in phi.
///
/// @param field_reaches  per face of the field body: whether it may intersect the surface body; null = unknown
double volume_sum(const SurfaceInField& side, const std::vector<std::uint8_t>* field_reaches);

}  // namespace riprap::contact
