// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/keys/keys_vary.hpp"

#include <utility>

namespace riprap::scene {

using namespace form;

namespace {

constexpr std::int64_t most_values = 1000, most_keys = 64;

const Table& vary_expect_table() {
    static const Table table{
        "vary.expect",
        "[[vary.expect]]",
        "What an expected answer is at each of the values. Answers that are "
        "not listed stay as they "
        "are.",
        {{"name", {text()}, "Name of an [[expect]] that gives a 'value'.", {}, true},
         {"values",
          {list(number(dimension::plain), 1, most_values)},
          "The expected number at each value, in SI.",
          {},
          true},
         {"tolerances",
          {list(number(dimension::plain, non_negative()), 1, most_values)},
          "The accepted absolute error at each value, in SI; that of the [[expect]] when not given.",
          {}}}};
    return table;
}

/// The keys of a band about a number that runs give together.
std::vector<Key> comparison_keys(std::string name_help) {
    return {{"name", {text()}, std::move(name_help), {}, true},
            {"value", {number(dimension::plain)}, "The expected number.", {}},
            {"tolerance", {number(dimension::plain, non_negative())}, "Accepted absolute error.", {}},
            {"low", {number(dimension::plain)}, "Lower end of the accepted band.", {}},
            {"high", {number(dimension::plain)}, "Upper end of the accepted band.", {}},
            {"citation", {text()}, "Source of the value: a formula, a paper, an experiment.", {}, true}};
}

std::vector<Group> comparison_groups() {
    return {{GroupRule::exactly_one, {"value", "low"}},
            {GroupRule::all_or_none, {"value", "tolerance"}},
            {GroupRule::all_or_none, {"low", "high"}}};
}

const Table& vary_ratio_table() {
    static const Table table{
        "vary.ratio", "[[vary.ratio]]",
        "An answer of each of the runs over that of the case as it stands, which `riprap validate` "
        "judges: what must not depend on the key, or by a known factor.",
        comparison_keys("Name of an [[expect]]."), comparison_groups()};
    return table;
}

const Table& vary_order_table() {
    static const Table table{"vary.order", "[[vary.order]]",
                             "The order of convergence over the runs, at least two, which `riprap validate` judges: "
                             "the slope of log |answer "
                             "- value| over log of the first key by least squares.",
                             comparison_keys("Name of an [[expect]] that gives a 'value'."), comparison_groups()};
    return table;
}

}  // namespace

const Table& vary_table() {
    static const Table table{
        "vary",
        "[[vary]]",
        "Values at which `riprap matrix` and `riprap validate` run the case again, one run each and one [[vary]] at a "
        "time. `riprap run` keeps what the case says.",
        {{"name", {text()}, "What the runs are called; the key when not given.", {}},
         {"key",
          {text(), list(text(), 1, most_keys)},
          "Which: the path as for --set, such as \"body.gate.density\" or \"gravity.0\"; or several of them, for rows.",
          {},
          true},
         {"values", {list(number(dimension::plain), 1, most_values)}, "Values of the key, in SI.", {}},
         {"words", {list(text(), 1, most_values)}, "Texts for the key, such as the words of methods.", {}},
         {"rows",
          {list(list(number(dimension::plain), 1, most_keys), 1, most_values)},
          "Of several keys: a row with a value of each for every run, in SI.",
          {}},
         {"full", {boolean()}, "Only with `riprap validate --full`: for runs that take long.", Value::of(false)},
         {"expect", {table_list(vary_expect_table)}, "What the expected answers are then.", Value::array()},
         {"ratio", {table_list(vary_ratio_table)}, "Answers over those of the case as it stands.", Value::array()},
         {"order", {table_list(vary_order_table)}, "Orders of convergence.", Value::array()}},
        {{GroupRule::exactly_one, {"values", "words", "rows"}}}};
    return table;
}

}  // namespace riprap::scene
