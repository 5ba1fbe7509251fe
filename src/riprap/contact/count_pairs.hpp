// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

namespace riprap::contact {

/// Returns the number of different keys in a list that is sorted by them: of touching pairs, however many contacts each
/// of them has.
inline std::int64_t count_pairs(std::span<const std::uint64_t> sorted_keys) {
    std::int64_t count = 0;
    for (std::size_t i = 0; i < sorted_keys.size(); ++i) {
        count += i == 0 || sorted_keys[i] != sorted_keys[i - 1] ? 1 : 0;
    }
    return count;
}

}  // namespace riprap::contact
