// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/validation/registry.hpp"

namespace riprap::validation {

/// Returns the folders validation/SUITE/CASE whose case.toml says what it expects, but for those of the cross table.
std::vector<ValidationCase> file_cases();

/// Runs the case of a folder and its [[vary]] as `riprap run` does, one run folder each, and reports what they expect.
void run_case_file(const CaseSetting& setting, CaseReport& report);

}  // namespace riprap::validation
