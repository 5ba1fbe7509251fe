// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/assemble/variations.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <set>
#include <string>

#include "riprap/scene/keys/check_keys.hpp"
#include "riprap/scene/keys/key_table.hpp"
#include "riprap/scene/text/override_paths.hpp"
#include "riprap/scene/text/suggest.hpp"
#include "riprap/scene/text/toml_reader.hpp"

namespace riprap::scene {

namespace {

const Value none = Value::array();

const Value& list_of(const Value& table, std::string_view key) {
    const Value* list = table.find(key);
    return list != nullptr ? *list : none;
}

std::vector<std::string> keys_of(const Value& vary) {
    const Value& key = get(vary, "key");
    std::vector<std::string> keys;
    if (key.is_text()) {
        keys.push_back(key.text);
    }
    for (const Value& one : key.items) {
        keys.push_back(one.text);
    }
    return keys;
}

/// The values of every key, a row for each run.
std::vector<std::vector<Value>> rows_of(const Value& vary) {
    std::vector<std::vector<Value>> rows;
    for (const Value& value : list_of(vary, "values").items) {
        rows.push_back({value});
    }
    const std::size_t keys = get(vary, "key").is_text() ? 1 : get(vary, "key").items.size();
    for (const Value& word : list_of(vary, "words").items) {
        rows.emplace_back(keys, word);
    }
    for (const Value& row : list_of(vary, "rows").items) {
        rows.push_back(row.items);
    }
    return rows;
}

std::string label_of(const Value& vary, const std::vector<std::string>& keys, const Value& first, std::size_t count) {
    const Value* name = vary.find("name");
    if (name != nullptr && count == 1) {
        return name->text;
    }
    const std::string_view what = name != nullptr ? name->text : keys.front();
    return first.is_text() ? fmt::format("{} = {}", what, first.text)
                           : fmt::format("{} = {:.6g}", what, first.as_number());
}

/// A value as --set takes it; a whole number without a point, as keys of counts want it and others take it.
std::string override_text(const Value& value) {
    if (value.is_text()) {
        return fmt::format("\"{}\"", value.text);
    }
    const double number = value.as_number();
    constexpr double most_whole = 1e15;
    return number == std::trunc(number) && std::abs(number) < most_whole ? fmt::format("{:.0f}", number)
                                                                         : number_text(number);
}

/// Number of the expected answer with a name; nothing where the case has none.
std::optional<std::size_t> expect_called(const Value& checked, const std::string& name) {
    const std::vector<Value>& expects = list_of(checked, "expect").items;
    for (std::size_t i = 0; i < expects.size(); ++i) {
        if (get_text(expects[i], "name") == name) {
            return i;
        }
    }
    return std::nullopt;
}

/// Why a case may not have these values; nothing where it may.
std::optional<Diagnostic> refusal(Value root, const std::vector<std::string>& overrides, bool is_planar) {
    std::vector<Diagnostic> found;
    for (const std::string& assignment : overrides) {
        apply_override(root, assignment, found);
    }
    if (found.empty()) {
        check_keys(root, case_table(), is_planar, found);
    }
    return found.empty() ? std::nullopt : std::optional(found.front());
}

void check_answers(const Value& vary, const Value& checked, std::size_t runs, std::vector<Diagnostic>& problems) {
    std::vector<std::string> known;
    for (const Value& expect : list_of(checked, "expect").items) {
        known.push_back(get_text(expect, "name"));
    }
    for (const Value& answer : list_of(vary, "expect").items) {
        const Value &name = get(answer, "name"), &values = get(answer, "values");
        const std::optional<std::size_t> expect = expect_called(checked, name.text);
        if (!expect) {
            const std::string meant = nearest(name.text, known);
            problems.push_back(
                {name.place, fmt::format("there is no [[expect]] '{}'", name.text),
                 meant.empty() ? "the name of an [[expect]]" : fmt::format("did you mean '{}'?", meant)});
        } else if (checked.find("expect")->items[*expect].find("value") == nullptr) {
            problems.push_back({name.place,
                                fmt::format("[[expect]] '{}' gives no 'value' that could change", name.text),
                                "a 'value'"});
        }
        const Value* tolerances = answer.find("tolerances");
        for (const Value* list : {&values, tolerances}) {
            if (list != nullptr && list->items.size() != runs) {
                problems.push_back({list->place,
                                    fmt::format("{} expected {} for {} runs", list->items.size(),
                                                list == tolerances ? "tolerances" : "values", runs),
                                    "one for each run"});
            }
        }
        if (tolerances != nullptr && expect && checked.find("expect")->items[*expect].find("tolerance") == nullptr) {
            problems.push_back({tolerances->place, fmt::format("[[expect]] '{}' has no 'tolerance'", name.text),
                                "a 'tolerance' there too"});
        }
    }
}

/// Refuses ratios and orders of answers that the case lacks, and orders without several numbers to fit.
void check_comparisons(const Value& vary, const Value& checked, std::size_t runs, std::vector<Diagnostic>& problems) {
    for (const char* const key : {"ratio", "order"}) {
        for (const Value& one : list_of(vary, key).items) {
            const Value& name = get(one, "name");
            const bool is_order = std::string_view(key) == "order";
            const std::optional<std::size_t> expect = expect_called(checked, name.text);
            if (!expect) {
                problems.push_back(
                    {name.place, fmt::format("there is no [[expect]] '{}'", name.text), "the name of an [[expect]]"});
            } else if (is_order && checked.find("expect")->items[*expect].find("value") == nullptr) {
                problems.push_back({name.place,
                                    fmt::format("[[expect]] '{}' gives no 'value' that could be approached", name.text),
                                    "a 'value'"});
            }
            if (is_order && (runs < 2 || !list_of(vary, "words").items.empty())) {
                problems.push_back({one.place, "an order of convergence takes two numbers of the key or more",
                                    "several 'values' or 'rows'"});
            }
        }
    }
}

/// Adds the runs of one [[vary]]; its answers must be there.
void add_runs(const Value& vary, std::int32_t number, const Value& checked, std::vector<Variation>& runs) {
    const std::vector<std::string> keys = keys_of(vary);
    const std::vector<std::vector<Value>> rows = rows_of(vary);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Value& first = rows[i].front();
        Variation run{label_of(vary, keys, first, rows.size()),
                      {},
                      get_boolean(vary, "full"),
                      number,
                      first.is_text() ? 0 : first.as_number()};
        for (std::size_t k = 0; k < keys.size(); ++k) {
            run.overrides.push_back(fmt::format("{}={}", keys[k], override_text(rows[i][k])));
        }
        for (const Value& answer : list_of(vary, "expect").items) {
            const std::optional<std::size_t> expect = expect_called(checked, get_text(answer, "name"));
            if (expect) {
                run.overrides.push_back(fmt::format("expect.{}.value={}", *expect,
                                                    number_text(get(answer, "values").items[i].as_number())));
                if (const Value* tolerances = answer.find("tolerances")) {
                    run.overrides.push_back(
                        fmt::format("expect.{}.tolerance={}", *expect, number_text(tolerances->items[i].as_number())));
                }
            }
        }
        runs.push_back(std::move(run));
    }
}

}  // namespace

