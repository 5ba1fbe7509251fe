// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "riprap/view/recorded_run.hpp"

namespace riprap::view {

/// Reads a run folder for looking at it. Takes what is there: a file that is missing, cut or not of Riprap is left out
/// with a notice, and everything else still works.
/// @throws FileError when the folder does not exist or nothing in it was written by a run
RecordedRun read_run(const std::filesystem::path& folder);

}  // namespace riprap::view
