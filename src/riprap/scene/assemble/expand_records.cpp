// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/assemble/expand_records.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "riprap/fluid/gauge/gauge.hpp"

namespace riprap::scene {

namespace {

void remove_key(Value& table, std::string_view key) {
    std::erase_if(table.entries, [key](const Entry& entry) { return entry.key == key; });
}

void expand_probe(const Value& probe, Value& list) {
    const Value* quantities = probe.find("quantity");
    if (quantities == nullptr || !quantities->is_array()) {
        list.items.push_back(probe);
        return;
    }
    for (const Value& quantity : quantities->items) {
        Value one = probe;
        one.set("quantity", quantity);
        // A list of one is that one.
        if (Value* name = one.find("name"); name != nullptr && name->is_text() && quantities->items.size() > 1) {
            name->text += '.' + quantity.text;
        }
        list.items.push_back(std::move(one));
    }
}

std::vector<std::string_view> kinds_at_points() {
    std::vector<std::string_view> words;
    for (const fluid::GaugeKind* kind : fluid::gauge_kinds()) {
        if (!has_end(kind->extent)) {
            words.push_back(kind->word);
        }
    }
    return words;
}

/// Gauges that look at a point of a line each.
void expand_gauge(const Value& gauge, Value& list, std::vector<Diagnostic>& problems) {
    const Value* count = gauge.find("count");
    const Value *point = gauge.find("point"), *end = gauge.find("end"), *kind = gauge.find("kind");
    if (count == nullptr || point == nullptr || kind == nullptr) {
        list.items.push_back(gauge);
        return;
    }
    if (end == nullptr) {
        problems.push_back({count->place, "'count' without 'end'", "an 'end': the gauges stand from point to end"});
        return;
    }
    const fluid::GaugeKind* word = fluid::find_gauge_kind(kind->text);
    if (word == nullptr || has_end(word->extent)) {
        problems.push_back({count->place, fmt::format("'count' does nothing for a '{}' gauge", kind->text),
                            fmt::format("a kind at a point: {}", fmt::join(kinds_at_points(), ", "))});
        return;
    }
    const Vec3 from = to_vector(*point), to = to_vector(*end);
    const auto digits = static_cast<int>(std::to_string(count->integer).size());
    for (std::int64_t k = 0; k < count->integer; ++k) {
        Value one = gauge;
        remove_key(one, "count");
        remove_key(one, "end");
        const double part = static_cast<double>(k) / static_cast<double>(count->integer - 1);
        Value place = Value::of((1 - part) * from + part * to);
        place.place = point->place;
        one.set("point", std::move(place));
        if (Value* name = one.find("name"); name != nullptr) {
            name->text = fmt::format("{}_{:0{}}", name->text, k + 1, digits);
        }
        list.items.push_back(std::move(one));
    }
}

}  // namespace

Value expand_records(Value root, std::vector<Diagnostic>& problems) {
    Value* output = root.find("output");
    if (output == nullptr || !output->is_table()) {
        return root;
    }
    for (const char* key : {"probe", "gauge"}) {
        Value* list = output->find(key);
        if (list == nullptr || !list->is_array()) {
            continue;
        }
        const std::vector<Value> entries = std::move(list->items);
        list->items.clear();
        for (const Value& entry : entries) {
            if (key == std::string_view("probe")) {
                expand_probe(entry, *list);
            } else {
                expand_gauge(entry, *list, problems);
            }
        }
    }
    return root;
}

}  // namespace riprap::scene
