// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/polyhedra/sound_part.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/geometry/polyhedra/merge_faces.hpp"

namespace riprap::geometry {

namespace {

/// Largest share of the volume that merging may change: more, and it has closed the part up.
constexpr double most_change = 0.01;

Vec3 extents_of(const std::vector<Vec3>& vertices) {
    Vec3 low = vertices[0], high = vertices[0];
    for (const Vec3& x : vertices) {
        low = min(low, x);
        high = max(high, x);
    }
    return high - low;
}

/// The part about the corner of its bounding box, in units of its extents where these are safe to multiply.
Polyhedron in_units_of(double extent, const Polyhedron& part) {
    Polyhedron scaled = part;
    for (Vec3& x : scaled.vertices) {
        x = (x - part.vertices[0]) / extent;
    }
    return scaled;
}

/// The least, over its faces, of the largest depth of a vertex below a face; 0 where a face has no area or a vertex
/// lies above one.
double thickness_of(const Polyhedron& part, double scale) {
    double thickness = std::numeric_limits<double>::infinity();
    for (const auto& loop : part.faces) {
        const Vec3 area = vector_area(part.vertices, loop);
        if (loop.size() < 3 || !(norm(area) > 0)) {
            return 0;
        }
        const Plane plane = face_plane(part.vertices, loop);
        double deepest = 0, highest = 0;
        for (const Vec3& x : part.vertices) {
            const double depth = plane.offset - dot(plane.normal, x);
            deepest = std::max(deepest, depth);
            highest = std::max(highest, -depth);
        }
        if (!(highest <= coplanar_tolerance * scale)) {
            return 0;
        }
        thickness = std::min(thickness, deepest);
    }
    return std::isfinite(thickness) ? thickness : 0;
}

/// Tells whether faces along z and across it are what is left of a prism.
bool is_prism_along_z(const Polyhedron& part) {
    return std::all_of(part.faces.begin(), part.faces.end(), [&](const auto& loop) {
        const double along = std::abs(face_plane(part.vertices, loop).normal.z);
        return along > 1 - coplanar_tolerance || along < coplanar_tolerance;
    });
}

/// Tells whether merging leaves a solid of the same volume, thicker than what merging resolves.
bool outlives_merging(const Polyhedron& part, bool is_planar) {
    const double scale = length_scale(part.vertices), before = mass_properties(part).volume;
    if (before > 0 && thickness_of(part, scale) >= safe_slenderness * scale && (!is_planar || is_prism_along_z(part))) {
        return true;  // no two of its faces are near enough to merge but those of one plane
    }
    const Polyhedron merged = merge_coplanar_faces(part);
    const double after = merged.faces.size() < 4 ? 0 : mass_properties(merged).volume;
    return before > 0 && std::abs(after - before) <= most_change * before &&
           thickness_of(merged, scale) > coplanar_tolerance * scale && (!is_planar || is_prism_along_z(merged));
}

/// The problem of a solid whose extents are held, but not its faces.
GeometryProblem flatness_problem(const Vec3& extents) {
    return {fmt::format("a part {:.3g} by {:.3g} by {:.3g} m in extent has a corner above a face, or faces so near to "
                        "each other that double precision makes one of them",
                        extents.x, extents.y, extents.z),
            "corners in the planes of their faces to a billionth of the extent, none outside, and a solid that is "
            "thicker than a millionth of it in all directions"};
}

}  // namespace

GeometryProblem extent_problem(const Vec3& extents, bool is_planar) {
    return {is_planar ? fmt::format("a part {:.3g} by {:.3g} m in extent, beside its metre of width, is out of the "
                                    "range of double precision",
                                    extents.x, extents.y)
                      : fmt::format("a part {:.3g} by {:.3g} by {:.3g} m in extent is out of the range of double "
                                    "precision",
                                    extents.x, extents.y, extents.z),
            is_planar ? "extents from 1e-6 to 1e6 m, each at least 1e-6 of the other"
                      : fmt::format("extents from {:g} to {:g} m, each at least {:g} of the largest", least_extent,
                                    most_extent, safe_slenderness)};
}

std::optional<GeometryProblem> part_problem(const Polyhedron& part, bool is_planar) {
    if (part.vertices.size() < 4 || !std::all_of(part.vertices.begin(), part.vertices.end(), is_finite)) {
        return GeometryProblem{"a part with a corner that is not finite", "sizes that double precision can add up"};
    }
    const Vec3 extents = extents_of(part.vertices);
    const double largest = is_planar ? std::max(extents.x, extents.y) : std::max({extents.x, extents.y, extents.z});
    if (!(largest >= least_extent && largest <= most_extent)) {
        return extent_problem(extents, is_planar);
    }
    // Lengths count against the largest of them, but the width of a planar part is in metres.
    const double unit = is_planar ? 1 : largest;
    if (!outlives_merging(in_units_of(unit, part), is_planar)) {
        const double smallest =
            is_planar ? std::min(extents.x, extents.y) : std::min({extents.x, extents.y, extents.z});
        const bool is_thick = smallest >= safe_slenderness * std::max(largest, unit);
        return is_thick && !is_planar ? flatness_problem(extents) : extent_problem(extents, is_planar);
    }
    return std::nullopt;
}

}  // namespace riprap::geometry
