// SPDX-License-Identifier: Apache-2.0
// Rows of the key table: planar sections cut into blocks along lines.
#include "riprap/scene/keys/key_table.hpp"
#include "riprap/scene/keys/words.hpp"
#include "riprap/scene/text/limits.hpp"

namespace riprap::scene {

using namespace form;

namespace {

Form point() { return list(number(dimension::length), 2, 2); }
Form points(std::int64_t least, std::int64_t most) { return list(point(), least, most); }

const Table& trace_set_table() {
    static const Table table{
        "section.joint_set",
        "[[section.joint_set]]",
        "Parallel joints through the section.",
        {required_key("angle", {number(dimension::angle)}, "Angle of the joints against +x, counter-clockwise."),
         required_key("spacing", {number(dimension::length, positive())}, "Distance between joints, across them."),
         key_or("spacing_scatter", {number(dimension::plain, {.low = 0, .high = 1, .is_high_open = true})},
                Value::of(0.0), "Spacings vary at random by up to this share."),
         optional_key("length", {number(dimension::length, positive())},
                      "Length of one joint; without it joints run through the whole section."),
         key_or("bridge", {number(dimension::length, non_negative())}, Value::of(0.0),
                "Rock between two joints of one line."),
         key_or("origin", {vector(dimension::length)}, Value::of(Vec3{}),
                "A point that one line of the set passes through.")}};
    return table;
}

const Table& section_load_table() {
    static const Table table{
        "section.load",
        "[[section.load]]",
        "A force on the block that a point of the section lies in. Its direction is fixed in space, its point moves "
        "with the block.",
        {optional_key("force", {vector(dimension::force)}, "The force at its full size."),
         optional_key("table", {form::table(load_data_table)}, "Force against time, instead of 'force'."),
         required_key("at", {point()}, "Point of application, where it is at the start."),
         key_or("start", {number(dimension::time, non_negative())}, Value::of(0.0), "No force before."),
         key_or("ramp", {number(dimension::time, non_negative())}, Value::of(0.0),
                "Time in which it grows to its full size."),
         optional_key("stop", {number(dimension::time, positive())}, "No force afterwards; never when not given.")},
        {{GroupRule::exactly_one, {"force", "table"}}}};
    return table;
}

}  // namespace

const Table& section_table() {
    static const Table table{
        "section",
        "[[section]]",
        "In a planar scene: rock cut into blocks along lines; named NAME[0], NAME[1], ... Lines are split where they "
        "cross; what ends inside a block cuts nothing. Blocks may be concave.",
        {required_key("name", {form::name()}, "Unique."),
         required_key("material", {form::name()}, "Name of the material of all blocks."),
         optional_key("outline", {points(3, 100'000)}, "Corners of the section, in either sense of turn."),
         optional_key("geometry", {path()},
                      "Instead of an outline: a geometry file of the 2D-DDA family (.geo), whose joints are the lines "
                      "and whose outline is among them. Blocks with a fixed point in them do not move, blocks with a "
                      "hole point are left out."),
         optional_key(
             "analysis", {path()},
             "Analysis file of the same family (.ana). Its loads, which may vary in time, act on the load points of "
             "the geometry; where the case says otherwise about material, joints or step there is a warning."),
         optional_key("lines", {list(points(2, 10'000), 1, 100'000)},
                      "Joints, each a list of two or more points [x, y]."),
         key_or("joint_set", {table_list(trace_set_table)}, Value::array(), "Joint sets."),
         optional_key("holes", {points(1, 10'000)}, "Points; the blocks that they lie in are left out: a tunnel."),
         optional_key("fixed_points", {points(1, 10'000)}, "Points; the blocks that they lie in do not move."),
         optional_key("fixed_below", {number(dimension::length)},
                      "Blocks whose centre of mass lies below this y do not move."),
         key_or("load", {table_list(section_load_table)}, Value::array(), "Forces on blocks."),
         optional_key("snap", {number(dimension::length, positive())},
                      "Points of lines that are nearer than this are one. That of the geometry file, or a billionth of "
                      "the section."),
         key_or("sliver", {number(dimension::plain, above(0, 0.1))}, Value::of(1e-4),
                "A block with an area below this share of its longest side squared is refused."),
         optional_key("seed", {integer(0, 9e15)}, "Own seed; otherwise from the seed of the case and the name."),
         key_or("fixed", {boolean()}, Value::of(false), "The blocks do not move."),
         optional_key("release_time", {number(dimension::time, non_negative())},
                      "Fixed blocks become free at this time.")},
        {{GroupRule::exactly_one, {"outline", "geometry"}}}};
    return table;
}

}  // namespace riprap::scene
