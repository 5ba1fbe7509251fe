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

constexpr double gravity = 9.81, depth = 0.25;

/// A tank of half-spaces of 0.16 m by 0.12 m, which a lattice of 0.02 m fits.
std::string tank(const std::string& method) {
    const auto wall = [](const std::string& name, const std::string& normal, double offset) {
        return fmt::format(
            "[[body]]\nname = '{}'\nmaterial = 'rock'\nshape = {{ half_space = {{ normal = {}, offset = {} }} }}\n"
            "fixed = true\n",
            name, normal, offset);
    };
    return fmt::format(
               "gravity = [0, 0, -{}]\nend = 0.3\n[material.rock]\ndensity = 2500\nnormal_stiffness = 1e6\n"
               "friction_coefficient = 0.4\n[fluid]\nmethod = '{}'\nspacing = 0.02\n"
               "domain = {{ low = [-0.1, -0.1, -0.1], high = [0.26, 0.22, 0.36] }}\n[[fluid.region]]\n"
               "box = {{ low = [0, 0, 0], high = [0.16, 0.12, {}] }}\n",
               gravity, method, depth) +
           wall("floor", "[0, 0, 1]", 0) + wall("left", "[1, 0, 0]", 0) + wall("right", "[-1, 0, 0]", -0.16) +
           wall("front", "[0, 1, 0]", 0) + wall("back", "[0, -1, 0]", -0.12) +
           "[[output.probe]]\nquantity = 'max_water_speed'\n";
}

// As long as walls took what their water does along one face of three that meet for sliding, wcmps threw the particle
// in each vertex out at 1.73 m/s.
TEST(StillTank, KeepsTheWaterInItsVerticesByEveryScheme) {
    for (const char* method : {"wcmps", "mps", "sph"}) {
        Simulation simulation(scene::read_case_text(tank(method), "case.toml", "."));
        const auto columns = sim::record_columns(simulation.model());
        double fastest = 0;
        while (simulation.steps_left() > 0) {
            const StepOutcome outcome = simulation.step(sim::Measure::energy);
            ASSERT_NE(outcome.kind, StepOutcome::Kind::refused) << method << ": " << outcome.why.text;
            if (simulation.state().time > 0.15) {
                fastest = std::max(fastest, sim::evaluate(columns.back(), simulation.now()));
            }
        }
        EXPECT_LT(fastest, 0.2 * std::sqrt(gravity * depth)) << method;
        EXPECT_GT(fastest, 0) << method;
    }
}

}  // namespace
}  // namespace riprap::run
