// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/text/value.hpp"

#include <fmt/format.h>

#include <cmath>

namespace riprap::scene {

Value Value::with_kind(ValueKind kind) {
    Value value;
    value.kind = kind;
    return value;
}

Value Value::array() { return with_kind(ValueKind::array); }
Value Value::table() { return with_kind(ValueKind::table); }
Value Value::of(int v) { return of(static_cast<std::int64_t>(v)); }
Value Value::of(const char* v) { return of(std::string_view(v)); }

Value Value::of(bool v) {
    Value value = with_kind(ValueKind::boolean);
    value.boolean = v;
    return value;
}

Value Value::of(std::int64_t v) {
    Value value = with_kind(ValueKind::integer);
    value.integer = v;
    return value;
}

Value Value::of(double v) {
    Value value = with_kind(ValueKind::number);
    value.number = v;
    return value;
}

Value Value::of(std::string_view v) {
    Value value = with_kind(ValueKind::text);
    value.text = std::string(v);
    return value;
}

Value Value::of(const Vec3& v) {
    Value value = with_kind(ValueKind::array);
    value.items = {of(v.x), of(v.y), of(v.z)};
    return value;
}

const Value* Value::find(std::string_view key) const {
    for (const Entry& entry : entries) {
        if (entry.key == key) {
            return &entry.value;
        }
    }
    return nullptr;
}

Value* Value::find(std::string_view key) {
    for (Entry& entry : entries) {
        if (entry.key == key) {
            return &entry.value;
        }
    }
    return nullptr;
}

Value& Value::set(std::string_view key, Value value, SourcePlace key_place) {
    for (Entry& entry : entries) {
        if (entry.key == key) {
            entry.place = std::move(key_place);
            entry.value = std::move(value);
            return entry.value;
        }
    }
    entries.push_back({std::string(key), std::move(key_place), std::move(value)});
    return entries.back().value;
}

std::string_view describe(ValueKind kind) {
    switch (kind) {
        case ValueKind::none:
            return "nothing";
        case ValueKind::boolean:
            return "true or false";
        case ValueKind::integer:
            return "an integer";
        case ValueKind::number:
            return "a number";
        case ValueKind::text:
            return "a text";
        case ValueKind::array:
            return "an array";
        case ValueKind::table:
            return "a table";
    }
    return "nothing";
}

std::string number_text(double value) {
    if (std::isnan(value)) {
        return "nan";
    }
    if (std::isinf(value)) {
        return value > 0 ? "inf" : "-inf";
    }
    std::string text = fmt::format("{}", value);
    if (text.find_first_of(".en") == std::string::npos) {
        text += ".0";
    }
    return text;
}

std::string excerpt(const Value& value) {
    constexpr std::size_t longest = 40;
    std::string text;
    switch (value.kind) {
        case ValueKind::array:
            text = "[";
            for (std::size_t i = 0; i < value.items.size() && text.size() < longest; ++i) {
                text += (i > 0 ? ", " : "") + excerpt(value.items[i]);
            }
            text += "]";
            break;
        case ValueKind::table:
            return "a table";
        case ValueKind::text:
            text = '"' + value.text + '"';
            break;
        case ValueKind::boolean:
            return value.boolean ? "true" : "false";
        case ValueKind::integer:
            return std::to_string(value.integer);
        case ValueKind::number:
            return number_text(value.number);
        case ValueKind::none:
            return "nothing";
    }
    if (text.size() > longest) {
        std::size_t cut = longest - 3;
        while (cut > 0 && (static_cast<unsigned char>(text[cut]) & 0xC0U) == 0x80U) {
            --cut;  // never cut within a UTF-8 character
        }
        text = text.substr(0, cut) + "...";
    }
    return text;
}

const Value& get(const Value& table, std::string_view key) {
    const Value* value = table.find(key);
    if (value == nullptr) {
        throw InternalError(fmt::format("the key table has no '{}' where the scene reader asks for it", key));
    }
    return *value;
}

double get_number(const Value& table, std::string_view key) { return get(table, key).as_number(); }
std::int64_t get_integer(const Value& table, std::string_view key) { return get(table, key).integer; }
bool get_boolean(const Value& table, std::string_view key) { return get(table, key).boolean; }
const std::string& get_text(const Value& table, std::string_view key) { return get(table, key).text; }
Vec3 get_vector(const Value& table, std::string_view key) { return to_vector(get(table, key)); }

Vec3 to_vector(const Value& array) {
    Vec3 v{};
    for (std::size_t i = 0; i < array.items.size() && i < 3; ++i) {
        v[static_cast<int>(i)] = array.items[i].as_number();
    }
    return v;
}

double get_number_or(const Value& table, std::string_view key, double otherwise) {
    const Value* value = table.find(key);
    return value == nullptr ? otherwise : value->as_number();
}

}  // namespace riprap::scene
