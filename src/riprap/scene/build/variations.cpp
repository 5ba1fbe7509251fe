// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/build/variations.hpp"

#include <fmt/format.h>

#include <optional>

#include "riprap/scene/keys/check_keys.hpp"
#include "riprap/scene/keys/key_table.hpp"
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
std::vector<std::vector<double>> rows_of(const Value& vary) {
    std::vector<std::vector<double>> rows;
    for (const Value& value : list_of(vary, "values").items) {
        rows.push_back({value.as_number()});
    }
    for (const Value& row : list_of(vary, "rows").items) {
        std::vector<double>& values = rows.emplace_back();
        for (const Value& value : row.items) {
            values.push_back(value.as_number());
        }
    }
    return rows;
}

std::string label_of(const Value& vary, const std::vector<std::string>& keys, const std::vector<double>& row,
                     std::size_t count) {
    const Value* name = vary.find("name");
    if (name != nullptr && count == 1) {
        return name->text;
    }
    return fmt::format("{} = {:.6g}", name != nullptr ? name->text : keys.front(), row.front());
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
        if (values.items.size() != runs) {
            problems.push_back({values.place, fmt::format("{} expected values for {} runs", values.items.size(), runs),
                                "one for each run"});
        }
    }
}

/// Adds the runs of one [[vary]]; its answers must be there.
void add_runs(const Value& vary, const Value& checked, std::vector<Variation>& runs) {
    const std::vector<std::string> keys = keys_of(vary);
    const std::vector<std::vector<double>> rows = rows_of(vary);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        Variation run{label_of(vary, keys, rows[i], rows.size()), {}, get_boolean(vary, "full")};
        for (std::size_t k = 0; k < keys.size(); ++k) {
            run.overrides.push_back(fmt::format("{}={}", keys[k], number_text(rows[i][k])));
        }
        for (const Value& answer : list_of(vary, "expect").items) {
            const std::optional<std::size_t> expect = expect_called(checked, get_text(answer, "name"));
            if (expect) {
                run.overrides.push_back(fmt::format("expect.{}.value={}", *expect,
                                                    number_text(get(answer, "values").items[i].as_number())));
            }
        }
        runs.push_back(std::move(run));
    }
}

}  // namespace

std::vector<Variation> variations_of(const Value& checked) {
    std::vector<Variation> runs;
    for (const Value& vary : list_of(checked, "vary").items) {
        add_runs(vary, checked, runs);
    }
    return runs;
}

void check_variations(const Value& checked, const Value& root, bool is_planar, std::vector<Diagnostic>& problems) {
    for (const Value& vary : list_of(checked, "vary").items) {
        const std::vector<std::string> keys = keys_of(vary);
        const std::vector<std::vector<double>> rows = rows_of(vary);
        const std::size_t before = problems.size();
        for (const std::vector<double>& row : rows) {
            if (row.size() != keys.size()) {
                problems.push_back({get(vary, "key").place,
                                    fmt::format("a row of {} values for {} keys", row.size(), keys.size()),
                                    "as many values in each row as keys; 'values' for one key"});
                break;
            }
        }
        check_answers(vary, checked, rows.size(), problems);
        if (problems.size() > before) {
            continue;
        }
        std::vector<Variation> runs;
        add_runs(vary, checked, runs);
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
