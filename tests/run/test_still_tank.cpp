// SPDX-License-Identifier: Apache-2.0
// Still water in a tank of space stays still, in its bottom vertices too.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "riprap/run/simulate/simulation.hpp"
#include "riprap/scene/read_case.hpp"
#include "riprap/sim/quantity.hpp"

namespace riprap::run {
namespace {

constexpr double gravity = 9.81;

/// A tank of half-spaces of 0.16 m by 0.12 m, which a lattice of 0.02 m fits; seconds in it.
std::string tank(const std::string& method, double depth, double end) {
    const auto wall = [](const std::string& name, const std::string& normal, double offset) {
        return fmt::format(
            "[[body]]\nname = '{}'\nmaterial = 'rock'\nshape = {{ half_space = {{ normal = {}, offset = {} }} }}\n"
            "fixed = true\n",
            name, normal, offset);
    };
    return fmt::format(
               "gravity = [0, 0, -{}]\nend = {}\n[material.rock]\ndensity = 2500\nnormal_stiffness = 1e6\n"
               "friction_coefficient = 0.4\n[fluid]\nmethod = '{}'\nspacing = 0.02\n"
               "domain = {{ low = [-0.1, -0.1, -0.1], high = [0.26, 0.22, 0.36] }}\n[[fluid.region]]\n"
               "box = {{ low = [0, 0, 0], high = [0.16, 0.12, {}] }}\n",
               gravity, end, method, depth) +
           wall("floor", "[0, 0, 1]", 0) + wall("left", "[1, 0, 0]", 0) + wall("right", "[-1, 0, 0]", -0.16) +
           wall("front", "[0, 1, 0]", 0) + wall("back", "[0, -1, 0]", -0.12) +
           "[[output.probe]]\nquantity = 'max_water_speed'\n";
}

/// The largest speed of the water from a time on [m/s].
double fastest_after(double begin, const std::string& method, double depth, double end) {
    Simulation simulation(scene::read_case_text(tank(method, depth, end), "case.toml", "."));
    const auto columns = sim::record_columns(simulation.model());
    double fastest = 0;
    while (simulation.steps_left() > 0) {
        const StepOutcome outcome = simulation.step(sim::Measure::energy);
        if (outcome.kind == StepOutcome::Kind::refused) {
            ADD_FAILURE() << method << ": " << outcome.why.text;
            break;
        }
        if (simulation.state().time > begin) {
            fastest = std::max(fastest, sim::evaluate(columns.back(), simulation.now()));
        }
    }
    return fastest;
}

// As long as walls took what their water does along one face of three that meet for sliding, wcmps threw the particle
// in each vertex out at 1.73 m/s.
TEST(StillTank, KeepsTheWaterInItsVerticesByEveryScheme) {
    constexpr double depth = 0.25;
    for (const char* method : {"wcmps", "mps", "sph"}) {
        const double fastest = fastest_after(0.15, method, depth, 0.3);
        EXPECT_LT(fastest, 0.2 * std::sqrt(gravity * depth)) << method;
        EXPECT_GT(fastest, 0) << method;
    }
}

// Of a last layer that the surface cut some places had a particle, alone on the water, and these fell in.
TEST(StillTank, BeginsAtRestAtDepthsThatTheSpacingDoesNotDivide) {
    for (const double depth : {0.246, 0.25, 0.254}) {
        for (const char* method : {"wcmps", "sph"}) {
            EXPECT_LT(fastest_after(0, method, depth, 0.12), 0.04 * std::sqrt(gravity * depth)) << method << depth;
        }
    }
}

}  // namespace
}  // namespace riprap::run
