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
SOLID
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
    const bool has_solid = contact.find("[solid]") != std::string::npos;
    text.replace(text.find("SOLID"), 5, has_solid ? "" : "[solid]\nmethod = \"sphere_dem\"");
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

/// A ball that slides or rolls along a floor.
constexpr const char* run_out = R"(
gravity = [0, 0, -9.81]
end = 1.0
[solid]
method = "sphere_dem"
youngs_modulus = 1e7
SOLID
[material.ball]
density = 1000.0
friction_coefficient = 0.5
BALL
[material.floor]
density = 1000.0
friction_coefficient = 0.5
FLOOR
CONTACT
[[body]]
name = "floor"
shape = { half_space = { normal = [0, 0, 1] } }
material = "floor"
fixed = true
[[body]]
name = "ball"
shape = { sphere = 0.05 }
position = [0, 0, 0.0498]
material = "ball"
MOTION
)";

struct RunOut {
    std::string solid{}, ball{}, floor{}, contact{}, motion{};
};

/// Mean deceleration of the ball along the floor from 0.05 to 0.15 s [m/s^2], its height at the end in `height`.
double deceleration(const RunOut& given, double* height = nullptr) {
    std::string text = run_out;
    for (const auto& [word, put] : {std::pair{"SOLID", &given.solid},
                                    {"BALL", &given.ball},
                                    {"FLOOR", &given.floor},
                                    {"CONTACT", &given.contact},
                                    {"MOTION", &given.motion}}) {
        text.replace(text.find(word), std::string(word).size(), *put);
    }
    scene::LoadedCase loaded = scene::read_case_text(text, "case.toml", "/nonexistent");
    sim::initialise(loaded.model, loaded.state);
    sim::Scratch scratch;
    double first = 0, since = 0;
    while (loaded.state.time < 0.15) {
        const sim::TimeStep next = sim::choose_time_step(loaded.model, loaded.state, scratch);
        EXPECT_TRUE(advance(loaded.model, loaded.state, scratch, next.dt).status.ok());
        if (since == 0 && loaded.state.time >= 0.05) {
            first = loaded.state.bodies.velocity[1].x;
            since = loaded.state.time;
        }
    }
    if (height != nullptr) {
        *height = loaded.state.bodies.position[1].z;
    }
    return (first - loaded.state.bodies.velocity[1].x) / (loaded.state.time - since);
}

const std::string pair_of_both = "[[contact.pair]]\nmaterials = [\"ball\", \"floor\"]\n";

TEST(SphereCases, rolling_friction_follows_the_mixing_rule_and_the_pair) {
    // mu_r g/(1 + 2/5) without slip
    const auto rolling = [](const std::string& contact) {
        return deceleration({.solid = "rolling = \"constant\"",
                             .ball = "rolling_friction = 0.08",
                             .floor = "rolling_friction = 0.02",
                             .contact = contact,
                             .motion = "velocity = [1, 0, 0]\nangular_velocity = [0, 20, 0]"}) *
               1.4 / 9.81;
    };
    EXPECT_NEAR(rolling("[contact]\nrolling_mixing = \"mean\""), 0.05, 0.001);
    EXPECT_NEAR(rolling("[contact]\nrolling_mixing = \"geometric\""), 0.04, 0.001);
    EXPECT_NEAR(rolling("[contact]\nrolling_mixing = \"maximum\"\n" + pair_of_both + "rolling_friction = 0.1"), 0.1,
                0.002);
}

TEST(SphereCases, kinetic_friction_follows_the_rule_of_friction_and_the_pair) {
    const auto sliding = [](const std::string& contact) {
        return deceleration({.ball = "kinetic_share = 0.8",
                             .floor = "kinetic_share = 0.4",
                             .contact = contact,
                             .motion = "velocity = [4, 0, 0]"}) /
               9.81;
    };
    EXPECT_NEAR(sliding("[contact]\nfriction_mixing = \"mean\""), 0.5 * 0.6, 0.003);
    EXPECT_NEAR(sliding("[contact]\nfriction_mixing = \"minimum\""), 0.5 * 0.4, 0.003);
    EXPECT_NEAR(sliding("[contact]\nfriction_mixing = \"minimum\"\n" + pair_of_both + "kinetic_share = 0.9"), 0.5 * 0.9,
                0.003);
}

TEST(SphereCases, a_pair_has_springs_of_its_own) {
    // a resting ball sinks in by m g/k
    const double weight = 1000 * 4 * M_PI / 3 * std::pow(0.05, 3) * 9.81;
    const auto overlap = [](const std::string& stiffness) {
        double height = 0;
        deceleration({.solid = "normal_law = \"linear\"\nrestitution = 0.1\nspring_stiffness = 1e5",
                      .contact = stiffness.empty() ? "" : pair_of_both + "spring_stiffness = " + stiffness},
                     &height);
        return 0.05 - height;
    };
    EXPECT_NEAR(overlap(""), weight / 1e5, 0.02 * weight / 1e5);
    EXPECT_NEAR(overlap("2e4"), weight / 2e4, 0.02 * weight / 2e4);
}

TEST(SphereCases, a_pair_has_a_contact_ratio_of_its_own) {
    const std::string rule =
        "[contact]\nrestitution_mixing = \"mean\"\n[[contact.pair]]\nmaterials = [\"ball\", "
        "\"floor\"]\ncontact_ratio = ";
    EXPECT_NEAR(restitution(rule + "0.2271"), 0.5, 0.01);
    EXPECT_NEAR(restitution(rule + "0.05"), 0.861, 0.01);
    // xi of a linear spring: e = exp(-pi xi/sqrt(1 - xi^2))
    const std::string linear = "\n[solid]\nmethod = \"sphere_dem\"\nnormal_law = \"linear\"\n";
    EXPECT_NEAR(restitution(rule + "0.2155" + linear), 0.5, 0.01);
}

TEST(SphereCases, linear_springs_keep_the_restitution_whether_they_pull_or_not) {
    const std::string rule = "[contact]\nrestitution_mixing = \"minimum\"\n[solid]\nmethod = \"sphere_dem\"\n",
                      linear = "normal_law = \"linear\"\nspring_stiffness = 2e5\n";
    EXPECT_NEAR(restitution(rule + linear), 0.5, 0.01);
    EXPECT_NEAR(restitution(rule + linear + "allows_pull = false"), 0.5, 0.01);
}

}  // namespace
}  // namespace riprap::run
