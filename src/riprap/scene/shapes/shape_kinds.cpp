// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/shapes/shape_kind.hpp"

#include "riprap/scene/shapes/composed_shapes.hpp"
#include "riprap/scene/shapes/convex_shapes.hpp"

namespace riprap::scene {

/// One line registers a kind.
const std::vector<ShapeKind>& shape_kinds() {
    static const std::vector<ShapeKind> kinds{
        box_shape(),        cube_shape(),         prism_shape(),       tetrahedron_shape(), wedge_shape(),
        octahedron_shape(), dodecahedron_shape(), icosahedron_shape(), sphere_shape(),      ellipsoid_shape(),
        ellipse_shape(),    cylinder_shape(),     hull_shape(),        random_hull_shape(), armour_shape(),
        polygon_shape(),    half_space_shape(),   stl_shape(),         obj_shape(),         terrain_shape(),
        mesh_shape(),       union_shape()};
    return kinds;
}

const ShapeKind& kind_of(const Value& shape) {
    for (const ShapeKind& kind : shape_kinds()) {
        if (shape.find(kind.row.name) != nullptr) {
            return kind;
        }
    }
    throw InternalError("a shape of no kind");
}

const Table& shape_table() {
    static const Table table = [] {
        Table made{"shape",
                   "shape = { ... }",
                   "Exactly one of these. Shapes lie about their own origin, which comes to the position of the body.",
                   {}};
        Group one{GroupRule::exactly_one, {}};
        for (const ShapeKind& kind : shape_kinds()) {
            made.keys.push_back(kind.row);
            one.keys.push_back(kind.row.name);
        }
        made.groups = {one};
        return made;
    }();
    return table;
}

}  // namespace riprap::scene
