// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "riprap/body/loads.hpp"

namespace riprap::coupling {

/// Loads of a fluid on every body, pressure and viscosity apart.
struct FluidLoads {
    body::Loads pressure, viscous;
    std::size_t bytes() const { return pressure.bytes() + viscous.bytes(); }
};

}  // namespace riprap::coupling
