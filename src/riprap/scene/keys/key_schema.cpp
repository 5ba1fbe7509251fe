// SPDX-License-Identifier: Apache-2.0
// The key table as a JSON Schema.
#include <fmt/format.h>

#include <cmath>

#include "riprap/scene/keys/key_table.hpp"
#include "riprap/scene/keys/key_text.hpp"
#include "riprap/scene/text/limits.hpp"

namespace riprap::scene {

namespace {

Value object(std::initializer_list<std::pair<std::string_view, Value>> members) {
    Value value = Value::table();
    for (const auto& [key, member] : members) {
        value.set(key, member);
    }
    return value;
}

Value type(std::string_view name) { return object({{"type", Value::of(name)}}); }

Value reference(const Table& table) { return object({{"$ref", Value::of(fmt::format("#/$defs/{}", table.id))}}); }

void add_range(Value& schema, const Range& range) {
    if (std::abs(range.low) < 1e308) {
        schema.set(range.is_low_open ? "exclusiveMinimum" : "minimum", Value::of(range.low));
    }
    if (std::abs(range.high) < 1e308) {
        schema.set(range.is_high_open ? "exclusiveMaximum" : "maximum", Value::of(range.high));
    }
}

Value any_of(std::vector<Value> choices) {
    if (choices.size() == 1) {
        return choices.front();
    }
    Value list = Value::array();
    list.items = std::move(choices);
    return object({{"anyOf", list}});
}

/// A number in SI, or a text with a number and a unit.
Value number_schema(const Form& form) {
    Value number = type("number");
    add_range(number, form.range);
    if (form.dimension.is_plain()) {
        return number;
    }
    number.set("description", Value::of(fmt::format("[{}]", si_unit(form.dimension))));
    Value text = type("string");
    text.set("pattern", Value::of(R"(^\s*[-+]?[0-9.]+([eE][-+]?[0-9]+)?\s*[A-Za-z0-9/^*\s-]*$)"));
    return any_of({number, text});
}

Value schema_of(const Form& form);

Value array_schema(Value items, std::int64_t low, std::int64_t high) {
    Value array = type("array");
    array.set("items", std::move(items));
    if (low > 0) {
        array.set("minItems", Value::of(low));
    }
    if (high < std::numeric_limits<std::int64_t>::max()) {
        array.set("maxItems", Value::of(high));
    }
    return array;
}

Value choice_schema(const Form& form) {
    Value words = Value::array();
    for (const std::string_view word : form.words) {
        words.items.push_back(Value::of(word));
    }
    return object({{"enum", words}});
}

Value schema_of(const Form& form) {
    switch (form.kind) {
        case FormKind::boolean:
            return type("boolean");
        case FormKind::integer: {
            Value integer = type("integer");
            integer.set("minimum", Value::of(static_cast<std::int64_t>(form.range.low)));
            integer.set("maximum", Value::of(static_cast<std::int64_t>(form.range.high)));
            return integer;
        }
        case FormKind::number:
            return number_schema(form);
        case FormKind::text:
        case FormKind::path: {
            Value text = type("string");
            text.set("maxLength", Value::of(static_cast<std::int64_t>(limits::text_bytes)));
            return text;
        }
        case FormKind::name: {
            Value name = type("string");
            name.set("pattern", Value::of("^[A-Za-z][A-Za-z0-9_.-]{0,63}$"));
            return name;
        }
        case FormKind::choice:
            return choice_schema(form);
        case FormKind::vector: {
            Form component = form;
            component.kind = FormKind::number;
            return array_schema(number_schema(component), 2, 3);
        }
        case FormKind::list:
            return array_schema(schema_of(form.item.front()), form.min_count, form.max_count);
        case FormKind::table:
            return reference(form.table());
        case FormKind::table_list:
            return array_schema(reference(form.table()), form.min_count, std::numeric_limits<std::int64_t>::max());
        case FormKind::named_tables: {
            Value tables = type("object");
            tables.set("additionalProperties", reference(form.table()));
            return tables;
        }
    }
    return Value::table();
}

/// The dimension of the numbers that a key takes; plain when it takes none.
Dimension dimension_of(const Form& form) {
    return form.item.empty() ? form.dimension : dimension_of(form.item.front());
}

Value required_list(const std::vector<std::string_view>& keys) {
    Value list = Value::array();
    for (const std::string_view key : keys) {
        list.items.push_back(Value::of(key));
    }
    return list;
}

/// The pattern of a key with a unit in its name; empty where it takes none.
std::string unit_pattern(const Key& key, const Form& form) {
    const std::string suffixes = suffixes_for(dimension_of(form));
    return dimension_of(form).is_plain() || suffixes.empty() ? "" : fmt::format("^{}_({})$", key.name, suffixes);
}

std::string description_of(const Key& key, bool has_readers) {
    return has_readers && !key.methods.empty()
               ? fmt::format("{} Read by solid.method {}.", key.help, fmt::join(key.methods, ", "))
               : key.help;
}

/// @param has_readers  its methods are those that read it, see Key::methods
Value property_of(const Key& key, bool has_readers) {
    std::vector<Value> forms;
    for (const Form& form : key.forms) {
        forms.push_back(schema_of(form));
    }
    Value property = any_of(std::move(forms));
    property.set("description", Value::of(description_of(key, has_readers)));
    if (key.otherwise && !key.otherwise->is_table()) {
        property.set("default", *key.otherwise);
    }
    return property;
}

/// Keys that must be given under their own name; those that may carry a unit in it cannot be asked for by name.
std::vector<std::string_view> required_keys(const std::vector<Key>& keys) {
    std::vector<std::string_view> names;
    for (const Key& key : keys) {
        if (key.is_required && unit_pattern(key, key.forms.front()).empty()) {
            names.push_back(key.name);
        }
    }
    return names;
}

/// For every method, where it is chosen: its own rows, and no key that only others have.
Value method_rules(const Table& table) {
    Value rules = Value::array();
    for (const std::string_view word : table.methods) {
        const Table part = table.part_of(word);
        Value own = Value::table();
        for (const Key& key : table.keys) {
            if (key.is_of(word) && !key.methods.empty()) {
                own.set(key.name, property_of(key, false));
            } else if (part.find(key.name) == nullptr) {
                own.set(key.name, Value::of(false));
            }
        }
        Value chosen = object({{"properties", object({{"method", object({{"const", Value::of(word)}})}})}});
        if (word != table.methods.front()) {
            chosen.set("required", required_list({"method"}));
        }
        rules.items.push_back(
            object({{"if", chosen},
                    {"then", object({{"properties", own}, {"required", required_list(required_keys(part.keys))}})}}));
    }
    return rules;
}

Value schema_of(const Table& table) {
    Value properties = Value::table(), with_units = Value::table();
    const bool has_readers = table.methods.empty();
    for (const Key& key : table.keys) {
        for (const Form& form : key.forms) {
            if (const std::string pattern = unit_pattern(key, form); !pattern.empty()) {
                with_units.set(pattern, any_of({type("number"), array_schema(Value::table(), 1, limits::table_rows)}));
            }
        }
        properties.set(key.name, key.methods.empty() || has_readers ? property_of(key, has_readers) : Value::table());
    }
    Value schema = type("object");
    schema.set("title", Value::of(table.header));
    schema.set("description", Value::of(table.help));
    schema.set("properties", std::move(properties));
    if (!with_units.entries.empty()) {
        schema.set("patternProperties", std::move(with_units));
    }
    if (table.methods.size() > 1) {
        schema.set("allOf", method_rules(table));
    } else if (const auto required = required_keys(table.keys); !required.empty()) {
        schema.set("required", required_list(required));
    }
    schema.set("additionalProperties", Value::of(false));
    return schema;
}

}  // namespace

std::string case_schema() {
    Value definitions = Value::table();
    for (const Table* table : all_tables()) {
        if (table->id != "case") {
            definitions.set(table->id, schema_of(*table));
        }
    }
    Value schema = object({{"$schema", Value::of("https://json-schema.org/draft/2020-12/schema")}});
    Value top = schema_of(case_table());
    for (Entry& entry : top.entries) {
        schema.set(entry.key, std::move(entry.value));
    }
    schema.set("title", Value::of("Riprap case file"));
    schema.set("$defs", std::move(definitions));
    return write_json(schema);
}

}  // namespace riprap::scene
