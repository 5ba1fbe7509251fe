// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include "riprap/validation/registry.hpp"

namespace riprap::validation {

/// Options of `riprap validate [SUITE[/CASE]]... [--full] [--json]`.
struct ValidateOptions {
    std::vector<std::string> selection;         ///< "zhao", "zhao/incline"; empty = every suite
    bool is_full{false};                        ///< also long cases, and every case in its long version
    bool is_still{false};                       ///< takes no step: what holds in a world in which nothing moves
    bool as_json{false};                        ///< one JSON object per suite instead of tables
    std::string results{"validation-results"};  ///< runs go to <results>/<suite>/; empty = none is kept
    std::string folder;                         ///< with the case files; empty = validation/ here, else the source's
    double tell_every{60};                      ///< `progress` says as often how far a simulation is [s]
    std::function<void(const std::string&)> after_case{};  ///< is given all results so far, as JSON, where it is set
};

/// Folder in which <suite>/<case> have their case files and words.
std::filesystem::path case_folder(const ValidateOptions& options);

/// Runs the selected cases in order, each for itself: one that throws becomes a failed result and the next one runs.
/// Prints to `out` a table per suite, or one JSON document ("suite" is "all" and cases are named "suite/case" when
/// several suites ran). The name of every case goes to `progress` as it starts, where not null.
/// @returns 0 when nothing is not_reproduced, 1 otherwise, 2 when the selection names nothing (the message says what
///          there is); values of ExitCode.
int validate(const ValidateOptions& options, std::span<const ValidationCase> cases, std::ostream& out,
             std::ostream* progress);

/// Runs all_cases() and reports on the terminal.
int validate_main(const ValidateOptions& options);

}  // namespace riprap::validation
