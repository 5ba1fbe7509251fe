// SPDX-License-Identifier: Apache-2.0
// Rows of the key table: prescribed motions, paddles among them.
#include <fmt/format.h>

#include "riprap/body/prescribed_motion.hpp"
#include "riprap/scene/keys/bound_keys.hpp"
#include "riprap/scene/keys/sea_words.hpp"
#include "riprap/scene/motions/paddle_waves.hpp"
#include "riprap/scene/text/limits.hpp"

namespace riprap::scene {

using namespace form;

namespace {

/// Rows of a law: its keys, or those that only a case has.
template <class Law>
std::vector<Key> rows_of_law() {
    return rows_of(Law::keys());
}
template <>
std::vector<Key> rows_of_law<body::TableMotion>() {
    return {optional_key("time", {list(number(dimension::time), 1, limits::table_rows)}, "Increasing times."),
            optional_key("displacement", {list(vector(dimension::length), 1, limits::table_rows)},
                         "Displacement from the start at each time."),
            optional_key("file", {path()}, "Table with rows t, x, y, z in SI (docs/howto/tables.md).")};
}

template <class Law>
const Table& law_table() {
    static const std::string id = fmt::format("motion.{}", Law::word);
    static const std::string header = fmt::format("motion = {{ {} = {{ ... }} }}", Law::word);
    static const Table table = [] {
        Table made{id, header, Law::help, rows_of_law<Law>()};
        if (made.find("file") != nullptr) {
            made.groups = {{GroupRule::exactly_one, {"time", "file"}},
                           {GroupRule::all_or_none, {"time", "displacement"}}};
        }
        return made;
    }();
    return table;
}

std::vector<Key> rows_of_wave_maker() {
    std::vector<Key> rows = rows_of(WaveMaker::keys());
    const std::vector<Key> of_seas{
        key_or("spectrum", {choice(spectra())}, Value::of("jonswap"), "Spectrum of a sea."),
        key_or("gamma", {number(dimension::plain, between(1, 10))}, Value::of(3.3), "Peak enhancement of jonswap."),
        optional_key("spectrum_file", {path()},
                     "Spectrum of a sea from a table (docs/howto/tables.md) with rows f [1/s], S [m^2 s], instead of "
                     "'spectrum' and 'period'; scaled to 'height' where that is given."),
        key_or("seed", {integer(0, 1e15)}, Value::of(std::int64_t{1}),
               "Number that the random phases of a sea follow from."),
        key_or("second_order", {boolean()}, Value::of(true),
               "A sea goes without free waves of the sums and differences of its frequencies; false: by linear "
               "theory.")};
    rows.insert(rows.end(), of_seas.begin(), of_seas.end());
    return rows;
}

const Table& wave_maker_table() {
    static const Table table{
        "motion.wave_maker", "motion = { wave_maker = { ... } }",
        "A paddle that makes waves in water of constant depth: the stroke follows from wave theory "
        "(docs/theory/waves.md). "
        "Up is against gravity.",
        rows_of_wave_maker()};
    return table;
}

}  // namespace

const Table& motion_table() {
    static const Table table = [] {
        Table made{"motion",
                   "motion = { ... }",
                   "A prescribed motion: the body goes its way whatever it meets. One law, between start and stop.",
                   {}};
        Group one{GroupRule::exactly_one, {}};
        const auto add = [&](std::string_view word, std::string_view brief, const Table& (*law)()) {
            made.keys.push_back({word, {form::table(law)}, std::string(brief), {}});
            one.keys.push_back(word);
        };
        body::MotionLaws::for_each([&]<class Law>() { add(Law::word, Law::brief, law_table<Law>); });
        add("wave_maker", "A paddle that makes waves.", wave_maker_table);
        made.keys.push_back(key_or("start", {number(dimension::time, non_negative())}, Value::of(0.0),
                                   "The law's t counts from here."));
        made.keys.push_back(optional_key("stop", {number(dimension::time, positive())},
                                         "The body rests afterwards; never when not given."));
        made.groups = {one};
        return made;
    }();
    return table;
}

}  // namespace riprap::scene
