// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

namespace riprap::sim {

/// Reductions of the values of an expected answer to one number.
inline constexpr std::array<std::string_view, 16> reductions{
    "last", "min",    "max", "extreme",    "time_of_min", "time_of_max", "mean",     "at",
    "when", "period", "rms", "mean_error", "worst",       "noise",       "incident", "reflection"};

/// Tells whether a reduction compares with points of another source.
constexpr bool is_of_curve(std::string_view reduction) {
    return reduction == "rms" || reduction == "mean_error" || reduction == "worst";
}

/// Tells whether a reduction takes the waves along a profile of gauges apart.
constexpr bool is_of_waves(std::string_view reduction) { return reduction == "incident" || reduction == "reflection"; }

/// Tells whether a reduction gives a time.
constexpr bool is_time(std::string_view reduction) { return reduction == "time_of_min" || reduction == "time_of_max"; }

/// Word for `along` of a curve whose points lie along the gauges of a profile, read at one time.
inline constexpr std::string_view along_profile = "place";

}  // namespace riprap::sim
