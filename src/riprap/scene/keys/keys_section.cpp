// SPDX-License-Identifier: Apache-2.0
// Rows of the key table: planar sections cut into blocks along lines.
#include "riprap/scene/keys/key_table.hpp"
#include "riprap/scene/keys/limits.hpp"
#include "riprap/scene/keys/words.hpp"

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
        {{"angle", {number(dimension::angle)}, "Angle of the joints against +x, counter-clockwise.", {}, true},
         {"spacing", {number(dimension::length, positive())}, "Distance between joints, across them.", {}, true},
         {"spacing_scatter",
          {number(dimension::plain, {.low = 0, .high = 1, .is_high_open = true})},
          "Spacings vary at random by up to this share.",
          Value::of(0.0)},
         {"length",
          {number(dimension::length, positive())},
          "Length of one joint; without it joints run through the whole section.",
          {}},
         {"bridge",
          {number(dimension::length, non_negative())},
          "Rock between two joints of one line.",
          Value::of(0.0)},
         {"origin",
          {vector(dimension::length)},
          "A point that one line of the set passes through.",
          Value::of(Vec3{})}}};
    return table;
}

const Table& section_load_table() {
    static const Table table{
        "section.load",
        "[[section.load]]",
        "A force on the block that a point of the section lies in. Its direction is fixed in space, its point moves "
        "with the block.",
        {{"force", {vector(dimension::force)}, "The force at its full size.", {}},
         {"table", {form::table(load_data_table)}, "Force against time, instead of 'force'.", {}},
         {"at", {point()}, "Point of application, where it is at the start.", {}, true},
         {"start", {number(dimension::time, non_negative())}, "No force before.", Value::of(0.0)},
         {"ramp",
          {number(dimension::time, non_negative())},
          "Time in which it grows to its full size.",
          Value::of(0.0)},
         {"stop", {number(dimension::time, positive())}, "No force afterwards; never when not given.", {}}},
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
        {{"name", {form::name()}, "Unique.", {}, true},
         {"material", {form::name()}, "Name of the material of all blocks.", {}, true},
         {"outline", {points(3, 100'000)}, "Corners of the section, in either sense of turn.", {}},
         {"geometry",
          {path()},
          "Instead of an outline: a geometry file of the 2D-DDA family (.geo), whose joints are the lines and whose "
          "outline is among them. Blocks with a fixed point in them do not move, blocks with a hole point are left "
          "out.",
          {}},
         {"analysis",
          {path()},
          "Analysis file of the same family (.ana). Its loads, which may vary in time, act on the load points of the "
          "geometry; where "
          "the case says otherwise about material, joints or step there is a warning.",
          {}},
         {"lines", {list(points(2, 10'000), 1, 100'000)}, "Joints, each a list of two or more points [x, y].", {}},
         {"joint_set", {table_list(trace_set_table)}, "Joint sets.", Value::array()},
         {"holes", {points(1, 10'000)}, "Points; the blocks that they lie in are left out: a tunnel.", {}},
         {"fixed_points", {points(1, 10'000)}, "Points; the blocks that they lie in do not move.", {}},
         {"fixed_below", {number(dimension::length)}, "Blocks whose centre of mass lies below this y do not move.", {}},
         {"load", {table_list(section_load_table)}, "Forces on blocks.", Value::array()},
         {"snap",
          {number(dimension::length, positive())},
          "Points of lines that are nearer than this are one. That of the geometry file, or a billionth of the "
          "section.",
          {}},
         {"sliver",
          {number(dimension::plain, above(0, 0.1))},
          "A block with an area below this share of its longest side squared is refused.",
          Value::of(1e-4)},
         {"seed", {integer(0, 9e15)}, "Own seed; otherwise from the seed of the case and the name.", {}},
         {"fixed", {boolean()}, "The blocks do not move.", Value::of(false)},
         {"release_time", {number(dimension::time, non_negative())}, "Fixed blocks become free at this time.", {}}},
        {{GroupRule::exactly_one, {"outline", "geometry"}}}};
    return table;
}

}  // namespace riprap::scene
