// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace riprap::contact {

/// Counts the pairs of bodies that have a row in a list of contacts, however many rows a pair has.
/// @param sorted_keys    first << 32 | second, increasing; firsts are grouped by body
/// @param body_of_first  body of a first, and of a second
template <class First, class Second>
std::int64_t count_body_pairs(std::span<const std::uint64_t> sorted_keys, std::int32_t body_count,
                              const First& body_of_first, const Second& body_of_second) {
    std::vector<std::int32_t> met_by(static_cast<std::size_t>(body_count),
                                     -1);  // last body that a body was counted with
    std::int64_t count = 0;
    for (const std::uint64_t key : sorted_keys) {
        const std::int32_t a = body_of_first(static_cast<std::int32_t>(key >> 32));
        std::int32_t& last =
            met_by[static_cast<std::size_t>(body_of_second(static_cast<std::int32_t>(key & 0xFFFFFFFF)))];
        count += last != a ? 1 : 0;
        last = a;
    }
    return count;
}

/// Counts the pairs where the keys are of bodies themselves: the different keys of a sorted list.
inline std::int64_t count_pairs(std::span<const std::uint64_t> sorted_keys) {
    std::int64_t count = 0;
    for (std::size_t i = 0; i < sorted_keys.size(); ++i) {
        count += i == 0 || sorted_keys[i] != sorted_keys[i - 1] ? 1 : 0;
    }
    return count;
}

}  // namespace riprap::contact
