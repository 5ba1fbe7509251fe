// SPDX-License-Identifier: Apache-2.0
#include "riprap/validation/mellado/mean_surface.hpp"

#include <gtest/gtest.h>

namespace riprap::validation::mellado {
namespace {

// The block of 0.1 m leaves lines free in its tank of 0.5 m, though the slice that stands for it is a metre thick.
TEST(MeanSurface, of_a_tank_in_the_plane_is_read_beside_the_block_in_it) {
    CaseSetting setting;
    setting.folder = "validation/mellado/block_entry";
    const std::vector<std::string> coarse{"fluid.spacing=0.025", "end=1e-3"};
    const water::WaterTrial trial(setting, coarse);
    EXPECT_NEAR(mean_surface(trial, {}, {0.5, 1.0, 0}), 0.5, 0.005);
}

}  // namespace
}  // namespace riprap::validation::mellado
