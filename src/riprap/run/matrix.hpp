// SPDX-License-Identifier: Apache-2.0
#pragma once

// One case with every solid method and every fluid.

#include <functional>
#include <string>
#include <vector>

namespace riprap::run {

struct MatrixOptions {
    std::string case_path;
    std::vector<std::string> overrides;  ///< "key=value" each, of every combination
    std::string quantity;  ///< column to compare; empty: of the first expected answer, else of the first record
};

/// Outcome of one combination.
struct MatrixEntry {
    std::string solid, fluid;  ///< words of the case; fluid "none" where the case has no fluid
    std::string status;        ///< "ran", "illegal" (refused before the first step) or "failed"
    double value{0};     ///< of the quantity at the end; reduced as the expected answer asks. NaN where it did not run
    double ns{0};        ///< wall time of a step
    double residual{0};  ///< of the energy ledger over what was turned over [-]
    std::string why;     ///< of what is illegal or failed
};

struct MatrixResult {
    std::string quantity;
    std::vector<MatrixEntry> entries;
};

/// Runs a case in memory with every combination of its solid.method and fluid.method. A combination that the reader
/// refuses is illegal, and the reader says why. @param each  is told of every entry as it is there
/// @throws FileError where there is no such case
MatrixResult run_matrix(const MatrixOptions& options, const std::function<void(const MatrixEntry&)>& each = {});

std::string matrix_json(const MatrixResult& result);

/// A line for every combination, and one above them.
std::string matrix_heading(const std::string& quantity);
std::string matrix_line(const MatrixEntry& entry);

}  // namespace riprap::run
