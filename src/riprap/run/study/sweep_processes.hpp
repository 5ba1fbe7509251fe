// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "riprap/run/study/sweep.hpp"

namespace riprap::run {

/// Called when a run of a study has ended, with its exit code.
using RunEnded = std::function<void(const SweepPoint&, int)>;

/// Runs at a time where the user names none: as many as there are cores for their threads.
int usual_jobs(int threads);

/// Runs the points of a study that are not finished, each by a process of its own, `jobs` at a time; writes no table.
/// A stop signal is passed on to those that run, and begins no other.
/// @param force  runs are begun anew, finished ones too
/// @returns the exit code: that of the first run that did not succeed, or 128 + a signal
int run_processes(const SweepOptions& options, int jobs, bool force, const RunEnded& ended);

}  // namespace riprap::run
