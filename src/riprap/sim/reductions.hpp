// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

namespace riprap::sim {

/// Reductions of the values of an expected answer to one number.
inline constexpr std::array<std::string_view, 8> reductions{"last", "min", "max",  "extreme",
                                                            "mean", "at",  "when", "period"};

}  // namespace riprap::sim
