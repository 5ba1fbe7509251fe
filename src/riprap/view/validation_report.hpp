// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace riprap::view {

/// Writes index.html into a folder: one page with every result of a validation, reds included, every plot that lies in
/// <folder>/<suite>/*.svg, and the words of each suite about its assumptions and what it does not reach.
/// `results_json` is what `riprap validate --json` prints; `suites` is the folder with <suite>/README.md.
/// @returns the page's path. @throws FileError
std::filesystem::path write_validation_report(const std::filesystem::path& folder, const std::string& results_json,
                                              const std::filesystem::path& suites);

}  // namespace riprap::view
