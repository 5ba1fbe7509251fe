// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/keys/bound_keys.hpp"

namespace riprap::scene {

namespace {

std::vector<Form> forms_of(const KeyRow& row) {
    switch (row.kind) {
        case KeyKind::boolean:
            return {form::boolean()};
        case KeyKind::integer:
            return {form::integer(row.range.low, row.range.high)};
        case KeyKind::choice:
            return {form::choice(row.words)};
        case KeyKind::vector:
            return {form::vector(row.dimension, row.range)};
        case KeyKind::number:
            break;
    }
    const Form number = form::number(row.dimension, row.range);
    return row.words.empty() ? std::vector{number} : std::vector{form::choice(row.words), number};
}

struct ToValue {
    Value operator()(std::monostate) const { return {}; }
    Value operator()(const std::string& word) const { return Value::of(std::string_view(word)); }
    template <class T>
    Value operator()(const T& value) const {
        return Value::of(value);
    }
};

}  // namespace

Key key_of(const KeyRow& row, const KeyValue& otherwise) {
    Key key{row.name, forms_of(row), std::string(row.help), std::nullopt, row.is_required};
    if (row.is_required) {
        return key;
    }
    if (!std::holds_alternative<std::monostate>(otherwise)) {
        key.otherwise = std::visit(ToValue{}, otherwise);
    } else if (!row.words.empty()) {
        key.otherwise = Value::of(row.words.front());  // "auto"
    }
    return key;
}

KeyValue key_value(const Value& given, KeyKind kind) {
    switch (kind) {
        case KeyKind::boolean:
            return given.boolean;
        case KeyKind::integer:
            return given.integer;
        case KeyKind::choice:
            return given.text;
        case KeyKind::vector:
            return to_vector(given);
        case KeyKind::number:
            return given.is_text() ? KeyValue() : KeyValue(given.as_number());
    }
    return {};
}

}  // namespace riprap::scene
