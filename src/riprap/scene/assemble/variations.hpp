// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "riprap/core/error.hpp"
#include "riprap/scene/text/value.hpp"

namespace riprap::scene {

/// A run of a case besides the one that it says.
struct Variation {
    std::string label;                   ///< "body.disc.density = 700"
    std::vector<std::string> overrides;  ///< "key=value" each, those of the expected answers included
    bool is_full{false};                 ///< only in the long version of the validation
    std::int32_t vary{-1};               ///< number of its [[vary]]; -1 for the case as it stands
    double first{0};                     ///< value of the first key; 0 where that is a text
};

/// Returns the runs that the [[vary]] of a case ask for, in their order.
/// @param checked  the case, its keys checked
std::vector<Variation> variations_of(const Value& checked);

/// Refuses [[vary]] whose key is none of the case or may not have one of the values, and answers that are none of the
/// case or not as many as the values.
/// @param root  as it was read, overrides applied
void check_variations(const Value& checked, const Value& root, bool is_planar, std::vector<Diagnostic>& problems);

}  // namespace riprap::scene
