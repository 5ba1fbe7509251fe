// SPDX-License-Identifier: Apache-2.0
#pragma once

// One case with every solid method and every fluid, its expected answers judged in each.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "riprap/run/figures/expects.hpp"

namespace riprap::run {

struct MatrixOptions {
    std::string case_path;
    std::vector<std::string> overrides;  ///< "key=value" each, of every combination
    std::string quantity;    ///< column to show; empty: of the first expected answer that is missed, else of the first
    bool has_scales{false};  ///< also with the step and the stiffness of the solid method times 1/4 and 4
    double most_seconds{600};  ///< processor time after which a run is stopped, as wrong [s]
};

/// Finding of one run. It is right where every expected answer is.
enum class Finding {
    right,
    wrong,     ///< an answer was missed, the run ended early, or it was refused without a physics that is missing
    refused,   ///< for physics that the methods lack
    unjudged,  ///< it ran, and the case expects nothing
};
std::string_view to_string(Finding finding);

/// Outcome of one run.
struct MatrixEntry {
    std::string solid, fluid;  ///< words of the case; fluid "none" where the case has no fluid
    std::string variation;     ///< what differs from the case: a [[vary]] or a scale; empty: nothing
    Finding finding{Finding::unjudged};
    std::vector<ExpectResult> answers{};
    std::string quantity{};  ///< that is shown
    double value{0};         ///< of the quantity; reduced as the expected answer asks. NaN where there is none
    double ns{0};            ///< wall time of a step
    double seconds{0};       ///< processor time of the run [s]
    double residual{0};      ///< of the energy ledger over what was turned over [-]; NaN where it did not run
    std::string why{};       ///< missing physics, how the run ended, or by which band an answer was missed
};

struct MatrixResult {
    std::string title;
    std::vector<MatrixEntry> entries;
};

/// Runs a case in memory with every combination of its solid.method and fluid.method, as it is and at the values of its
/// [[vary]]. @param each  is told of every entry as it is there
/// @throws FileError where there is no such case; CaseError where it cannot be read with the methods that it names
MatrixResult run_matrix(const MatrixOptions& options, const std::function<void(const MatrixEntry&)>& each = {});

std::string matrix_json(const MatrixResult& result);

/// A line for every combination, and one above them.
std::string matrix_heading();
std::string matrix_line(const MatrixEntry& entry);
/// "12 right, 1 wrong, 4 refused"
std::string matrix_counts(const std::vector<MatrixEntry>& entries);

}  // namespace riprap::run
