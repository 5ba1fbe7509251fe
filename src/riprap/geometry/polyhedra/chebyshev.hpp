// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "riprap/geometry/polyhedra/polyhedron.hpp"

namespace riprap::geometry {

/// A ball inside a convex body.
struct InscribedSphere {
    Vec3 centre;    ///< [m]; not unique for prisms and boxes
    double radius;  ///< [m]
};

/// Largest sphere inside a convex body, its Chebyshev centre: the linear program in (x, r)
///
///     maximise r  subject to  n_j . x + w_j r <= d_j,
///
/// with w_j = 1 for ordinary faces and w_j = 0 for internal ones, which bound the centre but may be pierced by the
/// sphere: a planar prism then gives its largest inscribed *circle*, and r is always the largest value of
/// min over field-carrying faces of h_j, so that the distance potential reaches exactly 1 [Zhao, 1.3].
///
/// Solved by randomised incremental elimination with a fixed seed [Seidel1991], O(faces) expected, after scaling to
/// unit size; every constraint is checked again at the end and the radius returned is the one that the centre really
/// has. Absolute error about 1e-15 of the body's size, so a needle of slenderness s has relative error s * 1e-15.
///
/// @param faces        outward planes of a bounded body with an interior
/// @param is_internal  per face, or empty for none; at least one face must carry the field
/// @param interior     any point inside or on the body, the origin of the computation [m]
/// @param scale        a length no smaller than the body's extent in any direction [m]
InscribedSphere largest_inscribed_sphere(std::span<const Plane> faces, std::span<const std::uint8_t> is_internal,
                                         const Vec3& interior, double scale);

}  // namespace riprap::geometry
