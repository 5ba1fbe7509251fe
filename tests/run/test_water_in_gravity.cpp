// SPDX-License-Identifier: Apache-2.0
// Gravity that grows or turns works on the water as it does on bodies: its work is booked, and steps are those of its
// full strength.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "riprap/run/simulate/simulation.hpp"
#include "riprap/scene/read_case.hpp"
#include "riprap/sim/quantity.hpp"

namespace riprap::run {
namespace {

constexpr double depth = 0.2, wide = 0.1, full = 9.81, end = 0.06;

/// A column of water in the plane between a floor and two walls, or between periodic sides.
std::string column(const std::string& method, const std::string& gravity, bool is_periodic, const std::string& more) {
    const auto wall = [](const std::string& name, const std::string& normal, double offset) {
        return fmt::format(
            "[[body]]\nname = '{}'\nmaterial = 'rock'\nshape = {{ half_space = {{ normal = {}, offset = {} }} }}\n"
            "fixed = true\n",
            name, normal, offset);
    };
    const double side = is_periodic ? 0 : 0.05;
    return fmt::format(
               "dimension = 2\nend = {}\n[gravity]\nvalue = [0, -{}]\n{}\n[material.rock]\ndensity = 2500\n"
               "normal_stiffness = 1e6\n[fluid]\nmethod = '{}'\nspacing = 0.01\ndomain = {{ low = [{}, -0.05], "
               "high = [{}, 0.3], periodic = [{}, false] }}\n[[fluid.region]]\nbox = {{ low = [0, 0], high = [{}, {}] "
               "}}\n{}",
               end, full, gravity, method, -side, wide + side, is_periodic, wide, depth, more) +
           wall("floor", "[0, 1]", 0) +
           (is_periodic ? "" : wall("left", "[1, 0]", 0) + wall("right", "[-1, 0]", -wide));
}

struct Books {
    double potential{0}, external{0}, largest_miss{0}, turnover{0};
    int steps{0};
};
Books books_of(const std::string& text) {
    Simulation simulation(scene::read_case_text(text, "case.toml", "."));
    Books books;
    while (simulation.steps_left() > 0) {
        const StepOutcome outcome = simulation.step(sim::Measure::energy);
        EXPECT_NE(outcome.kind, StepOutcome::Kind::refused) << outcome.why.text;
        if (outcome.kind == StepOutcome::Kind::refused) {
            break;
        }
        const auto value = [&](const char* name) {
            return sim::evaluate(*sim::find_column(simulation.model(), name), simulation.now());
        };
        books.potential = value("fluid.potential");
        books.external = value("fluid.external");
        books.largest_miss = std::max(books.largest_miss, std::abs(value("energy_residual")));
        books.turnover = value("energy_turnover");
        ++books.steps;
    }
    return books;
}

constexpr double weight = 1000 * wide * depth;  // of the water, over gravity [kg/m]

// Water that stays where it is has the potential -g.X, all of which what makes gravity grow has given it.
TEST(WaterInGravity, GetsThePotentialOfAGravityThatGrowsFromWhatMakesItGrow) {
    for (const char* method : {"sph", "wcmps", "mps", "grid"}) {
        const Books books = books_of(column(method, "ramp = 0.06", false, ""));
        const double lifted = weight * full * 0.5 * depth;
        EXPECT_NEAR(books.potential, lifted, 0.06 * lifted) << method;  // a kick lies half a step before the end
        EXPECT_NEAR(books.external, books.potential, 0.02 * lifted) << method;
        EXPECT_LT(books.largest_miss, 1e-6 * lifted) << method;
    }
}

TEST(WaterInGravity, ClosesItsBooksWhereGravityTurnsByATableAndStops) {
    for (const char* method : {"sph", "wcmps", "mps", "grid"}) {
        const Books books =
            books_of(column(method, "rotation = { axis = [0, 0, 1], time = [0, 0.03], angle = [0, 0.1] }", false, ""));
        // gravity (sin, -cos) of a tenth, at the middle of the column
        const double exact = weight * full * (std::cos(0.1) * 0.5 * depth - std::sin(0.1) * 0.5 * wide);
        EXPECT_NEAR(books.potential, exact, 0.02 * exact) << method;
        EXPECT_LT(books.largest_miss, 2e-3 * books.turnover) << method;
    }
}

// Gravity along a periodic axis has no potential: it drives the water, by work from outside, turning or not.
TEST(WaterInGravity, ClosesItsBooksBetweenPeriodicSidesToo) {
    for (const char* method : {"sph", "wcmps"}) {
        const Books books = books_of(column(method, "rotation = { axis = [0, 0, 1], rate = 2.0 }", true, ""));
        EXPECT_GT(books.turnover, 1e-3) << method;
        EXPECT_LT(books.largest_miss, 2e-3 * books.turnover) << method;
    }
}

// Of gravity at the start, which is nothing, a step of any length would be short enough.
TEST(WaterInGravity, GoesByStepsOfItsFullStrengthFromTheStartInTheGrid) {
    EXPECT_GT(books_of(column("grid", "ramp = 0.06", false, "")).steps, 3);
}

TEST(WaterInGravity, HasNoLevelsWavesOrStillSurfaceWhereGravityTurns) {
    const auto problem_of = [](const std::string& text) -> std::string {
        try {
            Simulation simulation(scene::read_case_text(text, "case.toml", "."));
        } catch (const CaseError& error) {
            return error.what();
        }
        return "";
    };
    const std::string turns = "rotation = { axis = [0, 0, 1], rate = 2.0 }";
    const std::string sill =
        "[[fluid.outflow]]\nname = 'sill'\ntowards = 'x'\nlow = [0.15, 0]\nhigh = [0.15, 0.3]\nlevel = 0.2\n";
    for (const char* method : {"sph", "grid"}) {
        EXPECT_THAT(problem_of(column(method, "ramp = 0.06", false, sill)),
                    ::testing::HasSubstr("the level of an outflow in gravity that grows or turns"))
            << method;
    }
    EXPECT_THAT(problem_of(column("hydrostatic", turns, false, "")),
                ::testing::HasSubstr("water that lies still in gravity that grows or turns"));
    EXPECT_THAT(problem_of(column("grid", turns, false,
                                  "[[fluid.wave]]\ntowards = 'x'\nheight = 0.01\ndepth = 0.2\nperiod = 1\n")),
                ::testing::HasSubstr("waves in gravity that grows or turns"));
}

}  // namespace
}  // namespace riprap::run
