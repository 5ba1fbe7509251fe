// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/keys/keys_vary.hpp"

namespace riprap::scene {

using namespace form;

namespace {

constexpr std::int64_t most_values = 1000, most_keys = 64;

const Table& vary_expect_table() {
    static const Table table{"vary.expect",
                             "[[vary.expect]]",
                             "What an expected answer is at each of the values; its tolerance stays. Answers that are "
                             "not listed stay as they "
                             "are.",
                             {{"name", {text()}, "Name of an [[expect]] that gives a 'value'.", {}, true},
                              {"values",
                               {list(number(dimension::plain), 1, most_values)},
                               "The expected number at each value, in SI.",
                               {},
                               true}}};
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
         {"rows",
          {list(list(number(dimension::plain), 1, most_keys), 1, most_values)},
          "Of several keys: a row with a value of each for every run, in SI.",
          {}},
         {"full", {boolean()}, "Only with `riprap validate --full`: for runs that take long.", Value::of(false)},
         {"expect", {table_list(vary_expect_table)}, "What the expected answers are then.", Value::array()}},
        {{GroupRule::exactly_one, {"values", "rows"}}}};
    return table;
}

}  // namespace riprap::scene
