// SPDX-License-Identifier: Apache-2.0
// Sampled bodies that meet face to face, off the lattices of their spheres.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "riprap/core/quat.hpp"
#include "riprap/run/simulate/simulation.hpp"
#include "riprap/scene/read_case.hpp"

namespace riprap::run {
namespace {

/// A cube that strikes a larger one at rest, face on face, off its centre by `offset`.
struct Impact {
    double small{0.4}, large{1.0};  ///< edges [m]
    Vec3 offset{0, 0.1, 0.07};      ///< [m]
    double restitution{1};
    double turned{0};  ///< the whole scene, about (1, 2, 3) [rad]
    std::string laws{};
    bool small_is_ball{false};  ///< of that diameter
};

struct After {
    Vec3 small, large, spin_of_small;  ///< [m/s], [rad/s], in the axes of the scene before it is turned
};

std::string text_of(const Vec3& v) { return fmt::format("[{}, {}, {}]", v.x, v.y, v.z); }

After strike(const Impact& impact) {
    const Vec3 axis = normalized(Vec3{1, 2, 3});
    const Quat turn = from_rotation_vector(impact.turned * axis);
    const std::string orientation = fmt::format("orientation = {{ axis_angle = {{ axis = {}, angle_deg = {} }} }}\n",
                                                text_of(axis), impact.turned * 180 / M_PI);
    const auto body = [&](const std::string& name, const std::string& shape, const Vec3& x, const Vec3& v) {
        return fmt::format(
            "[[body]]\nname = '{}'\nmaterial = 'rock'\nshape = {{ {} }}\nposition = {}\nvelocity = {}\n{}", name, shape,
            text_of(rotate(turn, x)), text_of(rotate(turn, v)), orientation);
    };
    const double gap = 0.02, apart = 0.5 * (impact.small + impact.large) + gap;
    const std::string text =
        "gravity = [0, 0, 0]\nend = 0.05\n[material.rock]\ndensity = 2500\nnormal_stiffness = 1e8\n"
        "friction_coefficient = 0\n[solid]\nmethod = 'sphere_dem'\n" +
        fmt::format("restitution = {}\n", impact.restitution) + impact.laws + "\n" +
        body("small",
             impact.small_is_ball ? fmt::format("sphere = {}", 0.5 * impact.small)
                                  : fmt::format("cube = {}", impact.small),
             impact.offset, {2, 0, 0}) +
        body("large", fmt::format("cube = {}", impact.large), {apart, 0, 0}, {});
    Simulation simulation(scene::read_case_text(text, "case.toml", "."));
    while (simulation.steps_left() > 0) {
        const StepOutcome outcome = simulation.step(sim::Measure::energy);
        EXPECT_NE(outcome.kind, StepOutcome::Kind::refused) << outcome.why.text;
        if (outcome.kind == StepOutcome::Kind::refused) {
            break;
        }
    }
    const body::BodyState& bodies = simulation.state().bodies;
    const body::BodySet& set = simulation.model().bodies;
    return {rotate_back(turn, bodies.velocity[0]), rotate_back(turn, bodies.velocity[1]),
            rotate_back(turn, angular_velocity(set, bodies, BodyId{0}))};
}

/// Impulse (1 + e) v/(1/m + 1/M + r^2/I) of a push through the centre of the smaller cube [N s].
double impulse_of(const Impact& impact) {
    const double m = 2500 * std::pow(impact.small, 3), big = 2500 * std::pow(impact.large, 3);
    const double inertia = big * impact.large * impact.large / 6;
    return (1 + impact.restitution) * 2 / (1 / m + 1 / big + norm_squared(impact.offset) / inertia);
}

void expect_head_on(const Impact& impact, const std::string& what) {
    const After after = strike(impact);
    const double m = 2500 * std::pow(impact.small, 3), big = 2500 * std::pow(impact.large, 3);
    const double push = impulse_of(impact);
    const double within = 0.01 * 2;
    EXPECT_NEAR(after.small.x, 2 - push / m, within) << what;
    EXPECT_NEAR(after.large.x, push / big, within) << what;
    EXPECT_LT(std::hypot(after.small.y, after.small.z), within) << what;
    EXPECT_LT(std::hypot(after.large.y, after.large.z), within) << what;
    // Rigid cubes would give it none; here the larger one turns a little while they touch.
    EXPECT_LT(norm(after.spin_of_small) * impact.small, 0.05) << what;
}

TEST(HeadOn, ACubeThatStrikesALargerOneOffItsLatticeIsThrownStraightBack) {
    expect_head_on({}, "as it is");
    expect_head_on({.restitution = 0.5}, "with half of its speed");
    expect_head_on({.turned = 37 * M_PI / 180}, "turned");
    expect_head_on({.small = 0.31, .offset = {0, -0.17, 0.23}}, "another size and place");
    expect_head_on({.small = 0.25, .large = 1.3, .offset = {0, 0.05, 0.31}}, "much smaller");
}

TEST(HeadOn, ItIsThrownStraightBackByEveryLawOfSharingAndNormals) {
    expect_head_on({.laws = "normals = 'faces'"}, "face normals");
    expect_head_on({.laws = "normal_law = 'linear'\nspring_stiffness = 1e6"}, "linear springs");
    expect_head_on({.laws = "sphere_radius = 0.05"}, "finer spheres");
    expect_head_on({.laws = "sharing = 'divide'\nyoungs_modulus = 1e8"}, "divided");
}

TEST(HeadOn, EqualCubesThatMeetWithAllOfTheirFacesExchangeTheirSpeeds) {
    const After after = strike({.small = 0.6, .large = 0.6, .offset = {}, .turned = 0.4});
    EXPECT_NEAR(after.small.x, 0, 0.02);
    EXPECT_NEAR(after.large.x, 2, 0.02);
    EXPECT_LT(std::hypot(after.large.y, after.large.z), 0.02);
}

TEST(HeadOn, ABallThatStrikesACubeBetweenTheSpheresOfItsFaceIsThrownStraightBack) {
    // By the samples of the cube its normal was that of whatever sphere lay next.
    const Impact impact{.small = 0.3, .offset = {0, 0.03, 0.05}, .small_is_ball = true};
    const After after = strike(impact);
    EXPECT_LT(after.small.x, -1.8);
    EXPECT_LT(std::hypot(after.small.y, after.small.z), 0.02);
}

}  // namespace
}  // namespace riprap::run
