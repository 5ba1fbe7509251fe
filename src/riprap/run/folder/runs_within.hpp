// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace riprap::run {

/// Says of a folder that is no run, but of a study or an ensemble, which runs are in it: "it holds 5 runs; give one of
/// them, such as study/run_001"; empty where none is. Looks at its own folders alone.
std::string runs_within(const std::filesystem::path& folder);

}  // namespace riprap::run
