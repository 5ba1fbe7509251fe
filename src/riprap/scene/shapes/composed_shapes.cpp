// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/shapes/composed_shapes.hpp"

#include "riprap/scene/keys/bound_keys.hpp"
#include "riprap/scene/keys/words.hpp"
#include "riprap/scene/shapes/shape_library.hpp"
#include "riprap/scene/text/limits.hpp"

namespace riprap::scene {

using namespace form;

namespace {

const Form length = number(dimension::length, positive());

const Table& half_space_table() {
    static const Table table{
        "shape.half_space", "shape = { half_space = { ... } }",
        "Everything on the inner side of a plane: a ground or a wall without thickness. Fixed or moving only.",
        rows_of(HalfSpaceShape::keys())};
    return table;
}

const Table& hull_table() {
    static const Table table{
        "shape.hull",
        "shape = { hull = { ... } }",
        "Convex hull of points.",
        {optional_key("points", {list(vector(dimension::length), 4, limits::shape_vertices)}, "The points."),
         optional_key("file", {path()}, "Table with one point x, y, z per row (docs/howto/tables.md)."),
         key_or("units", {choice(length_units())}, Value::of("m"), "Unit of the numbers in the file.")},
        {{GroupRule::exactly_one, {"points", "file"}}}};
    return table;
}

const Table& armour_table() {
    static const Table table{
        "shape.armour",
        "shape = { armour = { ... } }",
        "A concrete unit of a breakwater, by its class, as convex parts about its centre of mass. In planar scenes its "
        "section: a square, three legs, a cross with noses, an H, an H with a third fluke.",
        {required_key("unit", {choice(armour_units())}, "Class of the unit."),
         optional_key(
             "nominal_diameter", {length},
             "D_n: edge of the cube of the same volume; in planar scenes side of the square of the same area."),
         optional_key("mass", {number({0, 1, 0, 0}, positive())},
                      "Mass of one unit, D_n following from the density of the body, such as \"10 t\"; in planar "
                      "scenes per metre of width. For [[body]] and [[pack]].")},
        {{GroupRule::exactly_one, {"nominal_diameter", "mass"}}}};
    return table;
}

const Table& surface_table() {
    static const Table table{
        "shape.surface",
        "shape = { stl = { ... } } or { obj = { ... } }",
        "A closed surface from a file. Open, inverted, self-touching or degenerate surfaces are refused with the "
        "place; "
        "coplanar triangles are merged. A body that is not convex is given as several closed convex shells in the file "
        "(docs/howto/surfaces.md).",
        {required_key("file", {path()}, "STL (ASCII or binary) or OBJ file in the folder of the case."),
         required_key("units", {choice(length_units())}, "Unit of the numbers in the file; STL carries none."),
         key_or("scale", {number(dimension::plain, positive())}, Value::of(1.0), "Further factor on all coordinates."),
         key_or("repair", {boolean()}, Value::of(false),
                "Turn inverted faces and leave out collapsed ones, and say so, instead of refusing them."),
         key_or("center", {boolean()}, Value::of(false),
                "Move the centre of mass to the position; otherwise the file's origin is the position.")}};
    return table;
}

const Table& terrain_table() {
    static const Table table{
        "shape.terrain",
        "shape = { terrain = { ... } }",
        "Ground from heights, solid below; for bodies that are fixed or have a motion. Bodies slide over the edges of "
        "its triangles as over a plane (docs/howto/surfaces.md).",
        {optional_key(
             "file", {path()},
             "Heights on a grid: ESRI ASCII (.asc), or a table with x, y, z per row (docs/howto/tables.md); z up."),
         optional_key("profile", {list(list(number(dimension::length), 2, 2), 2, 100'000)},
                      "Ground of a planar scene, instead of a file: points x, y from left to right."),
         key_or("units", {choice(length_units())}, Value::of("m"), "Unit of the numbers in the file."),
         optional_key("nodata", {choice({"none"}), number(dimension::plain)},
                      "Number of the file that stands for no height, or \"none\": all numbers are heights, also those "
                      "that look like a mark for none."),
         optional_key(
             "region", {list(list(number(dimension::length), 2, 2), 2, 2)},
             "Low and high corner x, y of the part to take, in the coordinates of the file; all of it when not given."),
         key_or("origin", {vector(dimension::length)}, Value::of(Vec3{}),
                "Place in the coordinates of the file that comes to the position of the body."),
         optional_key("resolution", {length}, "Distance of grid points; that of the file when not given."),
         optional_key("thickness", {length},
                      "Thickness of the solid below, as far as blocks feel it; a share of it is how deep they may sink "
                      "in. Twice the distance of the points when not given.")},
        {{GroupRule::exactly_one, {"file", "profile"}}}};
    return table;
}

const Table& mesh_table() {
    static const Table table{
        "shape.mesh",
        "shape = { mesh = { ... } }",
        "Ground or walls from triangles, open or closed, solid behind their inner side; for bodies that are fixed or "
        "have a motion. Bodies slide over inner edges as over a plane (docs/howto/surfaces.md).",
        {required_key("file", {path()},
                      "STL (.stl), OBJ (.obj) or ParaView (.vtp) file in the folder of the case; triangles wind "
                      "counter-clockwise seen from outside."),
         required_key("units", {choice(length_units())}, "Unit of the numbers in the file, which carries none."),
         key_or("scale", {number(dimension::plain, positive())}, Value::of(1.0), "Further factor on all coordinates."),
         required_key("thickness", {length},
                      "Thickness of the solid behind the triangles, as far as blocks feel it; at most half of what a "
                      "closed surface has.")}};
    return table;
}

const Table& union_part_table() {
    static const Table table{
        "shape.union",
        "shape = { union = [ { ... }, ... ] }",
        "One convex part of a rigid union. Parts may touch, in whole faces, but not overlap; together they make one "
        "body.",
        {required_key("shape", {form::table(shape_table)}, "A convex shape."),
         key_or("position", {vector(dimension::length)}, Value::of(Vec3{}),
                "Position of the part in the frame of the body."),
         optional_key("orientation", {form::table(orientation_table)},
                      "Orientation of the part in the frame of the body.")}};
    return table;
}

}  // namespace

KeyList<HalfSpaceShape> HalfSpaceShape::keys() {
    using S = HalfSpaceShape;
    return {key::direction(&S::normal, "normal", "Points out of the solid; any length.").required(),
            key::number(&S::offset, "offset", dimension::length, key::any(),
                        "Distance of the plane from the position, along the normal.")};
}

ShapeKind half_space_shape() {
    ShapeKind kind{optional_key("half_space", {form::table(half_space_table)}, "A ground or wall.")};
    kind.role = ShapeRole::plane;
    return kind;
}

ShapeKind hull_shape() {
    const ShapeKind::Make make = [](ShapeLibrary& library, const Entry& given) {
        return library.make_hull(given.value);
    };
    return {optional_key("hull", {form::table(hull_table)}, "Convex hull of points."), make, nullptr};
}

ShapeKind armour_shape() {
    const ShapeKind::Make make = [](ShapeLibrary& library, const Entry& given) {
        return library.make_armour(given.value);
    };
    return {optional_key("armour", {form::table(armour_table)}, "A concrete unit of a breakwater."), make, make};
}

ShapeKind stl_shape() {
    const ShapeKind::Make make = [](ShapeLibrary& library, const Entry& given) {
        return library.make_surface(given.value, true);
    };
    return {optional_key("stl", {form::table(surface_table)}, "A surface from an STL file."), make, nullptr};
}

ShapeKind obj_shape() {
    const ShapeKind::Make make = [](ShapeLibrary& library, const Entry& given) {
        return library.make_surface(given.value, false);
    };
    return {optional_key("obj", {form::table(surface_table)}, "A surface from an OBJ file."), make, nullptr};
}

ShapeKind terrain_shape() {
    const ShapeKind::Make make = [](ShapeLibrary& library, const Entry& given) {
        return library.make_terrain(given.value);
    };
    return {optional_key("terrain", {form::table(terrain_table)}, "Ground from a grid of heights."), make, make,
            ShapeRole::ground};
}

ShapeKind mesh_shape() {
    const ShapeKind::Make make = [](ShapeLibrary& library, const Entry& given) {
        return library.make_mesh(given.value);
    };
    return {optional_key("mesh", {form::table(mesh_table)}, "Ground or walls from triangles."), make, make,
            ShapeRole::ground};
}

ShapeKind union_shape() {
    const ShapeKind::Make make = [](ShapeLibrary& library, const Entry& given) {
        return library.make_union(given.value);
    };
    return {optional_key("union", {table_list(union_part_table, 1)}, "Several convex parts as one rigid body."), make,
            make};
}

}  // namespace riprap::scene
