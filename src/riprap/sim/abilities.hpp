// SPDX-License-Identifier: Apache-2.0
#pragma once

// Physics that some methods have and others lack, by words that an expected answer may need.

#include <span>
#include <string_view>
#include <vector>

namespace riprap::sim {

struct Model;

struct Ability {
    std::string_view word;     ///< of the case
    std::string_view lacking;  ///< what a method without it is said to be: "no bonds"
    std::string_view help;
};

/// Every ability, in a fixed order.
std::span<const Ability> abilities();

/// Tells whether the methods of a case have an ability.
bool has_ability(const Model& model, std::string_view word);

/// Returns the words of the methods that have it, of the solids or of the fluids.
std::vector<std::string_view> methods_with(std::string_view word);

}  // namespace riprap::sim
