// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace riprap::view {

/// Writes index.html beside the sweep.json of a study: one table of all answers, each answer against each key, and
/// the curves of all runs over time. One file, without network. @returns the page
std::filesystem::path write_sweep_page(const std::filesystem::path& folder);

}  // namespace riprap::view
