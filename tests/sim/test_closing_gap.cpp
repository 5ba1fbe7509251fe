// SPDX-License-Identifier: Apache-2.0
// Water that a block squeezes out of a gap of a few spacings: docs/theory/sph.md, 4, and docs/theory/coupling.md, 7.
#include <gtest/gtest.h>

#include <cmath>

#include "sim/basin.hpp"

namespace riprap::sim {
namespace {

constexpr double edge = 0.4, density = 2600, touched = 0.1 * dp;  ///< [m], [kg/m^3], gap that counts as landed [m]

/// Until a square that sinks flat is `touched` above the floor, water leaving the gap under it without friction [s]:
///
///     (m + m_a + rho b^3/(12 s)) s'^2/2 = (m - rho b^2) g (s_0 - s),
///
/// s the gap, b the edge, m_a = rho b^2/2 about of the water beside and above. Per metre of width.
double sinking_time(double gap) {
    constexpr double water = 1000, g = 9.81, area = edge * edge;
    const double mass = density * area + 0.5 * water * area, weight = (density - water) * area * g;
    constexpr int count = 2000;
    double time = 0;
    for (int i = 0; i < count; ++i) {  // s = s_0 - fall u^2 takes the pole at rest away
        const double u = (i + 0.5) / count, fall = gap - touched, s = gap - fall * u * u;
        const double inertia = mass + water * edge * area / (12 * s);
        time += 2 * u * fall / count * std::sqrt(inertia / (2 * weight * (gap - s)));
    }
    return time;
}

TEST(ClosingGap, a_block_that_sinks_flat_lands_when_the_water_under_it_has_left_and_is_then_lifted_as_archimedes_says) {
    // The last particles used to hold it up, a few spacings apart and at ten times the pressure of the place.
    for (const double spacings : {1.0, 2.0}) {
        Basin basin;
        basin.rock().damping_ratio = 0.3;  // else the landing rings on
        basin.mix();
        basin.add_square(edge, density, {1, 0.5 * edge + spacings * dp, 0});
        basin.fill_pool(2, 0.8);
        Scratch scratch;
        const auto gap = [&] { return basin.state.bodies.position[0].y - 0.5 * edge; };
        const auto step = [&] {
            const StepReport report = basin.steps(1, scratch);
            EXPECT_TRUE(report.status.ok()) << report.status.text;
            return report.status.ok();
        };
        while (basin.state.time < 1 && gap() > touched && step()) {
        }
        const double expected = sinking_time(spacings * dp);
        EXPECT_NEAR(basin.state.time, expected, 0.3 * expected) << "from " << spacings << " spacings";
        while (basin.state.time < 1 && step()) {
        }
        double uplift = 0, count = 0;
        for (; basin.state.time < 2 && step(); ++count) {
            uplift += scratch.fluid_loads().pressure.force[0].y;
        }
        uplift /= count;
        EXPECT_LT(std::abs(gap()), 0.05 * dp);
        // Of the force on its base; 0.05 was measured: particles stand about it as the landing left them.
        EXPECT_NEAR(uplift, 1000 * 9.81 * edge * edge, 0.1 * 1000 * 9.81 * 0.8 * edge);
    }
}

}  // namespace
}  // namespace riprap::sim
