// SPDX-License-Identifier: Apache-2.0
#include "riprap/validation/registry.hpp"

#include <array>

#include "riprap/validation/zhao/cases.hpp"

namespace riprap::validation {

std::span<const ValidationCase> all_cases() {
    static constexpr std::array cases{
        ValidationCase{"zhao", "golden_values", "Contact of two blocks: energy, force and moment to ten digits", false,
                       zhao::golden_values},
        ValidationCase{"zhao", "two_tetrahedra", "A tetrahedron falls on the ridge of another and returns", false,
                       zhao::two_tetrahedra},
        ValidationCase{"zhao", "incline", "A block slides up an incline, stops, and slides back or stays", false,
                       zhao::incline},
    };
    return cases;
}

}  // namespace riprap::validation
