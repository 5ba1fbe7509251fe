// SPDX-License-Identifier: Apache-2.0
// Bodies that lack degrees of freedom, as cases ask for them.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "case_result.hpp"

namespace riprap::run {
namespace {

double value(const Simulation& simulation, const std::string& column) {
    return sim::evaluate(sim::find_column(simulation.model(), column).value(), simulation.now());
}

std::unique_ptr<Simulation> start(const std::string& text, const std::vector<std::string>& overrides = {}) {
    return std::make_unique<Simulation>(scene::read_case_text(text, "case.toml", "/nonexistent", overrides));
}

void step(Simulation& simulation) {
    const StepOutcome outcome = simulation.step(sim::Measure::energy);
    if (outcome.kind == StepOutcome::Kind::refused) {
        throw std::runtime_error(outcome.why.text);
    }
}

/// Steps until the value changes its sign. @returns that time, between the two steps [s]
double sign_change(Simulation& simulation, const std::string& column) {
    step(simulation);
    for (double before = value(simulation, column), since = simulation.state().time;;) {
        step(simulation);
        const double after = value(simulation, column), time = simulation.state().time;
        if (before * after < 0) {
            return since + (time - since) * before / (before - after);
        }
        before = after;
        since = time;
    }
}

/// A plate of 2500 kg on a hinge along y, turned by 40 degrees about x so that the hinge is no principal axis; a force
/// of 20 kN downwards acts on an arm of 0.4 m, level at first.
const std::string pendulum = R"(
gravity = [0.0, 0.0, 0.0]
end = 100.0
time_step = "1 ms"
[material.rock]
density = 2500.0
normal_stiffness = 1.0e7
[[body]]
name = "plate"
material = "rock"
shape = { box = [1.0, 2.0, 0.5] }
orientation = { axis_angle = { axis = [1.0, 0.0, 0.0], angle_deg = 40.0 } }
locked = ["x", "y", "z", "rotation_x", "rotation_z"]
load = [{ force = [0.0, 0.0, -2.0e4], at = [0.4, 0.0, 0.0] }]
)";

TEST(Locks, APendulumOnAHingeThatIsNoPrincipalAxisHasItsPeriod) {
    const double i_y = 2500.0 / 12 * (1.0 + 0.25), i_z = 2500.0 / 12 * (1.0 + 4.0);
    const double turn = 40 * std::numbers::pi / 180, c = std::cos(turn), s = std::sin(turn);
    const double moment = i_y * c * c + i_z * s * s;
    // T = 4 sqrt(I/(F a)) K(sin 45 deg), K(sqrt(1/2)) = Gamma(1/4)^2/(4 sqrt(pi)), for an amplitude of 90 degrees.
    const double k = std::pow(std::tgamma(0.25), 2) / (4 * std::sqrt(std::numbers::pi));
    const double period = 4 * std::sqrt(moment / (2e4 * 0.4)) * k;
    const auto run = start(pendulum);
    const double half = sign_change(*run, "plate.angular_velocity.y"),
                 whole = [&] { return sign_change(*run, "plate.angular_velocity.y"); }();
    EXPECT_NEAR(half, period / 2, 1e-4 * period);
    EXPECT_NEAR(whole, period, 1e-4 * period);
    EXPECT_EQ(value(*run, "plate.distance"), 0) << "the centre of mass stays";
    EXPECT_EQ(value(*run, "plate.angular_velocity.x"), 0);
    EXPECT_EQ(value(*run, "plate.angular_velocity.z"), 0);
    EXPECT_LT(std::abs(value(*run, "energy_residual")), 1e-5 * 2e4 * 0.4);
    for (const char axis : {'x', 'y', 'z'}) {
        EXPECT_LT(std::abs(value(*run, std::string("momentum_residual.") + axis)), 1e-9 * 2e4 * period);
        EXPECT_LT(std::abs(value(*run, std::string("angular_momentum_residual.") + axis)), 1e-9 * 2e4 * period);
    }
}

TEST(Locks, ABodyThatMayTurnAboutTwoAxesKeepsItsEnergyAndNeverTurnsAboutTheThird) {
    std::string text = pendulum.substr(0, pendulum.find("locked"));
    text += "locked = [\"rotation_y\"]\nangular_velocity = [3.0, 0.0, 2.0]\n";
    const auto run = start(text);
    step(*run);
    const double before = value(*run, "plate.kinetic_energy");
    double most = 0;
    for (int k = 0; k < 2000; ++k) {
        step(*run);
        most = std::max(most, std::abs(value(*run, "plate.kinetic_energy") - before));
        ASSERT_EQ(value(*run, "plate.angular_velocity.y"), 0);
    }
    EXPECT_GT(std::abs(value(*run, "plate.angular_velocity.x") - 3.0), 0.1) << "or nothing was tried";
    EXPECT_LT(most, 1e-4 * before);
}

/// A tower of 0.4 m by 2 m on a slope of 30 degrees: it tilts, where nothing keeps it upright.
const std::string tower = R"(
gravity = [4.905, 0.0, -8.4957]
end = 100.0
[material.rock]
density = 2500.0
normal_stiffness = 1.0e7
friction_coefficient = 0.4
[[body]]
name = "plane"
material = "rock"
shape = { half_space = { normal = [0.0, 0.0, 1.0], offset = 0.0 } }
fixed = true
[[body]]
name = "tower"
material = "rock"
shape = { box = [0.4, 0.4, 2.0] }
position = [0.0, 0.0, 1.0]
)";

