// SPDX-License-Identifier: Apache-2.0
// Rows of the key table: output, probes, expected answers.
#include <fmt/format.h>

#include <algorithm>

#include "riprap/io/output/output_kinds.hpp"
#include "riprap/scene/keys/methods.hpp"
#include "riprap/sim/abilities.hpp"
#include "riprap/sim/quantity.hpp"
#include "riprap/sim/reductions.hpp"

namespace riprap::scene {

using namespace form;

namespace {

std::vector<std::string_view> quantity_names() {
    std::vector<std::string_view> names;
    for (const sim::QuantityInfo& quantity : sim::quantities()) {
        if (std::find(names.begin(), names.end(), quantity.name) == names.end()) {
            names.push_back(quantity.name);
        }
    }
    return names;
}

/// The words of kinds of gauges that look at such places.
std::vector<std::string_view> gauge_words(bool (*looks_at)(fluid::GaugeExtent)) {
    std::vector<std::string_view> words;
    for (const fluid::GaugeKind* kind : fluid::gauge_kinds()) {
        if (looks_at(kind->extent)) {
            words.push_back(kind->word);
        }
    }
    return words;
}

std::string gauge_help() {
    std::string help;
    for (const fluid::GaugeKind* kind : fluid::gauge_kinds()) {
        help += fmt::format("{}{}: {}.", help.empty() ? "" : " ", kind->word, kind->help);
    }
    return help;
}

const Table& probe_table() {
    static const Table table{
        "output.probe",
        "[[output.probe]]",
        "A time history in probes.csv. Vectors give the columns NAME.x, NAME.y and NAME.z.",
        {optional_key("name", {form::name()}, "Name of the columns; BODY.QUANTITY when not given."),
         optional_key("body", {text()},
                      "Name of a body, \"NAME[17]\" for one of many; the whole scene when not given."),
         optional_key("at", {vector(dimension::length)},
                      "A point of the body, where it is at the start: position, displacement, distance, velocity and "
                      "speed are then those of this point, which moves, turns and strains with the body. The centre of "
                      "mass when not given."),
         required_key("quantity", {choice(quantity_names()), list(choice(quantity_names()), 1, 32)},
                      "Quantity to record. A list of several makes a probe of each: BODY.QUANTITY, or NAME.QUANTITY "
                      "where there is a name.")}};
    return table;
}

const Table& gauge_table() {
    static const Table table{
        "output.gauge",
        "[[output.gauge]]",
        "An instrument in the water: columns of probes.csv, and a name for [[expect]]. A dry place reads 0.",
        {required_key("name", {form::name()}, "Name of the column; velocities give NAME.x, NAME.y and NAME.z."),
         required_key("kind", {choice(gauge_words([](fluid::GaugeExtent) { return true; }))}, gauge_help()),
         optional_key("body", {text()},
                      fmt::format("Name of a body that it moves and turns with, point and end then being where they "
                                  "are at the start; for {}, whose face it is. Velocities and what is up stay those of "
                                  "the world; beyond the domain it reads 0. Not for {}.",
                                  fmt::join(gauge_words([](auto extent) { return extent == fluid::GaugeExtent::face; }),
                                            " and "),
                                  fmt::join(gauge_words([](auto extent) { return !may_move(extent); }), " and "))),
         required_key("point", {vector(dimension::length)}, "Where; start of the line; a corner."),
         optional_key("end", {vector(dimension::length)},
                      "End of the line; the opposite corner. With a kind that looks at a point only beside count."),
         optional_key("area", {number(dimension::area, positive())},
                      fmt::format("Sensing area, taken as a square; in a planar case the root of it is the length. For "
                                  "{}; as small as the water resolves, two spacings to a side, when not given.",
                                  fmt::join(gauge_words([](auto extent) { return extent == fluid::GaugeExtent::face; }),
                                            " and "))),
         optional_key("response", {number(dimension::time, positive())},
                      "Time of response theta: the instrument shows y with theta dy/dt = reading - y. At once when not "
                      "given."),
         optional_key(
             "count", {integer(2, 1000)},
             "A profile: so many gauges from point to end, NAME_1, NAME_2 and on. For kinds that look at a point.")}};
    return table;
}

std::vector<std::string_view> ability_words() {
    std::vector<std::string_view> words;
    for (const sim::Ability& ability : sim::abilities()) {
        words.push_back(ability.word);
    }
    return words;
}

std::string ability_help() {
    std::string help = "Physics without which no run can give the answer: a case whose methods lack it is refused.";
    for (const sim::Ability& ability : sim::abilities()) {
        help += fmt::format(" {}: {}.", ability.word, ability.help);
    }
    return help;
}

const Table& close_table() {
    static const Table table{
        "expect.close",
        "close = { ... }",
        "A wider band about `value` and the reason for it. `riprap run` still asks for the narrow one.",
        {{"tolerance", {number(dimension::plain, positive())}, "Absolute error, in SI.", {}},
         {"relative_tolerance", {number(dimension::plain, positive())}, "Relative error.", {}},
         {"reason", {text()}, "The property of the method that moves the value, with its size.", {}, true}},
        {{GroupRule::exactly_one, {"tolerance", "relative_tolerance"}}}};
    return table;
}

const Table& curve_table() {
    static const Table table{
        "expect.curve",
        "curve = { ... }",
        "Points of another source, say of an experiment. The quantity is read at the first moment at which `along` is "
        "at each point; what it never reaches has no value. Or, with along = \"place\", the gauges of a profile are "
        "read "
        "at one time, between them by the straight line.",
        {{"file", {path()}, "Table with two columns, along and value, in SI (docs/howto/tables.md).", {}},
         {"points",
          {list(list(number(dimension::plain), 2, 2), 1, 10000)},
          "The same as rows of two numbers, [along, value].",
          {}},
         {"along",
          {text()},
          "Quantity whose values the first column has; \"place\": distances from the first gauge of a profile.",
          Value::of("time")},
         {"shift",
          {number(dimension::plain, non_negative())},
          "Largest constant by which all values may differ from those of the source, in SI: that which makes the error "
          "least is taken off. With quantity = \"time\" it is a time, such as that of a gate.",
          Value::of(0.0)}},
        {{GroupRule::exactly_one, {"file", "points"}}}};
    return table;
}

const Table& waves_table() {
    static const Table table{
        "expect.waves",
        "waves = { ... }",
        "The regular waves that reduce = \"incident\" and \"reflection\" look for in a profile of gauges along their "
        "way.",
        {required_key("period", {number(dimension::time, positive())}, "Period."),
         required_key("length", {number(dimension::length, positive())}, "Wave length, of the theory.")}};
    return table;
}

const Table& damage_table() {
    static const Table table{
        "output.damage",
        "[[output.damage]]",
        "Damage of a layer of armour units: columns NAME.displaced, the units that have moved farther than `distance` "
        "since time 0, and NAME.n_od, that number per strip as wide as the nominal diameter D_n.",
        {required_key("name", {form::name()}, "Name of the columns."),
         required_key("bodies", {list(text(), 1, 64)}, "Names of [[body]] or [[pack]]: all units of each."),
         optional_key("distance", {number(dimension::length, positive())}, "D_n when not given."),
         optional_key("width", {number(dimension::length, positive())},
                      "Width of the layer along the breakwater; a planar scene is one strip.")}};
    return table;
}

}  // namespace

KeyList<sim::OutputSettings> output_keys() {
    using S = sim::OutputSettings;
    return {key::number(&S::interval, "interval", dimension::time, non_negative(), "Between frames; 0 = end/100."),
            key::number(&S::probe_interval, "probe_interval", dimension::time, non_negative(),
                        "Between rows of probes.csv and ledger.csv; 0 = end/1000."),
            key::number(&S::checkpoint_interval, "checkpoint_interval", dimension::time, positive(),
                        "Wall-clock time between checkpoints."),
            key::number(&S::ledger_tolerance, "ledger_tolerance", dimension::plain, above(0, 1),
                        "Share of the energy turned over that the energy ledger may fail to close by; looked at with "
                        "every row of ledger.csv. More ends the run.")};
}

const Table& output_table() {
    static const Table table = [] {
        std::vector<Key> keys = rows_of(output_keys());
        std::ranges::move(rows_of(io::output_keys()), std::back_inserter(keys));
        keys.push_back({"probe", {table_list(probe_table)}, "Time histories.", Value::array()});
        keys.push_back({"gauge", {table_list(gauge_table)}, "Instruments in the water.", Value::array()});
        keys.push_back({"damage", {table_list(damage_table)}, "Damage of armour layers.", Value::array()});
        return Table{"output", "[output]", "Files to write, quantities to watch, and how often.", keys};
    }();
    return table;
}

const Table& expect_table() {
    static const Table table{
        "expect",
        "[[expect]]",
        "An answer that the run must reach. The accepted band is value +- tolerance, value (1 +- relative_tolerance), "
        "or low to high. Reduced values may be taken off each other and divided by each other: a change since an "
        "event, a "
        "time between two events, a ratio.",
        {{"name", {text()}, "Name of the expected answer.", {}, true},
         {"quantity",
          {text()},
          "The name of a probe, or a quantity of the scene or of a body, with its component: \"solid.kinetic\", "
          "\"block.position.x\". \"block[mean].position.x\" is the mean over all blocks of one entry, "
          "\"row,top[mean].position.x\" over those of several, \"disc[mean]\" over "
          "the gauges of a profile; likewise sum, min and max. \"stone[above 0.33].displacement.y\" is the number of "
          "those above a level, in SI; \"grain[front 7 0.005].position.x\" the run-out of a heap: the first value, "
          "from the median on, above which the next width holds fewer. With a curve along = \"place\" the name of a "
          "profile.",
          {},
          true},
         {"reduce",
          {choice({sim::reductions.begin(), sim::reductions.end()})},
          "Reduction of the column to one number. extreme: the lowest or the highest, whichever is farther from zero, "
          "with its sign. time_of_min, time_of_max: the time at which it is lowest or highest. period: the mean time "
          "between two passages of the level `reaches` in one direction. rms, "
          "mean_error, worst: root of the mean square, mean size and largest size of the differences from the points "
          "of "
          "`curve`. noise: the largest difference of a step from the cubic through the two steps before and the two "
          "after it, over the largest size; for equal steps. incident, reflection: amplitude of the `waves` that run "
          "along a profile from its first gauge on, and of those that come back over it, by least squares "
          "(docs/theory/waves.md).",
          Value::of("last")},
         {"relative_to",
          {text()},
          "Another quantity, whose value at the same moment is taken off: the place of a body relative to another, "
          "say.",
          {}},
         {"minus",
          {text()},
          "Name of an earlier [[expect]] whose value is taken off the reduced one: reduce = \"last\" minus an answer "
          "at "
          "\"when\" is the change since that event.",
          {}},
         {"over", {text()}, "Name of an earlier [[expect]] by whose value the result is divided, after `minus`.", {}},
         {"curve", {form::table(curve_table)}, "Points for reduce = \"rms\", \"mean_error\" and \"worst\".", {}},
         {"waves", {form::table(waves_table)}, "Waves for reduce = \"incident\" and \"reflection\".", {}},
         {"from",
          {number(dimension::time, non_negative())},
          "Steps before this time do not count; not for at. With when, the level is passed after it. The start when "
          "not "
          "given.",
          {}},
         {"to",
          {number(dimension::time, positive())},
          "Nor do those after it; the end of the case when not given. What a run with an earlier end does not reach is "
          "not judged; with when, what has not happened yet.",
          {}},
         {"at", {number(dimension::time, non_negative())}, "Time for reduce = \"at\", and of a profile.", {}},
         {"when",
          {text()},
          "For reduce = \"when\": the value is taken at the moment at which this other quantity first passes a level.",
          {}},
         {"reaches",
          {number(dimension::plain)},
          "The level that `when` has to reach, from above or below, in SI; for reduce = \"period\" that of the "
          "quantity "
          "itself, 0 when not given.",
          {}},
         {"value", {number(dimension::plain)}, "The expected number, in SI.", {}},
         {"tolerance", {number(dimension::plain, non_negative())}, "Accepted absolute error, in SI.", {}},
         {"relative_tolerance", {number(dimension::plain, non_negative())}, "Accepted relative error.", {}},
         {"low", {number(dimension::plain)}, "Lower end of the accepted band, in SI.", {}},
         {"high", {number(dimension::plain)}, "Upper end of the accepted band, in SI.", {}},
         {"reported",
          {boolean()},
          "true instead of a band: the value is told and not judged. For what other answers name, and what no source "
          "gives.",
          {}},
         {"published", {number(dimension::plain)}, "What the source prints, where that is not `value`, in SI.", {}},
         {"close",
          {form::table(close_table)},
          "A wider band that a known property of the method explains: `riprap validate` says \"close\" there.",
          {}},
         {"bookkeeping",
          {boolean()},
          "An account that the program has to keep whatever it computes, no comparison with nature or theory.",
          Value::of(false)},
         {"needs", {list(choice(ability_words()), 1, 8)}, ability_help(), {}},
         {"citation", {text()}, "Source of the value: a formula, a paper, an experiment.", {}, true}},
        {{GroupRule::exactly_one, {"value", "low", "reported"}},
         {GroupRule::all_or_none, {"low", "high"}},
         {GroupRule::at_most_one, {"tolerance", "relative_tolerance"}}}};
    return table;
}

}  // namespace riprap::scene
