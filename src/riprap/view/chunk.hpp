// SPDX-License-Identifier: Apache-2.0
#pragma once

// The pieces that the page carries: bytes, ordered so that zlib finds little to say about them, then compressed.
// page/src/chunk.js reads the same.

#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace riprap::view {

/// zlib stream of the bytes. `is_noisy`: residuals of particles, where only runs of zeros are worth looking for.
std::string compress(std::string_view bytes, bool is_noisy = false);
/// @throws FileError when it is not a zlib stream of at most `limit` bytes
std::string decompress(std::string_view packed, std::size_t limit);

/// Words of `width` bytes, rewritten as all first bytes, then all second bytes, and so on.
std::string split_planes(std::string_view words, std::size_t width);
std::string join_planes(std::string_view planes, std::size_t width);

/// Rows of `row` bytes, each but the first replaced by its exclusive-or with the row before.
void difference_rows(std::string& bytes, std::size_t row);
void restore_rows(std::string& bytes, std::size_t row);

template <class T>
std::string bytes_of(std::span<const T> values) {
    return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}
template <class T>
std::vector<T> values_of(std::string_view bytes) {
    std::vector<T> values(bytes.size() / sizeof(T));
    std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
    return values;
}

}  // namespace riprap::view
