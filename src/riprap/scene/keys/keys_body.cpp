// SPDX-License-Identifier: Apache-2.0
// Rows of the key table: bodies, loads on them and their repetition.
#include "riprap/scene/keys/freedom_words.hpp"
#include "riprap/scene/keys/key_table.hpp"
#include "riprap/scene/keys/limits.hpp"
#include "riprap/scene/keys/words.hpp"

namespace riprap::scene {

using namespace form;

namespace {

Form count_triple(std::int64_t largest) { return list(integer(1, static_cast<double>(largest)), 2, 3); }

}  // namespace

const Table& load_data_table() {
    static const Table table{
        "load.table",
        "load = [ { table = { ... } }, ... ]",
        "Force against time from `start` on, linear between rows; none before the first, the last one afterwards. Of "
        "loads on bodies and on sections.",
        {{"time", {list(number(dimension::time), 1, limits::table_rows)}, "Increasing times.", {}},
         {"force", {list(vector(dimension::force), 1, limits::table_rows)}, "Force at each time.", {}},
         {"file", {path()}, "Table with rows t, x, y, z in SI (docs/howto/tables.md); in a plane t, x, y.", {}}},
        {{GroupRule::exactly_one, {"time", "file"}}, {GroupRule::all_or_none, {"time", "force"}}}};
    return table;
}

const Table& load_table() {
    static const Table table{
        "body.load",
        "load = [ { ... }, ... ]",
        "A force on a point of the body. Its direction is fixed in space, its point moves with the body. Its work is "
        "booked as solid.external. Every copy of a repeated body bears it.",
        {{"force", {vector(dimension::force)}, "The force at its full size.", {}},
         {"table", {form::table(load_data_table)}, "Force against time, instead of 'force'.", {}},
         {"at",
          {vector(dimension::length)},
          "Point of application, in the frame of the shape (grows with the scales of repeat); the centre of mass when "
          "not "
          "given.",
          {}},
         {"start", {number(dimension::time, non_negative())}, "No force before.", Value::of(0.0)},
         {"ramp",
          {number(dimension::time, non_negative())},
          "Time in which it grows to its full size.",
          Value::of(0.0)},
         {"stop", {number(dimension::time, positive())}, "No force afterwards; never when not given.", {}}},
        {{GroupRule::exactly_one, {"force", "table"}}}};
    return table;
}

const Table& repeat_table() {
    static const Table table{
        "repeat",
        "repeat = { ... }",
        "Copies of the body on a lattice, x fastest, then y, then z, or around an axis; named NAME[0], NAME[1], ...",
        {{"counts", {count_triple(limits::bodies)}, "Copies along x, y and z.", {}, true},
         {"pitch", {vector(dimension::length)}, "Distance between neighbours along x, y and z.", Value::of(Vec3{})},
         {"orientation",
          {form::table(orientation_table)},
          "Orientation of the lattice, such as along a slope, about the first copy; copies stay turned as the body is, "
          "and "
          "jitter goes along the axes of the world. What turn says comes after it.",
          {}},
         {"stagger",
          {number(dimension::length)},
          "Moves every other row along x, as bricks in a wall: all copies where the numbers along y and z add up to "
          "an odd one.",
          Value::of(0.0)},
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

const Table& spheres_table() {
    static const Table table{
        "body.spheres",
        "spheres = { ... }",
        "Spheres by which solid.method \"sphere_dem\" lets the body be met, instead of samples of its surface by "
        "solid.sphere_radius. Water, what is shown and, unless mass_of says otherwise, mass and inertia are those of "
        "its "
        "shape. Exactly one of file, shell, fill and ring.",
        {{"file",
          {path()},
          "Lines x y z radius in the frame of the shape, separated by blanks or commas; # begins a comment.",
          {}},
         {"units", {form::choice(length_units())}, "Unit of the numbers in the file.", Value::of("m")},
         {"shell",
          {integer(1, 200)},
          "Shell of a box: so many spheres along its shortest edge, all but those inside, flush with its faces.",
          {}},
         {"fill",
          {number(dimension::length, positive())},
          "In space: spacing of a cubic lattice of spheres inside the shape, those that can touch nothing left out: "
          "for surfaces "
          "from a file.",
          {}},
         {"ring",
          {integer(3, 10'000)},
          "Ring of a disc in a planar scene: so many spheres around it, whose outermost points lie on its circle.",
          {}},
         {"ring_radius",
          {number(dimension::length, positive())},
          "Radius of the spheres of a ring; when not given, neighbours touch.",
          {}},
         {"mass_of",
          {choice({"shape", "spheres"})},
          "Volume, centre of mass and inertia are those of the shape, or of the union of the spheres.",
          Value::of("shape")}},
        {{GroupRule::exactly_one, {"file", "shell", "fill", "ring"}}}};
    return table;
}

const Table& body_table() {
    static const Table table{
        "body",
        "[[body]]",
        "A block, a wall or a ground.",
        {{"name", {form::name()}, "Unique; names the body in output, probes and messages.", {}, true},
         {"shape", {form::table(shape_table)}, "Shape of the body.", {}, true},
         {"material", {form::name()}, "Name of its material.", {}, true},
         {"position", {vector(dimension::length)}, "Position of the origin of the shape.", Value::of(Vec3{})},
         {"orientation", {form::table(orientation_table)}, "Orientation of the body.", {}},
         {"velocity", {vector(dimension::velocity)}, "Velocity of the centre of mass at the start.", Value::of(Vec3{})},
         {"angular_velocity",
          {spin(dimension::angular_velocity), number(dimension::angular_velocity)},
          "At the start, in world axes; in a planar scene a number, about z.",
          Value::of(Vec3{})},
         {"density",
          {number(dimension::density, positive())},
          "Density of the body, instead of that of its material.",
          {}},
         {"mass",
          {number({0, 1, 0, 0}, positive())},
          "Mass of one body, its density following from the volume of its shape; per metre of width in a planar scene. "
          "Not "
          "with density.",
          {}},
         {"spheres", {form::table(spheres_table)}, "Spheres that stand for it; of sphere_dem alone.", {}},
         {"fixed", {boolean()}, "Does not move.", Value::of(false)},
         {"release_time",
          {number(dimension::time, non_negative())},
          "A fixed or moving body becomes free at this time.",
          {}},
         {"locked",
          {list(choice(freedoms()), 1, 6)},
          "Degrees of freedom that a free body lacks, along and about the axes of the world through its centre of "
          "mass; "
          "\"rotation\" is all three turns. Guides without friction hold it and take any load.",
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
