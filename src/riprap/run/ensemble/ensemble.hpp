// SPDX-License-Identifier: Apache-2.0
#pragma once

// Ensembles: one case run many times, each with its own values of the numbers that are not known exactly.

#include <cstdint>
#include <filesystem>

#include "riprap/run/drive/run_case.hpp"
#include "riprap/run/ensemble/bands.hpp"
#include "riprap/run/study/sweep_slurm.hpp"

namespace riprap::run {

struct EnsembleOptions {
    RunOptions run;  ///< `out` is the folder of the ensemble; member k lies in out/member-k
    std::int64_t members{0};
    int jobs{1};  ///< members at a time, each a process of its own; 1 = one after another in this process
};

/// Runs the members, each a run folder of its own with its drawn values as overrides; what is there already is
/// continued, and a member that is finished is left alone. Writes ensemble.csv (member, values, exit code),
/// ensemble.json (the same as sweep.json has of a study) and bands.csv. A member that is refused is named, and the
/// others go on; where all draw what a key does not allow, nothing is written. A signal stops all that run, and begins
/// no other. @returns the first exit code that is not zero, else 0
/// @throws FileError where a file in the folder is of another ensemble, or of the user's
int run_ensemble(const EnsembleOptions& options);

/// Writes the plan of an ensemble and the scripts that make it a job array of Slurm. @throws as run_ensemble
SlurmScripts write_ensemble_scripts(const EnsembleOptions& options, const SlurmOptions& slurm);

/// Writes the tables of an ensemble whose members other processes ran, and names those that are not finished.
/// @returns the exit code: 1 where a member is not finished or missed an expected answer
int gather_ensemble(const std::filesystem::path& out, bool is_quiet);

}  // namespace riprap::run
