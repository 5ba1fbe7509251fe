// SPDX-License-Identifier: Apache-2.0
// Sampled bodies in scenes with an answer by hand, at the shipped defaults of sphere_dem.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "riprap/run/simulate/simulation.hpp"
#include "riprap/scene/read_case.hpp"
#include "riprap/solid/sphere_dem/default_stiffness.hpp"

namespace riprap::run {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::string head(double end, const std::string& gravity, bool is_planar = true, const std::string& solid = "") {
    return fmt::format(
        "{}gravity = {}\nend = {}\n[material.rock]\ndensity = 2500\nnormal_stiffness = 1e8\n"
        "friction_coefficient = 0\n[solid]\nmethod = 'sphere_dem'\n{}\n",
        is_planar ? "dimension = 2\n" : "", gravity, end, solid);
}
std::string body(const std::string& name, const std::string& shape, const std::string& more) {
    return "[[body]]\nname = '" + name + "'\nmaterial = 'rock'\nshape = { " + shape + " }\n" + more + "\n";
}

struct End {
    std::string reason;  ///< of a refusal
    Vec3 position, velocity;
};

/// Runs a case and returns how its last body ends.
End end_of(const std::string& text) {
    Simulation simulation(scene::read_case_text(text, "case.toml", "."));
    End end;
    while (simulation.steps_left() > 0 && end.reason.empty()) {
        const StepOutcome outcome = simulation.step(sim::Measure::flow);
        end.reason = outcome.kind == StepOutcome::Kind::refused ? outcome.why.text : "";
    }
    end.position = simulation.state().bodies.position.back();
    end.velocity = simulation.state().bodies.velocity.back();
    return end;
}

/// A square of 0.2 m falls at 1 m/s onto a slot of `share` of its width, turned by `angle`. @returns its height above
/// the face of the slot [m]
double over_slot(double share, double angle, bool is_planar) {
    const double c = std::cos(angle), s = std::sin(angle), side = 0.1 * share + 0.5;
    const auto vector = [&](double x, double y) {
        return is_planar ? fmt::format("[{}, {}]", c * x - s * y, s * x + c * y)
                         : fmt::format("[{}, {}, 0]", c * x - s * y, s * x + c * y);
    };
    const std::string turn =
        is_planar ? fmt::format("orientation = {{ angle = {} }}\n", angle)
                  : fmt::format("orientation = {{ axis_angle = {{ axis = [0, 0, 1], angle_deg = {} }} }}\n",
                                angle * 180 / M_PI);
    const std::string wall = is_planar ? "box = [1, 0.5]" : "box = [1, 0.5, 1]",
                      cube = is_planar ? "box = [0.2, 0.2]" : "cube = 0.2";
    const End end =
        end_of(head(0.1, vector(0, -9.81), is_planar) +
               body("left", wall, turn + "fixed = true\nposition = " + vector(-side, -0.25)) +
               body("right", wall, turn + "fixed = true\nposition = " + vector(side, -0.25)) +
               body("block", cube, turn + "velocity = " + vector(0, -1) + "\nposition = " + vector(0, 0.12)));
    if (!end.reason.empty()) {
        EXPECT_THAT(end.reason, AllOf(HasSubstr("block"), ::testing::AnyOf(HasSubstr("left"), HasSubstr("right"))));
        return 1;
    }
    return -s * end.position.x + c * end.position.y;
}

TEST(SphereScenes, ABodyStaysAboveASlotNarrowerThanItself) {
    for (const double share : {0.5, 0.8, 0.9, 0.95}) {
        EXPECT_GT(over_slot(share, 0, true), 0.095) << share;
    }
    EXPECT_GT(over_slot(0.9, 37 * M_PI / 180, true), 0.095);
    EXPECT_GT(over_slot(0.9, 0, false), 0.095);
    EXPECT_GT(over_slot(0.95, 37 * M_PI / 180, false), 0.095);
}

TEST(SphereScenes, AStepOfATenthOfTheBlockStopsItAndASeamDoesNot) {
    const auto speed_over = [](double step) {
        return end_of(head(0.05, "[0, -9.81]") +
                      body("left", "box = [1, 0.5]", "fixed = true\nposition = [-0.5, -0.25]") +
                      body("right", "box = [1, 0.5]", fmt::format("fixed = true\nposition = [0.5, {}]", step - 0.25)) +
                      body("block", "box = [0.2, 0.1]", "position = [-0.12, 0.05]\nvelocity = [1, 0]"))
            .velocity.x;
    };
    EXPECT_NEAR(speed_over(0), 1, 0.005);
    for (const double step : {0.002, 0.01, 0.03}) {
        EXPECT_LT(speed_over(step), 0.05) << step;
    }
}

TEST(SphereScenes, APolygonIsSampledFlushWithItsFaces) {
    const End end =
        end_of(head(0.05, "[0, -9.81]") + body("floor", "half_space = { normal = [0, 1] }", "fixed = true") +
               body("stone", "polygon = [[-0.2, 0], [0.2, 0], [0.1, 0.2], [-0.1, 0.2]]", ""));
    EXPECT_EQ(end.reason, "");
    const double centre = 0.2 / 3 * (0.4 + 2 * 0.2) / (0.4 + 0.2);
    EXPECT_NEAR(end.position.y, centre, 1e-4 * 0.2);
}

/// Modulus that a case leaves to the method [Pa].
double modulus_of(const std::string& text, double* overlap = nullptr) {
    const scene::LoadedCase loaded = scene::read_case_text(text, "case.toml", ".");
    const auto& settings = std::get<solid::SphereDemSettings>(loaded.model.solid);
    if (overlap != nullptr) {
        const solid::SolidScene scene = sim::solid_scene(loaded.model);
        *overlap = solid::sphere_dem::static_overlap(
            solid::sphere_dem::contact_duty(scene, settings, loaded.state.bodies, 0), settings);
    }
    return settings.youngs_modulus;
}

TEST(SphereScenes, ADefaultModulusLetsABlockSinkInByATenThousandthAtRest) {
    const std::string floor = body("floor", "half_space = { normal = [0, 0, 1] }", "fixed = true");
    const std::string cube = body("cube", "cube = 1", "position = [0, 0, 0.5]");
    double overlap = 0;
    const double modulus = modulus_of(head(1, "[0, 0, -9.81]", false) + floor + cube, &overlap);
    EXPECT_NEAR(overlap, 1e-4, 1e-9);
    // On one edge, whose samples count by 1/4, 1/2, 1/2 and 1/4: m g/1.5 = 4/3 E* sqrt(1/6) (1e-4)^(3/2), E* = E/(2 (1
    // - 0.3^2))
    EXPECT_NEAR(modulus, 2 * 0.91 * 0.75 * 2500 * 9.81 / 1.5 / std::sqrt(1.0 / 6) * 1e6, 1e-6 * modulus);
    EXPECT_EQ(modulus_of(head(1, "[0, 0, -9.81]", false, "youngs_modulus = 3e8") + floor + cube), 3e8);
}

TEST(SphereScenes, ADefaultModulusLetsABlockSinkInByAHundredthInItsImpact) {
    const double modulus = modulus_of(head(1, "[0, 0, 0]", false) + body("cube", "cube = 1", "velocity = [0, 0, -8]"));
    // On one corner, whose sample counts by a quarter: m v^2/2 = 1/4 8/15 E* sqrt(1/6) (0.01)^(5/2)
    EXPECT_NEAR(modulus, 4 * 2 * 0.91 * 15.0 / 16 * 2500 * 64 / std::sqrt(1.0 / 6) * 1e5, 1e-6 * modulus);
}

TEST(SphereScenes, ADefaultModulusIsNoSofterThanTenMegapascals) {
    EXPECT_EQ(modulus_of(head(1, "[0, 0, 0]", false) + body("cube", "cube = 1", "")), 1e7);
}

/// Way along x of a block of 0.7 x 0.3 (x 0.5) m in 0.3 s without friction, under a pull of `share` of what cohesion
/// holds on its base [m].
double way_with_cohesion(double share, bool is_planar, const std::string& floor, const std::string& turn = "") {
    constexpr double cohesion = 4000, density = 2500, height = 0.3;
    const double pull = share * cohesion / (density * height);
    const std::string gravity = is_planar ? fmt::format("[{}, -9.81]", pull) : fmt::format("[{}, 0, -9.81]", pull);
    std::string text = head(0.3, gravity, is_planar) + floor +
                       body("block", is_planar ? "box = [0.7, 0.3]" : "box = [0.7, 0.5, 0.3]",
                            (is_planar ? "position = [0, 0.15]" : "position = [0, 0, 0.15]") + turn);
    text.insert(text.find("friction_coefficient"), fmt::format("cohesion = {}\n", cohesion));
    return end_of(text).position.x;
}

TEST(SphereScenes, CohesionHoldsASampledBlockUpToItsStrengthTimesItsBase) {
    const std::string line = body("floor", "half_space = { normal = [0, 1] }", "fixed = true");
    const std::string slab = body("floor", "box = [3, 1]", "fixed = true\nposition = [0.2, -0.5]");
    const std::string plane = body("floor", "half_space = { normal = [0, 0, 1] }", "fixed = true");
    const std::string turned = "\norientation = { axis_angle = { axis = [0, 0, 1], angle_deg = 37 } }";
    const double free = 0.5 * 0.1 * 4000 / (2500 * 0.3) * 0.09;  // under what is above the strength
    for (const auto& [is_planar, floor, turn] : {std::tuple{true, line, std::string()},
                                                 {true, slab, std::string()},
                                                 {false, plane, std::string()},
                                                 {false, plane, turned}}) {
        EXPECT_LT(std::abs(way_with_cohesion(0.95, is_planar, floor, turn)), 1e-4) << floor << turn;
        EXPECT_NEAR(way_with_cohesion(1.1, is_planar, floor, turn), free, 0.05 * free) << floor << turn;
    }
}

TEST(SphereScenes, ABlockAtRestTakesTheStepsOfItsContactsAndAFallingOneThoseOfItsImpact) {
    const std::string floor = body("floor", "half_space = { normal = [0, 1] }", "fixed = true");
    const auto steps_of = [&](double height, double end) {
        Simulation simulation(scene::read_case_text(
            head(end, "[0, -9.81]", true, "youngs_modulus = 1e9") + floor +
                body("block", "box = [0.3, 0.3]", fmt::format("position = [0, {}]", 0.15 + height)),
            "case.toml", "."));
        std::vector<double> steps;
        while (simulation.steps_left() > 0) {
            steps.push_back(simulation.next_dt());
            simulation.step(sim::Measure::flow);
        }
        return steps;
    };
    // Three cells of 0.1 m along the base, each a spring on R = 0.05 m: m g = 3 4/3 E* sqrt(R) d^(3/2).
    const double mass = 2500 * 0.09, inertia = mass * 0.09 / 6, modulus = 1e9 / (2 * 0.91), root = std::sqrt(0.05);
    const double overlap = std::pow(mass * 9.81 / (4 * modulus * root), 2.0 / 3);
    const double compliance = 1 / mass + 0.15 * 0.15 / inertia;  // of all, and with their arms along the base
    const double spring = 2 * modulus * std::sqrt(0.05 * overlap) *
                          (3 * compliance + (2 * 0.05 * 0.05 + 2 * 0.5 * 0.15 * 0.15) / inertia);
    EXPECT_NEAR(steps_of(0, 1).back(), 0.15 * 2 / std::sqrt(spring), 0.05 * 0.3 / std::sqrt(spring));
    // A fall of 0.1 m: an impact at 1.4 m/s on three springs takes fifty steps.
    const std::vector<double> falling = steps_of(0.1, 0.2);
    const double impact = 2.868 * std::pow(mass / (3 * modulus * root * std::sqrt(std::sqrt(2 * 9.81 * 0.1))), 0.4);
    EXPECT_LT(*std::ranges::min_element(falling), impact / 50);
    EXPECT_GT(*std::ranges::min_element(falling), impact / 200);
}

// Bodies that were held, driven or only turned were not seen to come: their contacts were as soft as weight alone asks.
TEST(SphereScenes, AreAsStiffForABodyThatIsLetGoOrDrivenAsForOneThatFallsAsFast) {
    const auto modulus = [](const std::string& gravity, const std::string& bodies) {
        const scene::LoadedCase loaded = scene::read_case_text(head(1, gravity, false) + bodies, "case.toml", ".");
        return std::get<solid::SphereDemSettings>(loaded.model.solid).youngs_modulus;
    };
    const std::string down = "[0, 0, -9.81]", none = "[0, 0, 0]";
    const std::string floor = body("floor", "box = [4, 4, 1]", "position = [0, 0, -0.5]\nfixed = true");
    const auto cube = [](const std::string& more) {
        return body("cube", "cube = 0.2", "position = [0, 0, 1.1]\n" + more);
    };
    const double falls = modulus(down, floor + cube(""));
    EXPECT_GT(falls, 2 * modulus(down, floor + body("cube", "cube = 0.2", "position = [0, 0, 0.1]")));
    EXPECT_EQ(modulus(down, floor + cube("fixed = true\nrelease_time = 0.1")), falls);

    const double flies = modulus(none, floor + cube("velocity = [0, 0, -3]"));
    const std::string ram = body("ram", "box = [1, 1, 0.2]",
                                 "position = [0, 0, 2]\nmotion = { linear = { velocity = "
                                 "[0, 0, -3] }, start = 0.4, stop = 0.402 }");
    EXPECT_NEAR(modulus(none, cube("") + ram), flies, 1e-9 * flies);
    const std::string away = body("ram", "box = [1, 1, 0.2]",
                                  "position = [0, 0, 2]\nmotion = { linear = { velocity = "
                                  "[0, 0, 3] } }");
    EXPECT_LT(modulus(none, cube("") + away), 0.1 * flies);
    EXPECT_GT(modulus(none, floor + cube("angular_velocity = [0, 30, 0]")), flies);
}

}  // namespace
}  // namespace riprap::run
