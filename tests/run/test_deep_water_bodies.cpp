// SPDX-License-Identifier: Apache-2.0
// Bodies let go and held in the middle of deep water, by the moving particle methods. Added masses in this tank, over
// that of the displaced water, are of a potential flow with p = 0 at the surface, by boundary elements: 200 panels on
// walls and surface, as many on the body; a disc far from all walls comes out as 1.001 (exact: 1).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "riprap/run/simulate/simulation.hpp"
#include "riprap/scene/read_case.hpp"

namespace riprap::run {
namespace {

constexpr const char* tank = R"(dimension = 2
gravity = [0.0, -9.81]
end = 0.1
[material.rock]
density = 2500.0
normal_stiffness = 1.0e6
[fluid]
method = "wcmps"
spacing = 0.04
domain = { low = [-0.24, -0.24], high = [1.76, 1.6] }
[[fluid.region]]
box = { low = [0.0, 0.0], high = [1.52, 1.2] }
[[body]]
name = "bottom"
material = "rock"
shape = { half_space = { normal = [0.0, 1.0] } }
fixed = true
[[body]]
name = "left"
material = "rock"
shape = { half_space = { normal = [1.0, 0.0] } }
fixed = true
[[body]]
name = "right"
material = "rock"
shape = { half_space = { normal = [-1.0, 0.0] } }
position = [1.52, 0.0]
fixed = true
[[body]]
name = "body"
material = "rock"
position = [0.76, 0.6]
)";

constexpr double gravity = 9.81;

struct Shape {
    const char *name, *text;
    double added_mass;  ///< C_a [-]
};
constexpr Shape disc{"disc", "shape = { sphere = 0.16 }\n", 1.076};
constexpr Shape box{"box", "shape = { box = [0.32, 0.32] }\n", 1.308};
constexpr Shape corner{"corner", "shape = { box = [0.32, 0.32] }\norientation = { angle = 0.7853982 }\n", 1.311};
constexpr Shape hexagon{"hexagon",
                        "shape = { polygon = [[0.184752, 0.0], [0.092376, 0.16], [-0.092376, 0.16], [-0.184752, 0.0], "
                        "[-0.092376, -0.16], [0.092376, -0.16]] }\n",
                        1.137};

Simulation start(const Shape& shape, const std::vector<std::string>& more) {
    return Simulation(scene::read_case_text(std::string(tank) + shape.text, "case.toml", "/nonexistent", more));
}

/// Upward speed that the body gains until the end [m/s].
double gained(const Shape& shape, const std::vector<std::string>& more) {
    Simulation simulation = start(shape, more);
    while (simulation.steps_left() > 0) {
        EXPECT_TRUE(simulation.step(sim::Measure::flow).is_accepted());
    }
    return simulation.state().bodies.velocity.back().y;
}

struct Release {
    const char* fluid;
    Shape shape;
    double density;  ///< over that of water [-]
};
void PrintTo(const Release& release, std::ostream* out) { *out << release.fluid << ' ' << release.density; }

class DeepWater : public ::testing::TestWithParam<Release> {};

// At the density of the lattice water of mps fell in the first 0.05 s, and a light disc started late.
INSTANTIATE_TEST_SUITE_P(
    Bodies, DeepWater,
    ::testing::Values(Release{"wcmps", disc, 0.7}, Release{"wcmps", disc, 2.5}, Release{"wcmps", box, 0.7},
                      Release{"wcmps", corner, 1.5}, Release{"wcmps", hexagon, 0.7}, Release{"mps", disc, 0.7},
                      Release{"mps", disc, 1.5}, Release{"mps", box, 2.5}, Release{"mps", box, 0.7},
                      Release{"mps", corner, 0.7}, Release{"mps", hexagon, 0.7}, Release{"mps", hexagon, 2.5}),
    [](const auto& release) {
        return fmt::format("{}_{}_{:.0f}", release.param.fluid, release.param.shape.name, 10 * release.param.density);
    });

// The published weight, and walls that mirror each particle, gave half of it.
TEST_P(DeepWater, a_body_let_go_gains_speed_by_its_weight_and_its_added_mass) {
    const Release& release = GetParam();
    const std::vector<std::string> more{fmt::format("fluid.method=\"{}\"", release.fluid),
                                        fmt::format("body.body.density={}", 1000 * release.density)};
    const double expected = gravity * (1 - release.density) / (release.density + release.shape.added_mass) * 0.1;
    EXPECT_NEAR(gained(release.shape, more), expected, 0.15 * std::abs(expected));
}

class DeepWaterDisc : public ::testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Words, DeepWaterDisc, ::testing::Values("wcmps", "mps"),
                         [](const auto& word) { return word.param; });

