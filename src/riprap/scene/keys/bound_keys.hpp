// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "riprap/core/key.hpp"
#include "riprap/scene/keys/key_table.hpp"

namespace riprap::scene {

/// The row of the key table that a bound key makes.
/// @param otherwise  its default; nothing where there is none
Key key_of(const KeyRow& row, const KeyValue& otherwise);

/// The value of a bound key in a resolved case.
KeyValue key_value(const Value& given, KeyKind kind);

/// Rows of the key table, with the values of a default-constructed S as defaults.
template <class S>
std::vector<Key> rows_of(const KeyList<S>& keys) {
    const S defaults{};
    std::vector<Key> rows;
    for (const BoundKey<S>& key : keys) {
        rows.push_back(key_of(key.row, key.get(defaults)));
    }
    return rows;
}

/// Fills the members of the keys that the resolved `table` has.
template <class S>
void read_keys(const Value& table, const KeyList<S>& keys, S& settings) {
    for (const BoundKey<S>& key : keys) {
        if (const Value* given = table.find(key.row.name)) {
            key.set(settings, key_value(*given, key.row.kind));
        }
    }
}

/// A key of settings that a case has filled.
struct FilledKey {
    KeyRow row;
    KeyValue value;
    bool is_default{false};
};

template <class S>
std::vector<FilledKey> filled_keys(const KeyList<S>& keys, const S& settings) {
    const S defaults{};
    std::vector<FilledKey> filled;
    for (const BoundKey<S>& key : keys) {
        const KeyValue value = key.get(settings);
        filled.push_back({key.row, value, value == key.get(defaults)});
    }
    return filled;
}

/// Warns of keys that have another value than their default while a condition of theirs does not hold.
/// @param table   resolved, with the places of the values
/// @param header  "[solid]"
void warn_of_unread_keys(const Value& table, std::string_view header, std::span<const FilledKey> keys,
                         std::vector<std::string>& warnings);

}  // namespace riprap::scene
