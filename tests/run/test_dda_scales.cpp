// SPDX-License-Identifier: Apache-2.0
// Blocks of any size at the default stiffness and step of the DDA methods: a scene s times as large goes by lengths
// times s and times times sqrt(s).
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <tuple>
#include <variant>

#include "riprap/run/simulate/simulation.hpp"
#include "riprap/scene/read_case.hpp"

namespace riprap::run {
namespace {

constexpr double g = 9.81;

/// A scene in the plane, scaled and turned.
struct Scene {
    std::string method{"planar_dda"};
    double size{1};
    double turned{0};        ///< [rad]
    std::string settings{};  ///< of the method
    std::string material{};

    Vec3 turn(double x, double y) const {
        return {x * std::cos(turned) - y * std::sin(turned), x * std::sin(turned) + y * std::cos(turned), 0};
    }
    std::string vector(double x, double y) const {
        const Vec3 v = turn(x, y);
        return fmt::format("[{}, {}]", v.x, v.y);
    }
    /// A box with its centre at (x, y) before turning and the speed (u, v), all of the scene with size 1.
    std::string box(const std::string& name, double wide, double high, double x, double y, double u = 0, double v = 0,
                    bool is_fixed = false) const {
        const double speed = std::sqrt(size);
        return fmt::format(
            "[[body]]\nname = '{}'\nmaterial = 'rock'\nshape = {{ box = [{}, {}] }}\nposition = {}\n"
            "orientation = {{ angle = {} }}\n{}\n",
            name, size * wide, size * high, vector(size * x, size * y), turned,
            is_fixed ? "fixed = true" : "velocity = " + vector(speed * u, speed * v));
    }
    std::string floor(double half = 3) const { return box("floor", 2 * half, 0.5, 0, -0.25, 0, 0, true); }
    /// Gravity along (x, y) before turning, which grows from nothing over a fifth of a second.
    std::string text(double x, double y, double end, const std::string& bodies, double ramp = 0) const {
        const double times = std::sqrt(size);
        // The waves through a metre of thickness bound the step of large blocks.
        const bool is_slow = method == "explicit_dda" && size > 1;
        return fmt::format(
            "{}dimension = 2\ngravity = {{ value = {}, ramp = {} }}\nend = {}\n[material.rock]\ndensity = 2500\n"
            "normal_stiffness = 1e8\n{}\n[solid]\nmethod = '{}'\n{}\n{}",
            is_slow ? "time_step_factor = 0.5\n" : "", vector(x, y), times * ramp, times * end, material, method,
            settings, bodies);
    }
};

/// Runs a case to its end.
std::unique_ptr<Simulation> run(const std::string& text) {
    auto simulation = std::make_unique<Simulation>(scene::read_case_text(text, "case.toml", "."));
    while (simulation->steps_left() > 0) {
        const StepOutcome outcome = simulation->step(sim::Measure::energy);
        if (outcome.kind == StepOutcome::Kind::refused) {
            ADD_FAILURE() << outcome.why.text;
            break;
        }
    }
    return simulation;
}

double value(const std::unique_ptr<Simulation>& simulation, const std::string& column) {
    return sim::evaluate(sim::find_column(simulation->model(), column).value(), simulation->now());
}

/// Displacement of the block along x and y before turning, over the size.
Vec3 way(const Scene& scene, const std::unique_ptr<Simulation>& simulation, const std::string& what = "displacement") {
    const double x = value(simulation, "block." + what + ".x"), y = value(simulation, "block." + what + ".y");
    const Vec3 back = Scene{.turned = -scene.turned}.turn(x, y);
    return back / (what == "displacement" ? scene.size : std::sqrt(scene.size));
}

class Sized : public ::testing::TestWithParam<std::tuple<const char*, double, double>> {
 protected:
    Scene scene() const {
        return {.method = std::get<0>(GetParam()), .size = std::get<1>(GetParam()), .turned = std::get<2>(GetParam())};
    }
};

TEST_P(Sized, ADroppedBlockComesToRestOnTheFloor) {
    Scene scene = this->scene();
    scene.material = "damping_ratio = 0.3\nfriction_coefficient = 0.3";
    // Implicit DDA has no dashpots: its steps take 1 - 0.74 of the speed, and bounces end after 0.67 s.
    const auto end = run(scene.text(0, -g, 1, scene.floor() + scene.box("block", 0.6, 0.4, 0, 0.25)));
    EXPECT_NEAR(way(scene, end).y, -0.05, 0.001);
    EXPECT_NEAR(way(scene, end).x, 0, 0.001);
}

TEST_P(Sized, ASlidingBlockStopsAfterItsWayOfFriction) {
    Scene scene = this->scene();
    scene.material = "friction_coefficient = 0.3";
    const auto end = run(scene.text(0, -g, 0.5, scene.floor() + scene.box("block", 0.7, 0.3, 0, 0.15, 1.2)));
    EXPECT_NEAR(way(scene, end).x, 1.44 / (2 * 0.3 * g), 0.01 * 0.245);
}

TEST_P(Sized, ABlockRestsBelowTheAngleOfFrictionAndSlidesAboveIt) {
    Scene scene = this->scene();
    scene.material = "friction_coefficient = 0.5773502692";
    const auto slid = [&](double degrees) {
        const double a = degrees * M_PI / 180;
        const auto end = run(scene.text(g * std::sin(a), -g * std::cos(a), 0.5,
                                        scene.floor() + scene.box("block", 0.8, 0.2, 0, 0.1), 0.2));
        return way(scene, end).x;
    };
    EXPECT_NEAR(slid(29), 0, 0.002);
    const double a = 33 * M_PI / 180, pull = g * (std::sin(a) - std::cos(a) * std::tan(M_PI / 6));
    EXPECT_NEAR(slid(33), pull * (0.04 / 6 + 0.2 * 0.3 / 2 + 0.09 / 2), 0.002);
}

TEST_P(Sized, ABrickTurnsOverTheEdgeBeyondItsMiddleOnly) {
    Scene scene = this->scene();
    scene.material = "friction_coefficient = 0.8";
    const auto turn = [&](double beyond) {
        const auto end = run(scene.text(
            0, -g, 0.6,
            scene.box("support", 2, 0.5, -1, -0.25, 0, 0, true) + scene.box("block", 1, 0.25, beyond, 0.125), 0.2));
        return value(end, "block.rotation");
    };
    EXPECT_NEAR(turn(-0.02), 0, 0.02);
    EXPECT_NEAR(turn(0.02), 0.30487, 0.02);  // as in validation/cross/overhang
}

TEST_P(Sized, AWeightlessBlockGivesItsSpeedToAnother) {
    Scene scene = this->scene();
    scene.material = "restitution = 1.0";
    if (scene.method != "explicit_dda") {
        scene.settings = fmt::format("youngs_modulus = {}", 5e9 * scene.size);  // waves as fast, beside the blocks
    }
    const auto end =
        run(scene.text(0, 0, 0.2, scene.box("other", 0.4, 0.4, 0.5, 0) + scene.box("block", 0.4, 0.4, 0, 0, 2)));
    // Implicit DDA has no restitution. Half an oscillation on four points, w dt = 0.2 sqrt(8), keeps e of the speed by
    // (1 + (w dt)^2/2)^(-1/2) a step, give or take a step.
    const bool is_damped = scene.method == "implicit_dda";
    const double lost = std::sqrt(1 + 0.5 * 0.32), e = is_damped ? std::pow(lost, -M_PI / std::sqrt(0.32)) : 1;
    EXPECT_NEAR(way(scene, end, "velocity").x, 1 - e, is_damped ? e * (lost - 1) : 0.02);
    EXPECT_NEAR(way(scene, end, "velocity").y, 0, 0.02);
}

std::string name_of(const ::testing::TestParamInfo<Sized::ParamType>& of) {
    return fmt::format("{}_{:.0f}_of_a_thousand{}", std::get<0>(of.param), 1000 * std::get<1>(of.param),
                       std::get<2>(of.param) > 0 ? "_turned" : "");
}

constexpr double turned_by_37_degrees = 0.645771823;

INSTANTIATE_TEST_SUITE_P(ImplicitMethods, Sized,
                         ::testing::Combine(::testing::Values("planar_dda", "implicit_dda"),
                                            ::testing::Values(1e-3, 0.03, 30, 1e3),
                                            ::testing::Values(0, turned_by_37_degrees)),
                         name_of);
INSTANTIATE_TEST_SUITE_P(ExplicitMethod, Sized,
                         ::testing::Values(std::tuple{"explicit_dda", 1e-3, turned_by_37_degrees},
                                           std::tuple{"explicit_dda", 30.0, 0.0}),
                         name_of);

/// Stiffness and step that a case runs with.
struct Chosen {
    double stiffness{0}, step{0}, modulus{0};
};

Chosen chosen(const std::string& text) {
    const scene::LoadedCase loaded = scene::read_case_text(text, "case.toml", ".");
    return std::visit(
        [](const auto& settings) {
            Chosen found;
            if constexpr (requires { settings.elasticity.contact_stiffness; }) {
                found.stiffness = settings.elasticity.contact_stiffness;
                found.modulus = settings.elasticity.youngs_modulus;
            }
            if constexpr (requires { settings.step; }) {
                found.step = settings.step;
            }
            return found;
        },
        loaded.model.solid);
}

/// A cube of rock with faces of a metre times `size`.
std::string cube(const std::string& method, double size, const std::string& more = "",
                 const std::string& gravity = "[0, 0, -9.81]") {
    return fmt::format(
        "gravity = {}\nend = 1\n[material.rock]\ndensity = 2500\nnormal_stiffness = 1e8\n[solid]\nmethod = '{}'\n"
        "[[body]]\nname = 'block'\nmaterial = 'rock'\nshape = {{ cube = {} }}\nposition = [0, 0, 0]\n{}\n",
        gravity, method, size, more);
}

TEST(DdaScales, RockOfAMetreHasAHundredMillionNewtonsAMetreAndAMillisecond) {
    const Chosen found = chosen(cube("implicit_dda", 1));
    EXPECT_NEAR(found.stiffness, 1e8, 0.02e8);  // 2000 2500 9.81/0.5
    EXPECT_NEAR(found.step, 1e-3, 0.02e-3);     // 0.2 sqrt(0.5/(2000 9.81))
}

TEST(DdaScales, FollowTheSquareOfTheSizeInSpaceTheSizeInThePlaneAndItsRootInTime) {
    const Chosen metre = chosen(cube("implicit_dda", 1));
    const Scene of_metre{.method = "planar_dda"};
    const Chosen square = chosen(of_metre.text(0, -g, 1, of_metre.box("block", 1, 1, 0, 0)));
    EXPECT_NEAR(square.stiffness, metre.stiffness, 1e-9 * metre.stiffness);
    for (const double s : {1e-3, 1e3}) {
        const Chosen scaled = chosen(cube("implicit_dda", s));
        EXPECT_NEAR(scaled.stiffness, s * s * metre.stiffness, 1e-9 * scaled.stiffness);
        EXPECT_NEAR(scaled.step, std::sqrt(s) * metre.step, 1e-9 * scaled.step);
        const Scene scene{.method = "planar_dda", .size = s};
        const Chosen in_plane = chosen(scene.text(0, -g, 1, scene.box("block", 1, 1, 0, 0)));
        EXPECT_NEAR(in_plane.stiffness, s * square.stiffness, 1e-9 * in_plane.stiffness);
        EXPECT_NEAR(in_plane.step, std::sqrt(s) * square.step, 1e-9 * in_plane.step);
    }
}

TEST(DdaScales, TheFootOfAStackCarriesAllBlocksOfIt) {
    const Scene scene{.method = "planar_dda"};
    const auto stiffness = [&](int blocks, double apart) {
        std::string bodies;
        for (int i = 0; i < blocks; ++i) {
            bodies += scene.box(fmt::format("block{}", i), 0.5, 0.5, i * apart, 0.25 + (apart > 0 ? 0 : 0.5 * i));
        }
        return chosen(scene.text(0, -g, 1, scene.floor() + bodies)).stiffness;
    };
    const double one = 2000 * 2500 * 0.25 * g / 0.25;
    EXPECT_NEAR(stiffness(1, 0), one, 1e-9 * one);
    EXPECT_NEAR(stiffness(4, 0), 4 * one, 1e-9 * one);
    EXPECT_NEAR(stiffness(9, 0), 9 * one, 1e-9 * one);
    EXPECT_NEAR(stiffness(4, 0.6), one, 1e-9 * one);  // beside each other
}

TEST(DdaScales, ALargeBlockUnderAPebbleCarriesThePebbleAlone) {
    const Scene scene{.method = "planar_dda"};
    const std::string pebble = scene.box("pebble", 0.02, 0.02, 0, 1.01), block = scene.box("block", 1, 1, 0, 0.5);
    const double alone = chosen(scene.text(0, -g, 1, block)).stiffness;
    EXPECT_NEAR(chosen(scene.text(0, -g, 1, block + pebble)).stiffness, (1 + 0.02 * 0.02) * alone, 1e-9 * alone);
}

TEST(DdaScales, SmallBlocksOfTheExplicitMethodAreOnlyAsStiffAsTheirPressureAsks) {
    EXPECT_NEAR(chosen(cube("explicit_dda", 1)).modulus, 4.905e9, 1);  // 400000 2500 9.81 0.5
    EXPECT_NEAR(chosen(cube("explicit_dda", 1e-3)).modulus, 4e5 * 2500 * g * 0.5e-3, 1);
    EXPECT_EQ(chosen(cube("explicit_dda", 1e3)).modulus, 5e9);
    EXPECT_EQ(chosen(cube("implicit_dda", 1e-3)).modulus, 5e9);
    const auto steps = [](double size) {
        return run(cube("explicit_dda", size, "", "[0, 0, -9.81]\nmax_steps = 1"))->next_dt() / std::sqrt(size);
    };
    EXPECT_NEAR(steps(1e-3), steps(0.1), 1e-4 * steps(0.1));
}

TEST(DdaScales, ABlockOnOneCornerSinksByATwoThousandthOfItsRadius) {
    Scene scene{.method = "planar_dda", .settings = "dynamic_factor = 0\n"};
    for (const double size : {0.01, 1.0}) {
        scene.size = size;
        const auto end = run(scene.text(0, -g, 0.05, scene.floor() + scene.box("block", 0.5, 0.5, 0, 0.25)));
        EXPECT_NEAR(way(scene, end).y, -0.25 / 2000 / 2, 0.2 * 0.25 / 2000 / 2);  // on two
    }
}

TEST(DdaScales, LoadsAndSpeedsStandForGravityWhereThereIsNone) {
    const std::string none = "[0, 0, 0]";
    const Chosen weight = chosen(cube("implicit_dda", 1)), bare = chosen(cube("implicit_dda", 1, "", none));
    EXPECT_EQ(bare.stiffness, weight.stiffness);  // standard gravity where nothing gives a scale
    EXPECT_EQ(bare.step, weight.step);
    const Chosen loaded = chosen(cube("implicit_dda", 1, "[[body.load]]\nforce = [5000, 0, 0]\nramp = 0.5", none));
    EXPECT_NEAR(loaded.stiffness, 2000 * 5000 / 0.5, 1);
    EXPECT_NEAR(loaded.step, 0.2 * std::sqrt(0.5 / (2000 * 2.0)), 1e-9);
    const Chosen fast = chosen(cube("implicit_dda", 1, "velocity = [4, 0, 0]", none));
    EXPECT_NEAR(fast.stiffness, 2000 * 2500 * (16 / (4 * 0.5)) / 0.5, 1);
    const Chosen turning = chosen(cube("implicit_dda", 1, "angular_velocity = [0, 0, 4]", none));
    EXPECT_NEAR(turning.stiffness, 2000 * 2500 * (16 * 0.5 / (4 * 0.5)) / 0.5, 1);  // corners 0.707 m from the axis
    const Chosen slow = chosen(cube("implicit_dda", 1, "velocity = [4, 0, 0]"));
    EXPECT_EQ(slow.stiffness, weight.stiffness);  // less than it weighs
}

TEST(DdaScales, AStatedValueKeepsItsBitsAndTheOtherIsChosen) {
    const std::string text = cube("implicit_dda", 0.01);
    const auto with = [&](const std::string& key) {
        std::string changed = text;
        return chosen(changed.insert(changed.find("[[body]]"), key + "\n"));
    };
    EXPECT_EQ(with("contact_stiffness = 1e8").stiffness, 1e8);
    EXPECT_EQ(with("contact_stiffness = 1e8").step, chosen(text).step);
    EXPECT_EQ(with("step = 1e-3").step, 1e-3);
    EXPECT_EQ(with("step = 1e-3").stiffness, chosen(text).stiffness);
    EXPECT_EQ(with("step = 'auto'").step, chosen(text).step);
    EXPECT_THROW(with("contact_stiffness = 1e8\ncontact_stiffness_per_area = 1e9"), CaseError);
    EXPECT_THROW(with("contact_stiffness = 0"), CaseError);
}

TEST(DdaScales, CheckTellsWhatTheyFollowFrom) {
    EXPECT_THAT(
        scene::read_case_text(cube("implicit_dda", 1), "case.toml", ".").notes,
        ::testing::IsSupersetOf({
            "solid.contact_stiffness = 9.81e+07 N/m, 2000 m a/R of 'block', R = 0.5 m, a = 9.81 m/s^2 by its weight",
            "solid.step = 0.00101 s, 0.2 sqrt(R/(2000 a)) of 'block', R = 0.5 m, a = 9.81 m/s^2 by its weight",
        }));
}

}  // namespace
}  // namespace riprap::run
