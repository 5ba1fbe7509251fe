// SPDX-License-Identifier: Apache-2.0
// Rows of the key table: prescribed motions, paddles among them.
#include "riprap/scene/keys/key_table.hpp"
#include "riprap/scene/keys/limits.hpp"
#include "riprap/scene/keys/sea_words.hpp"

namespace riprap::scene {

using namespace form;

namespace {

const Form phase = number(dimension::angle);

std::vector<std::string_view> paddle_waves() {
    std::vector<std::string_view> words = key::texts_of(wave_kinds());
    words.push_back(irregular_wave);
    return words;
}

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
         {"file", {path()}, "Table with rows t, x, y, z in SI (docs/howto/tables.md).", {}}},
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
        {{"paddle", {choice(paddles())}, "An upright plate, or one hinged at the bed.", Value::of("piston")},
         {"wave",
          {choice(paddle_waves())},
          "A sine; a sine whose free second harmonic is cancelled (piston only); one solitary wave (piston only); a "
          "sea "
          "(piston only); none, for a paddle that only absorbs.",
          Value::of("regular")},
         {"height", {number(dimension::length, positive())}, "Wave height, crest to trough; of a sea H_m0.", {}},
         {"depth", {number(dimension::length, positive())}, "Depth of still water.", {}, true},
         {"period",
          {number(dimension::time, positive())},
          "Wave period, of a sea that of its peak; not for a solitary wave.",
          {}},
         {"direction", {form::direction()}, "Direction of the waves.", Value::of(Vec3{1, 0, 0})},
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
          {}},
         {"spectrum", {choice(spectra())}, "Spectrum of a sea.", Value::of("jonswap")},
         {"gamma", {number(dimension::plain, between(1, 10))}, "Peak enhancement of jonswap.", Value::of(3.3)},
         {"spectrum_file",
          {path()},
          "Spectrum of a sea from a table (docs/howto/tables.md) with rows f [1/s], S [m^2 s], instead of 'spectrum' "
          "and "
          "'period'; "
          "scaled "
          "to 'height' where that is given.",
          {}},
         {"seed",
          {integer(0, 1e15)},
          "Number that the random phases of a sea follow from.",
          Value::of(std::int64_t{1})},
         {"second_order",
          {boolean()},
          "A sea goes without free waves of the sums and differences of its frequencies; false: by linear theory.",
          Value::of(true)}}};
    return table;
}

}  // namespace

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

}  // namespace riprap::scene
