// SPDX-License-Identifier: Apache-2.0
#pragma once

// Judges what the runs of one case give together: ratios of answers and orders of convergence.

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>

#include "riprap/scene/assemble/variations.hpp"
#include "riprap/validation/result.hpp"

namespace riprap::validation {

/// Keeps what one run of a case answered.
struct RunAnswers {
    struct Answer {
        double value{0};
        std::optional<double> exact{};
    };
    scene::Variation variation;
    std::map<std::string, Answer> of;  ///< by name of the [[expect]]
};

/// @param expects  [[expect]] of the case as it was run, @param found  what its summary says of each
RunAnswers answers_of_run(const scene::Value& expects, const nlohmann::json& found, const scene::Variation& variation);

/// Reports [[vary.ratio]] and [[vary.order]] of a case.
/// @param checked  the case, its keys checked, @param runs  those that finished
void compare_runs(const scene::Value& checked, std::span<const RunAnswers> runs, CaseReport& report);

/// Slope of log y over log x by least squares [-]; NaN for fewer than two pairs that are positive.
double logarithmic_slope(std::span<const double> x, std::span<const double> y);

}  // namespace riprap::validation
