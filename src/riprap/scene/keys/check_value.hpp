// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "riprap/scene/keys/key_table.hpp"

namespace riprap::scene {

inline constexpr const char* name_rule =
    "a name has 1 to 64 letters, digits, '_', '-' or '.', and starts with a letter";

/// True for names that are safe in file names, columns and dotted paths.
bool is_name(std::string_view text);

/// True when the kind of `given` is one that the form takes; its content is not looked at.
bool fits(const Value& given, const Form& form);

/// "a length [m], 0 < value", "one of: both, contactor": what a form takes, for messages and pages.
std::string describe_form(const Form& form);

/// "0 < value <= 1", empty for an unbounded range.
std::string describe_range(const Range& range);

/// Checks single values (numbers, texts, choices, vectors) and converts them to SI.
class ValueChecker {
 public:
    ValueChecker(bool is_planar, std::vector<Diagnostic>& problems) : is_planar_(is_planar), problems_(problems) {}

    /// @param name  of the key, for messages
    /// @param unit  from a suffix of the key
    /// @returns nothing, and a problem, when the value is refused
    std::optional<Value> check(const Value& given, const Form& form, const std::string& name,
                               const std::optional<Unit>& unit);

 private:
    std::optional<Value> number(const Value& given, const Form& form, const std::string& name,
                                const std::optional<Unit>& unit);
    std::optional<Value> vector(const Value& given, const Form& form, const std::string& name,
                                const std::optional<Unit>& unit);
    std::optional<Value> text(const Value& given, const Form& form, const std::string& name);
    std::optional<Value> refuse(const Value& given, std::string message, std::string allowed);

    bool is_planar_;
    std::vector<Diagnostic>& problems_;
};

}  // namespace riprap::scene
