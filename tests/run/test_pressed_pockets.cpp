// SPDX-License-Identifier: Apache-2.0
// Full pockets of the grid that free bodies close: their water carries the bodies.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "riprap/run/simulate/simulation.hpp"
#include "riprap/scene/read_case.hpp"
#include "riprap/sim/advance.hpp"

namespace riprap::run {
namespace {

using testing::HasSubstr;

constexpr double gravity = 9.81;

/// Places of a scene turned about the origin.
struct Turned {
    double angle{0};  ///< [rad]

    std::string place(double x, double y) const {
        const double c = std::cos(angle), s = std::sin(angle);
        return fmt::format("[{:.17g}, {:.17g}]", c * x - s * y, s * x + c * y);
    }
    std::string box(const std::string& name, double low_x, double low_y, double high_x, double high_y,
                    const std::string& more) const {
        return fmt::format(
            "[[body]]\nname = '{}'\nmaterial = 'rock'\nshape = {{ box = [{:.17g}, {:.17g}] }}\nposition = {}\n"
            "orientation = {{ angle = {:.17g} }}\n{}\n",
            name, high_x - low_x, high_y - low_y, place(0.5 * (low_x + high_x), 0.5 * (low_y + high_y)), angle, more);
    }
    std::string water(double low_x, double low_y, double high_x, double high_y) const {
        return fmt::format("[[fluid.region]]\nshape = {{ polygon = [{}, {}, {}, {}] }}\n", place(low_x, low_y),
                           place(high_x, low_y), place(high_x, high_y), place(low_x, high_y));
    }
    /// A scene with a floor and two walls 0.8 m apart.
    std::string tank(const std::string& inside, const std::string& solid = "distance_potential_dem") const {
        return fmt::format(
                   "dimension = 2\ngravity = {}\nend = 10\n[solid]\nmethod = '{}'\n[material.rock]\n"
                   "density = 2500\nnormal_stiffness = 1e7\nfriction_coefficient = 0\ndamping_ratio = 0.2\n"
                   "[fluid]\nmethod = 'grid'\nspacing = 0.04\ndomain = {{ low = {}, high = {} }}\n",
                   place(0, -gravity), solid, angle == 0 ? "[-0.36, -0.36]" : "[-1.1, -0.4]",
                   angle == 0 ? "[1.16, 1.4]" : "[1.2, 1.8]") +
               inside + box("floor", -0.2, -0.2, 1, 0, "fixed = true") + box("left", -0.2, 0, 0, 1.2, "fixed = true") +
               box("right", 0.8, 0, 1, 1.2, "fixed = true");
    }
};

/// Goes on to a time; returns what ended the run before.
std::string run_to(Simulation& simulation, double time) {
    while (simulation.state().time < time) {
        const StepOutcome outcome = simulation.step(sim::Measure::energy);
        if (outcome.kind == StepOutcome::Kind::refused) {
            return outcome.why.text;
        }
    }
    return "";
}

Simulation simulate(const std::string& text) { return Simulation(scene::read_case_text(text, "case.toml", ".")); }

Vec3 place_of(const Simulation& simulation, const std::string& name) {
    for (std::int32_t b = 0; b < simulation.model().bodies.size(); ++b) {
        if (simulation.model().bodies.name(BodyId{b}) == name) {
            return simulation.state().bodies.position[static_cast<std::size_t>(b)];
        }
    }
    throw std::logic_error("no such body");
}

/// Way of a body until a time; the run must get there [m].
double way_of(const std::string& text, const std::string& name, double time) {
    Simulation simulation = simulate(text);
    const Vec3 start = place_of(simulation, name);
    EXPECT_EQ(run_to(simulation, time), "") << text;
    return norm(place_of(simulation, name) - start);
}

// Story: the pressure of the pocket was that of the air around it, and the block fell through the water.
TEST(PressedPockets, CarryABlockAsWideAsItsTankWithEverySolidAtAnyAngle) {
    for (const char* solid : {"distance_potential_dem", "explicit_dda", "implicit_dda", "planar_dda", "sphere_dem"}) {
        const Turned upright;
        EXPECT_LT(
            way_of(upright.tank(
                       upright.water(0, 0, 0.8, 0.4) + upright.box("block", 0, 0.4, 0.8, 0.7, "density = 1500"), solid),
                   "block", 0.2),
            1e-3)
            << solid;
    }
    for (const double degrees : {37.0, -12.0}) {
        const Turned turned{degrees * M_PI / 180};
        EXPECT_LT(
            way_of(turned.tank(turned.water(0, 0, 0.8, 0.4) + turned.box("block", 0, 0.4, 0.8, 0.7, "density = 1500")),
                   "block", 0.2),
            1e-3)
            << degrees;
    }
}

TEST(PressedPockets, CarryAHeavyAndALightBlock) {
    for (const int density : {300, 7800}) {
        const Turned upright;
        EXPECT_LT(way_of(upright.tank(upright.water(0, 0, 0.8, 0.4) +
                                      upright.box("block", 0, 0.4, 0.8, 0.7, fmt::format("density = {}", density))),
                         "block", 0.3),
                  1e-3)
            << density;
    }
}

TEST(PressedPockets, CarryTwoBlocksOneAboveTheOther) {
    const Turned upright;
    const std::string text = upright.tank(upright.water(0, 0, 0.8, 0.4) + upright.water(0, 0.6, 0.8, 0.9) +
                                          upright.box("lower", 0, 0.4, 0.8, 0.6, "density = 1500") +
                                          upright.box("upper", 0, 0.9, 0.8, 1.1, "density = 2000"));
    EXPECT_LT(way_of(text, "lower", 0.2), 1e-3);
    EXPECT_LT(way_of(text, "upper", 0.2), 1e-3);
}

TEST(PressedPockets, HoldABlockBetweenTwoPocketsOfAClosedTank) {
    const Turned upright;
    EXPECT_LT(way_of(upright.tank(upright.water(0, 0, 0.8, 0.4) + upright.water(0, 0.7, 0.8, 1) +
                                  upright.box("block", 0, 0.4, 0.8, 0.7, "density = 1500") +
                                  upright.box("lid", 0, 1, 0.8, 1.2, "fixed = true")),
                     "block", 0.2),
              1e-3);
}

// Two pistons a fixed way apart drive water, a block and water through a level tube: the block goes as far as they do.
TEST(PressedPockets, TakeABlockAlongBetweenTwoPistons) {
    const std::string text = R"(
dimension = 2
gravity = [0.0, -9.81]
end = 10
[material.rock]
density = 2500
normal_stiffness = 1e7
friction_coefficient = 0
damping_ratio = 0.2
[fluid]
method = 'grid'
spacing = 0.04
domain = { low = [-0.4, -0.36], high = [2.6, 0.92] }
[[fluid.region]]
box = { low = [0.2, 0], high = [0.8, 0.4] }
[[fluid.region]]
box = { low = [1.2, 0], high = [1.8, 0.4] }
)" + Turned{}.box("floor", -0.4, -0.2, 2.6, 0, "fixed = true") +
                             Turned{}.box("roof", -0.4, 0.4, 2.6, 0.6, "fixed = true") +
                             Turned{}.box("block", 0.8, 0, 1.2, 0.4, "") +
                             Turned{}.box("near", 0, 0, 0.2, 0.4, "motion = { linear = { velocity = [0.3, 0] } }") +
                             Turned{}.box("far", 1.8, 0, 2, 0.4, "motion = { linear = { velocity = [0.3, 0] } }");
    Simulation simulation = simulate(text);
    ASSERT_EQ(run_to(simulation, 0.3), "");
    EXPECT_NEAR(place_of(simulation, "block").x - 1, 0.3 * simulation.state().time, 1e-3);
}

TEST(PressedPockets, HoldABlockThatIsDrawnOutOfThem) {
    const Turned upright;
    for (const double share : {1.5, 4.0}) {  // of its weight
        const std::string load =
            fmt::format("density = 1500\n[[body.load]]\nforce = [0, {}]", share * 1500 * 0.24 * gravity);
        EXPECT_LT(way_of(upright.tank(upright.water(0, 0, 0.8, 0.4) + upright.box("block", 0, 0.4, 0.8, 0.7, load)),
                         "block", 0.2),
                  1e-3)
            << share;
    }
}

/// Mean pressure of 0.4 m of water under a block of 1500 kg/m^3 times 0.3 m [Pa].
constexpr double mean_pressure = gravity * (1500 * 0.3 + 1000 * 0.2);

double sinking(double step, double time) {
    const Turned upright;
    return way_of(
        fmt::format("time_step = {}\n", step) +
            upright.tank(upright.water(0, 0, 0.8, 0.4) + upright.box("block", 0, 0.4, 0.8, 0.7, "density = 1500")),
        "block", time);
}

TEST(PressedPockets, GiveWayByTheirPressureOverTheBulkModulusOfWaterInShortSteps) {
    EXPECT_NEAR(sinking(5e-4, 0.05), mean_pressure * 0.4 / (1000 * 1480.0 * 1480), 3e-7);
}

// A piston draws a full pocket apart in which a free block lies: the block could follow, and the pocket may become
// hollow by 0.0015 of its 0.4 m.
TEST(PressedPockets, EndTheRunWhereTheyBecomeHollow) {
    const Turned upright;
    Simulation simulation = simulate(
        upright.tank(upright.water(0, 0, 0.8, 0.4) + upright.box("block", 0.3, 0, 0.5, 0.16, "") +
                     upright.box("piston", 0, 0.4, 0.8, 0.6, "motion = { linear = { velocity = [0, 0.03] } }")));
    EXPECT_THAT(run_to(simulation, 0.1), HasSubstr("'piston' draws apart the pocket"));
    EXPECT_NEAR(simulation.state().time, 0.0015 * 0.4 / 0.03, 0.006);
}

// Water that has just begun to hold a block which 30 times its weight draws out of it makes energy in steps of the
// default length; the remedy that the message names makes the run pass.
TEST(PressedPockets, MakeNoEnergyInStepsAsShortAsTheMessageSays) {
    const Turned upright;
    const std::string text =
        upright.tank(upright.water(0, 0, 0.8, 0.4) +
                     upright.box("block", 0, 0.4, 0.8, 0.7, "density = 1500\n[[body.load]]\nforce = [0, 117e3]"));
    Simulation simulation = simulate(text);
    std::string problem, remedy;
    while (simulation.state().time < 0.05 && problem.empty()) {
        const StepOutcome outcome = simulation.step(sim::Measure::energy);
        if (outcome.kind == StepOutcome::Kind::refused) {
            problem = outcome.why.text;
            remedy = outcome.why.remedy;
        }
    }
    ASSERT_THAT(problem, HasSubstr("the numerics made"));
    ASSERT_EQ(remedy, "fluid.courant = 0.22");
    const std::string key = "spacing = 0.04\n";
    std::string mended = text;
    mended.insert(mended.find(key) + key.size(), "courant = 0.22\n");
    Simulation again = simulate(mended);
    EXPECT_EQ(run_to(again, 0.05), "");
}

TEST(GridSteps, StartAtAFiftiethOfWhatGravityAllowsAndGrowByATwentiethOfTheTime) {
    const Turned upright;
    Simulation simulation = simulate(upright.tank(upright.water(0, 0, 0.8, 0.4)));
    const double first = 0.02 * std::sqrt(0.45 * 0.04 / gravity);
    ASSERT_NE(simulation.step(sim::Measure::flow).kind, StepOutcome::Kind::refused);
    EXPECT_NEAR(simulation.state().time, first, 0.1 * first);
    ASSERT_EQ(run_to(simulation, 0.1), "");
    const double before = simulation.state().time;
    ASSERT_NE(simulation.step(sim::Measure::flow).kind, StepOutcome::Kind::refused);
    EXPECT_NEAR(simulation.state().time - before, first + 0.05 * before, 0.1 * (first + 0.05 * before));
}

}  // namespace
}  // namespace riprap::run
