// SPDX-License-Identifier: Apache-2.0
// Story: balls and discs met others as the polyhedra that stand for them. With dashpots a disc of the distance
// potential had 0.84 m/s left of 1.33 when it rolled, as each facet was struck; walls about a pyramid of discs bore
// 1.3 times their load, as corners lie outside of the circle; sphere_dem threw a ball off three fixed ones.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "ground_case.hpp"
#include "riprap/run/simulate/simulation.hpp"
#include "riprap/scene/read_case.hpp"

namespace riprap::run {
namespace {

struct Method {
    const char* name;
    const char* keys;  ///< of [solid]
};

/// The top of a case: its material and method, with gravity that grows so that nothing bounces.
std::string scene_of(const Method& method, bool is_planar, double end, double friction) {
    return fmt::format(
        "{}gravity = {{ value = [{}], ramp = 0.1 }}\nend = {}\n[material.rock]\ndensity = 2500.0\nnormal_stiffness = "
        "1e8\nfriction_coefficient = {}\ndamping_ratio = 0.2\n[solid]\nmethod = \"{}\"\n{}\n",
        is_planar ? "dimension = 2\n" : "", is_planar ? "0.0, -9.81" : "0.0, 0.0, -9.81", end, friction, method.name,
        method.keys);
}

std::string body(const std::string& name, const std::string& shape, const std::string& at, const std::string& more) {
    return fmt::format("[[body]]\nname = \"{}\"\nshape = {{ {} }}\nmaterial = \"rock\"\nposition = [{}]\n{}\n", name,
                       shape, at, more);
}

/// An answer at the end.
std::string answer(const std::string& quantity, double value, double tolerance) {
    return fmt::format(
        "[[expect]]\nname = \"{0}\"\nquantity = \"{0}\"\nvalue = {1}\ntolerance = {2}\ncitation = \"by hand\"\n",
        quantity, value, tolerance);
}

void expect_answers(const std::string& text, const std::string& folder = ".") {
    Simulation simulation(scene::read_case_text(text, "case.toml", folder));
    while (simulation.steps_left() > 0) {
        const StepOutcome outcome = simulation.step(sim::Measure::flow);
        ASSERT_NE(outcome.kind, StepOutcome::Kind::refused) << outcome.why.text;
    }
    for (const ExpectResult& result : simulation.judge(true)) {
        EXPECT_EQ(result.verdict, Verdict::passed) << result.name << " " << result.value;
    }
}

class RoundContacts : public ::testing::TestWithParam<Method> {};

// Holds that what slides without spin rolls in the end with v/(1 + I/(m r^2)): 2/3 of its speed as a disc, 5/7 as a
// ball.
TEST_P(RoundContacts, ADiscRollsWithTwoThirdsOfItsSpeedWhateverItsDashpots) {
    expect_answers(
        scene_of(GetParam(), true, 0.8, 0.5) + body("floor", "box = [8.0, 1.0]", "0.0, -0.5", "fixed = true") +
        body("disc", "sphere = 0.2", "-1.0, 0.2", "velocity = [2.0, 0.0]") + answer("disc.velocity.x", 4.0 / 3, 0.01));
}

TEST_P(RoundContacts, ABallRollsWithFiveSeventhsOfItsSpeedWhateverItsDashpots) {
    expect_answers(scene_of(GetParam(), false, 0.6, 0.5) +
                   body("floor", "box = [8.0, 2.0, 1.0]", "0.0, 0.0, -0.5", "fixed = true") +
                   body("ball", "sphere = 0.2", "-1.0, 0.0, 0.2", "velocity = [2.0, 0.0, 0.0]") +
                   answer("ball.velocity.x", 10.0 / 7, 0.01));
}

// Half of the weight of the uppermost of three discs leans on either lower one along 60 degrees: W/2 cot 60.
TEST_P(RoundContacts, APyramidOfDiscsPressesItsWallsAsCirclesDo) {
    const double r = 0.2, weight = M_PI * r * r * 2500 * 9.81;
    expect_answers(scene_of(GetParam(), true, 0.5, 0.0) +
                   body("floor", "box = [4.0, 1.0]", "0.0, -0.5", "fixed = true") +
                   body("left", "box = [0.5, 2.0]", "-0.65, 1.0", "fixed = true") +
                   body("right", "box = [0.5, 2.0]", "0.65, 1.0", "fixed = true") +
                   body("a", "sphere = 0.2", "-0.2, 0.2", "") + body("b", "sphere = 0.2", "0.2, 0.2", "") +
                   body("top", "sphere = 0.2", fmt::format("0.0, {:.15g}", r * (1 + std::sqrt(3))), "") +
                   answer("left.contact_force.x", -weight / 2 / std::sqrt(3), 0.02 * weight));
}

// A ball in the pit between three fixed balls that touch each other: each bears a third of its weight.
TEST_P(RoundContacts, ABallRestsInThePitOfThreeFixedBalls) {
    const double r = 0.2, weight = 4.0 / 3 * M_PI * r * r * r * 2500 * 9.81;
    std::string text = scene_of(GetParam(), false, 0.5, 0.0);
    for (int i = 0; i < 3; ++i) {
        const double angle = 2 * M_PI / 3 * i, reach = 2 * r / std::sqrt(3);
        text += body(fmt::format("fixed_{}", i), "sphere = 0.2",
                     fmt::format("{:.15g}, {:.15g}, 0.0", reach * std::cos(angle), reach * std::sin(angle)),
                     "fixed = true");
    }
    expect_answers(
        text + body("ball", "sphere = 0.2", fmt::format("0.0, 0.0, {:.15g}", 2 * r * std::sqrt(2.0 / 3)), "") +
        answer("ball.displacement.z", 0, 1e-3) + answer("fixed_0.contact_force.z", -weight / 3, 0.01 * weight));
}

INSTANTIATE_TEST_SUITE_P(Methods, RoundContacts,
                         ::testing::Values(Method{"distance_potential_dem", ""},
                                           Method{"distance_potential_dem", "contact = \"common_plane_soft\""},
                                           Method{"distance_potential_dem", "contact = \"common_plane_penalty\""},
                                           Method{"sphere_dem", ""}, Method{"explicit_dda", ""},
                                           Method{"implicit_dda", ""}));

class RoundOnGround : public ::testing::TestWithParam<Method> {};

TEST_P(RoundOnGround, ADiscRollsOverTheCornersOfAProfileAsOverAPlane) {
    expect_answers(scene_of(GetParam(), true, 0.8, 0.5) +
                   body("ground", "terrain = { profile = [[-4, 0], [-1.1, 0], [-0.73, 0], [0.1, 0], [4, 0]] }",
                        "0.0, 0.0", "fixed = true") +
                   body("disc", "sphere = 0.2", "-1.0, 0.2", "velocity = [2.0, 0.0]") +
                   answer("disc.velocity.x", 4.0 / 3, 0.01));
}

TEST_P(RoundOnGround, ABallRollsOverTrianglesAsOverAPlane) {
    const CaseFolder folder;
    folder.write_heights(30, 16, 0.13, [](double, double) { return 0.0; });
    expect_answers(scene_of(GetParam(), false, 0.6, 0.5) +
                       body("ground", "terrain = { file = 'bed.asc' }", "0.0, 0.0, 0.0", "fixed = true") +
                       body("ball", "sphere = 0.2", "-0.5, 0.03, 0.2", "velocity = [2.0, 0.0, 0.0]") +
                       answer("ball.velocity.x", 10.0 / 7, 0.01) + answer("ball.velocity.y", 0, 0.01),
                   folder.path());
}

// In a gutter of 90 degrees a ball touches both sides, its centre r sqrt(2) above the bottom; on the crest of a roof it
// balances on the line, r above it, and rolls along it with 5/7 of its speed.
TEST_P(RoundOnGround, ABallLiesInAGutterAndRollsAlongACrest) {
    for (const bool is_crest : {false, true}) {
        const CaseFolder folder;
        const double y0 = 0.04;
        folder.write_heights(30, 27, 0.08,
                             [&](double, double y) { return (is_crest ? -0.3 : 1.0) * std::abs(y - y0); });
        const double height = is_crest ? 0.2 : 0.2 * std::sqrt(2.0);
        const std::string motion = is_crest ? "velocity = [1.0, 0.0, 0.0]" : "";
        expect_answers(scene_of(GetParam(), false, is_crest ? 0.3 : 0.5, 0.4) +
                           body("ground", "terrain = { file = 'bed.asc' }", "0.0, 0.0, 0.0", "fixed = true") +
                           body("ball", "sphere = 0.2", fmt::format("0.1, {}, {:.15g}", y0, height), motion) +
                           answer("ball.displacement.z", 0, 1e-3) + answer("ball.displacement.y", 0, 1e-3) +
                           answer("ball.velocity.x", is_crest ? 5.0 / 7 : 0, is_crest ? 0.01 : 1e-3),
                       folder.path());
    }
}

INSTANTIATE_TEST_SUITE_P(Methods, RoundOnGround,
                         ::testing::Values(Method{"sphere_dem", ""}, Method{"explicit_dda", ""},
                                           Method{"implicit_dda", ""}));

}  // namespace
}  // namespace riprap::run
