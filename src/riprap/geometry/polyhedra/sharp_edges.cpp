// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/polyhedra/sharp_edges.hpp"

#include <cmath>

namespace riprap::geometry {

namespace {

/// Half of the thickness of a planar prism [m].
constexpr double half_thickness = 0.5;

/// cos of the least angle between the normals of two faces of a part whose edges are sharp: 29 degrees, between the 30
/// of regular prisms of twelve sides, which have corners, and the 27.7 of those of thirteen, so that no last digit
/// decides.
constexpr double bluntest = 0.8746197071393957;

bool is_end(const ConvexView& shape, int face, double side) {
    return shape.is_internal[face] != 0 && shape.normal_z[face] == side && shape.offset[face] == half_thickness;
}

}  // namespace

bool is_planar_prism(const ConvexView& shape) {
    bool has_top = false, has_bottom = false;
    for (int f = 0; f < shape.face_count; ++f) {
        has_top = has_top || is_end(shape, f, 1);
        has_bottom = has_bottom || is_end(shape, f, -1);
    }
    return has_top && has_bottom;
}

bool has_sharp_edges(const ConvexView& shape) {
    const bool is_prism = is_planar_prism(shape);
    for (int f = 0; f < shape.face_count; ++f) {
        if (shape.is_internal[f] != 0) {
            if (!(is_prism && std::abs(shape.normal_z[f]) == 1)) {
                return false;
            }
            continue;
        }
        for (int g = 0; g < f; ++g) {
            if (shape.is_internal[g] == 0 && dot(shape.normal(f), shape.normal(g)) > bluntest) {
                return false;
            }
        }
    }
    return true;
}

}  // namespace riprap::geometry
