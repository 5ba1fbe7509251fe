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
        {required_key("name", {text()}, "Name of an [[expect]] that gives a 'value'."),
         required_key("values", {list(number(dimension::plain), 1, most_values)},
                      "The expected number at each value, in SI."),
         optional_key("tolerances", {list(number(dimension::plain, non_negative()), 1, most_values)},
                      "The accepted absolute error at each value, in SI; that of the [[expect]] when not given.")}};
    return table;
}

/// The keys of a band about a number that runs give together.
std::vector<Key> comparison_keys(std::string name_help) {
    return {required_key("name", {text()}, std::move(name_help)),
            optional_key("value", {number(dimension::plain)}, "The expected number."),
            optional_key("tolerance", {number(dimension::plain, non_negative())}, "Accepted absolute error."),
            optional_key("low", {number(dimension::plain)}, "Lower end of the accepted band."),
            optional_key("high", {number(dimension::plain)}, "Upper end of the accepted band."),
            required_key("citation", {text()}, "Source of the value: a formula, a paper, an experiment.")};
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
        {optional_key("name", {text()}, "What the runs are called; the key when not given."),
         required_key("key", {text(), list(text(), 1, most_keys)},
                      "Which: the path as for --set, such as \"body.gate.density\" or \"gravity.0\"; or several of "
                      "them, for rows and words."),
         optional_key("values", {list(number(dimension::plain), 1, most_values)}, "Values of the key, in SI."),
         optional_key("words", {list(text(), 1, most_values)},
                      "Texts for the key, such as the words of methods; of several keys the same for all."),
         optional_key("rows", {list(list(number(dimension::plain), 1, most_keys), 1, most_values)},
                      "Of several keys: a row with a value of each for every run, in SI."),
         key_or("full", {boolean()}, Value::of(false), "Only with `riprap validate --full`: for runs that take long."),
         key_or("expect", {table_list(vary_expect_table)}, Value::array(), "What the expected answers are then."),
         key_or("ratio", {table_list(vary_ratio_table)}, Value::array(),
                "Answers over those of the case as it stands."),
         key_or("order", {table_list(vary_order_table)}, Value::array(), "Orders of convergence.")},
        {{GroupRule::exactly_one, {"values", "words", "rows"}}}};
    return table;
}

}  // namespace riprap::scene
