// SPDX-License-Identifier: Apache-2.0
// The only translation unit that includes toml++.
#include "riprap/scene/text/toml_reader.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>

#include "riprap/core/printable.hpp"
#include "riprap/scene/text/limits.hpp"
#include "riprap/scene/text/toml_scan.hpp"

namespace riprap::scene {

namespace {

/// Copies a toml++ tree into values with places. Recursion is bounded by the scan for nesting.
class Copier {
 public:
    Copier(const std::string& name, std::vector<Diagnostic>& problems) : name_(name), problems_(problems) {}

    Value copy(const toml::node& node) {
        Value value;
        value.place = place(node.source());
        if (++count_ > limits::values) {
            if (count_ == limits::values + 1) {
                problems_.push_back({value.place, "the file holds too many values",
                                     fmt::format("at most {} are accepted; put long lists in a file", limits::values)});
            }
            return value;
        }
        if (const auto* table = node.as_table()) {
            value.kind = ValueKind::table;
            copy_table(*table, value);
        } else if (const auto* array = node.as_array()) {
            value.kind = ValueKind::array;
            value.items.reserve(array->size());
            for (const toml::node& item : *array) {
                value.items.push_back(copy(item));
            }
        } else if (const auto* text = node.as_string()) {
            value.kind = ValueKind::text;
            value.text = text->get();
            if (value.text.size() > limits::text_bytes) {
                problems_.push_back({value.place, fmt::format("a text of {} bytes", value.text.size()),
                                     fmt::format("at most {} are accepted", limits::text_bytes)});
            }
            refuse_control(value.text, value.place);
        } else if (const auto* integer = node.as_integer()) {
            value.kind = ValueKind::integer;
            value.integer = integer->get();
        } else if (const auto* number = node.as_floating_point()) {
            value.kind = ValueKind::number;
            value.number = number->get();
        } else if (const auto* boolean = node.as_boolean()) {
            value.kind = ValueKind::boolean;
            value.boolean = boolean->get();
        } else {
            problems_.push_back({value.place, "a date or time", "no key takes one; write times as seconds or \"2 h\""});
        }
        return value;
    }

 private:
    SourcePlace place(const toml::source_region& region) const {
        return {name_, static_cast<std::uint32_t>(region.begin.line), static_cast<std::uint32_t>(region.begin.column)};
    }

    /// Texts are printed, and a terminal obeys what it is printed.
    void refuse_control(const std::string& text, const SourcePlace& at) {
        if (printable(text) != text) {
            problems_.push_back(
                {at, fmt::format("'{}' holds control characters", text), "printable characters, line feeds and tabs"});
        }
    }

    void copy_table(const toml::table& table, Value& value) {
        for (const auto& [key, node] : table) {
            refuse_control(std::string(key.str()), place(key.source()));
            value.entries.push_back({std::string(key.str()), place(key.source()), copy(node)});
        }
        // toml++ sorts keys; the order of the file reads better and makes messages come from top to bottom.
        std::stable_sort(value.entries.begin(), value.entries.end(), [](const Entry& a, const Entry& b) {
            return std::pair(a.place.line, a.place.column) < std::pair(b.place.line, b.place.column);
        });
    }

    const std::string& name_;
    std::vector<Diagnostic>& problems_;
    std::size_t count_{0};
};

}  // namespace

Value parse_toml(std::string_view text, const std::string& name, std::vector<Diagnostic>& problems) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";  // some editors begin UTF-8 with one
    if (text.starts_with(byte_order_mark)) {
        text.remove_prefix(byte_order_mark.size());
    }
    const std::size_t before = problems.size();
    scan_toml(text, name, problems);
    if (problems.size() > before) {
        return Value::table();
    }
    try {
        const toml::table table = toml::parse(text, std::string_view(name));
        Value root = Copier(name, problems).copy(table);
        root.place = {name, 1, 1};
        return problems.size() > before ? Value::table() : root;
    } catch (const toml::parse_error& error) {
        const auto& at = error.source().begin;
        problems.push_back({{name, static_cast<std::uint32_t>(at.line), static_cast<std::uint32_t>(at.column)},
                            std::string(error.description()),
                            "a case file is TOML 1.0"});
        return Value::table();
    }
}

}  // namespace riprap::scene
