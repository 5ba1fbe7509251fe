// SPDX-License-Identifier: Apache-2.0
#include "riprap/validation/registry.hpp"

#include <array>

#include "riprap/validation/zhao/cases.hpp"

namespace riprap::validation {

std::span<const ValidationCase> all_cases() {
    static constexpr std::array cases{
        ValidationCase{"zhao", "golden_values", "Contact of two blocks: energy, force and moment to ten digits", false,
                       zhao::golden_values},
    };
    return cases;
}

}  // namespace riprap::validation
