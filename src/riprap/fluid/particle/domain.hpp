// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "riprap/core/vec3.hpp"

namespace riprap::fluid {

/// The box that particles may be in. A particle that leaves through a side that is not periodic is reported, never
/// dropped in silence. In two dimensions z is ignored.
struct Domain {
    Vec3 low{};                         ///< [m]
    Vec3 high{};                        ///< [m]
    std::array<bool, 3> is_periodic{};  ///< per axis
    int dimension{3};                   ///< 2 or 3
};

}  // namespace riprap::fluid
