// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "riprap/validation/after_step.hpp"
#include "riprap/validation/result.hpp"

namespace riprap::validation {

/// Input of a case besides its report.
struct CaseSetting {
    std::filesystem::path folder;   ///< validation/<suite>/<case> with the case's files
    std::filesystem::path results;  ///< where runs are kept; empty = they are not
    bool is_full{false};            ///< the long version
    bool is_plain{false};           ///< the case as it stands alone, without its [[vary]]
    bool is_still{false};           ///< judges a world in which nothing moves, and takes no step
    AfterStep after_step{};         ///< is told how far a simulation is, where it is set
};

/// One published example or analytical solution. `run` fills the report; what it throws becomes a failed result.
struct ValidationCase {
    std::string_view suite;
    std::string_view name;
    std::string_view title;
    bool is_long;  ///< only run when asked for by name or with --full
    void (*run)(const CaseSetting& setting, CaseReport& report);
};

/// Every case, in the order in which they run: the case files of all suites, then the scenes of the cross table.
std::span<const ValidationCase> all_cases();

}  // namespace riprap::validation
