// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>

#include "riprap/validation/validate.hpp"

namespace riprap::validation {
namespace {

/// Dry cases that take well under a second and one of each kind with water that takes seconds: joint uplift, buoyancy,
/// a wave, a dam break. The others run with `riprap validate`.
class QuickCase : public testing::TestWithParam<const char*> {};

TEST_P(QuickCase, reaches_its_published_or_exact_answers) {
    ValidateOptions options;
    options.selection = {GetParam()};
    options.results = "";
    options.folder = RIPRAP_SOURCE_DIR "/validation";
    std::ostringstream table;
    EXPECT_EQ(validate(options, all_cases(), table, nullptr), 0) << table.str();
}

INSTANTIATE_TEST_SUITE_P(Validation, QuickCase,
                         testing::Values("zhao/two_tetrahedra", "rigid/free_fall", "rigid/spinning_projectile",
                                         "rigid/two_cubes", "rigid/dragged_block", "water/stacked_blocks",
                                         "water/submerged_square", "water/standing_wave", "water/dam_break_front",
                                         "mellado/two_spheres_glass", "mellado/sphere_on_plane", "mellado/restitution",
                                         "mellado/oblique_polyethylene_centre", "mellado/sliding_impact",
                                         "dda/planar_sliding_block", "dda/planar_pendulum",
                                         "dda/planar_column_plane_stress", "dda/planar_slope_tip",
                                         "dda/planar_keystone", "dda/rocking_3d_small", "ding/arch_3d_stands",
                                         "ding/dam_uplift_full"),
                         [](const auto& test) {
                             std::string name = test.param;
                             std::replace(name.begin(), name.end(), '/', '_');
                             return name;
                         });

}  // namespace
}  // namespace riprap::validation
