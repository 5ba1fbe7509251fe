// SPDX-License-Identifier: Apache-2.0
#include "riprap/linear/huge_pages.hpp"

#include <cstdint>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace riprap::linear {

void advise_huge_pages([[maybe_unused]] void* begin, [[maybe_unused]] std::size_t bytes) {
#if defined(__linux__) && defined(MADV_HUGEPAGE)
    constexpr std::uintptr_t small = 4096, huge = std::uintptr_t{2} << 20;
    if (bytes < 2 * huge) {
        return;
    }
    const auto first = reinterpret_cast<std::uintptr_t>(begin);
    const std::uintptr_t start = (first + small - 1) / small * small, end = (first + bytes) / small * small;
    // refused by systems without such pages, where all stays as it was
    static_cast<void>(madvise(reinterpret_cast<void*>(start), end - start, MADV_HUGEPAGE));
#endif
}

}  // namespace riprap::linear
