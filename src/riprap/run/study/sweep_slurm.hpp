// SPDX-License-Identifier: Apache-2.0
#pragma once

// Studies on a cluster: the runs of a plan as a job array of Slurm.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "riprap/run/study/sweep.hpp"

namespace riprap::run {

/// Holds what a cluster is asked for; empty = its own default.
struct SlurmOptions {
    std::string partition, time, account, memory;
    int jobs{0};                       ///< runs at a time; 0 = as many as the cluster gives
    std::filesystem::path program;     ///< riprap, as the nodes see it
    std::int64_t largest_index{1000};  ///< of an array: MaxArraySize - 1
};

/// Names the scripts of a study, in its folder.
struct SlurmScripts {
    std::filesystem::path task, gather, submit;
};

/// Writes numbers from 1 as Slurm reads them: {1, 2, 3, 7} as "1-3,7".
std::string array_of(const std::vector<std::size_t>& numbers);

/// Writes slurm_task.sh, the job of one run, slurm_gather.sh, which makes the tables after the last one, and
/// slurm_submit.sh, which hands both in: a job array of the runs that are not finished, several arrays where an index
/// would pass the cluster's limit. All are meant to be read, and may be edited before slurm_submit.sh is run.
SlurmScripts write_slurm_scripts(const SweepOptions& options, const SlurmOptions& slurm);

/// Asks for the largest index of an array here, by `scontrol show config`; 1000, Slurm's default, where that cannot be
/// asked.
std::int64_t largest_array_index();

/// Runs slurm_submit.sh. @returns 0 @throws FileError where there is no sbatch, or it refuses the study
int submit(const SlurmScripts& scripts);

}  // namespace riprap::run
