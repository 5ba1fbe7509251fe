// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <chrono>
#include <vector>

#include "riprap/core/parallel_device.hpp"

namespace selftest {

/// Seconds of one call, median of nine after two to warm up.
template <class Work>
double seconds_of(const Work& work) {
    std::vector<double> times;
    for (int k = 0; k < 11; ++k) {
        riprap::parallel::device::wait();
        const auto start = std::chrono::steady_clock::now();
        work();
        riprap::parallel::device::wait();
        times.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    std::nth_element(times.begin() + 2, times.begin() + 6, times.end());
    return times[6];
}

}  // namespace selftest
