// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace riprap::view {

/// Writes index.html into a folder: one page with every case of a validation, reds included. A case has its results
/// and what <words>/<suite>/<case>/README.md says of source, choices and bands; a suite what its own README.md says.
/// `results_json` is what `riprap validate --json` prints.
/// @returns the page's path. @throws FileError
std::filesystem::path write_validation_report(const std::filesystem::path& folder, const std::string& results_json,
                                              const std::filesystem::path& words, bool is_whole = true);

}  // namespace riprap::view
