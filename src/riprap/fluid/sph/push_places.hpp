// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace riprap::fluid {

/// Places of vectors in the `pushes` of ForceSumsIn: the force, and the way to particles of the surface.
struct PushPlaces {
    static constexpr std::size_t at_force = 0, at_surface = 3;
};

}  // namespace riprap::fluid
