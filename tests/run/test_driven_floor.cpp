// SPDX-License-Identifier: Apache-2.0
// A half-space that is driven carries, tilts and drags a block of three-dimensional DDA.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "riprap/run/simulate/simulation.hpp"

namespace riprap::run {
namespace {

constexpr double weight = 25000, friction = 0.3;

/// A cube of 1 m and 2.5 t under 10 m/s^2, pressed by its weight into a floor that moves by `motion`.
struct Scene {
    Scene(const std::string& method, const std::string& motion, const std::string& velocity)
        : simulation(scene::read_case_text("gravity = [0.0, 0.0, -10.0]\nend = 10.0\n"
                                           "[material.rock]\ndensity = 2500.0\nnormal_stiffness = 1.0e7\n"
                                           "friction_coefficient = 0.3\ndamping_ratio = 0.2\n"
                                           "[solid]\nmethod = \"" +
                                               method + "\"\n" + (method == "implicit_dda" ? "step = 0.002\n" : "") +
                                               "youngs_modulus = 1.0e8\ncontact_stiffness = 1.0e7\n"
                                               "[[body]]\nname = \"floor\"\nmaterial = \"rock\"\n"
                                               "shape = { half_space = { normal = [0, 0, 1] } }\nmotion = { " +
                                               motion +
                                               " }\n[[body]]\nname = \"block\"\nmaterial = \"rock\"\n"
                                               "shape = { cube = 1.0 }\nposition = [0, 0, 0.499375]\nvelocity = " +
                                               velocity + "\n",
                                           "case.toml", "/nonexistent", {})) {}
    void go(double time) {
        while (simulation.state().time < time) {
            const StepOutcome outcome = simulation.step(sim::Measure::energy);
            ASSERT_NE(outcome.kind, StepOutcome::Kind::refused) << outcome.why.text;
        }
    }
    double value(const char* column) const {
        return sim::evaluate(sim::find_column(simulation.model(), column).value(), simulation.now());
    }
    Simulation simulation;
};

class DrivenFloor : public ::testing::TestWithParam<const char*> {};

TEST_P(DrivenFloor, ThatRisesLiftsABlockAndWorksAgainstItsWeight) {
    Scene scene(GetParam(), "linear = { velocity = [0, 0, 0.1] }", "[0, 0, 0.1]");
    scene.go(1);
    const double way = 0.1 * scene.simulation.state().time;
    EXPECT_NEAR(scene.value("block.displacement.z"), way, 0.01 * way);
    EXPECT_NEAR(std::abs(scene.value("solid.driven")), weight * way, 0.01 * weight * way);
    EXPECT_LT(std::abs(scene.value("energy_residual")), 1e-3 * weight * way);
}

TEST_P(DrivenFloor, ThatGoesSidewaysDragsABlockAlongByFriction) {
    Scene scene(GetParam(), "linear = { velocity = [0.5, 0, 0] }", "[0, 0, 0]");
    scene.go(1);
    const double slip = 0.5 * 0.5 / (2 * friction * 10);
    const double way = 0.5 * scene.simulation.state().time - slip;
    EXPECT_NEAR(scene.value("block.displacement.x"), way, 0.01 * way);
    EXPECT_NEAR(scene.value("block.velocity.x"), 0.5, 0.005);
    EXPECT_NEAR(scene.value("solid.friction"), friction * weight * slip, 0.03 * friction * weight * slip);
}

TEST_P(DrivenFloor, ThatTiltsLetsABlockSlideAtTheAngleOfFriction) {
    constexpr double rate = 0.2;
    Scene scene(GetParam(), "rotation = { center = [0, 0, 0], axis = [0, 1, 0], rate = 0.2 }", "[0, 0, 0]");
    const auto slipped = [&scene] {
        const double angle = rate * scene.simulation.state().time;
        return scene.value("block.position.x") * std::cos(angle) - scene.value("block.position.z") * std::sin(angle);
    };
    const double angle = std::atan(friction);
    scene.go((angle - 0.5 * std::numbers::pi / 180) / rate);
    EXPECT_LT(std::abs(slipped()), 2e-3);
    scene.go((angle + 6 * std::numbers::pi / 180) / rate);
    EXPECT_GT(slipped(), 0.02);
}

INSTANTIATE_TEST_SUITE_P(Methods, DrivenFloor, ::testing::Values("explicit_dda", "implicit_dda"));

}  // namespace
}  // namespace riprap::run
