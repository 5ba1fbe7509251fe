// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

namespace riprap::sim {

/// Reductions of the values of an expected answer to one number.
inline constexpr std::array<std::string_view, 10> reductions{"last", "min",  "max",    "extreme", "mean",
                                                             "at",   "when", "period", "rms",     "worst"};

/// Tells whether a reduction compares with points of another source.
constexpr bool is_of_curve(std::string_view reduction) { return reduction == "rms" || reduction == "worst"; }

}  // namespace riprap::sim
