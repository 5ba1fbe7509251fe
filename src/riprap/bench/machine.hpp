// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace riprap::bench {

/// Limits of the machine with so many threads.
struct ThreadLimits {
    int threads{1};
    double triad{0};       ///< [B/s], 24 bytes counted per element, arrays far larger than any cache
    double fma_double{0};  ///< [flop/s]
    double fma_single{0};  ///< [flop/s]
};

/// The machine by number of threads, in the order measured; the first entry is for one thread.
struct MachineLimits {
    std::vector<ThreadLimits> by_threads;
};

/// The machine on which published peers and the targets of docs/howto/benchmarks.md were measured, one core.
inline constexpr ThreadLimits reference_core{1, 43.5e9, 143.9e9, 287.5e9};

/// Best of several passes each, about a second per number of threads: these are limits, not averages.
MachineLimits measure_machine(const std::vector<int>& thread_counts);

/// One core here over one core of the reference machine in fused multiply-add, double precision: what compute-bound
/// targets are scaled by. 1 where it was not measured.
double core_speed(const MachineLimits& machine);

}  // namespace riprap::bench
