// SPDX-License-Identifier: Apache-2.0
#pragma once

// A run folder as a case: what was run is run again.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace riprap::run {

/// The case that a run folder holds, and how its run ended.
struct StoredRun {
    std::filesystem::path case_file;     ///< the copy in the folder
    std::vector<std::string> overrides;  ///< "key=value" each, as the run was started with
    std::string name;                    ///< of the folder
    std::string status;                  ///< "finished", ...
    std::string state_hash;              ///< empty where it has not ended
    std::string build;                   ///< version, commit, compiler and processor, as one text
    double time{0};                      ///< that it reached [s]
};

/// Reads a run folder; nothing where the path is none. @throws FileError where its files are damaged
std::optional<StoredRun> stored_run(const std::filesystem::path& folder);

/// Whether a run ended with the State of another one, in words with the reason where it did not.
struct Comparison {
    bool is_same;
    std::string text;
};
/// Compares a run that has ended with the stored one. Where one of them has not ended, or they went to other times,
/// there is nothing to compare, which is no difference.
Comparison compare(const StoredRun& first, const std::filesystem::path& again);

}  // namespace riprap::run
