// SPDX-License-Identifier: Apache-2.0
// Bodies that meet edge on edge, in gaps narrower than they are, or that are put behind each other by a table: they are
// held, thrown back, or the run ends with the pair named. None is ever on the other side at the end.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "riprap/core/quat.hpp"
#include "riprap/run/simulate/simulation.hpp"
#include "riprap/scene/read_case.hpp"

namespace riprap::run {
namespace {

using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

struct End {
    std::string reason;  ///< of the refusal; empty where the end was reached
    sim::State state;
};

End end_of(const std::string& text) {
    Simulation simulation(scene::read_case_text(text, "case.toml", "."));
    while (simulation.steps_left() > 0) {
        const StepOutcome outcome = simulation.step(sim::Measure::flow);
        if (outcome.kind == StepOutcome::Kind::refused) {
            return {outcome.why.text, simulation.state()};
        }
    }
    return {"", simulation.state()};
}

constexpr double degree = M_PI / 180;

/// A scene without weight, turned as a whole, with all lengths and times times `size`.
struct Scene {
    std::string contact;
    Quat turn{};
    double size{1};
    std::string text{};

    std::string vector(const Vec3& v) const {
        const Vec3 turned = rotate(turn, v);
        return fmt::format("[{:.17g}, {:.17g}, {:.17g}]", turned.x, turned.y, turned.z);
    }
    Scene& body(const std::string& name, const std::string& shape, const Vec3& place, const Quat& own,
                const std::string& more) {
        const Quat q = turn * own;
        text += fmt::format(
            "[[body]]\nname = '{}'\nmaterial = 'rock'\nshape = {{ {} }}\nposition = {}\n{}\n"
            "orientation = {{ quaternion = [{:.17g}, {:.17g}, {:.17g}, {:.17g}] }}\n",
            name, shape, vector(size * place), more, q.w, q.x, q.y, q.z);
        return *this;
    }
    std::string box(const Vec3& sides) const {
        return fmt::format("box = [{}, {}, {}]", size * sides.x, size * sides.y, size * sides.z);
    }
    std::string velocity(const Vec3& v) const { return "velocity = " + vector(v); }
    End run(double end, const std::string& stiffness = "2e7") const {
        return end_of(
            fmt::format("gravity = [0, 0, 0]\nend = {}\n[solid]\nmethod = 'distance_potential_dem'\ncontact = "
                        "'{}'\n[material.rock]\ndensity = 2500\nfriction_coefficient = 0.3\ndamping_ratio = "
                        "0.1\nnormal_stiffness = {}\n",
                        size * end, contact, stiffness) +
            text);
    }
    /// Height of the second body over the first, as the scene was before it was turned, over `size`.
    double height(const End& end) const {
        return rotate(conjugate(turn), end.state.bodies.position[1] - end.state.bodies.position[0]).z / size;
    }
};

const Quat upright{};
Quat about(const Vec3& axis, double degrees) { return from_rotation_vector(degrees * degree * normalized(axis)); }

/// Two bars 50 mm thick whose edges cross at an angle; the upper one falls on the lower one.
Scene crossing_bars(const std::string& contact, double angle, double speed, const Quat& turn = {}, double size = 1) {
    Scene scene{contact, turn, size};
    scene.body("lower", scene.box({0.4, 0.05, 0.05}), {}, about({1, 0, 0}, 45), "fixed = true");
    scene.body("upper", scene.box({0.4, 0.05, 0.05}), {0.013, 0.007, 0.08},
               about({0, 0, 1}, angle) * about({1, 0, 0}, 45), scene.velocity({0, 0, -speed}));
    return scene;
}

TEST(BodiesThroughBodies, BarsThatCrossEdgeOnEdgeAreThrownBackAcrossACommonPlane) {
    for (const std::string contact : {"common_plane_soft", "common_plane_penalty"}) {
        for (const double angle : {30.0, 60.0, 90.0}) {
            const Scene scene = crossing_bars(contact, angle, 3);
            const End end = scene.run(0.025);
            EXPECT_THAT(end.reason, IsEmpty()) << contact << ' ' << angle;
            EXPECT_GT(scene.height(end), 0.06) << contact << ' ' << angle;
        }
    }
}

TEST(BodiesThroughBodies, SoAreSmallAndLargeBarsInAnyPosture) {
    for (const double size : {1e-3, 1e3}) {
        const Scene scene = crossing_bars("common_plane_soft", 90, 3, about({0.3, 1, 0.2}, 37), size);
        const End end = scene.run(0.025);
        EXPECT_THAT(end.reason, IsEmpty()) << size;
        EXPECT_GT(scene.height(end), 0.06) << size;
    }
}

TEST(BodiesThroughBodies, BarsTooFastForTheirEdgesEndTheRun) {
    for (const std::string contact : {"common_plane_soft", "common_plane_penalty", "distance_potential"}) {
        const End end = crossing_bars(contact, 90, 30, about({0, 1, 0}, 37)).run(0.01);
        EXPECT_THAT(end.reason, AllOf(HasSubstr("lower"), HasSubstr("upper"))) << contact;
    }
}

TEST(BodiesThroughBodies, ATipOfATetrahedronOnAnEdgeIsThrownBackOrEndsTheRun) {
    for (const std::string contact : {"common_plane_soft", "common_plane_penalty", "distance_potential"}) {
        for (const double speed : {1.0, 30.0}) {
            Scene scene{contact, about({1, 2, 0}, 37)};
            scene.body("bar", scene.box({0.4, 0.05, 0.05}), {}, about({1, 0, 0}, 45), "fixed = true");
            // Its lowest corner is the tip.
            scene.body("tip",
                       "hull = { points = [[0.1, 0, 0.1], [-0.05, 0.08, 0.1], [-0.05, -0.08, 0.1], [0, 0, -0.1]] }",
                       {0.02, 0.001, 0.15}, upright, scene.velocity({0, 0, -speed}));
            const End end = scene.run(0.15 / speed);
            EXPECT_TRUE(!end.reason.empty() || scene.height(end) > 0.05) << contact << ' ' << speed << end.reason;
        }
    }
}

TEST(BodiesThroughBodies, AThinPlateThatFallsEdgewiseOnAFaceIsThrownBackOrEndsTheRun) {
    for (const std::string contact : {"common_plane_soft", "common_plane_penalty", "distance_potential"}) {
        Scene scene{contact, about({1, 0, 1}, 37)};
        scene.body("floor", scene.box({0.5, 0.5, 0.02}), {}, upright, "fixed = true");
        scene.body("plate", scene.box({0.2, 0.01, 0.2}), {0.01, 0.02, 0.2}, about({0, 1, 0}, 45),
                   scene.velocity({0, 0, -5}));
        const End end = scene.run(0.06);
        EXPECT_TRUE(!end.reason.empty() || scene.height(end) > 0.1) << contact << scene.height(end) << end.reason;
    }
}

/// A box of width 1 over a gap of `width` between the faces of two blocks 2 deep.
Scene box_over_gap(const std::string& contact, double width, double speed, const Quat& turn = {}, double size = 1) {
    Scene scene{contact, turn, size};
    scene.body("left", scene.box({1, 2, 2}), {-0.5 - 0.5 * width, 0, -1}, upright, "fixed = true");
    scene.body("box", scene.box({1, 1.2, 1}), {0, 0, 0.55}, upright, scene.velocity({0, 0, -speed}));
    scene.body("right", scene.box({1, 2, 2}), {0.5 + 0.5 * width, 0, -1}, upright, "fixed = true");
    return scene;
}

TEST(BodiesThroughBodies, ABoxThatIsSqueezedIntoAGapNarrowerThanItselfEndsTheRunOrIsThrownBack) {
    for (const std::string contact : {"distance_potential", "common_plane_soft", "common_plane_penalty"}) {
        for (const double width : {0.83, 0.9}) {
            for (const double speed : {20.0, 40.0, 200.0}) {
                const Scene scene = box_over_gap(contact, width, speed, about({1, 1, 0}, 37));
                const End end = scene.run(6 / speed);
                EXPECT_TRUE(!end.reason.empty() || scene.height(end) > 1) << contact << ' ' << width << ' ' << speed;
                EXPECT_THAT(end.reason, AnyOf(IsEmpty(), HasSubstr("box")));
            }
        }
    }
}

TEST(BodiesThroughBodies, ASlowBoxStaysOverTheGapAndOneThatFitsGoesThrough) {
    const Scene slow = box_over_gap("distance_potential", 0.9, 2, {}, 1e-3);
    const End held = slow.run(0.3);
    EXPECT_THAT(held.reason, IsEmpty());
    EXPECT_GT(slow.height(held), 1.4);  // thrown back
    const Scene wide = box_over_gap("distance_potential", 1.02, 100);
    const End through = wide.run(0.03);
    EXPECT_THAT(through.reason, IsEmpty());
    EXPECT_LT(wide.height(through), -1);
}

TEST(BodiesThroughBodies, AGapThatSqueezesABoxByThreePercentOfItsRadiusCountsAndByOneAndAHalfDoesNot) {
    const Scene tight = box_over_gap("distance_potential", 0.97, 40),
                loose = box_over_gap("distance_potential", 0.985, 40);
    EXPECT_THAT(tight.run(0.1).reason, HasSubstr("squeezed through between left and right"));
    const End through = loose.run(0.1);
    EXPECT_THAT(through.reason, IsEmpty());
    EXPECT_LT(loose.height(through), -1);
}

std::string planar(const std::string& more) {
    return "dimension = 2\ngravity = [0, -9.81]\n[material.rock]\ndensity = 2500\nfriction_coefficient = 0\n"
           "damping_ratio = 0.1\nnormal_stiffness = 2e7\n" +
           more;
}
/// As soft at corners as the potential is: what is squeezed goes on against its first push.
const std::string by_field = "[solid]\ncorners = 'field'\n";
std::string polygon(const std::string& name, const std::string& shape, const std::string& more) {
    return "[[body]]\nname = '" + name + "'\nmaterial = 'rock'\nshape = { " + shape + " }\n" + more + "\n";
}

TEST(BodiesThroughBodies, ABoxBetweenTwoWedgesInThePlaneEndsTheRunInTheGap) {
    const End end =
        end_of("end = 0.03\n" +
               planar(by_field + polygon("l", "polygon = [[-0.05, 0.5], [-0.6, 0.5], [-0.05, -0.1]]", "fixed = true") +
                      polygon("r", "polygon = [[0.05, 0.5], [0.05, -0.1], [0.6, 0.5]]", "fixed = true") +
                      polygon("b", "box = [0.12, 0.12]", "position = [0, 0.7]\nvelocity = [0, -20]")));
    EXPECT_THAT(end.reason, AllOf(HasSubstr("l and b"), HasSubstr("gone"), HasSubstr("against the push")));
    EXPECT_GT(end.state.bodies.position[2].y, 0.45);
}

/// A disc of 0.1 m, or another body as wide, falls onto a slot between two boxes.
std::string round_over_slot(const std::string& shape, double width, double speed, double end) {
    const double x = 0.2 + 0.1 * width;
    return fmt::format("end = {}\n", end) +
           planar(polygon("l", "box = [0.4, 0.3]", fmt::format("position = [{}, 0]\nfixed = true", -x)) +
                  polygon("r", "box = [0.4, 0.3]", fmt::format("position = [{}, 0]\nfixed = true", x)) +
                  polygon("b", shape, fmt::format("position = [0, 0.3]\nvelocity = [0, {}]", -speed)));
}

TEST(BodiesThroughBodies, ADiscThatIsSqueezedThroughASlotEndsTheRunInItsMouth) {
    for (const std::string shape :
         {"sphere = 0.1", "ellipse = [0.1, 0.16]", "prism = { sides = 24, circumradius = 0.1 }"}) {
        for (const double width : {0.85, 0.9, 0.94}) {
            for (const double speed : {8.0, 20.0}) {
                const End end = end_of(round_over_slot(shape, width, speed, 1.2 / speed));
                const double height = end.state.bodies.position[2].y;
                EXPECT_TRUE(!end.reason.empty() || height > 0.3) << shape << width << speed;  // else thrown back
                EXPECT_GT(height, 0.05) << shape << ' ' << width << ' ' << speed;
            }
        }
        const double speed = shape == "sphere = 0.1" ? 11 : 8;  // a disc's own contact throws it back at 8
        EXPECT_THAT(
            end_of(round_over_slot(shape, 0.9, speed, 1.2 / speed)).reason,
            AllOf(HasSubstr("b is squeezed through between l and r"), HasSubstr("no gap narrower than itself")));
        // One that fits goes through, and a slow one stays in the mouth.
        const End through = end_of(round_over_slot(shape, 1.01, 8, 0.15));
        EXPECT_THAT(through.reason, IsEmpty()) << shape;
        EXPECT_LT(through.state.bodies.position[2].y, -0.3) << shape;
        const End held = end_of(round_over_slot(shape, 0.8, 0.5, 0.5));
        EXPECT_THAT(held.reason, IsEmpty()) << shape;
        EXPECT_GT(held.state.bodies.position[2].y, 0.15) << shape;
    }
}

TEST(BodiesThroughBodies, ARunThatStopsInTheGapAndGoesOnEndsAsTheWholeOne) {
    const std::string text =
        "end = 0.03\n" +
        planar(by_field + polygon("l", "polygon = [[-0.05, 0.5], [-0.6, 0.5], [-0.05, -0.1]]", "fixed = true") +
               polygon("r", "polygon = [[0.05, 0.5], [0.05, -0.1], [0.6, 0.5]]", "fixed = true") +
               polygon("b", "box = [0.12, 0.12]", "position = [0, 0.7]\nvelocity = [0, -20]"));
    Simulation whole(scene::read_case_text(text, "case.toml", "."));
    while (whole.state().bodies.position[2].y > 0.53) {  // its lower face is in the gap
        ASSERT_TRUE(whole.step(sim::Measure::flow).is_accepted());
    }
    RunRecord record;
    whole.note(record);
    Simulation resumed(scene::read_case_text(text, "case.toml", "."));
    resumed.restore(whole.state(), record);
    StepOutcome first, second;
    do {
        first = whole.step(sim::Measure::flow);
        second = resumed.step(sim::Measure::flow);
        ASSERT_EQ(first.why.text, second.why.text);
    } while (first.kind != StepOutcome::Kind::refused);
    EXPECT_THAT(first.why.text, HasSubstr("against the push"));
    EXPECT_EQ(whole.state().bodies, resumed.state().bodies);
}

const std::string twelve_sides = [] {
    std::string corners;
    for (int k = 0; k < 12; ++k) {
        const double angle = (k + 0.5) * M_PI / 6;
        corners += fmt::format("{}[{}, {}]", k > 0 ? ", " : "", 0.3 * std::cos(angle), 0.3 * std::sin(angle));
    }
    return "polygon = [" + corners + "]";
}();

TEST(BodiesThroughBodies, ABlockThatRollsOverAnEdgeOrLiesDeepOnItsFloorIsLeftAlone) {
    // Soft: the twelve-sided roller lies 3 % of its radius deep in the table, and goes over its edge and down beside
    // it.
    const End roller =
        end_of("end = 1.4\n" + planar("").replace(planar("").find("2e7"), 3, "3e5") +
               polygon("table", "box = [2, 1]", "position = [-1, -0.5]\nfixed = true") +
               polygon("roller", twelve_sides, "position = [-0.3, 0.29]\nvelocity = [1, 0]\nangular_velocity = -3.4"));
    EXPECT_THAT(roller.reason, IsEmpty());
    EXPECT_LT(roller.state.bodies.position[1].y, -0.5);
}

TEST(BodiesThroughBodies, ABlockThatItsWeightPressesDeepIntoItsFloorSlidesOverASeam) {
    for (const std::string method : {"distance_potential_dem", "sphere_dem"}) {
        const std::string solid = "[solid]\nmethod = '" + method + "'\n";
        const End end = end_of("end = 0.6\n" + planar("").replace(planar("").find("2e7"), 3, "2e5") + solid +
                               polygon("left", "box = [4, 1]", "position = [-2, -0.5]\nfixed = true") +
                               polygon("right", "box = [4, 1]", "position = [2, -0.5]\nfixed = true") +
                               polygon("block", "box = [0.6, 0.4]", "position = [-0.7, 0.19]\nvelocity = [2, 0]"));
        EXPECT_THAT(end.reason, IsEmpty()) << method;
        EXPECT_GT(end.state.bodies.position[2].x, 0.4) << method;
    }
}

TEST(BodiesThroughBodies, AnyMethodSeesAPlateThatATablePutsBehindABlock) {
    struct Method {
        std::string word, more;
    };
    for (const Method& method :
         {Method{"distance_potential_dem", ""}, Method{"distance_potential_dem", "contact = 'common_plane_soft'\n"},
          Method{"explicit_dda", "youngs_modulus = 1e7\n"}, Method{"implicit_dda", "youngs_modulus = 1e7\n"},
          Method{"sphere_dem", "youngs_modulus = 1e7\n"}}) {
        for (const std::string fixed_step : {"", "time_step = 1e-4\nforce_time_step = true\n"}) {
            const End end =
                end_of("gravity = [0, 0, 0]\nend = 0.02\n" + fixed_step + "[solid]\nmethod = '" + method.word + "'\n" +
                       method.more +
                       "[material.rock]\ndensity = 2500\nnormal_stiffness = 1e7\nfriction_coefficient = 0.1\n"
                       "[[body]]\nname = 'block'\nmaterial = 'rock'\nshape = { cube = 0.1 }\nposition = [0.3, 0, 0.2]\n"
                       "[[body]]\nname = 'plate'\nmaterial = 'rock'\nshape = { box = [1, 1, 0.02] }\n"
                       "motion = { table = { time = [0, 0.01, 0.010001, 1], displacement = [[0, 0, 0], [0, 0, 0], "
                       "[0, 0, 0.5], [0, 0, 0.5]] } }\n");
            EXPECT_THAT(end.reason, AllOf(HasSubstr("block"), HasSubstr("plate")))
                << method.word << method.more << fixed_step;
        }
    }
}

TEST(BodiesThroughBodies, ATableThatJumpsWhereNothingIsRunsOn) {
    const End end = end_of(
        "gravity = [0, 0, 0]\nend = 0.02\n[material.rock]\ndensity = 2500\nnormal_stiffness = 1e7\n"
        "[[body]]\nname = 'block'\nmaterial = 'rock'\nshape = { cube = 0.1 }\nposition = [0.8, 0, 0.2]\n"
        "[[body]]\nname = 'plate'\nmaterial = 'rock'\nshape = { box = [1, 1, 0.02] }\n"
        "motion = { table = { time = [0, 0.01, 0.010001, 1], displacement = [[0, 0, 0], [0, 0, 0], [0, 0, 0.5], "
        "[0, 0, 0.5]] } }\n");
    EXPECT_THAT(end.reason, IsEmpty());
}

}  // namespace
}  // namespace riprap::run
