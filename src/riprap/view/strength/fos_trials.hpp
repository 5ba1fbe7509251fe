// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "riprap/view/strength/fos_report.hpp"

namespace riprap::view {

struct FosRequest {
    std::string case_path;               ///< the case file
    std::vector<std::string> overrides;  ///< "key=value" each
    std::filesystem::path out;           ///< one folder per trial in it, and the files of write_fos
    std::string watched;                 ///< beginning of the names of watched bodies; empty: all free ones
    run::FactorSearch::Range range;
    FailureCriteria criteria;
    std::vector<std::string> reduces;     ///< empty: all strengths
    double begins{-1}, over{0}, hold{0};  ///< of trials [s]; below 0, and 0: usual ones
    int jobs{1}, threads{1};
    bool quiet{false};
};

/// A search as it is known before any trial.
struct FosPlan {
    run::SweepOptions study;  ///< without points
    run::TrialTimes times;
    std::vector<std::int32_t> watched;
    double size{0};      ///< of the largest watched body [m]
    std::string method;  ///< solid.method
    /// The method that takes the fewest steps: planar_dda in the plane, implicit_dda in space.
    std::string proposed;
};

/// Reads the case and fills in what the request leaves open. @throws CaseError where there is nothing to reduce or to
/// watch
FosPlan plan_fos(const FosRequest& request);

/// Runs the trials, several at a time, and judges them. A search that was stopped goes on where it was, by the same
/// call. Writes write_fos at the end.
/// @returns the exit code: 0 where F is bracketed, 1 where it is not or trials contradict each other, else that of the
/// first trial that could not be judged, or 128 + a signal
/// @throws FileError where the folder holds something else
int run_fos(const FosRequest& request, const FosPlan& plan);

}  // namespace riprap::view
