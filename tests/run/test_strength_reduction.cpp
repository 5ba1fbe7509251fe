// SPDX-License-Identifier: Apache-2.0
// [strength] divides friction, cohesion and tensile strength during a run, in every solid method alike.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "riprap/core/error.hpp"
#include "riprap/run/simulate/simulation.hpp"
#include "riprap/sim/time_step.hpp"

namespace riprap::run {
namespace {

constexpr double gravity = 9.81, degree = M_PI / 180;

/// A block of 500 kg/m on a plane that dips at 30 degrees, x down the dip; its material has what `strength` says.
std::string block_on_slope(const std::string& method, const std::string& strength) {
    return fmt::format(R"(
dimension = 2
gravity = [{}, {}]
end = 1.0
settle = 0.2
settle_static = true
[strength]
reduction = 2.0
over = 0.8
[solid]
method = "{}"
[material.rock]
density = 2500.0
{}
[[body]]
name = "ground"
shape = {{ box = [8.0, 1.0] }}
position = [2.0, -0.5]
material = "rock"
fixed = true
[[body]]
name = "block"
shape = {{ box = [1.0, 0.2] }}
position = [0.0, 0.1]
material = "rock"
)",
                       gravity * std::sin(30 * degree), -gravity * std::cos(30 * degree), method, strength);
}

std::string friction_of(const std::string& method, double angle) {
    return fmt::format("friction_coefficient = {}\n{}", std::tan(angle * degree),
                       method == "distance_potential_dem" ? "normal_stiffness = 1.0e8\n" : "");
}

std::unique_ptr<Simulation> start(const std::string& text, const std::vector<std::string>& overrides = {}) {
    return std::make_unique<Simulation>(scene::read_case_text(text, "case.toml", ".", overrides));
}

double way_of(Simulation& simulation, const char* column = "block.displacement.x") {
    while (simulation.steps_left() > 0) {
        const StepOutcome outcome = simulation.step(sim::Measure::energy);
        EXPECT_TRUE(outcome.is_accepted()) << outcome.why.with_remedy();
        if (!outcome.is_accepted()) {
            break;
        }
    }
    return sim::evaluate(*sim::find_column(simulation.model(), column), simulation.now());
}

/// Divisor of the scene above at a time.
double divisor(double time) {
    const double u = std::min(1.0, time / 0.8);
    return 1 + u * u * u * (10 - 15 * u + 6 * u * u);
}

/// Way of a block in 1 s whose acceleration by the strength that is left is a(D), once that is positive.
template <class Acceleration>
double integrated_way(const Acceleration& a) {
    double v = 0, x = 0;
    constexpr int steps = 100000;
    for (int k = 0; k < steps; ++k) {
        const double dt = 1.0 / steps;
        v = std::max(0.0, v + dt * a(divisor((k + 0.5) * dt), v > 0));
        x += dt * v;
    }
    return x;
}

class StrengthReduction : public testing::TestWithParam<const char*> {};

TEST_P(StrengthReduction, ABlockSlidesByCoulombAndNewtonOnceFrictionHasFallenToTheDip) {
    const double expected = integrated_way([](double d, bool) {
        return gravity * (std::sin(30 * degree) - std::cos(30 * degree) * std::tan(40 * degree) / d);
    });
    EXPECT_NEAR(expected, 0.1742, 0.0005);
    const auto run = start(block_on_slope(GetParam(), friction_of(GetParam(), 40)));
    EXPECT_NEAR(way_of(*run), expected, 0.01 * expected);
}

TEST_P(StrengthReduction, FrictionStaysWhereItIsNotNamed) {
    const auto run = start(block_on_slope(GetParam(), friction_of(GetParam(), 40) + "cohesion = 1.0\n"),
                           {"strength.reduces=[\"cohesion\"]"});
    EXPECT_NEAR(way_of(*run), 0, 1e-3);
}

TEST_P(StrengthReduction, BodiesSettleWithTheInitialDivisor) {
    // 25 degrees do not hold it, twice the strength does; it ends at 0.75 of tan(25)/tan(30).
    const auto run = start(block_on_slope(GetParam(), friction_of(GetParam(), 25)),
                           {"strength.initial=0.5", "strength.reduction=0.75"});
    EXPECT_NEAR(run->initial().bodies.position[1].x, 0, 1e-3);
    EXPECT_NEAR(way_of(*run), 0, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Methods, StrengthReduction,
                         testing::Values("distance_potential_dem", "sphere_dem", "planar_dda", "implicit_dda",
                                         "explicit_dda"),
                         [](const auto& test) { return std::string(test.param); });

class ReductionOfBonds : public testing::TestWithParam<const char*> {};

/// Way of what lets go once strength is divided by more than `limit`, and has the acceleration `a` then.
double way_after(double limit, double a) {
    return integrated_way([=](double d, bool moves) { return d > limit || moves ? a : 0; });
}

// A bond is lost after a slip or a gap, which takes a while of the fall: by 1.65 at the latest, where 1.5 is the limit.

TEST_P(ReductionOfBonds, ABondWithoutFrictionHoldsUntilItsCohesionHasFallenToTheThrust) {
    const double a = gravity * std::sin(30 * degree), thrust = 500 * a;  // [N/m], on 1 m of face
    const auto run = start(block_on_slope(GetParam(), fmt::format("cohesion = {}\n", 1.5 * thrust)));
    const double way = way_of(*run);
    EXPECT_GT(way, way_after(1.65, a));
    EXPECT_LT(way, 1.01 * way_after(1.5, a));
}

TEST_P(ReductionOfBonds, ABlockHangsUntilTheTensileStrengthHasFallenToItsWeight) {
    const std::string strength = fmt::format("cohesion = 1.0e6\ntensile_strength = {}\n", 1.5 * 500 * gravity);
    std::string text = block_on_slope(GetParam(), strength);
    const std::string below = "position = [0.0, 0.1]";
    text.replace(text.find(below), below.size(), "position = [0.0, -1.1]");
    const auto run = start(text, {fmt::format("gravity=[0, {}]", -gravity)});
    const double way = -way_of(*run, "block.displacement.y");
    EXPECT_GT(way, way_after(1.65, gravity));
    EXPECT_LT(way, 1.01 * way_after(1.5, gravity));
}

INSTANTIATE_TEST_SUITE_P(Methods, ReductionOfBonds, testing::Values("planar_dda", "implicit_dda", "explicit_dda"),
                         [](const auto& test) { return std::string(test.param); });

TEST(StrengthReductionOfACase, IsRefusedWhereNothingIsDivided) {
    for (const char* strength : {"friction_coefficient = 0.0\n", "cohesion = 1.0e3\n"}) {
        try {
            start(block_on_slope("planar_dda", strength), {"strength.reduces=[\"friction\"]"});
            FAIL() << strength;
        } catch (const CaseError& error) {
            EXPECT_THAT(error.what(), testing::HasSubstr("'strength' divides nothing"));
        }
    }
}

TEST(StrengthReductionOfACase, WarnsOfARunThatEndsBeforeStrengthHasChanged) {
    const auto loaded = scene::read_case_text(block_on_slope("planar_dda", "friction_coefficient = 0.8\n"), "case.toml",
                                              ".", std::vector<std::string>{"strength.begins=0.5"});
    EXPECT_THAT(loaded.warnings, testing::Contains(testing::HasSubstr("before strength has changed at 1.3 s")));
}

TEST(StrengthReductionOfACase, KeepsItsBitsWhereScratchIsDropped) {
    for (const char* method : {"distance_potential_dem", "sphere_dem", "planar_dda", "implicit_dda", "explicit_dda"}) {
        SCOPED_TRACE(method);
        const auto loaded = scene::read_case_text(block_on_slope(method, friction_of(method, 40)), "case.toml", ".",
                                                  std::vector<std::string>{"settle=0", "settle_static=false"});
        sim::State kept = loaded.state, dropped = loaded.state;
        sim::Scratch scratch, forgetful;
        sim::initialise(loaded.model, kept);
        sim::initialise(loaded.model, dropped);
        const double dt = sim::largest_time_step(loaded.model, sim::time_step_bound(loaded.model, kept));
        kept.time = dropped.time = 0.5;  // while strength falls
        for (int k = 0; k < 20; ++k) {
            sim::advance(loaded.model, kept, scratch, dt);
            forgetful.forget();
            sim::advance(loaded.model, dropped, forgetful, dt);
        }
        EXPECT_EQ(kept.bodies.position[1], dropped.bodies.position[1]);
        EXPECT_EQ(kept.bodies.velocity[1], dropped.bodies.velocity[1]);
    }
}

}  // namespace
}  // namespace riprap::run
