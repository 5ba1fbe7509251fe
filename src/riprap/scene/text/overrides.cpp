// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "riprap/scene/text/limits.hpp"
#include "riprap/scene/text/override_paths.hpp"
#include "riprap/scene/text/suggest.hpp"
#include "riprap/scene/text/toml_reader.hpp"

namespace riprap::scene {

namespace {

void place_all(Value& value, const SourcePlace& place) {
    value.place = place;
    for (Value& item : value.items) {
        place_all(item, place);
    }
    for (Entry& entry : value.entries) {
        entry.place = place;
        place_all(entry.value, place);
    }
}

/// The value of an assignment: TOML, or a text where it is a bare word or quantity such as `auto` or `1 ms`.
Value read_value(const std::string& text, const SourcePlace& place, std::vector<Diagnostic>& problems) {
    std::vector<Diagnostic> toml_problems;
    const bool has_line_break = text.find('\n') != std::string::npos;
    const Value parsed = parse_toml("value = " + text, place.file, toml_problems);
    if (toml_problems.empty() && !has_line_break && parsed.entries.size() == 1 && parsed.find("value") != nullptr) {
        Value value = *parsed.find("value");
        place_all(value, place);
        return value;
    }
    const bool is_word = !text.empty() && text.size() <= limits::text_bytes &&
                         text.find_first_of("\"'[]{}#=\n") == std::string::npos &&
                         std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c < 0x7F; });
    if (!is_word) {
        problems.push_back({place, fmt::format("'{}' is not a TOML value", text.substr(0, 80)),
                            "for example 0.4, true, \"text\", [1, 2, 3]"});
        return {};
    }
    Value value = Value::of(text);
    value.place = place;
    return value;
}

/// Returns the entries that a step which names no entry of `list` could have meant.
std::string what_entries(const Value& list, const std::string& step) {
    constexpr std::size_t most = 8;
    std::vector<std::string> names;
    for (const Value& item : list.items) {
        if (const Value* name = item.find("name")) {
            names.push_back(name->text);
        }
    }
    if (const std::string meant = nearest(step, names); !meant.empty()) {
        return fmt::format("did you mean '{}'?", meant);
    }
    const bool is_long = names.size() > most;
    names.resize(std::min(names.size(), most));
    return fmt::format("entries are chosen by their number, from 0{}{}{}",
                       names.empty() ? "" : ", or name: ", fmt::join(names, ", "), is_long ? " and more" : "");
}

/// Returns the keys of `table` that a step which is none of them could have meant.
std::string what_keys(const Value& table, const std::string& step) {
    std::vector<std::string> names;
    for (const Entry& entry : table.entries) {
        names.push_back(entry.key);
    }
    const std::string meant = nearest(step, names);
    return meant.empty() ? fmt::format("one of: {}", fmt::join(names, ", ")) : fmt::format("did you mean '{}'?", meant);
}

/// A key given with a unit suffix ("spacing_mm") replaces the same key with another suffix or none.
void set_key(Value& table, const std::string& key, Value value, const SourcePlace& place) {
    std::erase_if(table.entries,
                  [&](const Entry& entry) { return entry.key != key && gives_the_same(key, entry.key); });
    table.set(key, std::move(value), place);
}

}  // namespace

void apply_override(Value& root, const std::string& assignment, std::vector<Diagnostic>& problems) {
    const SourcePlace place{fmt::format("--set {}", assignment.substr(0, 80)), 0, 0};
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos || equals == 0) {
        problems.push_back({place, "it is not an assignment", "write --set path.to.key=value"});
        return;
    }
    const std::vector<std::string> steps = split_path(std::string_view(assignment).substr(0, equals));
    if (std::any_of(steps.begin(), steps.end(), [](const std::string& s) { return s.empty(); }) ||
        steps.size() > static_cast<std::size_t>(limits::key_segments)) {
        problems.push_back({place, "the path has empty or too many steps", "write --set path.to.key=value"});
        return;
    }
    Value value = read_value(assignment.substr(equals + 1), place, problems);
    if (value.kind == ValueKind::none) {
        return;
    }
    Value* at = &root;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        if (at->is_array()) {
            const std::optional<std::size_t> entry = find_entry(*at, steps, i);
            if (!entry) {
                problems.push_back(
                    {place, fmt::format("the list has no entry '{}'", steps[i]), what_entries(*at, steps[i])});
                return;
            }
            at = &at->items[*entry];
            if (i + 1 == steps.size()) {
                *at = std::move(value);
                return;
            }
            continue;
        }
        if (i + 1 == steps.size()) {
            break;
        }
        if (!at->is_table()) {
            problems.push_back({place, fmt::format("there is no key '{}' in {}", steps[i], describe(at->kind)), ""});
            return;
        }
        Value* next = at->find(steps[i]);
        if (next == nullptr && i == 1 && steps[0] == "material") {
            // A new one would be a material that nothing is made of: the values meant for another go unread.
            problems.push_back({place, fmt::format("there is no material '{}'", steps[i]), what_keys(*at, steps[i])});
            return;
        }
        if (next == nullptr) {
            Value table = Value::table();
            table.place = place;
            next = &at->set(steps[i], std::move(table), place);
        }
        at = next;
    }
    if (at->is_table()) {
        set_key(*at, steps.back(), std::move(value), place);
    } else {
        problems.push_back({place, fmt::format("there is no key '{}' in {}", steps.back(), describe(at->kind)), ""});
    }
}

}  // namespace riprap::scene
