// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "riprap/validation/after_step.hpp"
#include "riprap/validation/result.hpp"
#include "riprap/view/plot_svg.hpp"

namespace riprap::validation {

// Every case draws its curves with these.
using view::Axis;
using view::Curve;
using view::CurveStyle;
using view::Plot;

/// Input of a case besides its report.
struct CaseSetting {
    std::filesystem::path folder;   ///< validation/<suite>/<case> with the case's files
    std::filesystem::path results;  ///< where plots go; empty = none are written
    bool is_full{false};            ///< the long version
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

/// Every case, in the order in which they run. One explicit list: nothing registers itself.
std::span<const ValidationCase> all_cases();

/// Writes a plot as <results>/<name>.svg; does nothing when no plots are wanted.
void write_plot(const CaseSetting& setting, std::string_view name, const Plot& plot);

}  // namespace riprap::validation
