// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "riprap/validation/grid/grid_trial.hpp"

namespace riprap::validation::grid {
namespace {

/// Water under air, both at 2 m/s through a channel 1 m high, without gravity: nothing changes.
GridTrial half_full_channel() {
    GridSettings settings = make_tank({}, {2, 1, 0.5}, {16, 8, 1});
    settings.gravity = {};
    settings.side[0].kind = SideKind::inflow;
    settings.side[0].inflow = [](const Vec3& x, double) { return Inflow{{2, 0, 0}, x.y < 0.5 ? 1.0 : 0.0}; };
    settings.side[1].kind = SideKind::open;
    return {settings, make_state(
                          settings, [](const Vec3& x) { return x.y < 0.5 ? 1.0 : 0.0; },
                          [](const Vec3&) {
                              return Vec3{2, 0, 0};
                          })};
}

// Gauges are read before the first step too: a case crashed there, as no flux has been computed then.
TEST(GridTrial, reads_the_flow_of_water_alone_and_none_before_the_first_step) {
    GridTrial trial = half_full_channel();
    trial.add("flow", [](const GridTrial& t) { return t.flow_at(1.0); });
    trial.run(0.1);
    ASSERT_GT(trial.column("flow").size(), 2U);
    EXPECT_EQ(trial.column("flow").front(), 0);
    EXPECT_NEAR(trial.column("flow").back(), 2 * 0.5, 1e-6);
}

}  // namespace
}  // namespace riprap::validation::grid
