// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace riprap::linear {

/// Asks the system to back memory that nobody has written yet by pages of 2 MiB, where it knows them: a stream through
/// a large array then waits for fewer addresses. Does nothing for less than two such pages.
void advise_huge_pages(void* begin, std::size_t bytes);

/// Makes `array` one of `size` zeros on huge pages.
inline void fill_with_zeros(std::size_t size, std::vector<double>& array) {
    array.clear();
    if (array.capacity() < size) {
        array.reserve(size);
        advise_huge_pages(array.data(), size * sizeof(double));
    }
    array.resize(size);
}

}  // namespace riprap::linear
