// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "riprap/core/bytes.hpp"

namespace riprap::fluid {

/// A list of whole numbers from 0 on that takes two bytes for each where all of them fit, else four, and no room beyond
/// its end.
class SmallNumbers {
 public:
    void assign(std::span<const std::int32_t> numbers) {
        const bool is_narrow = std::ranges::all_of(numbers, [](std::int32_t n) { return n <= largest_narrow; });
        fill(narrow_, is_narrow ? numbers : std::span<const std::int32_t>{});
        fill(wide_, is_narrow ? std::span<const std::int32_t>{} : numbers);
    }
    std::size_t size() const { return std::max(narrow_.size(), wide_.size()); }
    std::int32_t operator[](std::size_t i) const { return narrow_.empty() ? wide_[i] : narrow_[i]; }
    /// Writes `count` of them from `first` on.
    void copy(std::size_t first, std::size_t count, std::int32_t* out) const {
        if (narrow_.empty()) {
            std::copy_n(wide_.begin() + static_cast<std::ptrdiff_t>(first), count, out);
        } else {
            std::copy_n(narrow_.begin() + static_cast<std::ptrdiff_t>(first), count, out);
        }
    }
    std::size_t bytes() const { return bytes_of(narrow_, wide_); }

 private:
    static constexpr std::int32_t largest_narrow = 0xFFFF;

    /// Takes the numbers into room of their size, give or take an eighth, so that lists made again need no new one.
    template <class T>
    static void fill(std::vector<T>& to, std::span<const std::int32_t> numbers) {
        if (to.capacity() < numbers.size() || to.capacity() > numbers.size() + numbers.size() / 8) {
            to = std::vector<T>();
            to.reserve(numbers.size());
        }
        to.resize(numbers.size());
        std::ranges::transform(numbers, to.begin(), [](std::int32_t n) { return static_cast<T>(n); });
    }

    std::vector<std::uint16_t> narrow_;
    std::vector<std::int32_t> wide_;
};

}  // namespace riprap::fluid
