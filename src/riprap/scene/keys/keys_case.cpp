// SPDX-License-Identifier: Apache-2.0
// Rows of the key table: the top of the file, gravity, solid.
#include <fmt/format.h>

#include <algorithm>

#include "riprap/scene/keys/key_table.hpp"
#include "riprap/scene/keys/keys_vary.hpp"
#include "riprap/scene/keys/methods.hpp"
#include "riprap/scene/keys/renamed.hpp"
#include "riprap/scene/text/limits.hpp"
#include "riprap/sim/method_traits.hpp"

namespace riprap::scene {

using namespace form;

KeyList<sim::TimeSettings> time_keys() {
    using S = sim::TimeSettings;
    return {
        key::number(&S::factor, "time_step_factor", dimension::plain, above(0, 1),
                    "Share of the stability limit 2/omega_max that \"auto\" uses."),
        key::boolean(&S::force_time_step, "force_time_step", "Accept a time_step above the stability limit."),
        key::number(&S::settle, "settle", dimension::time, non_negative(),
                    "Before time 0 free bodies come to rest for so long, without water and with driven bodies where "
                    "they start; displacements and damage count from there. With fluids without particles."),
        key::integer(&S::max_steps, "max_steps", -1, 1e15, "Stop after so many steps; -1 = no limit.")};
}

namespace {

/// Adds the solid methods that do what is asked for to a help.
std::string with_solids(std::string_view help, sim::SolidAbility asks) {
    return fmt::format("{} Of solid.method {}.", help, fmt::join(sim::solids_that(asks), " and "));
}

const Table& spread_table() {
    static const Table table{
        "spread",
        "[[spread]]",
        "A number that is not known exactly: `riprap run --ensemble N` draws it anew for every member, from the seed "
        "of "
        "the case, the number of the member and the key alone. Runs of one member keep what the case says.",
        {required_key("key", {text()}, "Which: the path as for --set, such as \"body.gate.motion.linear.velocity.2\"."),
         optional_key("low", {number(dimension::plain)}, "Least value of a uniform distribution, in SI."),
         optional_key("high", {number(dimension::plain)}, "Largest value."),
         optional_key("mean", {number(dimension::plain)}, "Mean of a normal distribution, in SI."),
         optional_key("deviation", {number(dimension::plain, non_negative())}, "Standard deviation.")},
        {{GroupRule::exactly_one, {"low", "mean"}},
         {GroupRule::all_or_none, {"low", "high"}},
         {GroupRule::all_or_none, {"mean", "deviation"}}}};
    return table;
}

const Table& fixed_point_table() {
    static const std::string help = with_solids(
        "A point of a block that a stiff spring holds where it is at the start; the block may turn about it and "
        "strain.",
        sim::SolidAbility::fixed_points);
    static const Table table{
        "fixed_point",
        "[[fixed_point]]",
        help,
        {required_key("body", {text()}, "Name of the body, \"NAME[17]\" for one of many."),
         required_key("at", {vector(dimension::length)}, "The point, where it is at the start."),
         optional_key("stiffness", {number(dimension::stiffness, positive())},
                      "Stiffness of the spring, in every direction; a hundred contact stiffnesses when not given.")}};
    return table;
}

const Table& strength_table() {
    static const Table table{
        "strength",
        "[strength]",
        "Strengths of all contacts are divided by a factor that changes smoothly during the run: tan of the friction "
        "angle, cohesion, tensile strength. `riprap fos` finds by such runs the factor at which bodies fail.",
        {required_key("reduction", {number(dimension::plain, between(0.01, 1000))},
                      "By which strengths are divided in the end; below 1 they grow."),
         key_or("initial", {number(dimension::plain, between(0.01, 1000))}, Value::of(1.0),
                "By which they are divided before, also while bodies settle."),
         key_or("begins", {number(dimension::time, non_negative())}, Value::of(0.0),
                "Time at which the change begins."),
         required_key("over", {number(dimension::time, positive())},
                      "How long the change takes: long against the time that bodies take to come to rest."),
         optional_key("reduces", {list(choice({"friction", "cohesion", "tension"}), 1, 3)},
                      "Strengths that are divided; all when not given.")}};
    return table;
}

const Table& bolt_table() {
    static const std::string help = with_solids(
        "A straight spring between points of two bodies, under tension and compression alike: a rock bolt. "
        "Forces are per metre of width.",
        sim::SolidAbility::bolts);
    static const Table table{
        "bolt",
        "[[bolt]]",
        help,
        {required_key("bodies", {list(text(), 2, 2)}, "Names of the bodies at its ends; one may be fixed."),
         required_key("ends", {list(vector(dimension::length), 2, 2)},
                      "Ends of the bolt at the start, in the order of the bodies."),
         required_key("stiffness", {number(dimension::stiffness, positive())}, "E A / l of the bolt."),
         key_or("pretension", {number(dimension::force, non_negative())}, Value::of(0.0),
                "Pretension: force at the start.")}};
    return table;
}

Table rows_of_case() {
    return {
        "case",
        "(top of the file)",
        "Title and length of the experiment, and how time advances.",
        {key_or("format", {integer(1, newest_format)}, Value::of(newest_format),
                "Version of the case file that its keys are of; a program that is older refuses it. `riprap upgrade "
                "CASE` gives keys of older versions their names of today."),
         key_or("title", {text()}, Value::of(""), "One line that says what the case shows."),
         key_or("source", {text()}, Value::of(""),
                "Publication that the case is taken from: authors and year, section, figure or table. `riprap list "
                "--published` finds cases by it."),
         key_or("dimension", {integer(2, 3)}, Value::of(3),
                "3, or 2 for a planar scene: shapes are prisms one unit thick whose motion stays in the x-y plane."),
         required_key("gravity", {vector(dimension::acceleration), form::table(gravity_table)},
                      "Gravity as a vector, or a table for gravity that grows or turns. No axis is up by nature; keys "
                      "of geology (dip) take +z as up."),
         required_key("end", {number(dimension::time, positive())}, "Physical time at which the run ends."),
         key_or("time_step", {choice({"auto"}), number(dimension::time, positive())}, Value::of("auto"),
                "\"auto\": time_step_factor times the stability limit, shortened so that the last step meets the end, "
                "and halved for a while after a step that was refused. A number is refused above the limit unless "
                "force_time_step is set."),
         key_or("settle_static", {boolean()}, Value::of(false),
                "Bodies settle without inertia: implicit methods start each step at rest, explicit ones take a tenth "
                "of the velocities in each step, explicit_dda a hundredth. A body that cannot stand creeps meanwhile, "
                "and starts from rest at time 0."),
         optional_key("settle_time_step", {number(dimension::time, positive())},
                      "Time step while bodies settle; that of the run when not given."),
         optional_key("settle_friction", {number(dimension::plain, non_negative())},
                      "Friction coefficient of all contacts while bodies settle, instead of theirs: a high one holds "
                      "what would slide, until time 0; none lets a heap lie close."),
         key_or("seed", {integer(0, 9e15)}, Value::of(1), "Seed of everything random in the case."),
         key_or("seeds", {integer(1, 1000)}, Value::of(1),
                "`riprap validate` runs the case and each of its variations with so many seeds, from `seed` on, and "
                "judges the means of answers: of packings, one of which tells little."),
         key_or("long", {boolean()}, Value::of(false),
                "It takes many minutes: of a suite, `riprap validate` runs it with --full alone; by its name always."),
         key_or("material", {named_tables(material_table, limits::materials)}, Value::table(),
                "Materials by name; a case of water alone needs none."),
         key_or("contact", {form::table(contact_table)}, Value::table(), "Contact of two materials."),
         optional_key("strength", {form::table(strength_table)}, "Reduction of strength during the run."),
         key_or("solid", {form::table(solid_table)}, Value::table(), "Method and settings of the solids."),
         optional_key("fluid", {form::table(fluid_table)}, "Water, when there is any."),
         key_or("body", {table_list(body_table)}, Value::array(),
                "Blocks, walls and grounds; one entry may stand for many."),
         key_or("pack", {table_list(pack_table)}, Value::array(), "Many blocks from a recipe."),
         key_or("rock_mass", {table_list(rock_mass_table)}, Value::array(), "A region cut into blocks by joint sets."),
         key_or("section", {table_list(section_table)}, Value::array(),
                "A planar section cut into blocks along lines."),
         key_or("fixed_point", {table_list(fixed_point_table)}, Value::array(), "Points of bodies held in place."),
         key_or("bolt", {table_list(bolt_table)}, Value::array(), "Rock bolts between bodies."),
         key_or("spread", {table_list(spread_table)}, Value::array(),
                "Numbers that differ between the members of an ensemble."),
         key_or("vary", {table_list(vary_table)}, Value::array(),
                "Values at which `riprap matrix` and `riprap validate` run the case again."),
         key_or("output", {form::table(output_table)}, Value::table(), "Files to write, and their intervals."),
         key_or("expect", {table_list(expect_table)}, Value::array(),
                "Answers the run must reach: a case is also a test.")}};
}

}  // namespace

const Table& case_table() {
    static const Table table = [] {
        Table made = rows_of_case();
        const std::vector<Key> time = rows_of(time_keys());
        const auto after = [](const Key& key) { return key.name == "seed"; };
        made.keys.insert(std::find_if(made.keys.begin(), made.keys.end(), after), time.begin(), time.end());
        return made;
    }();
    return table;
}

namespace {

const Table& gravity_rotation_table() {
    static const Table table{
        "gravity.rotation",
        "gravity = { rotation = { ... } }",
        "Turns gravity about an axis, at a constant rate or by given angles: a tilting platform without moving it.",
        {required_key("axis", {axis()}, "Axis of the turn; gravity turns by the right-hand rule."),
         optional_key("rate", {number(dimension::angular_velocity)}, "Angular velocity of gravity."),
         key_or("start", {number(dimension::time, non_negative())}, Value::of(0.0), "Start of the turn by a rate."),
         optional_key("stop", {number(dimension::time, non_negative())}, "End of it; none when not given."),
         optional_key("time", {list(number(dimension::time, non_negative()), 1, limits::table_rows)},
                      "Increasing times, instead of a rate: a platform that stops on its way."),
         optional_key("angle", {list(number(dimension::angle), 1, limits::table_rows)},
                      "Angle at each time, linear in between; the first one before, the last one afterwards.")},
        {{GroupRule::exactly_one, {"rate", "time"}}, {GroupRule::all_or_none, {"time", "angle"}}}};
    return table;
}

}  // namespace

const Table& gravity_table() {
    static const Table table{
        "gravity",
        "[gravity]",
        "Gravity as a function of time.",
        {required_key("value", {vector(dimension::acceleration)}, "Gravity at full strength, before any turn."),
         key_or("ramp", {number(dimension::time, non_negative())}, Value::of(0.0),
                "Gravity grows linearly from zero over this time."),
         optional_key("rotation", {form::table(gravity_rotation_table)}, "Turns gravity.")}};
    return table;
}

const Table& solid_table() {
    static const Table table = with_methods({"solid", "[solid]", "Motion and contact of solids.", {}},
                                            "Method by which blocks move.", SolidMethods::all(), {});
    return table;
}

}  // namespace riprap::scene
