// SPDX-License-Identifier: Apache-2.0
// Rows of the key table: bodies, loads on them and their repetition.
#include "riprap/scene/keys/freedom_words.hpp"
#include "riprap/scene/keys/key_table.hpp"
#include "riprap/scene/keys/words.hpp"
#include "riprap/scene/text/limits.hpp"

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
        {optional_key("time", {list(number(dimension::time), 1, limits::table_rows)}, "Increasing times."),
         optional_key("force", {list(vector(dimension::force), 1, limits::table_rows)}, "Force at each time."),
         optional_key("file", {path()},
                      "Table with rows t, x, y, z in SI (docs/howto/tables.md); in a plane t, x, y.")},
        {{GroupRule::exactly_one, {"time", "file"}}, {GroupRule::all_or_none, {"time", "force"}}}};
    return table;
}

const Table& load_table() {
    static const Table table{
        "body.load",
        "load = [ { ... }, ... ]",
        "A force on a point of the body. Its direction is fixed in space, its point moves with the body. Its work is "
        "booked as solid.external. Every copy of a repeated body bears it.",
        {optional_key("force", {vector(dimension::force)}, "The force at its full size."),
         optional_key("table", {form::table(load_data_table)}, "Force against time, instead of 'force'."),
         optional_key("at", {vector(dimension::length)},
                      "Point of application, in the frame of the shape (grows with the scales of repeat); the centre "
                      "of mass when not given."),
         key_or("start", {number(dimension::time, non_negative())}, Value::of(0.0), "No force before."),
         key_or("ramp", {number(dimension::time, non_negative())}, Value::of(0.0),
                "Time in which it grows to its full size."),
         optional_key("stop", {number(dimension::time, positive())}, "No force afterwards; never when not given.")},
        {{GroupRule::exactly_one, {"force", "table"}}}};
    return table;
}

const Table& repeat_table() {
    static const Table table{
        "repeat",
        "repeat = { ... }",
        "Copies of the body on a lattice, x fastest, then y, then z, or around an axis; named NAME[0], NAME[1], ...",
        {required_key("counts", {count_triple(limits::bodies)}, "Copies along x, y and z."),
         key_or("pitch", {vector(dimension::length)}, Value::of(Vec3{}),
                "Distance between neighbours along x, y and z."),
         optional_key("orientation", {form::table(orientation_table)},
                      "Orientation of the lattice, such as along a slope, about the first copy; copies stay turned as "
                      "the body is, and jitter goes along the axes of the world. What turn says comes after it."),
         key_or("stagger", {number(dimension::length)}, Value::of(0.0),
                "Moves every other row along x, as bricks in a wall: all copies where the numbers along y and z add up "
                "to an odd one."),
         key_or("turn", {number(dimension::angle)}, Value::of(0.0),
                "Copy i is turned by i times this angle about the axis."),
         key_or("turn_axis", {form::axis()}, Value::of(Vec3{0, 0, 1}), "Direction of the axis."),
         key_or("turn_center", {vector(dimension::length)}, Value::of(Vec3{}), "A point of the axis."),
         key_or("random_orientation", {boolean()}, Value::of(false),
                "Turn every copy at random, all directions alike (about z in a planar scene)."),
         key_or("jitter", {number(dimension::length, non_negative())}, Value::of(0.0),
                "Move every copy at random by at most this much along each axis."),
         optional_key("scales", {list(number(dimension::plain, positive()), 1, 64)},
                      "Factors on the size, taken in turn copy by copy.")}};
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
        {optional_key(
             "file", {path()},
             "Lines x y z radius in the frame of the shape, separated by blanks or commas; # begins a comment."),
         key_or("units", {form::choice(length_units())}, Value::of("m"), "Unit of the numbers in the file."),
         optional_key(
             "shell", {integer(1, 200)},
             "Shell of a box: so many spheres along its shortest edge, all but those inside, flush with its faces."),
         optional_key("fill", {number(dimension::length, positive())},
                      "In space: spacing of a cubic lattice of spheres inside the shape, those that can touch nothing "
                      "left out: for surfaces from a file."),
         optional_key(
             "ring", {integer(3, 10'000)},
             "Ring of a disc in a planar scene: so many spheres around it, whose outermost points lie on its circle."),
         optional_key("ring_radius", {number(dimension::length, positive())},
                      "Radius of the spheres of a ring; when not given, neighbours touch."),
         key_or("mass_of", {choice({"shape", "spheres"})}, Value::of("shape"),
                "Volume, centre of mass and inertia are those of the shape, or of the union of the spheres.")},
        {{GroupRule::exactly_one, {"file", "shell", "fill", "ring"}}}};
    return table;
}

const Table& body_table() {
    static const Table table{
        "body",
        "[[body]]",
        "A block, a wall or a ground.",
        {required_key("name", {form::name()}, "Unique; names the body in output, probes and messages."),
         required_key("shape", {form::table(shape_table)}, "Shape of the body."),
         required_key("material", {form::name()}, "Name of its material."),
         key_or("position", {vector(dimension::length)}, Value::of(Vec3{}), "Position of the origin of the shape."),
         optional_key("orientation", {form::table(orientation_table)}, "Orientation of the body."),
         key_or("velocity", {vector(dimension::velocity)}, Value::of(Vec3{}),
                "Velocity of the centre of mass at the start."),
         key_or("angular_velocity", {spin(dimension::angular_velocity), number(dimension::angular_velocity)},
                Value::of(Vec3{}), "At the start, in world axes; in a planar scene a number, about z."),
         optional_key("density", {number(dimension::density, positive())},
                      "Density of the body, instead of that of its material."),
         optional_key("mass", {number({0, 1, 0, 0}, positive())},
                      "Mass of one body, its density following from the volume of its shape; per metre of width in a "
                      "planar scene. Not with density."),
         optional_key("spheres", {form::table(spheres_table)}, "Spheres that stand for it; of sphere_dem alone."),
         key_or("fixed", {boolean()}, Value::of(false), "Does not move."),
         optional_key("release_time", {number(dimension::time, non_negative())},
                      "A fixed or moving body becomes free at this time."),
         optional_key(
             "locked", {list(choice(freedoms()), 1, 6)},
             "Degrees of freedom that a free body lacks, along and about the axes of the world through its centre of "
             "mass; \"rotation\" is all three turns. Guides without friction hold it and take any load."),
         optional_key("motion", {form::table(motion_table)}, "A prescribed motion."),
         optional_key("load", {table_list(load_table)}, "Forces on points of it."),
         key_or("slip", {boolean()}, Value::of(true),
                "Water slides along the body freely; false: it sticks to it, which needs a boundary layer of several "
                "spacings to mean anything."),
         key_or("wet", {boolean()}, Value::of(true), "Feels water and is felt by it; false: water passes through."),
         optional_key("repeat", {form::table(repeat_table)}, "Many copies.")}};
    return table;
}

}  // namespace riprap::scene
