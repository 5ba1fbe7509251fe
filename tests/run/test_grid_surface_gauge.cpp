// SPDX-License-Identifier: Apache-2.0
// Gauges of the surface of the grid's water.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <utility>

#include "riprap/run/simulate/simulation.hpp"
#include "riprap/scene/read_case.hpp"

namespace riprap::run {
namespace {

constexpr double spacing = 0.1;

/// Still water up to a height in a tank 2 m long, and a gauge at x.
double surface_of(double height, double x, const char* kind = "surface") {
    const std::string text = fmt::format(R"(
dimension = 2
gravity = [0.0, -9.81]
end = 1.0
[material.rock]
density = 2500.0
normal_stiffness = 1e6
[fluid]
method = "grid"
spacing = {0}
domain = {{ low = [0.0, 0.0], high = [2.0, 1.2] }}
[[fluid.region]]
box = {{ low = [0.0, 0.0], high = [2.0, {1}] }}
[[body]]
name = "pier"
shape = {{ box = [0.25, 1.0] }}
position = [1.5, 0.5]
fixed = true
material = "rock"
[[output.gauge]]
name = "eta"
kind = "{3}"
point = [{2}, 0.0]
end = [{2}, 1.1]
)",
                                         spacing, height, x, kind);
    Simulation simulation(scene::read_case_text(text, "case.toml", "."));
    simulation.step(sim::Measure::energy);
    return sim::evaluate(*sim::find_column(simulation.model(), "eta"), simulation.now());
}

// Story: a `surface` gauge read 0.49 or 0.59 m of any level between, for cells of a tenth of a metre.
TEST(GridSurfaceGauge, reads_the_level_of_still_water_to_a_hundredth_of_a_cell) {
    for (const double level : {0.502, 0.51, 0.53, 0.55, 0.57, 0.598, 0.6}) {
        for (const double x : {0.02, 0.53, 1.33, 1.98}) {  // beside a side of the domain and a pier too
            EXPECT_NEAR(surface_of(level, x), level, 0.01 * spacing) << level << " at x = " << x;
        }
        EXPECT_NEAR(surface_of(level, 0.53, "run_up"), level, 0.01 * spacing) << level;
    }
}

// Before the first solve P = p - rho g.x is 0 everywhere, and gauges showed rho g.x: -1962 Pa at 0.2 m of 0.6 m.
TEST(GridSurfaceGauge, PressureBeforeTheFirstStepIsThatOfWaterAtRest) {
    const auto at_start = [](double x, double y, const char* entry) {
        const std::string text = fmt::format(R"(
dimension = 2
gravity = [0.0, -9.81]
end = 1.0
[material.rock]
density = 2500.0
normal_stiffness = 1e6
[fluid]
method = "grid"
spacing = 0.1
domain = {{ low = [{0}, {1}], high = [{2}, {3}] }}
[[fluid.region]]
box = {{ low = [{0}, {1}], high = [{2}, {4}] }}
[[body]]
name = "pier"
shape = {{ box = [0.25, 1.0] }}
position = [{5}, {6}]
fixed = true
material = "rock"
[[output.gauge]]
name = "p"
{7}
)",
                                             x, y, x + 2, y + 1.2, y + 0.63, x + 1.5, y + 0.5,
                                             fmt::format(fmt::runtime(entry), x + 1.375, y + 0.25, x + 0.77, y + 0.2));
        const Simulation simulation(scene::read_case_text(text, "case.toml", "."));
        return sim::evaluate(*sim::find_column(simulation.model(), "p"), simulation.now());
    };
    for (const auto& [x, y] : {std::pair{0.0, 0.0}, std::pair{-3.0, 40.0}, std::pair{432150.0, 5103420.0}}) {
        EXPECT_NEAR(at_start(x, y, "kind = \"pressure\"\npoint = [{2}, {3}]"), 9810 * 0.43, 1e-3);
        EXPECT_NEAR(at_start(x, y, "kind = \"wall_pressure\"\nbody = \"pier\"\npoint = [{0}, {1}]"), 9810 * 0.38, 1);
    }
}

}  // namespace
}  // namespace riprap::run
