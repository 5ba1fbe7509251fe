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
        ValidationCase{"zhao", "pillar_impact", "A block hits a row and a pillar of blocks", false,
                       zhao::pillar_impact},
        ValidationCase{"zhao", "wedge_static", "A wedge slides down its line of intersection", false,
                       zhao::wedge_static},
        ValidationCase{"zhao", "wedge_dynamic", "A wedge on a shaken slope slides, stops and rests", false,
                       zhao::wedge_dynamic},
    };
    return cases;
}

}  // namespace riprap::validation
