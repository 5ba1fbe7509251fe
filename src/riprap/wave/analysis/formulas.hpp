// SPDX-License-Identifier: Apache-2.0
#pragma once

// Formulas that an engineer holds the answers of a run against.

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace riprap::wave {

/// An input of the formulas: a number of the sea or of the structure.
struct FormulaInput {
    std::string_view key, unit, help;
};
std::span<const FormulaInput> formula_inputs();

/// Values of inputs by their keys.
using FormulaValues = std::map<std::string, double, std::less<>>;

/// An answer with the band that nine of ten of the tests behind the formula lie in.
struct Predicted {
    double value, low, high;
};

/// One formula. Its coefficients c have a deviation s; `answer` takes c + n s, n = 0 for the mean and 1 for design.
struct Formula {
    std::string_view name, quantity, unit, source, range;
    std::vector<std::string_view> inputs;
    double (*answer)(const FormulaValues& given, double deviations);
    bool (*is_in_range)(const FormulaValues& given);
    bool has_band;  ///< the source states deviations
};
std::span<const Formula> formulas();

/// The first input that a formula lacks; empty where it has all.
std::string_view lacks(const Formula& formula, const FormulaValues& given);

/// Mean and band, mean -+ 1.645 deviations. @pre the formula lacks nothing
Predicted predict(const Formula& formula, const FormulaValues& given);

}  // namespace riprap::wave
