// SPDX-License-Identifier: Apache-2.0
// The account of the water of the grid: bodies that press closed pockets together.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "riprap/run/simulate/simulation.hpp"
#include "riprap/scene/read_case.hpp"

namespace riprap::run {
namespace {

using testing::HasSubstr;

/// A tank 1 m wide of a floor and two walls, water in it up to a height, and one more body between or over the walls.
std::string tank(double height, double wall, const std::string& body) {
    return fmt::format(R"(
dimension = 2
gravity = [0.0, -9.81]
end = 10.0
[material.rock]
density = 2500.0
normal_stiffness = "20 MPa"
friction_coefficient = 0.3
damping_ratio = 0.1
[fluid]
method = "grid"
spacing = 0.05
domain = {{ low = [-0.4, -0.4], high = [1.4, 2.0] }}
[[fluid.region]]
box = {{ low = [0.0, 0.0], high = [1.0, {0}] }}
[[body]]
name = "floor"
material = "rock"
shape = {{ box = [1.6, 0.3] }}
position = [0.5, -0.15]
fixed = true
[[body]]
name = "left"
material = "rock"
shape = {{ box = [0.3, {1}] }}
position = [-0.15, {2}]
fixed = true
[[body]]
name = "right"
material = "rock"
shape = {{ box = [0.3, {1}] }}
position = [1.15, {2}]
fixed = true
[[body]]
name = "lid"
material = "rock"
{3}
)",
                       height, wall, 0.5 * wall, body);
}

struct End {
    std::string problem, remedy;  ///< empty where the run has gone on to its time
    double time{0};               ///< [s]
    double lost{0};               ///< largest share of the water that was missing at the end of a step
};

End run_to(const std::string& text, double time) {
    Simulation simulation(scene::read_case_text(text, "case.toml", "."));
    End end;
    const auto mass = [&] {
        return sim::evaluate(*sim::find_column(simulation.model(), "water_mass"), simulation.now());
    };
    double at_start = 0;
    while (simulation.state().time < time) {
        const StepOutcome outcome = simulation.step(sim::Measure::energy);
        if (outcome.kind == StepOutcome::Kind::refused) {
            end.problem = outcome.why.text;
            end.remedy = outcome.why.remedy;
            break;
        }
        at_start = at_start == 0 ? mass() : at_start;
        end.lost = std::max(end.lost, std::abs(mass() / at_start - 1));
    }
    end.time = simulation.state().time;
    return end;
}

// Story: 500 kg/m of water under a piston became 214, and 1000 under a lid 854, with exit 0.
TEST(GridAccount, a_piston_as_wide_as_its_tank_ends_the_run_once_the_air_below_it_is_gone) {
    for (const double gap : {0.01, 0.04}) {
        const End end = run_to(tank(0.5, 1.9,
                                    fmt::format("shape = {{ box = [1.0, 0.1] }}\nposition = [0.5, {}]\nmotion "
                                                "= {{ linear = {{ velocity = [0.0, -0.3] }} }}\n",
                                                0.55 + gap)),
                               0.5);
        EXPECT_THAT(end.problem, HasSubstr("'lid' presses together the pocket of 0.48")) << gap;
        EXPECT_THAT(end.problem, HasSubstr("allowed: 3 % more"));
        EXPECT_THAT(end.remedy, HasSubstr("a gap of 0.1 m, two cells"));
        EXPECT_NEAR(end.time, (gap + 0.03 * 0.5) / 0.3, 0.02) << gap;
        EXPECT_LT(end.lost, 1e-9) << gap;
    }
}

TEST(GridAccount, a_lid_that_presses_a_full_box_together_by_three_hundredths_ends_the_run) {
    const End end = run_to(tank(1.0, 1.0,
                                "shape = { box = [1.6, 0.2] }\nposition = [0.5, 1.1]\nmotion = { linear = { "
                                "velocity = [0.0, -0.3] } }\n"),
                           0.5);
    EXPECT_THAT(end.problem, HasSubstr("'lid' presses together the pocket of 0.97"));
    EXPECT_NEAR(end.time, 0.03 / 0.3, 0.01);
    EXPECT_LT(end.lost, 1e-9);
}

TEST(GridAccount, a_block_as_wide_as_its_tank_is_carried_by_the_water_below_it) {
    for (const char* solid : {"distance_potential_dem", "planar_dda"}) {
        const End end = run_to(tank(0.9, 1.9,
                                    fmt::format("shape = {{ box = [1.0, 0.2] }}\nposition = [0.5, 0.6]\n"
                                                "[solid]\nmethod = \"{}\"\n",
                                                solid)),
                               0.5);
        EXPECT_EQ(end.problem, "") << solid;
        EXPECT_LT(end.lost, 1e-9) << solid;
    }
}

TEST(GridAccount, a_piston_that_is_drawn_out_of_a_full_pocket_under_water_ends_the_run) {
    const End end = run_to(tank(0.9, 1.9,
                                "shape = { box = [1.0, 0.2] }\nposition = [0.5, 0.5]\nmotion = { linear = { "
                                "velocity = [0.0, 0.3] } }\n"),
                           0.5);
    EXPECT_THAT(end.problem, HasSubstr("'lid' draws apart the pocket of "));
    EXPECT_THAT(end.problem, HasSubstr("of water would come in through closed walls"));
    EXPECT_LT(end.time, 0.02);
}

TEST(GridAccount, a_piston_with_the_gap_that_the_remedy_names_goes_through_the_water) {
    const End end = run_to(tank(0.5, 1.9,
                                "shape = { box = [0.8, 0.1] }\nposition = [0.5, 0.56]\nmotion = { linear = { "
                                "velocity = [0.0, -0.3] } }\n"),
                           1.0);
    EXPECT_EQ(end.problem, "");
    EXPECT_LT(end.lost, 1e-9);
}

TEST(GridAccount, a_block_that_comes_to_rest_on_two_steps_under_water_may_close_the_pocket_below_it) {
    const std::string steps = R"(
[[body]]
name = "step_a"
material = "rock"
shape = { box = [0.2, 0.1] }
position = [0.3, 0.05]
fixed = true
[[body]]
name = "step_b"
material = "rock"
shape = { box = [0.2, 0.1] }
position = [0.7, 0.05]
fixed = true
)";
    const End end = run_to(tank(0.5, 1.9, "shape = { box = [0.6, 0.1] }\nposition = [0.5, 0.165]\n" + steps), 1.0);
    EXPECT_EQ(end.problem, "");
    EXPECT_LT(end.lost, 1e-9);
}

/// In space: a piston 0.4 m square in a shaft as wide.
TEST(GridAccount, a_piston_in_space_ends_the_run) {
    const End end = run_to(R"(
gravity = [0.0, 0.0, -9.81]
end = 1.0
[material.rock]
density = 2500.0
normal_stiffness = 2e7
[fluid]
method = "grid"
spacing = 0.05
domain = { low = [0.0, 0.0, 0.0], high = [0.4, 0.4, 0.6] }
[[fluid.region]]
box = { low = [0.0, 0.0, 0.0], high = [0.4, 0.4, 0.3] }
[[body]]
name = "piston"
material = "rock"
shape = { box = [0.4, 0.4, 0.1] }
position = [0.2, 0.2, 0.36]
motion = { linear = { velocity = [0.0, 0.0, -0.2] } }
)",
                           0.5);
    EXPECT_THAT(end.problem, HasSubstr("'piston' presses together the pocket of 0.046"));
    EXPECT_THAT(end.problem, HasSubstr("m^3 around (0.2, 0.2, 0.14"));
    EXPECT_NEAR(end.time, (0.01 + 0.03 * 0.3) / 0.2, 0.02);
    EXPECT_LT(end.lost, 1e-9);
}

}  // namespace
}  // namespace riprap::run