TEST(Locks, ATowerThatCannotTurnSlidesWhereItWouldTilt) {
    for (const std::string solid : {"[solid]\nmethod = \"distance_potential_dem\"\n",
                                    "[solid]\nmethod = \"sphere_dem\"\nsphere_radius = 0.1\n"}) {
        SCOPED_TRACE(solid);
        const auto free = start(tower + solid), held = start(tower + "locked = [\"rotation\"]\n" + solid);
        const auto run_to = [](Simulation& run, double time) {
            while (run.state().time < time) {
                step(run);
            }
        };
        run_to(*free, 0.5);
        run_to(*held, 0.25);
        // The tower bounces a little: friction is 0.4 of the force that changes its velocity along z, bounces included.
        const auto gained = [&] { return value(*held, "tower.velocity.x") + 0.4 * value(*held, "tower.velocity.z"); };
        const double since = held->state().time, before = gained();
        run_to(*held, 0.5);
        EXPECT_GT(value(*free, "tower.rotation"), 0.05);
        EXPECT_EQ(value(*held, "tower.rotation"), 0);
        const double slide = 4.905 - 0.4 * 8.4957;
        EXPECT_NEAR((gained() - before) / (held->state().time - since), slide, 0.01 * slide);
        EXPECT_LT(std::abs(value(*held, "energy_residual")), 1e-3 * value(*held, "energy_turnover"));
        EXPECT_LT(std::abs(value(*held, "momentum_residual.z")), 1e-9 * 800 * 9.81);
        EXPECT_LT(std::abs(value(*held, "angular_momentum_residual.y")), 1e-9 * 800 * 9.81);
    }
}

/// A stamp in a vertical guide stands on a wedge that is drawn below it at 1 m/s.
const std::string stamp = R"(
gravity = [0.0, 0.0, -9.81]
end = 100.0
[material.rock]
density = 2500.0
normal_stiffness = 1.0e7
damping_ratio = 0.2
[[body]]
name = "wedge"
material = "rock"
shape = { box = [8.0, 2.0, 1.0] }
orientation = { axis_angle = { axis = [0.0, 1.0, 0.0], angle_deg = -20.0 } }
motion = { linear = { velocity = [-1.0, 0.0, 0.0] } }
[[body]]
name = "stamp"
material = "rock"
shape = { cube = 0.6 }
position = [0.0, 0.0, 0.945]
locked = ["x", "y", "rotation"]
)";

TEST(Locks, AStampInAGuideRisesAsTheWedgeBelowItSays) {
    const auto run = start(stamp);
    while (run->state().time < 1.5) {
        step(*run);
    }
    EXPECT_EQ(value(*run, "stamp.displacement.x"), 0);
    EXPECT_NEAR(value(*run, "stamp.velocity.z"), std::tan(20 * std::numbers::pi / 180), 1e-3);
    EXPECT_LT(std::abs(value(*run, "energy_residual")), 1e-3 * value(*run, "energy_turnover"));
    EXPECT_LT(std::abs(value(*run, "momentum_residual.x")), 1e-9 * 540 * 9.81);
}

/// A box of 2 m by 1 m floats half submerged in still water, hinged at its centre.
const std::string hinged_box = R"(
dimension = 2
gravity = [0.0, -9.81]
end = 100.0
time_step = "2 ms"
[material.wood]
density = 500.0
normal_stiffness = 1.0e7
[[body]]
name = "box"
material = "wood"
shape = { box = [2.0, 1.0] }
orientation = { angle_deg = 1.0 }
locked = ["x", "y"]
[fluid]
method = "hydrostatic"
density = 1000.0
spacing = "2 cm"
domain = { low = [-4.0, -3.0], high = [4.0, 2.0] }
[[fluid.region]]
box = { low = [-4.0, -3.0], high = [4.0, 0.0] }
)";

TEST(Locks, AFloatingBoxOnAHingeRollsWithThePeriodOfItsMetacentre) {
    const double mass = 500 * 2, inertia = mass / 12 * (4 + 1), inertia_of_plane = 8.0 / 12, below = 1, arm = 0.25;
    // Restoring moment per radian: rho g (I_plane - V BG).
    const double stiffness = 1000 * 9.81 * (inertia_of_plane - below * arm);
    const double period = 2 * std::numbers::pi * std::sqrt(inertia / stiffness);
    const auto run = start(hinged_box);
    const double half = sign_change(*run, "box.angular_velocity.z");
    EXPECT_NEAR(half, period / 2, 0.005 * period);
    EXPECT_EQ(value(*run, "box.distance"), 0);
}

}  // namespace
}  // namespace riprap::run