TEST_P(DeepWaterDisc, goes_on_to_rise_where_the_published_weight_held_it) {
    // 0.839 m/s after half a second in a potential flow
    const std::vector<std::string> own{"fluid.method=" + GetParam(), "body.body.density=700", "end=0.5"};
    std::vector<std::string> published = own;
    published.insert(published.end(), {"fluid.weight=reciprocal", "fluid.wall_pressure=mirrored"});
    EXPECT_GT(gained(disc, own), 0.6);
    EXPECT_LT(gained(disc, published), 0.4);
}

TEST_P(DeepWaterDisc, is_lifted_by_the_weight_of_its_water_where_it_is_held) {
    Simulation simulation = start(disc, {"fluid.method=" + GetParam(), "body.body.fixed=true", "end=0.8"});
    const std::size_t body = simulation.state().bodies.position.size() - 1;
    double impulse = 0, seconds = 0, before = 0;
    while (simulation.steps_left() > 0) {
        ASSERT_TRUE(simulation.step(sim::Measure::flow).is_accepted());
        const double now = simulation.state().time;
        if (now > 0.4) {
            impulse += (now - before) * simulation.scratch().fluid_loads().pressure.force[body].y;
            seconds += now - before;
        }
        before = now;
    }
    const double weight = 1000 * gravity * 3.14159265 * 0.16 * 0.16;
    EXPECT_NEAR(impulse / seconds, weight, 0.02 * weight);
}

// Water stands in the joint under a block that lies on the bed: without it the block was pressed down with 853 N/m.
TEST(DeepWaterJoint, lifts_a_block_on_the_bed_by_the_weight_of_its_water_with_mps) {
    constexpr const char* bed = R"(dimension = 2
gravity = [0.0, -9.81]
end = 0.2
[material.rock]
density = 1900.0
[solid]
method = "planar_dda"
[fluid]
method = "mps"
spacing = 0.02
domain = { low = [-0.1, -0.1], high = [1.1, 1.0] }
[[fluid.region]]
box = { low = [0.0, 0.0], high = [1.0, 0.6] }
[[body]]
name = "floor"
shape = { box = [1.2, 0.1] }
position = [0.5, -0.05]
material = "rock"
fixed = true
[[body]]
name = "left"
shape = { box = [0.1, 1.0] }
position = [-0.05, 0.5]
material = "rock"
fixed = true
[[body]]
name = "right"
shape = { box = [0.1, 1.0] }
position = [1.05, 0.5]
material = "rock"
fixed = true
[[body]]
name = "block"
shape = { box = [0.2, 0.16] }
position = [0.5, 0.08]
material = "rock"
)";
    Simulation simulation(scene::read_case_text(bed, "case.toml", "/nonexistent", {}));
    const std::size_t body = simulation.state().bodies.position.size() - 1;
    double impulse = 0, before = 0;
    while (simulation.steps_left() > 0) {
        ASSERT_TRUE(simulation.step(sim::Measure::flow).is_accepted());
        const double now = simulation.state().time;
        impulse += now > 0.1 ? (now - before) * simulation.scratch().fluid_loads().pressure.force[body].y : 0;
        before = now;
    }
    EXPECT_NEAR(impulse / 0.1, 1000 * gravity * 0.2 * 0.16, 0.03 * 1000 * gravity * 0.2 * 0.16);
}

}  // namespace
}  // namespace riprap::run
