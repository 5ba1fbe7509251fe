// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace riprap::fluid::wcmps {

/// Limits of the classification [JandaghianShakibaeinia2020].
inline constexpr double splash_limit = 0.4;      ///< beta_E of C
inline constexpr double surface_limit = 0.9;     ///< beta_F of C
inline constexpr double neighbour_limit = 0.75;  ///< beta_N of N/N_0

}  // namespace riprap::fluid::wcmps
