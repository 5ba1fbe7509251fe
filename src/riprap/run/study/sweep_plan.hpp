// SPDX-License-Identifier: Apache-2.0
#pragma once

// The plan of a study in its folder: what its runs are, so that other processes and machines may take part.

#include "riprap/run/study/sweep.hpp"

namespace riprap::run {

/// Takes the folder of a study and writes its plan, sweep_plan.json, unless the same plan is there.
/// @throws FileError when the folder holds another study or other files; CaseError of the first run where no case can
/// be read
void claim_study(const SweepOptions& options);

/// Writes sweep_plan.json into a folder that is ours already.
void write_plan(const SweepOptions& options);

/// Reads the plan in a folder: case, runs and what is set in all of them. @throws FileError where there is none
SweepOptions read_plan(const std::filesystem::path& out);

/// Tells whether a run of the study has reached its end.
bool is_finished(const SweepOptions& options, const SweepPoint& point);

/// Writes sweep.json and sweep.csv from what the folders of the runs hold now, and tells which cannot be read.
/// @returns an exit code
int write_tables(const SweepOptions& options);

/// Writes the tables of a study whose runs other processes made, and names those that are not finished.
/// @returns the exit code: 1 where a run is not finished or an expected answer was missed
int gather_study(const SweepOptions& options);

/// Names the runs of a sweep.json that cannot be read or are not finished, and says how many are.
/// @returns the exit code, as gather_study
int tell_unfinished(const SweepOptions& options, const std::string& json);

}  // namespace riprap::run
