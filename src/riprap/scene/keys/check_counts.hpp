// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/scene/text/value.hpp"

namespace riprap::scene {

/// Bodies and parts that the case asks for, from counts alone. A problem, and false, when above limits.hpp.
bool check_counts(const Value& root, std::vector<Diagnostic>& problems);

}  // namespace riprap::scene
