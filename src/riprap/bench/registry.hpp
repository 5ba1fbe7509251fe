// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "riprap/bench/machine.hpp"

namespace riprap::bench {

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

/// Every bench, in the order in which they run. One explicit list: nothing registers itself.
std::span<const Bench> all_benches();

}  // namespace riprap::bench
