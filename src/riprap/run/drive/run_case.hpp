// SPDX-License-Identifier: Apache-2.0
#pragma once

// From a case to a finished run folder. All functions return the exit code of the program and let errors of the
// input, of files and of checkpoints out as exceptions (core/error.hpp).

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "riprap/run/drive/watch.hpp"
#include "riprap/scene/read_case.hpp"

namespace riprap::run {

struct RunOptions {
    std::string case_path;               ///< the case file
    std::vector<std::string> overrides;  ///< "key=value" each
    std::filesystem::path out;           ///< the run folder
    int threads{0};                      ///< 0 = all that the process may use
    bool resume{false};                  ///< continue the run in `out` if there is one
    bool force{false};                   ///< replace the run in `out` if there is one
    bool quiet{false};                   ///< print errors and verdicts only
    bool silent{false};                  ///< print nothing; summary.json says it all
    Watch watch{};                       ///< may be empty
};

struct ResumeOptions {
    std::filesystem::path folder;
    int threads{0};
    std::optional<double> end;              ///< a new end of the run [s]
    std::optional<std::int64_t> max_steps;  ///< a new limit; -1 = none
    bool quiet{false};
};

/// Sets the number of threads; 0 = the first number of OMP_NUM_THREADS, or else all that the process may use.
void use_threads(int threads);

/// Runs a case from the beginning, or continues it with `resume`.
int run_case(const RunOptions& options);

/// Runs a case that was read already, from a file or a text; `case_path` is not used.
int run_loaded(scene::LoadedCase loaded, const RunOptions& options);

/// Continues the run in a folder with the case stored there. With the same end the result has the same bits as a run
/// that was never stopped, at any number of threads.
int resume_run(const ResumeOptions& options);

}  // namespace riprap::run
