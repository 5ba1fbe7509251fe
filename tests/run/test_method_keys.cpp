// SPDX-License-Identifier: Apache-2.0
// Every key of every method, and every word of its choices, changes the result of a case: a key that nothing reads, or
// a word that falls into the default, fails here. Each method has a case in tests/run/methods, SIDE-WORD.toml, whose
// lines that begin with "#@ KEY" say how a key is tried where that does not follow from its kind:
//     #@ KEY try VALUE              this value, instead of one near the default
//     #@ KEY with TABLE.KEY=VALUE   beside another value of other keys, on both sides of the comparison
//     #@ KEY same: REASON           the result must not change
//     #@ KEY steps N                after so many steps
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>

#include "riprap/scene/keys/key_table.hpp"
#include "run/case_result.hpp"

namespace riprap::run {
namespace {

using scene::Form;
using scene::FormKind;
using scene::Key;
using scene::Table;

constexpr int usual_steps = 4;

/// A value to try for a key, and the other assignments that it needs.
struct Trial {
    std::string value;              ///< empty: one near the default
    std::vector<std::string> with;  ///< other assignments
    bool is_same{false};
    int steps{usual_steps};
};

struct MethodCase {
    std::string text;
    std::map<std::string, Trial> trials;
};

MethodCase read_method_case(const std::string& side, std::string_view word) {
    const std::string path = "tests/run/methods/" + side + "-" + std::string(word) + ".toml";
    std::ifstream file(path);
    EXPECT_TRUE(file.good()) << "a case is wanted in which every key of the method acts: " << path;
    MethodCase found;
    for (std::string line; std::getline(file, line);) {
        found.text += line + "\n";
        std::istringstream words(line);
        std::string mark, key, what, rest;
        if (!(words >> mark >> key >> what) || mark != "#@") {
            continue;
        }
        Trial& trial = found.trials[key];
        std::getline(words >> std::ws, rest);
        if (what == "try") {
            trial.value = rest;
        } else if (what == "with") {
            trial.with.push_back(rest);
        } else if (what == "steps") {
            trial.steps = std::stoi(rest);
        } else {
            EXPECT_TRUE(what == "same:" && !rest.empty()) << path << ": " << line;
            trial.is_same = true;
        }
    }
    return found;
}

std::string near_number(const Form& form, double value, bool is_integer) {
    const double low = std::max(form.range.low, -1e9), high = std::min(form.range.high, 1e9);
    const double step = is_integer ? 1 : value != 0 ? 0.1 * value : std::min(0.1, 0.1 * high);
    const double other = form.range.contains(value - step) && value - step != low ? value - step : value + step;
    return is_integer ? std::to_string(static_cast<std::int64_t>(other)) : fmt::format("{:.6g}", other);
}

/// Values to try instead of the default, as a case writes them.
std::vector<std::string> others(const Key& key, const Trial& trial) {
    std::vector<std::string> values;
    if (!trial.value.empty()) {
        values.push_back(trial.value);
    }
    for (const Form& form : key.forms) {
        const scene::Value* otherwise = key.otherwise ? &*key.otherwise : nullptr;
        if (form.kind == FormKind::choice) {
            for (const std::string_view word : form.words) {
                if (otherwise == nullptr || otherwise->text != word) {
                    values.push_back(fmt::format("\"{}\"", word));
                }
            }
        } else if (!trial.value.empty() || otherwise == nullptr) {
            continue;
        } else if (form.kind == FormKind::boolean) {
            values.emplace_back(otherwise->boolean ? "false" : "true");
        } else if ((form.kind == FormKind::number || form.kind == FormKind::integer) && otherwise->is_number()) {
            values.push_back(near_number(form, otherwise->as_number(), form.kind == FormKind::integer));
        } else if (form.kind == FormKind::vector) {
            Vec3 v = scene::to_vector(*otherwise);
            values.push_back(fmt::format("[{}, {}, {}]", v.x + 0.1, v.y, v.z));
        }
    }
    return values;
}

/// Keys that build geometry or records have tests of their own.
bool is_structure(const Key& key) {
    const auto is_table = [](const Form& form) {
        return form.table != nullptr || form.kind == FormKind::list || form.kind == FormKind::path;
    };
    return std::all_of(key.forms.begin(), key.forms.end(), is_table);
}

void try_every_key(const std::string& side, const Table& table) {
    for (const std::string_view method : table.methods) {
        MethodCase one = read_method_case(side, method);
        if (testing::Test::HasFailure()) {
            continue;
        }
        std::map<std::pair<std::vector<std::string>, int>, std::string> plain;  // by what stands beside the key
        for (const Key& key : table.part_of(method).keys) {
            const std::string name(key.name);
            const Trial trial = one.trials[name];
            one.trials.erase(name);
            if (name == "method" || is_structure(key)) {
                continue;
            }
            const std::vector<std::string> values = others(key, trial);
            EXPECT_FALSE(values.empty()) << method << ": " << name << " wants a line '#@ " << name << " try VALUE'";
            for (const std::string& value : values) {
                SCOPED_TRACE(fmt::format("{}, {} = {}", method, name, value));
                try {
                    std::string& without = plain[{trial.with, trial.steps}];
                    without = without.empty() ? result_of(one.text, trial.with, trial.steps) : without;
                    std::vector<std::string> assignments = trial.with;
                    assignments.push_back(fmt::format("{}.{}={}", side, name, value));
                    const std::string with = result_of(one.text, assignments, trial.steps);
                    EXPECT_EQ(with == without, trial.is_same) << (trial.is_same ? "it acts" : "nothing reads it");
                } catch (const std::exception& error) {
                    ADD_FAILURE() << error.what();
                }
            }
        }
        for (const auto& [name, trial] : one.trials) {
            ADD_FAILURE() << method << " has no key '" << name << "'";
        }
    }
}

/// A value of the key of a condition under which the condition does not hold; with it what the key is tried with.
std::vector<std::string> broken(const std::string& side, const KeyCondition& condition, const Key& other,
                                const Trial& trial) {
    std::vector<std::string> values = others(other, trial);
    values.push_back(condition.words.empty() ? fmt::format("{:.1f}", condition.above) : excerpt(*other.otherwise));
    const auto breaks = [&condition](const std::string& value) {
        const auto is_value = [&value](std::string_view word) {
            return value == word || value == fmt::format("\"{}\"", word);
        };
        return condition.words.empty() ? value == fmt::format("{:.1f}", condition.above)
                                       : std::ranges::none_of(condition.words, is_value);
    };
    const auto value = std::ranges::find_if(values, breaks);
    EXPECT_NE(value, values.end()) << condition.key;
    std::vector<std::string> assignments = trial.with;
    assignments.push_back(fmt::format("{}.{}={}", side, condition.key, *value));
    return assignments;
}

bool is_told(const std::string& text, const std::vector<std::string>& assignments, const std::string& key) {
    const auto warnings = scene::read_case_text(text, "case.toml", "/nonexistent", assignments).warnings;
    return std::ranges::any_of(warnings, [&key](const std::string& warning) {
        return warning.find("'" + key + "' of ") != std::string::npos &&
               warning.find("does nothing here") != std::string::npos;
    });
}

/// Where a condition of a key does not hold, the key changes no result, and a warning says so.
void try_every_condition(const std::string& side, const Table& table) {
    for (const std::string_view method : table.methods) {
        MethodCase one = read_method_case(side, method);
        const Table part = table.part_of(method);
        for (const Key& key : part.keys) {
            for (const KeyCondition& condition : key.conditions) {
                SCOPED_TRACE(fmt::format("{}, {} with {}", method, key.name, condition.key));
                const Key* other = part.find(condition.key);
                ASSERT_NE(other, nullptr);
                Trial trial = one.trials[std::string(key.name)];
                const std::string name(key.name), value = others(key, trial).front();
                const std::string given = fmt::format("{}.{}={}", side, name, value);
                trial.with.push_back(given);
                EXPECT_FALSE(is_told(one.text, trial.with, name));
                std::vector<std::string> without =
                    broken(side, condition, *other, one.trials[std::string(condition.key)]);
                std::vector<std::string> with = without;
                with.push_back(given);
                EXPECT_TRUE(is_told(one.text, with, name));
                EXPECT_EQ(result_of(one.text, with, trial.steps), result_of(one.text, without, trial.steps))
                    << "it acts";
            }
        }
    }
}

TEST(MethodKeys, whose_condition_does_not_hold_change_nothing_and_are_told) {
    try_every_condition("solid", scene::solid_table());
    try_every_condition("fluid", scene::fluid_table());
}

TEST(MethodKeys, every_key_and_word_of_a_solid_method_changes_the_result) {
    try_every_key("solid", scene::solid_table());
}

TEST(MethodKeys, every_key_and_word_of_a_fluid_method_changes_the_result) {
    try_every_key("fluid", scene::fluid_table());
}

}  // namespace
}  // namespace riprap::run
