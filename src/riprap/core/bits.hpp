// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>

#include "riprap/core/config.hpp"

namespace riprap {

/// Returns the place of the lowest bit that is set; some bit has to be.
RIPRAP_HD inline int lowest_bit(std::uint32_t bits) {
#if defined(__CUDA_ARCH__)
    return __ffs(static_cast<int>(bits)) - 1;
#else
    return std::countr_zero(bits);
#endif
}

}  // namespace riprap
