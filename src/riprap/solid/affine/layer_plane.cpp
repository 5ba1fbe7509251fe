// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/affine/layer_plane.hpp"

#include <cmath>
#include <vector>

#include "riprap/core/index.hpp"

namespace riprap::solid::affine {

namespace {

/// Strain across a layer at which blocks of it still count as equally thick [-].
constexpr double unlike_share = 0.02;

/// Does each of two blocks that overlap fill the range of the other along the normal of their plane? Nothing parts them
/// there: they are prisms of a planar scene, or plates of one layer, in by more than their thickness.
bool fill_one_layer(const contact::PlacedHull& a, const contact::PlacedHull& b, const contact::CommonPlane& plane) {
    if (plane.gap >= 0 || a.is_half_space() || b.is_half_space() ||
        std::abs(dot(plane.normal, b.centre - a.centre)) > -unlike_share * plane.gap) {
        return false;  // most pairs
    }
    const auto reach_of = [](const contact::PlacedHull& hull, const Vec3& direction) {
        return dot(direction, hull.vertices[at(support_vertex(hull, direction))]);
    };
    const double top = reach_of(a, plane.normal), bottom = reach_of(a, -plane.normal);
    const double unlike = std::abs(reach_of(b, plane.normal) - top) + std::abs(reach_of(b, -plane.normal) - bottom);
    return unlike < unlike_share * (top + bottom);
}

/// A hull stretched along a direction, so that no plane across it is one of least overlap.
struct Stretched {
    std::vector<Vec3> vertices, normals;
    contact::PlacedHull hull;

    Stretched(const contact::PlacedHull& from, const Vec3& along)
        : vertices(from.vertices.begin(), from.vertices.end()), normals(from.normals.size()), hull(from) {
        constexpr double factor = 1e3;
        for (Vec3& x : vertices) {
            x += (factor - 1) * dot(along, x - from.centre) * along;
        }
        place_normals(*from.topology, vertices, normals);
        hull.vertices = vertices;
        hull.normals = normals;
    }
};

}  // namespace

contact::CommonPlane plane_between(const contact::PlacedHull& a, const contact::PlacedHull& b,
                                   const contact::PlaneFeature& before, double reach) {
    contact::CommonPlane plane = contact::common_plane(a, b, before, reach);
    if (!fill_one_layer(a, b, plane)) {
        return plane;
    }
    const Stretched wide_a(a, plane.normal), wide_b(b, plane.normal);
    plane = contact::common_plane(wide_a.hull, wide_b.hull, before, reach);
    plane.gap = plane_gap(a, b, plane.normal);
    return plane;
}

}  // namespace riprap::solid::affine
