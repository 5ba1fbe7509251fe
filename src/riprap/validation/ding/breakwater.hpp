// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/validation/grid/grid_trial.hpp"

// Water of the breakwater of [Ding2021, chapter 6]: a caisson behind a slope of stones, and a solitary wave.

namespace riprap::validation::ding {

/// Dimensions of [Ding2021, chapter 6]. Assumed, as the thesis gives none: stones up to half the height of the caisson.
struct Breakwater {
    static constexpr double depth = 10, wave_height = 6, caisson_height = 13, caisson_front = 15.96 * 13,
                            caisson_width = 13, slope_height = 6.5, length = 240, ceiling = 30;
    double cell_x{1.2}, cell_y{0.75};  ///< [m]
    double slope{2};                   ///< length over height of the seaward slope [-]
    double layer{2};                   ///< thickness of the armour layer T_a [m]
    bool has_rear_armour{false};       ///< a zone of stones, 6 m high and long, behind the caisson
};

/// Time at which the crest passes x = 0: half the period of the wave, for which the arrivals of the thesis fit [s].
inline constexpr double crest_at_inlet = 3.74;

grid::GridTrial make_breakwater(const Breakwater& breakwater);

/// Highest place with water within 2 m of the front of the caisson [m].
double height_at_front(const grid::GridTrial& trial);

void layer_thickness(const CaseSetting& setting, CaseReport& report);
void flow_patterns(const CaseSetting& setting, CaseReport& report);
void unit_shapes(const CaseSetting& setting, CaseReport& report);
void shoreward_slopes(const CaseSetting& setting, CaseReport& report);
void unit_cohesion(const CaseSetting& setting, CaseReport& report);

}  // namespace riprap::validation::ding
