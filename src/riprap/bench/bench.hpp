// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "riprap/bench/registry.hpp"

namespace riprap::bench {

/// Options of `riprap bench [NAME]... [--full] [--json] [--threads N]`.
struct BenchOptions {
    std::vector<std::string> selection;  ///< names or beginnings of names: "pile", "contact.cube_cube"; empty = all
    bool is_full{false};                 ///< also long benches
    bool as_json{false};                 ///< one JSON document instead of a table
    int threads{0};                      ///< measured besides one thread; 0 = all of the machine
};

/// Measures the machine, then runs the selected benches in order. Prints to `out` one table or one JSON document; the
/// name of every bench goes to `progress` as it starts, where not null. A time is never judged: a slow machine is no
/// failure.
/// @param measure  measure_machine, or what stands for it in a test
/// @returns 0, or 2 when the selection names nothing (the message says what there is); values of ExitCode.
int run_benches(const BenchOptions& options, std::span<const Bench> benches,
                MachineLimits (*measure)(const std::vector<int>& thread_counts), std::ostream& out,
                std::ostream* progress);

/// Runs all_benches() and reports on the terminal.
int bench_main(const BenchOptions& options);

/// {"machine": {...}, "results": [{"name", "threads", "value", "unit", "note"}]}
std::string to_json(const MachineLimits& machine, const std::vector<Result>& results);
std::string to_table(const MachineLimits& machine, const std::vector<Result>& results);

}  // namespace riprap::bench
