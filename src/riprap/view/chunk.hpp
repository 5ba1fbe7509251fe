// SPDX-License-Identifier: Apache-2.0
#pragma once

// The pieces that the page carries: bytes, ordered so that zlib finds little to say about them, then compressed.
// page/src/chunk.js reads the same.

#include <span>
#include <string>
#include <string_view>

namespace riprap::view {

/// zlib stream of the bytes. `is_noisy`: residuals of particles, where only runs of zeros are worth looking for.
std::string compress(std::string_view bytes, bool is_noisy = false);

/// Words of `width` bytes, rewritten as all first bytes, then all second bytes, and so on.
std::string split_planes(std::string_view words, std::size_t width);

/// Rows of `row` bytes, each but the first replaced by its exclusive-or with the row before.
void difference_rows(std::string& bytes, std::size_t row);

template <class T>
std::string bytes_of(std::span<const T> values) {
    return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

}  // namespace riprap::view
