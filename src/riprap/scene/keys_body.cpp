// SPDX-License-Identifier: Apache-2.0
// Rows of the key table: bodies, their shapes, orientation, motion and repetition.
#include "riprap/scene/key_table.hpp"
#include "riprap/scene/limits.hpp"

namespace riprap::scene {

using namespace form;

namespace {

const Form length = number(dimension::length, positive());
Form count_triple(std::int64_t largest) { return list(integer(1, static_cast<double>(largest)), 2, 3); }

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
         {"file", {path()}, "CSV file with a header line and one point x, y, z per row.", {}},
         {"units", {choice({"m", "cm", "mm"})}, "Unit of the numbers in the file.", Value::of("m")}},
        {{GroupRule::exactly_one, {"points", "file"}}}};
    return table;
}

const Table& random_hull_table() {
    static const Table table{"shape.random_hull",
                             "shape = { random_hull = { ... } }",
                             "Convex hull of random points on a sphere: an irregular stone.",
                             {{"corners", {integer(4, 200)}, "Number of points.", Value::of(12)},
                              {"circumradius", {length}, "Radius of the sphere.", {}, true},
                              {"seed", {integer(0, 9e15)}, "Which stone.", Value::of(1)}}};
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
         {"units", {choice({"m", "cm", "mm"})}, "Unit of the numbers in the file; STL carries none.", {}, true},
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

const Table& union_part_table() {
    static const Table table{
        "shape.union",
        "shape = { union = [ { ... }, ... ] }",
        "One convex part of a rigid union. Parts may touch, in whole faces, but not overlap; together they make one "
        "body.",
        {{"shape", {form::table(shape_table)}, "A convex shape.", {}, true},
         {"position", {vector(dimension::length)}, "Of the part in the frame of the body.", Value::of(Vec3{})},
         {"orientation", {form::table(orientation_table)}, "Of the part in the frame of the body.", {}}}};
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

const Table& prism_table() {
    static const Table table{
        "shape.prism",
        "shape = { prism = { ... } }",
        "A right prism along z, about its centre: a regular polygon, or any convex one.",
        {{"sides", {integer(3, 64)}, "Corners of a regular polygon.", {}},
         {"circumradius", {length}, "Of the regular polygon.", {}},
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

const Form phase = number(dimension::angle);

const Table& linear_table() {
    static const Table table{"motion.linear",
                             "motion = { linear = { ... } }",
                             "Constant velocity.",
                             {{"velocity", {vector(dimension::velocity)}, "Velocity.", {}, true}}};
    return table;
}
const Table& sinusoidal_table() {
    static const Table table{"motion.sinusoidal",
                             "motion = { sinusoidal = { ... } }",
                             "x(t) = x0 + amplitude (sin(2 pi t/period + phase) - sin(phase)). It starts with its "
                             "speed at that phase, as if "
                             "struck; from rest with phase = \"90 deg\", on one side of its start then, or with a "
                             "ramp: x0 + r(t) amplitude sin(2 pi t/period + phase), r growing from 0 to 1.",
                             {{"amplitude", {vector(dimension::length)}, "Amplitude of the displacement.", {}, true},
                              {"period", {number(dimension::time, positive())}, "Period.", {}, true},
                              {"phase", {phase}, "Phase at the start.", Value::of(0.0)},
                              {"ramp",
                               {number(dimension::time, non_negative())},
                               "Time in which it grows from rest to its full size.",
                               Value::of(0.0)}}};
    return table;
}
const Table& motion_data_table() {
    static const Table table{
        "motion.table",
        "motion = { table = { ... } }",
        "Displacement against time, linear between rows, constant beyond both ends.",
        {{"time", {list(number(dimension::time), 1, limits::table_rows)}, "Increasing times.", {}},
         {"displacement",
          {list(vector(dimension::length), 1, limits::table_rows)},
          "Displacement from the start at each time.",
          {}},
         {"file", {path()}, "CSV file with a header line and rows t, x, y, z in SI.", {}}},
        {{GroupRule::exactly_one, {"time", "file"}}, {GroupRule::all_or_none, {"time", "displacement"}}}};
    return table;
}
const Table& rotation_table() {
    static const Table table{
        "motion.rotation",
        "motion = { rotation = { ... } }",
        "A turn about a fixed axis: angle(t) = rate t + amplitude (sin(2 pi t/period + phase) - sin(phase)), with a "
        "ramp rate t + r(t) amplitude sin(2 pi t/period + phase), r growing from 0 to 1.",
        {{"center", {vector(dimension::length)}, "A point of the axis.", {}, true},
         {"axis", {form::axis()}, "Direction of the axis.", Value::of(Vec3{0, 0, 1})},
         {"rate", {number(dimension::angular_velocity)}, "Angular velocity of the steady turn.", Value::of(0.0)},
         {"amplitude", {phase}, "Amplitude of an oscillation added to it.", Value::of(0.0)},
         {"period", {number(dimension::time, positive())}, "Period of the oscillation.", Value::of(1.0)},
         {"phase", {phase}, "Phase of the oscillation at the start.", Value::of(0.0)},
         {"ramp",
          {number(dimension::time, non_negative())},
          "Time in which the oscillation grows from rest to its full size.",
          Value::of(0.0)}}};
    return table;
}

const Table& wave_maker_table() {
    static const Table table{
        "motion.wave_maker",
        "motion = { wave_maker = { ... } }",
        "A paddle that makes waves in water of constant depth: the stroke follows from wave theory "
        "(docs/theory/waves.md). "
        "Up is against gravity.",
        {{"paddle", {choice({"piston", "flap"})}, "An upright plate, or one hinged at the bed.", Value::of("piston")},
         {"wave",
          {choice({"regular", "second_order", "solitary", "none"})},
          "A sine; a sine whose free second harmonic is cancelled (piston only); one solitary wave (piston only); "
          "none, "
          "for a paddle that only absorbs.",
          Value::of("regular")},
         {"height", {number(dimension::length, positive())}, "Wave height, crest to trough.", {}},
         {"depth", {number(dimension::length, positive())}, "Depth of still water.", {}, true},
         {"period", {number(dimension::time, positive())}, "Wave period; not for a solitary wave.", {}},
         {"direction", {form::direction()}, "Where the waves go.", Value::of(Vec3{1, 0, 0})},
         {"hinge", {vector(dimension::length)}, "A point of a flap's hinge, at the bed.", {}},
         {"absorb",
          {vector(dimension::length)},
          "A point at the foot of the paddle's face: it then also takes up waves that come back, by the surface in "
          "front of it (piston only; docs/theory/waves.md).",
          {}},
         {"phase", {phase}, "Phase of the sine at the start.", Value::of(0.0)},
         {"ramp",
          {number(dimension::time, non_negative())},
          "Time over which the stroke grows; two periods when not given.",
          {}}}};
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
         {"hull", {form::table(hull_table)}, "Convex hull of points.", {}},
         {"random_hull", {form::table(random_hull_table)}, "An irregular stone.", {}},
         {"polygon",
          {list(list(number(dimension::length), 2, 2), 3, 256)},
          "Corners x, y of a convex polygon, in order; planar scenes only.",
          {}},
         {"half_space", {form::table(half_space_table)}, "A ground or wall.", {}},
         {"stl", {form::table(surface_table)}, "A surface from an STL file.", {}},
         {"obj", {form::table(surface_table)}, "A surface from an OBJ file.", {}},
         {"union", {table_list(union_part_table, 1)}, "Several convex parts as one rigid body.", {}}},
        {{GroupRule::exactly_one,
          {"box", "cube", "prism", "tetrahedron", "wedge", "octahedron", "dodecahedron", "icosahedron", "hull",
           "random_hull", "polygon", "half_space", "stl", "obj", "union"}}}};
    return table;
}

const Table& orientation_table() {
    static const Table table{"orientation",
                             "orientation = { ... }",
                             "How the body is turned from its own axes to those of the world. One way of saying it.",
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

const Table& motion_table() {
    static const Table table{
        "motion",
        "motion = { ... }",
        "A prescribed motion: the body goes its way whatever it meets. One law, between start and stop.",
        {{"linear", {form::table(linear_table)}, "Constant velocity.", {}},
         {"sinusoidal", {form::table(sinusoidal_table)}, "A sine.", {}},
         {"table", {form::table(motion_data_table)}, "Displacements from a table.", {}},
         {"rotation", {form::table(rotation_table)}, "A turn about a fixed axis.", {}},
         {"wave_maker", {form::table(wave_maker_table)}, "A paddle that makes waves.", {}},
         {"start", {number(dimension::time, non_negative())}, "The law's t counts from here.", Value::of(0.0)},
         {"stop", {number(dimension::time, positive())}, "The body rests afterwards; never when not given.", {}}},
        {{GroupRule::exactly_one, {"linear", "sinusoidal", "table", "rotation", "wave_maker"}}}};
    return table;
}

const Table& load_table() {
    static const Table table{
        "body.load",
        "load = [ { ... }, ... ]",
        "A force on a point of the body. Its direction is fixed in space, its point moves with the body. Its work is "
        "booked as work_external. Every copy of a repeated body bears it.",
        {{"force", {vector(dimension::force)}, "The force at its full size.", {}, true},
         {"at",
          {vector(dimension::length)},
          "Where it acts, in the frame of the shape (grows with the scales of repeat); the centre of mass when not "
          "given.",
          {}},
         {"start", {number(dimension::time, non_negative())}, "No force before.", Value::of(0.0)},
         {"ramp",
          {number(dimension::time, non_negative())},
          "Time in which it grows to its full size.",
          Value::of(0.0)},
         {"stop", {number(dimension::time, positive())}, "No force afterwards; never when not given.", {}}}};
    return table;
}

const Table& repeat_table() {
    static const Table table{
        "repeat",
        "repeat = { ... }",
        "Copies of the body on a lattice, x fastest, then y, then z, or around an axis; named NAME[0], NAME[1], ...",
        {{"counts", {count_triple(limits::bodies)}, "Copies along x, y and z.", {}, true},
         {"pitch", {vector(dimension::length)}, "Distance between neighbours along x, y and z.", Value::of(Vec3{})},
         {"turn", {number(dimension::angle)}, "Copy i is turned by i times this angle about the axis.", Value::of(0.0)},
         {"turn_axis", {form::axis()}, "Direction of the axis.", Value::of(Vec3{0, 0, 1})},
         {"turn_center", {vector(dimension::length)}, "A point of the axis.", Value::of(Vec3{})},
         {"random_orientation",
          {boolean()},
          "Turn every copy at random, all directions alike (about z in a planar scene).",
          Value::of(false)},
         {"jitter",
          {number(dimension::length, non_negative())},
          "Move every copy at random by at most this much along each axis.",
          Value::of(0.0)},
         {"scales",
          {list(number(dimension::plain, positive()), 1, 64)},
          "Factors on the size, taken in turn copy by copy.",
          {}}}};
    return table;
}

const Table& body_table() {
    static const Table table{
        "body",
        "[[body]]",
        "A block, a wall or a ground.",
        {{"name", {form::name()}, "Unique; names the body in output, probes and messages.", {}, true},
         {"shape", {form::table(shape_table)}, "Its shape.", {}, true},
         {"material", {form::name()}, "Name of its material.", {}, true},
         {"position", {vector(dimension::length)}, "Of the origin of the shape.", Value::of(Vec3{})},
         {"orientation", {form::table(orientation_table)}, "How it is turned.", {}},
         {"velocity", {vector(dimension::velocity)}, "Of the centre of mass, at the start.", Value::of(Vec3{})},
         {"angular_velocity",
          {spin(dimension::angular_velocity), number(dimension::angular_velocity)},
          "At the start, in world axes; in a planar scene a number, about z.",
          Value::of(Vec3{})},
         {"density", {number(dimension::density, positive())}, "Instead of that of the material.", {}},
         {"fixed", {boolean()}, "Does not move.", Value::of(false)},
         {"release_time",
          {number(dimension::time, non_negative())},
          "A fixed or moving body becomes free at this time.",
          {}},
         {"motion", {form::table(motion_table)}, "A prescribed motion.", {}},
         {"load", {table_list(load_table)}, "Forces on points of it.", {}},
         {"slip",
          {boolean()},
          "Water slides along the body freely; false: it sticks to it, which needs a boundary layer of several "
          "spacings to mean anything.",
          Value::of(true)},
         {"wet", {boolean()}, "Feels water and is felt by it; false: water passes through.", Value::of(true)},
         {"repeat", {form::table(repeat_table)}, "Many copies.", {}}}};
    return table;
}

}  // namespace riprap::scene
