// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace riprap {

/// Bytes that arrays hold, entries of nested ones included: for reports of memory.
template <class T>
std::size_t bytes_of(const std::vector<T>& array) {
    return array.capacity() * sizeof(T);
}
template <class T>
std::size_t bytes_of(const std::vector<std::vector<T>>& arrays) {
    std::size_t bytes = arrays.capacity() * sizeof(std::vector<T>);
    for (const std::vector<T>& array : arrays) {
        bytes += bytes_of(array);
    }
    return bytes;
}
template <class First, class Second, class... More>
std::size_t bytes_of(const First& first, const Second& second, const More&... more) {
    return bytes_of(first) + bytes_of(second) + (std::size_t{0} + ... + bytes_of(more));
}

}  // namespace riprap
