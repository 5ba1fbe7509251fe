// SPDX-License-Identifier: Apache-2.0
// One floating box finds its draft in every fluid that one word chooses.
#include <gtest/gtest.h>

#include "riprap/run/simulate/simulation.hpp"
#include "riprap/scene/read_case.hpp"

namespace riprap::run {
namespace {

/// Mean height of the box of cases/floating_box over two periods of its heave [m].
double mean_height(const std::string& method) {
    const std::vector<std::string> overrides{"fluid.spacing=0.02", "fluid.method=" + method, "end=1.8"};
    Simulation simulation(scene::read_case("cases/floating_box/case.toml", overrides));
    const std::size_t box = simulation.state().bodies.position.size() - 1;
    double sum = 0, before = simulation.state().time;
    while (simulation.steps_left() > 0) {
        EXPECT_TRUE(simulation.step(sim::Measure::flow).is_accepted());
        const double now = simulation.state().time;
        sum += (now - before) * simulation.state().bodies.position[box].y;
        before = now;
    }
    return sum / before;
}

TEST(FloatingBox, FindsItsDraftInEveryFluid) {
    // A heave a sin(w t), a = 0.0143 m, w = 7/s, moves the mean over a time t by 2 a/(w t) at most.
    constexpr double band = 0.003;
    for (const std::string method : {"sph", "hydrostatic"}) {
        EXPECT_NEAR(mean_height(method), 0.4, band) << method;
    }
}

}  // namespace
}  // namespace riprap::run
