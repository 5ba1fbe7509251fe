// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "riprap/validation/water/water_trial.hpp"

// One dam break with floes [Mellado2021, 3] [Amaro2021]: how it is set up and what is read of it.

namespace riprap::validation::mellado {

inline constexpr std::array bed_depths{0.0, 0.01, 0.025, 0.05};  ///< of the water below the dam [m]
inline constexpr double floe_thickness = 0.0195;                 ///< [m]
inline constexpr double rest_time = 3.0;  ///< from here on waves run back and forth over a level [s]
/// When floes are said to weaken impact, run-up and splash [s].
inline constexpr double late = 1.6, late_end = 2.4;

/// Spacing of the particles: a twelfth of the depth behind the gate; --full: six to the thickness of a floe [m].
double floe_spacing(const CaseSetting& setting);

struct FloeRun {
    double depth{0.025}, end{1.5};
    std::string_view fluid{"wcmps"}, solid{"sphere_dem"};
    std::vector<std::string> more{};
};

struct FloeOutcome {
    double arrival{std::nan("")};            ///< of the front at the downstream wall [s]
    double level{std::nan("")};              ///< mean of the free surface over the last half second [m]
    double expected_level{std::nan("")};     ///< volume of the water and of what floats in it, over the tank [m]
    double level_behind_gate{std::nan("")};  ///< the same over the part behind the gate [m]
    std::optional<water::WaterTrial> trial{};

    /// Row of the largest x of a block until then.
    std::size_t row_of_farthest(const std::string& block, double until = 1.5) const;
    double farthest(const std::string& block) const;
    /// Mean height of the centres of blocks from `start` to the end [m].
    double mean_height(std::span<const std::string> blocks, double start) const;
    /// Highest splash of the late stages: height above which a hundredth of the water stands [m].
    double late_splash() const;
};

/// One run of validation/mellado/<folder>. The long version is saved on its way, so that a killed one goes on.
FloeOutcome run_floes(const CaseSetting& setting, const std::string& folder, const FloeRun& run);

}  // namespace riprap::validation::mellado
