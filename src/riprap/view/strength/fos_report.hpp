// SPDX-License-Identifier: Apache-2.0
#pragma once

// Result of a search for the factor of safety, for people and as files.

#include <filesystem>
#include <string>
#include <vector>

#include "riprap/run/strength/factor_search.hpp"
#include "riprap/run/strength/trial_plan.hpp"
#include "riprap/view/strength/trial_verdict.hpp"

namespace riprap::view {

struct FosReport {
    run::FactorSearch::Range range;
    run::TrialTimes times;
    FailureCriteria criteria;
    std::vector<std::string> reduces;  ///< empty: all strengths
    double stood{0}, failed{0};        ///< the bracket; 0 = none
    std::vector<double> contradictions;
    std::vector<TrialVerdict> trials;  ///< by factor, ascending

    bool is_found() const { return stood > 0 && failed > 0; }
    /// Middle of the bracket [-].
    double factor() const { return 0.5 * (stood + failed); }
    /// Returns the trial at the upper end of the bracket, which shows the mode; nullptr where none failed.
    const TrialVerdict* failing() const;
};

/// One line: "factor of safety 1.284, 1.279 to 1.289".
std::string headline(const FosReport& report);
/// The result for people: bracket, mode by block, warnings with their remedies.
std::string fos_text(const FosReport& report);

/// Writes fos.json, fos.csv (the trials), fos_bodies.csv (the mode), fos.svg and the page of all trials, index.html,
/// into the folder of the study.
/// @param study  all trials, by factor
/// @returns the page
std::filesystem::path write_fos(const run::SweepOptions& study, const FosReport& report);

}  // namespace riprap::view
