// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "riprap/scene/text/value.hpp"

namespace riprap::scene {

/// Reads a TOML text into a tree. The text is looked at before the TOML library sees it: size, UTF-8, control
/// characters, nesting, length of dotted keys, and keys outside quotes are ASCII (toml++ 3.3 reaches undefined
/// behaviour on other keys). Problems are appended; the tree is empty when there are any.
Value parse_toml(std::string_view text, const std::string& name, std::vector<Diagnostic>& problems);

/// Applies "path.to.key=value" to the tree. Steps of the path into a list are a number or the `name` of an entry.
void apply_override(Value& root, const std::string& assignment, std::vector<Diagnostic>& problems);

}  // namespace riprap::scene
