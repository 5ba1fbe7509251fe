// SPDX-License-Identifier: Apache-2.0
// Spheres in case files: shapes, materials and what two of them make together.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "riprap/core/index.hpp"
#include "riprap/scene/read_case.hpp"
#include "riprap/sim/advance.hpp"
#include "riprap/sim/time_step.hpp"

namespace riprap::run {
namespace {

constexpr const char* drop = R"(
gravity = [0, 0, -9.81]
end = 1.0
[solid]
method = "sphere_dem"
[material.ball]
density = 1200.0
normal_stiffness = 1.0e6
youngs_modulus = 7.0e7
poisson_ratio = 0.1
restitution = 0.8
[material.floor]
density = 2500.0
normal_stiffness = 1.0e6
youngs_modulus = 2.1e11
restitution = 0.5
CONTACT
[[body]]
name = "floor"
shape = { half_space = { normal = [0, 0, 1] } }
material = "floor"
fixed = true
[[body]]
name = "ball"
shape = { sphere = 0.05 }
position = [0, 0, 0.051]
velocity = [0, 0, -3]
material = "ball"
)";

scene::LoadedCase read(const std::string& contact) {
    std::string text = drop;
    text.replace(text.find("CONTACT"), 7, contact);
    return scene::read_case_text(text, "case.toml", "/nonexistent");
}

TEST(SphereCases, tell_how_deep_a_ball_is_in_the_floor) {
    scene::LoadedCase loaded = read("[contact]\nrestitution_mixing = \"mean\"");
    loaded.model.gravity.value = {};
    sim::initialise(loaded.model, loaded.state);
    loaded.state.bodies.position[1] = {0, 0, 0.05 - 1e-4};
    loaded.state.bodies.velocity[1] = {};
    sim::Scratch scratch;
    const sim::StepReport report = advance(loaded.model, loaded.state, scratch, 1e-6, sim::Measure::energy);
    EXPECT_NEAR(report.max_depth, 1e-4, 1e-12);
    EXPECT_NEAR(report.max_potential, 1e-4 / 0.05, 1e-12);
}

/// Speed after the impact over that before.
double restitution(const std::string& contact) {
    scene::LoadedCase loaded = read(contact);
    loaded.model.gravity.value = {};
    sim::initialise(loaded.model, loaded.state);
    sim::Scratch scratch;
    while (loaded.state.time < 0.01) {
        const sim::TimeStep next = sim::choose_time_step(loaded.model, loaded.state, scratch);
        EXPECT_TRUE(advance(loaded.model, loaded.state, scratch, next.dt).status.ok());
    }
    return loaded.state.bodies.velocity[1].z / 3;
}

TEST(SphereCases, a_ball_of_a_case_is_one_sphere_of_its_mass) {
    const scene::LoadedCase loaded = read("[contact]\nrestitution_mixing = \"mean\"");
    const double volume = 4 * M_PI / 3 * std::pow(0.05, 3);
    EXPECT_NEAR(loaded.model.bodies.mass[1], 1200 * volume, 1e-9 * volume * 1200);
    const double exact = 0.4 * 1200 * volume * 0.05 * 0.05;
    EXPECT_NEAR(loaded.model.bodies.principal_moments[1].x, exact, 0.01 * exact);
}

TEST(SphereCases, restitution_follows_the_mixing_rule_and_the_pair) {
    EXPECT_NEAR(restitution("[contact]\nrestitution_mixing = \"mean\""), 0.65, 0.01);
    EXPECT_NEAR(restitution("[contact]\nrestitution_mixing = \"minimum\""), 0.5, 0.01);
    EXPECT_NEAR(restitution("[contact]\nrestitution_mixing = \"mean\"\n[[contact.pair]]\nmaterials = [\"ball\", "
                            "\"floor\"]\nrestitution = 0.9"),
                0.9, 0.01);
}

TEST(SphereCases, materials_that_differ_in_restitution_want_a_rule) {
    try {
        read("");
        FAIL() << "accepted";
    } catch (const CaseError& error) {
        EXPECT_THAT(to_string(error.problems()[0]), ::testing::HasSubstr("restitution_mixing"));
    }
}

}  // namespace
}  // namespace riprap::run
