// SPDX-License-Identifier: Apache-2.0
// The resolved case as TOML and as JSON.
#include <algorithm>

#include "riprap/scene/text/value.hpp"

namespace riprap::scene {

namespace {

/// Escapes shared by TOML basic strings and JSON.
std::string in_quotes(std::string_view text) {
    constexpr const char* hex = "0123456789abcdef";
    std::string out = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            out += '\\';
            out += c;
        } else if (c == '\n') {
            out += "\\n";
        } else if (c == '\t') {
            out += "\\t";
        } else if (byte < 0x20 || byte == 0x7F) {
            out += "\\u00";
            out += hex[byte >> 4U];
            out += hex[byte & 15U];
        } else {
            out += c;
        }
    }
    return out + '"';
}

std::string toml_key(const std::string& key) {
    const bool is_bare = !key.empty() && std::all_of(key.begin(), key.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
    });
    return is_bare ? key : in_quotes(key);
}

bool is_table_list(const Value& value) {
    return value.is_array() && !value.items.empty() &&
           std::all_of(value.items.begin(), value.items.end(), [](const Value& item) { return item.is_table(); });
}

std::string scalar_text(const Value& value) {
    switch (value.kind) {
        case ValueKind::boolean:
            return value.boolean ? "true" : "false";
        case ValueKind::integer:
            return std::to_string(value.integer);
        case ValueKind::number:
            return number_text(value.number);
        default:
            return in_quotes(value.text);
    }
}

std::string inline_toml(const Value& value) {
    if (value.is_array()) {
        std::string out = "[";
        for (std::size_t i = 0; i < value.items.size(); ++i) {
            out += (i > 0 ? ", " : "") + inline_toml(value.items[i]);
        }
        return out + "]";
    }
    if (value.is_table()) {
        std::string out = "{";
        for (std::size_t i = 0; i < value.entries.size(); ++i) {
            out += (i > 0 ? ", " : " ") + toml_key(value.entries[i].key) + " = " + inline_toml(value.entries[i].value);
        }
        return out + (value.entries.empty() ? "}" : " }");
    }
    return scalar_text(value);
}

/// Tables get headers two levels deep ([solid], [material.rock], [[body]], [[contact.pair]]); deeper ones are inline.
void write_table(const Value& table, const std::string& path, int depth, std::string& out) {
    const auto has_header = [depth](const Value& value) {
        return depth < 2 && (value.is_table() || is_table_list(value));
    };
    for (const Entry& entry : table.entries) {
        if (!has_header(entry.value)) {
            out += toml_key(entry.key) + " = " + inline_toml(entry.value) + "\n";
        }
    }
    for (const Entry& entry : table.entries) {
        if (!has_header(entry.value)) {
            continue;
        }
        const std::string name = path.empty() ? toml_key(entry.key) : path + "." + toml_key(entry.key);
        if (entry.value.is_table()) {
            out += "\n[" + name + "]\n";
            write_table(entry.value, name, depth + 1, out);
        } else {
            for (const Value& item : entry.value.items) {
                out += "\n[[" + name + "]]\n";
                write_table(item, name, depth + 1, out);
            }
        }
    }
}

void json(const Value& value, const std::string& indent, std::string& out) {
    const std::string inner = indent + "  ";
    if (value.is_array()) {
        const bool is_flat = std::none_of(value.items.begin(), value.items.end(),
                                          [](const Value& v) { return v.is_array() || v.is_table(); });
        out += '[';
        for (std::size_t i = 0; i < value.items.size(); ++i) {
            out += i > 0 ? "," : "";
            out += is_flat ? (i > 0 ? " " : "") : "\n" + inner;
            json(value.items[i], inner, out);
        }
        out += is_flat ? "]" : "\n" + indent + "]";
    } else if (value.is_table()) {
        out += '{';
        for (std::size_t i = 0; i < value.entries.size(); ++i) {
            out += (i > 0 ? ",\n" : "\n") + inner + in_quotes(value.entries[i].key) + ": ";
            json(value.entries[i].value, inner, out);
        }
        out += value.entries.empty() ? "}" : "\n" + indent + "}";
    } else if (value.kind == ValueKind::none) {
        out += "null";
    } else {
        out += scalar_text(value);
    }
}

}  // namespace

std::string write_toml(const Value& table) {
    std::string out;
    write_table(table, "", 0, out);
    return out;
}

std::string write_json(const Value& value) {
    std::string out;
    json(value, "", out);
    return out + "\n";
}

}  // namespace riprap::scene
