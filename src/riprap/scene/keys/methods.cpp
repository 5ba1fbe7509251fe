// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/keys/methods.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace riprap::scene {

namespace {

bool is_same_row(const Key& a, const Key& b) {
    const auto text = [](const Key& key) { return key.otherwise ? excerpt(*key.otherwise) : ""; };
    return a.name == b.name && a.forms == b.forms && a.help == b.help && a.is_required == b.is_required &&
           text(a) == text(b);
}

void add_row(std::vector<Key>& rows, Key row, std::string_view method) {
    const auto same =
        std::find_if(rows.begin(), rows.end(), [&row](const Key& other) { return is_same_row(row, other); });
    if (same != rows.end()) {
        same->methods.push_back(method);
        return;
    }
    row.methods = {method};
    rows.push_back(std::move(row));
}

const Key& scene_key(const std::vector<Key>& scene_keys, std::string_view name) {
    for (const Key& key : scene_keys) {
        if (key.name == name) {
            return key;
        }
    }
    throw InternalError(fmt::format("a method names '{}' among its scene_keys, and scene/ has no such key", name));
}

}  // namespace

Table with_methods(Table table, std::string_view question, const std::vector<Method>& methods,
                   const std::vector<Key>& scene_keys) {
    std::string help(question);
    for (const Method& method : methods) {
        if (std::find(table.methods.begin(), table.methods.end(), method.word) != table.methods.end()) {
            throw InternalError(fmt::format("two methods are called '{}'", method.word));
        }
        table.methods.push_back(method.word);
        help += fmt::format("{} {}: {}", table.methods.size() > 1 ? ";" : "", method.word, method.help);
    }
    std::vector<Key> rows;
    for (const Method& method : methods) {
        for (const Key& row : method.keys) {
            add_row(rows, row, method.word);
        }
    }
    for (const Method& method : methods) {
        for (const std::string_view name : method.scene_keys) {
            add_row(rows, scene_key(scene_keys, name), method.word);
        }
    }
    for (Key& row : rows) {
        if (row.methods.size() == methods.size()) {
            row.methods.clear();
        }
    }
    table.keys.insert(table.keys.begin(),
                      {"method", {form::choice(table.methods)}, help + ".", Value::of(table.methods.front())});
    table.keys.insert(table.keys.end(), rows.begin(), rows.end());
    return table;
}

}  // namespace riprap::scene
