// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "riprap/core/error.hpp"
#include "riprap/scene/text/value.hpp"

namespace riprap::scene {

/// Refuses [[spread]] whose key is none of the case, or whose ends the key does not allow. Of a normal distribution the
/// mean is tried: what a member far from it may not have is told when members are drawn.
/// @param checked  the case, its keys checked
/// @param root     as it was read, overrides applied
void check_spreads(const Value& checked, const Value& root, bool is_planar, std::vector<Diagnostic>& problems);

/// Problems of the keys of a case with other values in it; its bodies and water are not looked at.
/// @param name  of the file
std::vector<Diagnostic> problems_of_keys(std::string_view text, const std::string& name,
                                         std::span<const std::string> overrides);

}  // namespace riprap::scene
