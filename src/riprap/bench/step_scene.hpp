// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/sim/advance.hpp"

namespace riprap::bench {

/// A scene of blocks and water that whole steps are timed on.
struct StepScene {
    sim::Model model;
    sim::State state;
};

/// Size of the scenes below: 1 as they are timed, more for coarser particles and fewer blocks.
struct StepSize {
    double coarser{1};  ///< factor on the spacing [-]
    int fewer{1};       ///< divides the number of blocks along each axis
};

/// A column of 163 000 particles at spacing 7.9 mm falls on a box in a tank of 1.6 m by 0.67 m.
StepScene dam_break_on_box(const StepSize& size = {});

/// A dam break over a wet bed carries four floating blocks [Mellado2021]; a gate is pulled up.
StepScene dam_break_with_floes(const StepSize& size = {});

/// Where the blocks of rubble_in_basin stand.
enum class Rubble {
    none,      ///< nowhere, though the water is that of in_basin
    nowhere,   ///< nowhere, and water takes their room
    far_dry,   ///< behind a wall, where no water comes; the water is that of nowhere
    in_basin,  ///< on the floor of the basin
};

/// A basin of water at rest, 117 000 particles where a third of the blocks is in it, and 3072 cubes with gaps of half
/// an edge in a heap of 12 layers.
/// @param wet  depth of the water over the height of the heap [-]
StepScene rubble_in_basin(Rubble rubble, double wet, const StepSize& size = {});

/// 500 blocks slide down a plane at 35 degrees into water, at 2 m/s when it begins.
StepScene slide_into_water(const StepSize& size = {});

}  // namespace riprap::bench
