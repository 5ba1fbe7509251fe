// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "riprap/contact/narrowphase/hull.hpp"

namespace riprap::contact {

/// Pair of features that fixes the direction of a common plane.
enum class PlaneKind : std::uint8_t {
    none,    ///< no common plane yet
    face_a,  ///< parallel to a face of A
    face_b,  ///< parallel to a face of B
    faces,   ///< halfway between a face of A and one of B that are equally good
    edges,   ///< parallel to an edge of A and an edge of B
    link     ///< across the shortest link of two features that do not overlap (vertex to vertex or to edge), or of two
             ///< tips that have met since: see share_plane_of_tips
};

/// Which face, or which two edges, fix a plane. Survives from step to step: the direction is computed again from it.
struct PlaneFeature {
    PlaneKind kind{PlaneKind::none};
    std::int32_t a{-1}, b{-1};  ///< face or edge numbers of A and B; -1 = has no part in it
    friend bool operator==(const PlaneFeature&, const PlaneFeature&) = default;
};

/// One number per feature, for a field of State; 0 = none.
std::uint64_t pack(const PlaneFeature& feature);
PlaneFeature unpack_feature(std::uint64_t packed);

/// The common plane of two convex bodies [Cundall1988]: the unit normal n, from A to B, that maximises the gap
///
///     g(n) = min over corners of B of n.x  -  max over corners of A of n.x                          [m],
///
/// positive apart, negative where they overlap: the largest gap, or the smallest overlap with its sign. The plane
/// itself lies halfway.
struct CommonPlane {
    Vec3 normal;              ///< from A to B [-]
    double gap;               ///< g [m]
    PlaneFeature feature;     ///< that fixes the normal
    bool is_fallback{false};  ///< the local search was not certain, and all features were tried
};

/// g(n) by one pass over the corners of both bodies.
double plane_gap(const PlacedHull& a, const PlacedHull& b, const Vec3& normal);

/// The exact common plane. Overlapping bodies: the best of all face normals and all pairs of edges whose arcs cross on
/// the sphere of normals (separating-axis theorem). Bodies apart: the link of the nearest points.
CommonPlane common_plane_exact(const PlacedHull& a, const PlacedHull& b);

/// The fast common plane [Nezami2004] [MikolaSitar2013]: from a first direction, looks at the nearest corner of each
/// body and moves on to the best of the planes parallel to the faces, pairs of edges and edges around them, and the
/// perpendicular bisector of the two corners, until none is better. A local optimum of an overlap need not be the
/// global one (and the search may stop early): see common_plane.
/// @param start  first direction, of any length; zero = between the centres
CommonPlane common_plane_fast(const PlacedHull& a, const PlacedHull& b, const Vec3& start);

/// The common plane that contact uses: from the feature of the last step where there is one, else fast, with the exact
/// search where the fast one is not certain: where the touching features do not face each other, and for an overlap
/// without a memory. The old feature is kept while its gap is within 1e-6 of the smaller body's size of the best, so
/// that a symmetric contact does not jump between equal planes. Where a face of A and one of B give the same gap (to
/// the same share), the plane lies halfway between them: neither body is preferred, and what is symmetric stays so.
/// Likewise between all planes as good where two tips meet, which had no plane before but a link.
/// @param reach  bodies farther apart than this are no contact: returns the first plane found that shows it [m]
CommonPlane common_plane(const PlacedHull& a, const PlacedHull& b, const PlaneFeature& before, double reach);

/// Puts the plane of two bodies that overlap halfway between all planes as good as it, where these differ: where a tip
/// meets a tip (or an edge) that it is aligned with, their faces and edges all around are as good, and either of them
/// alone would throw what is symmetric to its side. Leaves the plane where no other is as good.
/// @param tolerance  of the gaps [m]
void share_plane_of_tips(const PlacedHull& a, const PlacedHull& b, double tolerance, CommonPlane& plane);

/// Finds the common plane with a direction as memory: the normal of the last step, zero where there was none.
CommonPlane common_plane_near(const PlacedHull& a, const PlacedHull& b, const Vec3& before, double reach);

/// Direction of a stored feature at the present places; zero where it has none (edges that became parallel, `link`).
Vec3 feature_normal(const PlacedHull& a, const PlacedHull& b, const PlaneFeature& feature);

}  // namespace riprap::contact
