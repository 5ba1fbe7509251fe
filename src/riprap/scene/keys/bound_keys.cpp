// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/keys/bound_keys.hpp"

#include <fmt/format.h>

#include <algorithm>

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
        case KeyKind::direction:
            return {form::direction()};
        case KeyKind::axis:
            return {form::axis()};
        case KeyKind::text:
            return {form::text()};
        case KeyKind::name:
            return {form::name()};
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

/// `rolling = "constant" or "spring"`, `density_diffusion above 0`
std::string text_of(const KeyCondition& condition) {
    if (condition.words.empty()) {
        return fmt::format("{} above {}", condition.key, condition.above);
    }
    const bool is_boolean = condition.words.front() == "true" || condition.words.front() == "false";
    const std::string_view quote = is_boolean ? "" : "\"";
    return fmt::format("{} = {}{}{}", condition.key, quote,
                       fmt::join(condition.words, fmt::format("{} or {}", quote, quote)), quote);
}

/// The value of a key as a condition names it: the word of a choice, "auto" for no number.
std::string word_of(const FilledKey& key) {
    if (const auto* word = std::get_if<std::string>(&key.value)) {
        return *word;
    }
    if (const auto* flag = std::get_if<bool>(&key.value)) {
        return *flag ? "true" : "false";
    }
    const bool has_word = std::holds_alternative<std::monostate>(key.value) && !key.row.words.empty();
    return has_word ? std::string(key.row.words.front()) : "";
}

bool holds(const KeyCondition& condition, const FilledKey& key) {
    if (condition.words.empty()) {
        const auto* number = std::get_if<double>(&key.value);
        return number != nullptr && *number > condition.above;
    }
    return std::ranges::find(condition.words, word_of(key)) != condition.words.end();
}

}  // namespace

Key key_of(const KeyRow& row, const KeyValue& otherwise) {
    Key key{row.name, forms_of(row), std::string(row.help), std::nullopt, row.is_required};
    key.conditions = row.conditions;
    for (const KeyCondition& condition : row.conditions) {
        key.help += fmt::format(" Read with {}.", text_of(condition));
    }
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
        case KeyKind::text:
        case KeyKind::name:
            return given.text;
        case KeyKind::vector:
        case KeyKind::direction:
        case KeyKind::axis:
            return to_vector(given);
        case KeyKind::number:
            return given.is_text() ? KeyValue() : KeyValue(given.as_number());
    }
    return {};
}

void warn_of_unread_keys(const Value& table, std::string_view header, std::span<const FilledKey> keys,
                         std::vector<std::string>& warnings) {
    for (const FilledKey& key : keys) {
        const Value* given = table.find(key.row.name);
        if (key.is_default || given == nullptr) {
            continue;
        }
        for (const KeyCondition& condition : key.row.conditions) {
            const auto other = std::ranges::find(keys, condition.key, [](const FilledKey& k) { return k.row.name; });
            if (other == keys.end()) {
                throw InternalError(fmt::format("'{}' of {} is read with '{}', which is no key of the method",
                                                key.row.name, header, condition.key));
            }
            if (!holds(condition, *other)) {
                const std::string now = excerpt(get(table, condition.key));
                warnings.push_back(to_string(Diagnostic{
                    given->place,
                    fmt::format("'{}' of {} does nothing here: {} is {}", key.row.name, header, condition.key, now),
                    "leave it out, or " + text_of(condition)}));
                break;
            }
        }
    }
}

}  // namespace riprap::scene
