// SPDX-License-Identifier: Apache-2.0
// Rows of the key table: shapes and how they are turned.
#include "riprap/scene/keys/key_table.hpp"
#include "riprap/scene/keys/limits.hpp"
#include "riprap/scene/keys/words.hpp"

namespace riprap::scene {

using namespace form;

namespace {

const Form length = number(dimension::length, positive());

const Table& half_space_table() {
    static const Table table{
        "shape.half_space",
        "shape = { half_space = { ... } }",
        "Everything on the inner side of a plane: a ground or a wall without thickness. Fixed or moving only.",
        {{"normal", {direction()}, "Points out of the solid; any length.", {}, true},
         {"offset",
          {number(dimension::length)},
          "Distance of the plane from the position, along the normal.",
          Value::of(0.0)}}};
    return table;
}

const Table& hull_table() {
    static const Table table{
        "shape.hull",
        "shape = { hull = { ... } }",
        "Convex hull of points.",
        {{"points", {list(vector(dimension::length), 4, limits::shape_vertices)}, "The points.", {}},
         {"file", {path()}, "Table with one point x, y, z per row (docs/howto/tables.md).", {}},
         {"units", {choice(length_units())}, "Unit of the numbers in the file.", Value::of("m")}},
        {{GroupRule::exactly_one, {"points", "file"}}}};
    return table;
}

const Table& random_hull_table() {
    static const Table table{"shape.random_hull",
                             "shape = { random_hull = { ... } }",
                             "Convex hull of random points on a sphere: an irregular stone.",
                             {{"corners", {integer(4, 200)}, "Number of points.", Value::of(12)},
                              {"circumradius", {length}, "Radius of the sphere.", {}, true},
                              {"seed", {integer(0, 9e15)}, "Seed of the stone.", Value::of(1)}}};
    return table;
}

const Table& armour_table() {
    static const Table table{
        "shape.armour",
        "shape = { armour = { ... } }",
        "A concrete unit of a breakwater, by its class, as convex parts about its centre of mass. In planar scenes its "
        "section: a square, three legs, a cross with noses, an H, an H with a third fluke.",
        {{"unit", {choice(armour_units())}, "Class of the unit.", {}, true},
         {"nominal_diameter",
          {length},
          "D_n: edge of the cube of the same volume; in planar scenes side of the square of the same area.",
          {}},
         {"mass",
          {number({0, 1, 0, 0}, positive())},
          "Mass of one unit, D_n following from the density of the body, such as \"10 t\"; in planar scenes per metre "
          "of "
          "width. For [[body]] and [[pack]].",
          {}}},
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
        {{"file", {path()}, "STL (ASCII or binary) or OBJ file in the folder of the case.", {}, true},
         {"units", {choice(length_units())}, "Unit of the numbers in the file; STL carries none.", {}, true},
         {"scale", {number(dimension::plain, positive())}, "Further factor on all coordinates.", Value::of(1.0)},
         {"repair",
          {boolean()},
          "Turn inverted faces and leave out collapsed ones, and say so, instead of refusing them.",
          Value::of(false)},
         {"center",
          {boolean()},
          "Move the centre of mass to the position; otherwise the file's origin is the position.",
          Value::of(false)}}};
    return table;
}

const Table& terrain_table() {
    static const Table table{
        "shape.terrain",
        "shape = { terrain = { ... } }",
        "Ground from heights, solid below; for bodies that are fixed or have a motion. Bodies slide over the edges of "
        "its triangles as over a plane (docs/howto/surfaces.md).",
        {{"file",
          {path()},
          "Heights on a grid: ESRI ASCII (.asc), or a table with x, y, z per row (docs/howto/tables.md); z up.",
          {}},
         {"profile",
          {list(list(number(dimension::length), 2, 2), 2, 100'000)},
          "Ground of a planar scene, instead of a file: points x, y from left to right.",
          {}},
         {"units", {choice(length_units())}, "Unit of the numbers in the file.", Value::of("m")},
         {"nodata",
          {choice({"none"}), number(dimension::plain)},
          "Number of the file that stands for no height, or \"none\": all numbers are heights, also those that look "
          "like "
          "a mark for none.",
          {}},
         {"region",
          {list(list(number(dimension::length), 2, 2), 2, 2)},
          "Low and high corner x, y of the part to take, in the coordinates of the file; all of it when not given.",
          {}},
         {"origin",
          {vector(dimension::length)},
          "Place in the coordinates of the file that comes to the position of the body.",
          Value::of(Vec3{})},
         {"resolution", {length}, "Distance of grid points; that of the file when not given.", {}},
         {"thickness",
          {length},
          "Thickness of the solid below, as far as blocks feel it; a share of it is how deep they may sink in. Twice "
          "the "
          "distance of the points when not given.",
          {}}},
        {{GroupRule::exactly_one, {"file", "profile"}}}};
    return table;
}

const Table& mesh_table() {
    static const Table table{
        "shape.mesh",
        "shape = { mesh = { ... } }",
        "Ground or walls from triangles, open or closed, solid behind their inner side; for bodies that are fixed or "
        "have a motion. Bodies slide over inner edges as over a plane (docs/howto/surfaces.md).",
        {{"file",
          {path()},
          "STL (.stl), OBJ (.obj) or ParaView (.vtp) file in the folder of the case; triangles wind "
          "counter-clockwise seen from outside.",
          {},
          true},
         {"units", {choice(length_units())}, "Unit of the numbers in the file, which carries none.", {}, true},
         {"scale", {number(dimension::plain, positive())}, "Further factor on all coordinates.", Value::of(1.0)},
         {"thickness",
          {length},
          "Thickness of the solid behind the triangles, as far as blocks feel it; at most half of what a closed "
          "surface has.",
          {},
          true}}};
    return table;
}

const Table& union_part_table() {
    static const Table table{
        "shape.union",
        "shape = { union = [ { ... }, ... ] }",
        "One convex part of a rigid union. Parts may touch, in whole faces, but not overlap; together they make one "
        "body.",
        {{"shape", {form::table(shape_table)}, "A convex shape.", {}, true},
         {"position", {vector(dimension::length)}, "Position of the part in the frame of the body.", Value::of(Vec3{})},
         {"orientation", {form::table(orientation_table)}, "Orientation of the part in the frame of the body.", {}}}};
    return table;
}

const Table& regular_table() {
    static const Table table{"shape.regular",
                             "shape = { octahedron = { ... } }",
                             "A regular solid about its centre.",
                             {{"edge", {length}, "Length of an edge.", {}},
                              {"circumradius", {length}, "Distance of the corners from the centre.", {}}},
                             {{GroupRule::exactly_one, {"edge", "circumradius"}}}};
    return table;
}

const Table& cylinder_table() {
    static const Table table{"shape.cylinder",
                             "shape = { cylinder = { ... } }",
                             "A cylinder along z, about its centre, as a prism with its volume.",
                             {{"radius", {length}, "Radius of the circle.", {}, true},
                              {"height", {length}, "Along z; half of it to either side.", {}, true},
                              {"sides", {integer(8, 64)}, "Sides of the prism.", Value::of(std::int64_t{32})}}};
    return table;
}

const Table& prism_table() {
    static const Table table{
        "shape.prism",
        "shape = { prism = { ... } }",
        "A right prism along z, about its centre: a regular polygon, or any convex one.",
        {{"sides", {integer(3, 64)}, "Corners of a regular polygon.", {}},
         {"circumradius", {length}, "Circumradius of the regular polygon.", {}},
         {"points",
          {list(list(number(dimension::length), 2, 2), 3, 256)},
          "Corners x, y of a convex polygon, in order.",
          {}},
         {"height",
          {length},
          "Along z; the prism reaches half of it to either side. Not given in a planar scene, where it is 1 m.",
          {}}},
        {{GroupRule::exactly_one, {"sides", "points"}}, {GroupRule::all_or_none, {"sides", "circumradius"}}}};
    return table;
}

const Table& orientation_axis_table() {
    static const Table table{"orientation.axis_angle",
                             "orientation = { axis_angle = { ... } }",
                             "A turn about an axis by the right-hand rule.",
                             {{"axis", {form::axis()}, "Axis of the turn.", Value::of(Vec3{0, 0, 1})},
                              {"angle", {number(dimension::angle)}, "Angle of the turn.", {}, true}}};
    return table;
}

}  // namespace

const Table& shape_table() {
    static const Table table{
        "shape",
        "shape = { ... }",
        "Exactly one of these. Shapes lie about their own origin, which comes to the position of the body.",
        {{"box", {vector(dimension::length, positive())}, "Edge lengths along x, y, z, about the centre.", {}},
         {"cube", {length}, "Edge length, about the centre.", {}},
         {"prism", {form::table(prism_table)}, "A right prism.", {}},
         {"tetrahedron",
          {length, list(vector(dimension::length), 4, 4)},
          "Edge length of a regular one about its centre, or its four corners.",
          {}},
         {"wedge",
          {vector(dimension::length, positive())},
          "Half a box [0, x] by [0, y] by [0, z], upright face in x = 0, upper edge along y.",
          {}},
         {"octahedron", {length, form::table(regular_table)}, "Edge length of a regular one, or a table.", {}},
         {"dodecahedron", {length, form::table(regular_table)}, "Edge length of a regular one, or a table.", {}},
         {"icosahedron", {length, form::table(regular_table)}, "Edge length of a regular one, or a table.", {}},
         {"sphere",
          {length},
          "Radius of a ball, in a planar scene of a disc. solid.method \"sphere_dem\" takes it as one sphere; other "
          "methods, and what is shown, as a polyhedron of 320 triangles (a prism of 64 sides) with its volume.",
          {}},
         {"ellipsoid",
          {vector(dimension::length, positive())},
          "Semi-axes along x, y and z, as a polyhedron of 320 triangles with its volume; not in a planar scene.",
          {}},
         {"ellipse",
          {list(number(dimension::length, positive()), 2, 2)},
          "Semi-axes along x and y, as a prism of 64 sides with its area; planar scenes only.",
          {}},
         {"cylinder",
          {form::table(cylinder_table)},
          "A round cylinder along z; in a planar scene sphere is a disc.",
          {}},
         {"hull", {form::table(hull_table)}, "Convex hull of points.", {}},
         {"random_hull", {form::table(random_hull_table)}, "An irregular stone.", {}},
         {"armour", {form::table(armour_table)}, "A concrete unit of a breakwater.", {}},
         {"polygon",
          {list(list(number(dimension::length), 2, 2), 3, 256)},
          "Corners x, y of a convex polygon, in order; planar scenes only.",
          {}},
         {"half_space", {form::table(half_space_table)}, "A ground or wall.", {}},
         {"stl", {form::table(surface_table)}, "A surface from an STL file.", {}},
         {"obj", {form::table(surface_table)}, "A surface from an OBJ file.", {}},
         {"terrain", {form::table(terrain_table)}, "Ground from a grid of heights.", {}},
         {"mesh", {form::table(mesh_table)}, "Ground or walls from triangles.", {}},
         {"union", {table_list(union_part_table, 1)}, "Several convex parts as one rigid body.", {}}},
        {{GroupRule::exactly_one,
          {"box",        "cube",      "prism",   "tetrahedron", "wedge", "octahedron",  "dodecahedron", "icosahedron",
           "sphere",     "ellipsoid", "ellipse", "cylinder",    "hull",  "random_hull", "armour",       "polygon",
           "half_space", "stl",       "obj",     "terrain",     "mesh",  "union"}}}};
    return table;
}

const Table& orientation_table() {
    static const Table table{"orientation",
                             "orientation = { ... }",
                             "Rotation of the body from its own axes to those of the world, in one of these forms.",
                             {{"axis_angle", {form::table(orientation_axis_table)}, "A turn about an axis.", {}},
                              {"angle", {number(dimension::angle)}, "A turn about z; the way of planar scenes.", {}},
                              {"euler",
                               {list(number(dimension::angle), 3, 3)},
                               "Turns about the fixed x, then y, then z axis (roll, pitch, yaw).",
                               {}},
                              {"quaternion",
                               {list(number(dimension::plain), 4, 4)},
                               "w, x, y, z of the turn from body to world; any length but zero.",
                               {}},
                              {"dip",
                               {number(dimension::angle, between(-1.5707963267948966, 1.5707963267948966))},
                               "Tilts the body's z axis: its x-y plane dips by this angle below the horizontal, z up.",
                               {}},
                              {"dip_direction",
                               {number(dimension::angle)},
                               "Azimuth towards which the plane dips, clockwise from +y (north) to +x (east).",
                               {}}},
                             {{GroupRule::exactly_one, {"axis_angle", "angle", "euler", "quaternion", "dip"}},
                              {GroupRule::all_or_none, {"dip", "dip_direction"}}}};
    return table;
}

}  // namespace riprap::scene
