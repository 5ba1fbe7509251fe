// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "riprap/core/parallel.hpp"

namespace riprap::fluid {

/// Makes `count` zeros of each of these.
template <class... Vectors>
void make_zeros(std::size_t count, Vectors&... sums) {
    const auto make = [count]<class T>(std::vector<T>& all) {
        all.resize(count);
        parallel::for_each(static_cast<std::int64_t>(count),
                           [&](std::int64_t i) { all[static_cast<std::size_t>(i)] = T{}; });
    };
    (make(sums), ...);
}

}  // namespace riprap::fluid
