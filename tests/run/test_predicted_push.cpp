// SPDX-License-Identifier: Apache-2.0
// Impacts of corners, edges and strips that `riprap check` predicts by the energy along the way, beside their runs.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <regex>

#include "riprap/run/check/check_case.hpp"
#include "riprap/run/simulate/simulation.hpp"
#include "riprap/scene/read_case.hpp"

namespace riprap::run {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

CaseCheck check_of(const std::string& text) { return check_case(scene::read_case_text(text, "case.toml", ".")); }

std::string rock(bool is_planar, double end, double stiffness = 1e8) {
    return fmt::format("{}end = {}\n[material.rock]\ndensity = 2500\nnormal_stiffness = {}\nfriction_coefficient = 0\n",
                       is_planar ? "dimension = 2\ngravity = [0, -9.81]\n" : "gravity = [0, 0, -9.81]\n", end,
                       stiffness);
}

std::string body(const std::string& name, const std::string& more) {
    return "[[body]]\nname = '" + name + "'\nmaterial = 'rock'\n" + more + "\n";
}

/// A body that falls onto others, and the way down to where they meet.
struct Fall {
    std::string name, text;
    int falling;     ///< its number
    bool is_planar;  ///< y is up, else z
    double meets;    ///< [m]
};
void PrintTo(const Fall& fall, std::ostream* out) { *out << fall.name; }

/// Returns how far the body goes beyond its meeting, at most [m].
double sinks(const Fall& fall) {
    Simulation simulation(scene::read_case_text(fall.text, "case.toml", "."));
    const auto height = [&] {
        const Vec3 x = simulation.state().bodies.position[static_cast<std::size_t>(fall.falling)];
        return fall.is_planar ? x.y : x.z;
    };
    const double start = height();
    double lowest = start;
    while (simulation.steps_left() > 0) {
        simulation.step(sim::Measure::flow);
        lowest = std::min(lowest, height());
    }
    return start - lowest - fall.meets;
}

class PredictedPush : public ::testing::TestWithParam<Fall> {};

TEST_P(PredictedPush, SinksInAsItsRunDoes) {
    const Fall& fall = GetParam();
    const CaseCheck check = check_of(fall.text);
    ASSERT_TRUE(check.overlap && check.overlap->found.is_impact);
    EXPECT_NEAR(sinks(fall), check.overlap->found.overlap, 0.06 * check.overlap->found.overlap);
}

std::string bars(double speed) {
    return rock(false, 0.06) +
           body("lower",
                "fixed = true\nshape = { box = [0.05, 1, 0.05] }\n"
                "orientation = { axis_angle = { axis = [0, 1, 0], angle_deg = 45 } }") +
           body("upper", fmt::format("shape = {{ box = [1, 0.05, 0.05] }}\nposition = [0, 0, 0.09]\n"
                                     "orientation = {{ axis_angle = {{ axis = [1, 0, 0], angle_deg = 45 }} }}\n"
                                     "velocity = [0, 0, {}]",
                                     -speed));
}

std::string slot(const std::string& shape, double width) {
    const auto side = [width](double way) {
        return fmt::format("fixed = true\nshape = {{ box = [0.5, 0.3] }}\nposition = [{}, -0.15]",
                           way * (0.25 + width / 2));
    };
    return rock(true, 0.25) + body("left", side(-1)) + body("right", side(1)) +
           body("falling", "velocity = [0, -0.5]\n" + shape);
}

std::string corner() {
    return rock(true, 0.1, 1e9) + body("floor", "fixed = true\nshape = { box = [4, 1] }\nposition = [0, -0.5]") +
           body("falling",
                "shape = { box = [0.5, 0.5] }\nposition = [0, 0.3545533906]\nvelocity = [0, -0.5]\n"
                "orientation = { angle_deg = 45 }");
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, PredictedPush,
    ::testing::Values(
        Fall{"edge_on_edge", bars(1), 1, false, 0.09 - 0.05 * std::numbers::sqrt2},
        Fall{"disc_on_a_slot", slot("shape = { sphere = 0.06 }\nposition = [0, 0.05]", 0.108), 2, true, 0.0238466034},
        Fall{"corner_in_an_open_joint",
             slot("shape = { box = [0.1, 0.1] }\nposition = [0, 0.06]\norientation = { angle_deg = 45 }", 0.04), 2,
             true, 0.06 - (0.05 * std::numbers::sqrt2 - 0.02)},
        Fall{"corner_on_a_floor", corner(), 1, true, 0.001}),
    [](const auto& made) { return made.param.name; });

/// A block that slides at 1 m/s towards a step `high` metres high, 0.4 m away.
std::string step_before(double high, double stiffness, const std::string& corners = "stiff") {
    return rock(true, 0.5, stiffness) + "[solid]\ncorners = '" + corners + "'\n" +
           body("left", "fixed = true\nshape = { box = [4, 0.5] }\nposition = [-2, -0.25]") +
           body("right", fmt::format("fixed = true\nshape = {{ box = [4, 0.5] }}\nposition = [2, {}]", high - 0.25)) +
           body("block", "shape = { box = [0.7, 0.3] }\nposition = [-0.75, 0.15]\nvelocity = [1, 0]");
}

double farthest(const std::string& text) {
    Simulation simulation(scene::read_case_text(text, "case.toml", "."));
    double most = -1;
    while (simulation.steps_left() > 0) {
        simulation.step(sim::Measure::flow);
        most = std::max(most, simulation.state().bodies.position[2].x);
    }
    return most + 0.75;
}

TEST(PredictedStep, TooLowForItsStiffnessIsWarnedOfWithOneThatHoldsTheBlock) {
    for (const double high : {0.005, 0.012}) {
        SCOPED_TRACE(high);
        const CaseCheck check = check_of(step_before(high, 1e8 * 0.005 / high, "field"));
        const auto found = std::ranges::find_if(check.warnings, [](const std::string& text) {
            return text.find("lets the one go round the other") != std::string::npos;
        });
        ASSERT_NE(found, check.warnings.end());
        EXPECT_THAT(*found, HasSubstr("'block' comes to 'right' with 1 m/s"));
        std::smatch named;
        ASSERT_TRUE(std::regex_search(*found, named, std::regex("of about ([0-9.e+]+) Pa")));
        const double stiffness = std::stod(named[1]);
        EXPECT_GT(farthest(step_before(high, 1e8 * 0.005 / high, "field")), 0.42) << "goes over it";
        EXPECT_LT(farthest(step_before(high, 1.05 * stiffness, "field")), 0.408) << "is held";
        EXPECT_GT(farthest(step_before(high, 0.5 * stiffness, "field")), 0.41) << "no more than what is needed";
    }
}

TEST(PredictedStep, IsHeldByStiffCornersWhereTheFieldAloneLetsTheBlockPass) {
    for (const double high : {0.005, 0.012}) {
        const std::string text = step_before(high, 1e8 * 0.005 / high);
        EXPECT_THAT(check_of(text).warnings, Not(Contains(HasSubstr("lets the one go round the other")))) << high;
        EXPECT_LT(farthest(text), 0.408) << high;
    }
}

TEST(PredictedStep, HighEnoughIsNotWarnedOf) {
    EXPECT_THAT(check_of(step_before(0.1, 1e8)).warnings, Not(Contains(HasSubstr("comes to"))));
}

TEST(PredictedStep, OfAHundredthOfTheBlockIsASeam) {
    EXPECT_THAT(check_of(step_before(0.0005, 1e8)).warnings, Not(Contains(HasSubstr("comes to"))));
}

TEST(PredictedPushes, OfABlockThatBrushesPastAnotherInItsFallAreNone) {
    const std::string text = rock(true, 1) +
                             body("floor", "fixed = true\nshape = { box = [4, 1] }\nposition = [0, -0.5]") +
                             body("post", "fixed = true\nshape = { box = [0.2, 1] }\nposition = [0, 0.5]") +
                             body("falling", "shape = { box = [0.2, 0.2] }\nposition = [0.196, 1.2]");
    EXPECT_THAT(check_of(text).warnings, Not(Contains(HasSubstr("comes to"))));
}

}  // namespace
}  // namespace riprap::run
