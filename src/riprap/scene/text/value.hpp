// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "riprap/core/error.hpp"
#include "riprap/core/vec3.hpp"

namespace riprap::scene {

/// A TOML value. Dates and times are refused by the reader: no key takes one.
enum class ValueKind { none, boolean, integer, number, text, array, table };

struct Entry;

/// One value of a case file with the place it was read from. The tree is independent of the TOML library, so that
/// checking, overriding, resolving and writing need not include it.
struct Value {
    ValueKind kind{ValueKind::none};
    SourcePlace place;
    bool boolean{false};
    std::int64_t integer{0};
    double number{0};
    std::string text;
    std::vector<Value> items;    ///< of an array
    std::vector<Entry> entries;  ///< of a table, in the order of the file

    static Value of(bool v);
    static Value of(std::int64_t v);
    static Value of(int v);
    static Value of(double v);
    static Value of(std::string_view v);
    static Value of(const char* v);
    static Value of(const Vec3& v);
    static Value array();
    static Value table();

    bool is_table() const { return kind == ValueKind::table; }
    bool is_array() const { return kind == ValueKind::array; }
    bool is_text() const { return kind == ValueKind::text; }
    bool is_number() const { return kind == ValueKind::number || kind == ValueKind::integer; }
    /// The number of an integer or a number.
    double as_number() const { return kind == ValueKind::integer ? static_cast<double>(integer) : number; }

    const Value* find(std::string_view key) const;  ///< null when the table has no such key
    Value* find(std::string_view key);
    /// Sets or replaces a key of a table and returns the stored value.
    Value& set(std::string_view key, Value value, SourcePlace key_place = {});

 private:
    static Value with_kind(ValueKind kind);
};

/// A key of a table, where it stands, and its value.
struct Entry {
    std::string key;
    SourcePlace place;
    Value value;
};

/// "a number", "a table", ... for messages.
std::string_view describe(ValueKind kind);

/// The value as a reader would write it, at most ~40 characters, for messages.
std::string excerpt(const Value& value);

/// One canonical TOML text of a table: scalars first, then tables; numbers in the shortest form that reads back to
/// the same bits. `parse_toml(write_toml(v))` equals v but for places.
std::string write_toml(const Value& table);

/// Writes a table as JSON, indented by two blanks.
std::string write_json(const Value& value);

/// Shortest decimal text that reads back to the same double, always with '.', 'e', "inf" or "nan" in it.
std::string number_text(double value);

// The functions below read values that have passed the key table: a missing key is a bug of Riprap, not of the case.

const Value& get(const Value& table, std::string_view key);  ///< @throws InternalError
double get_number(const Value& table, std::string_view key);
std::int64_t get_integer(const Value& table, std::string_view key);
bool get_boolean(const Value& table, std::string_view key);
const std::string& get_text(const Value& table, std::string_view key);
Vec3 get_vector(const Value& table, std::string_view key);
Vec3 to_vector(const Value& array);
double get_number_or(const Value& table, std::string_view key, double otherwise);

}  // namespace riprap::scene
