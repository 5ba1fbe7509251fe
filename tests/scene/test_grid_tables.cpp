// SPDX-License-Identifier: Apache-2.0
// Waves, stones and sponges of the grid fluid: what is refused, with the number and what to change.
#include "case_fixture.hpp"

namespace riprap::scene {
namespace {

using namespace test;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

const std::string tank = R"(dimension = 2
gravity = [0.0, -9.81]
end = 1.0
[material.rock]
density = 2500.0
normal_stiffness = 1.0e7
[[body]]
name = "block"
material = "rock"
shape = { box = [0.5, 0.5] }
position = [5.0, 0.25]
[fluid]
method = "grid"
spacing = 0.05
domain = { low = [0.0, 0.0], high = [10.0, 2.0] }
[[fluid.region]]
level = 1.0
)";

std::string wave(const std::string& keys) { return tank + "[[fluid.wave]]\ntowards = \"x\"\ndepth = 1.0\n" + keys; }

struct Refusal {
    std::string name, text, message, allowed;
};

class GridTables : public testing::TestWithParam<Refusal> {};

TEST_P(GridTables, are_refused_with_what_was_read_and_what_is_allowed) {
    const std::vector<std::string> problems = problems_of(GetParam().text);
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_THAT(problems.front(), StartsWith("case.toml:"));
    EXPECT_THAT(problems.front(), HasSubstr(GetParam().message));
    EXPECT_THAT(problems.front(), HasSubstr(GetParam().allowed));
}

INSTANTIATE_TEST_SUITE_P(
    Refusals, GridTables,
    testing::Values(
        Refusal{"low_wave", wave("wave = \"solitary\"\nheight = 0.2\n"),
                "a wave 0.2 m high on cells of 0.05 m: 4 cells over its height",
                "at least 5 cells: a spacing of 0.04 m"},
        Refusal{"nearly_resolved_wave", wave("wave = \"solitary\"\nheight = 0.2499\n"), "4.99 cells over its height",
                "at least 5 cells"},
        Refusal{"wave_that_no_theory_has", wave("wave = \"solitary\"\nheight = 0.9\n"),
                "heights up to 0.75 of the depth", "a lower wave"},
        Refusal{"absorber_for_short_waves", wave("wave = \"regular\"\nheight = 0.3\nperiod = 2.0\nabsorb = true\n"),
                "a side cannot absorb waves of kd = ", "absorb = false and a [[fluid.sponge]]"},
        Refusal{"idle_side", wave("wave = \"none\"\n"), "a side that neither makes nor absorbs waves", "absorb = true"},
        Refusal{"wave_without_height", wave("wave = \"solitary\"\n"), "a wave without 'height'", "the height"},
        Refusal{"wave_without_period", wave("wave = \"regular\"\nheight = 0.3\n"), "a regular wave without 'period'",
                "the period"},
        Refusal{"wave_against_gravity",
                tank + "[[fluid.wave]]\ntowards = \"y\"\nwave = \"solitary\"\nheight = 0.3\ndepth = 1.0\n",
                "a side beside it", "'towards' along another axis"},
        Refusal{"wave_out_of_the_plane",
                tank + "[[fluid.wave]]\ntowards = \"z\"\nwave = \"solitary\"\nheight = 0.3\ndepth = 1.0\n",
                "out of the plane", "\"x\", \"-x\""},
        Refusal{"stones_elsewhere",
                tank + "[[fluid.porous]]\nshape = { polygon = [[20, 0], [21, 0], [21, 1]] }\nporosity = 0.4\n"
                       "grain_size = 0.1\nlinear = 50.0\nquadratic = 2.0\n",
                "holds the middle of no cell", "a zone in the domain"},
        Refusal{"stones_without_a_coefficient",
                tank + "[[fluid.porous]]\nshape = { polygon = [[4, 0], [6, 0], [6, 1]] }\nporosity = 0.4\n"
                       "grain_size = 0.1\nquadratic = 2.0\n",
                "[[fluid.porous]] lacks 'linear'", "mu_1 or alpha"},
        Refusal{"sponge_inside_out", tank + "[[fluid.sponge]]\ntowards = \"x\"\nlow = [9.0, 0.0]\nhigh = [8.0, 2.0]\n",
                "the sponge reaches from 9 m to 8 m along x", "low below high"},
        Refusal{"courant_above_its_bound", with(tank, "spacing = 0.05\n", "spacing = 0.05\ncourant = 0.6\n"), "0.6",
                "0.5"},
        Refusal{"three_cells", with(tank, "spacing = 0.05\n", "spacing = 0.6\n"), "3.33 cells of 0.6 m",
                "four cells at least"}),
    [](const testing::TestParamInfo<Refusal>& refusal) { return refusal.param.name; });

TEST(GridTable, takes_a_wave_of_five_cells) {
    EXPECT_THAT(problems_of(wave("wave = \"solitary\"\nheight = 0.25\n")), IsEmpty());
}

}  // namespace
}  // namespace riprap::scene
