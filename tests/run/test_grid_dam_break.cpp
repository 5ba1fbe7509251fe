// SPDX-License-Identifier: Apache-2.0
// Water that is let go on the grid.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "riprap/run/simulate/simulation.hpp"

namespace riprap::run {
namespace {

/// Water of the plane let go in a dry tank `size` times 1.6 m wide and 1 m high.
std::string let_go(double size, double spacing, double left, double bottom, double right, double top) {
    return fmt::format(R"(
dimension = 2
gravity = [0.0, -9.81]
end = 10.0
[fluid]
method = "grid"
spacing = {}
domain = {{ low = [0.0, 0.0], high = [{}, {}] }}
[[fluid.region]]
box = {{ low = [{}, {}], high = [{}, {}] }}
)",
                       size * spacing, size * 1.6, size, size * left, size * bottom, size * right, size * top);
}

/// Runs a case with all defaults and returns the most energy that the scheme made by then over the largest kinetic
/// energy by then.
double made_of_motion(const std::string& text, double end) {
    Simulation simulation(scene::read_case_text(text, "case.toml", "."));
    double most = 0, kinetic = 0;
    while (simulation.state().time < end) {
        const StepOutcome outcome = simulation.step(sim::Measure::energy);
        EXPECT_TRUE(outcome.is_accepted()) << outcome.why.text;
        if (!outcome.is_accepted()) {
            return 1;
        }
        const sim::Ledger& ledger = simulation.report().ledger;
        kinetic = std::max(kinetic, ledger.fluid.kinetic);
        most = std::max(most, -ledger.fluid.own.front() / kinetic);
    }
    return most;
}

constexpr double a_hundredth = 0.01;

// Story: a first step of 33 ms let the water gain 0.33 m/s while it fell by nothing. The next ones were a quarter as
// long, so they took back a quarter of that energy, and the run ended at 0.09 s.
TEST(GridDamBreak, makes_no_energy_at_any_size_and_spacing) {
    EXPECT_LT(made_of_motion(let_go(1, 0.025, 0, 0, 0.4, 0.55), 0.12), a_hundredth);
    EXPECT_LT(made_of_motion(let_go(1, 0.05, 0, 0, 0.4, 0.55), 0.12), a_hundredth);
    EXPECT_LT(made_of_motion(let_go(1, 0.0125, 0, 0, 0.4, 0.55), 0.06), a_hundredth);
    EXPECT_LT(made_of_motion(let_go(20, 0.025, 0, 0, 0.4, 0.55), 0.12 * std::sqrt(20)), a_hundredth);
    EXPECT_LT(made_of_motion(let_go(1, 0.025, 0, 0, 1.0, 0.25), 0.12), a_hundredth);
}

TEST(GridDamBreak, makes_no_energy_where_both_sides_of_a_tall_column_are_free) {
    EXPECT_LT(made_of_motion(let_go(2, 0.025, 0.35, 0, 0.65, 0.95), 0.16), a_hundredth);
}

TEST(GridDamBreak, makes_no_energy_beside_a_fixed_post) {
    const std::string post = R"(
[material.rock]
density = 2500.0
normal_stiffness = 1.0e7
[[body]]
name = "post"
shape = { box = [0.1, 0.2] }
position = [0.8, 0.1]
material = "rock"
fixed = true
)";
    EXPECT_LT(made_of_motion(let_go(1, 0.025, 0, 0, 0.4, 0.55) + post, 0.12), a_hundredth);
}

TEST(GridDamBreak, a_column_that_falls_through_air_makes_no_energy) {
    EXPECT_LT(made_of_motion(let_go(1, 0.025, 0.3, 0.5, 0.6, 0.9), 0.25), a_hundredth);
}

TEST(GridDamBreak, makes_no_energy_in_space) {
    const std::string tank = R"(
gravity = [0.0, 0.0, -9.81]
end = 10.0
[fluid]
method = "grid"
spacing = 0.05
domain = { low = [0.0, 0.0, 0.0], high = [1.2, 0.2, 0.8] }
[[fluid.region]]
box = { low = [0.0, 0.0, 0.0], high = [0.4, 0.2, 0.5] }
)";
    EXPECT_LT(made_of_motion(tank, 0.12), a_hundredth);
}

}  // namespace
}  // namespace riprap::run
