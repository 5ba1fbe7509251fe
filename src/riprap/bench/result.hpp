// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
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

/// One core here over one core of the reference machine in fused multiply-add, double precision: what compute-bound
/// targets are scaled by. 1 where it was not measured.
inline double core_speed(const MachineLimits& machine) {
    return machine.by_threads.empty() ? 1 : machine.by_threads.front().fma_double / reference_core.fma_double;
}

/// One measured figure.
struct Result {
    std::string name;  ///< the bench's name, or that with a suffix: "pile.10k", "pile.10k.speedup"
    int threads;       ///< that did the work
    double value;
    std::string unit;
    std::string note;  ///< repetitions and spread, sizes, what else is worth knowing
};

/// Input of a bench.
struct Setting {
    std::vector<int> thread_counts{1};  ///< to measure with, increasing, starting with 1
    MachineLimits machine{};            ///< of this machine, to compare with
};

/// One question. `run` appends its answers; the number of host threads is back to what it was afterwards.
struct Bench {
    std::string_view name;
    std::string_view title;
    bool is_long;  ///< only run when asked for by its full name or with --full
    void (*run)(const Setting& setting, std::vector<Result>& results);
};

}  // namespace riprap::bench
