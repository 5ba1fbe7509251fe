// SPDX-License-Identifier: Apache-2.0
#pragma once

// Why a pair of methods cannot run a case, as a short list of physics: "plane only", "no locks". The list is found by
// trying: a method lacks a feature where the smallest case with it is refused, and the same case without it is not.

#include <string>
#include <string_view>
#include <vector>

#include "riprap/scene/text/value.hpp"

namespace riprap::run {

/// Physics that a case asks for and the methods lack; empty where they have all that it asks for.
/// @param root   the case as it was read
/// @param fluid  "none" where the case has no water
std::vector<std::string> missing_physics(const scene::Value& root, std::string_view solid, std::string_view fluid);

}  // namespace riprap::run