std::vector<Variation> variations_of(const Value& checked) {
    std::vector<Variation> runs;
    const std::vector<Value>& list = list_of(checked, "vary").items;
    for (std::size_t i = 0; i < list.size(); ++i) {
        add_runs(list[i], static_cast<std::int32_t>(i), checked, runs);
    }
    return runs;
}

void check_variations(const Value& checked, const Value& root, bool is_planar, std::vector<Diagnostic>& problems) {
    for (const Value& vary : list_of(checked, "vary").items) {
        const std::vector<std::string> keys = keys_of(vary);
        const std::vector<std::vector<Value>> rows = rows_of(vary);
        const std::size_t before = problems.size();
        std::set<std::string> plain;
        for (const std::string& key : keys) {
            plain.insert(plain_path(root, key));
        }
        if (plain.size() < keys.size()) {
            problems.push_back({get(vary, "key").place, "a key stands twice in one [[vary]]", "each key once"});
        }
        for (const std::vector<Value>& row : rows) {
            if (row.size() != keys.size()) {
                problems.push_back({get(vary, "key").place,
                                    fmt::format("a row of {} values for {} keys", row.size(), keys.size()),
                                    "as many values in each row as keys; 'values' for one key"});
                break;
            }
        }
        check_answers(vary, checked, rows.size(), problems);
        check_comparisons(vary, checked, rows.size(), problems);
        if (problems.size() > before) {
            continue;
        }
        std::vector<Variation> runs;
        add_runs(vary, 0, checked, runs);
        for (const Variation& run : runs) {
            if (const auto refused = refusal(root, run.overrides, is_planar)) {
                problems.push_back(
                    {get(vary, "key").place, fmt::format("{}: {}", run.label, refused->message), refused->allowed});
                break;
            }
        }
    }
}

}  // namespace riprap::scene
