// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "riprap/scene/text/limits.hpp"
#include "riprap/scene/text/suggest.hpp"
#include "riprap/scene/text/toml_reader.hpp"
#include "riprap/scene/text/units.hpp"

namespace riprap::scene {

namespace {

std::vector<std::string> split_path(std::string_view path) {
    std::vector<std::string> steps;
    std::size_t begin = 0;
    while (begin <= path.size()) {
        const std::size_t dot = std::min(path.find('.', begin), path.size());
        steps.emplace_back(path.substr(begin, dot - begin));
        begin = dot + 1;
    }
    return steps;
}

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

/// The entry of a list that steps of a path from `first` on mean, by its number or its name: names may hold dots, the
/// longest that fits counts. `first` becomes the last step that it takes.
Value* list_entry(Value& list, const std::vector<std::string>& steps, std::size_t& first) {
    const std::string& step = steps[first];
    std::size_t index = 0;
    const auto [end, code] = std::from_chars(step.data(), step.data() + step.size(), index);
    if (code == std::errc{} && end == step.data() + step.size()) {
        return index < list.items.size() ? &list.items[index] : nullptr;
    }
    for (std::size_t last = steps.size(); last-- > first;) {
        const std::string called =
            fmt::format("{}", fmt::join(steps.begin() + static_cast<std::ptrdiff_t>(first),
                                        steps.begin() + static_cast<std::ptrdiff_t>(last) + 1, "."));
        for (Value& item : list.items) {
            if (const Value* name = item.find("name"); name != nullptr && name->text == called) {
                first = last;
                return &item;
            }
        }
    }
    return nullptr;
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
    const auto base_of = [](std::string_view k) {
        const auto suffixed = split_unit_suffix(k);
        return suffixed ? suffixed->base : k;
    };
    std::erase_if(table.entries, [&](const Entry& entry) {
        return entry.key != key && (base_of(entry.key) == key || entry.key == base_of(key) ||
                                    (base_of(key) != key && base_of(entry.key) == base_of(key)));
    });
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
            const Value* const list = at;
            at = list_entry(*at, steps, i);
            if (at == nullptr) {
                problems.push_back(
                    {place, fmt::format("the list has no entry '{}'", steps[i]), what_entries(*list, steps[i])});
                return;
            }
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
