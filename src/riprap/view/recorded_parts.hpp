// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "riprap/run/folder/run_folder.hpp"
#include "riprap/view/recorded_run.hpp"

// Parts of a run folder, read one by one: see read_run.

namespace riprap::view {

inline constexpr std::size_t text_limit = std::size_t{64} << 20U;  ///< largest case or summary that is read [bytes]

/// Tells whether there is a file or folder; no where it may not be entered.
bool is_there(const std::filesystem::path& path);

/// Reads one part; a file or folder that cannot be read becomes a notice of the run.
void attempt(RecordedRun& run, const std::function<void()>& part);

/// Reads title, materials, gravity, gauges, still water, porous zones and dry bodies of the resolved case.
void read_resolved(RecordedRun& run, const std::filesystem::path& path);

/// Reads how the run ended, and its warnings: from the summary, and from the log where that is missing.
void read_status(RecordedRun& run, const run::RunFolder& folder);

/// Returns a text that is JSON. @throws FileError where it is none, or nested too deep
std::string json_text(const std::filesystem::path& path);

/// Finds the files of all frames: those that the run lists, or that lie in its folder where the list is lost.
void find_frames(RecordedRun& run, const run::RunFolder& folder);

}  // namespace riprap::view
