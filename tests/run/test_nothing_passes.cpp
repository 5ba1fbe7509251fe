// SPDX-License-Identifier: Apache-2.0
// Scenes in which something passed through something else, or energy came from nowhere, and the run ended well.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "riprap/run/check/check_case.hpp"
#include "riprap/run/simulate/simulation.hpp"
#include "riprap/scene/read_case.hpp"

namespace riprap::run {
namespace {

using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

struct End {
    std::string reason;  ///< of the refusal; empty where the end was reached
    double time;         ///< [s]
    std::int64_t retries;
    std::string remedy{};
};

End end_of(const std::string& text) {
    Simulation simulation(scene::read_case_text(text, "case.toml", "."));
    while (simulation.steps_left() > 0) {
        const StepOutcome outcome = simulation.step(sim::Measure::flow);
        if (outcome.kind == StepOutcome::Kind::refused) {
            return {outcome.why.text, simulation.state().time, simulation.summary().retries, outcome.why.remedy};
        }
    }
    return {"", simulation.state().time, simulation.summary().retries};
}

std::string rock(const std::string& stiffness, const std::string& more = {}) {
    return "[material.rock]\ndensity = 2500\nfriction_coefficient = 0.5\nnormal_stiffness = " + stiffness + "\n" + more;
}
std::string body(const std::string& name, const std::string& shape, const std::string& more) {
    return "[[body]]\nname = '" + name + "'\nmaterial = 'rock'\nshape = { " + shape + " }\n" + more + "\n";
}
const std::string gravity = "gravity = [0, 0, -9.81]\n";
const std::string floor_of_rock = body("ground", "half_space = { normal = [0, 0, 1] }", "fixed = true");

TEST(NothingPasses, ThroughAPlateThatIsTooSoft) {
    const std::string text = gravity + "end = 0.4\n" + rock("1e5") +
                             body("plate", "box = [1, 1, 0.02]", "fixed = true") +
                             body("cube", "cube = 0.1", "position = [0, 0, 0.3]\nvelocity = [0, 0, -3]");
    const End end = end_of(text);
    EXPECT_THAT(end.reason, AllOf(HasSubstr("cube"), HasSubstr("plate")));
    EXPECT_LT(end.time, 0.12);  // it was through at 0.11 s
    const scene::LoadedCase loaded = scene::read_case_text(text, "case.toml", ".");
    EXPECT_THAT(loaded.warnings, Contains(AllOf(HasSubstr("'cube'"), HasSubstr("'plate'"), HasSubstr("holds about"))));
    EXPECT_THAT(check_case(loaded).refusal, AllOf(HasSubstr("'cube'"), HasSubstr("normal_stiffness")));
}

TEST(NothingPasses, ThroughAFloorThatCannotCarryItsWeight) {
    const End end = end_of(gravity + "end = 1\n" + rock("1000") + floor_of_rock +
                           body("block", "cube = 1", "position = [0, 0, 0.5]"));
    EXPECT_THAT(end.reason, AllOf(HasSubstr("block"), HasSubstr("ground")));
}

TEST(NothingPasses, AsSpheresAreTooSoft) {
    const auto end = [](const std::string& law) {
        return end_of(gravity + "end = 1\n" + rock("1e7") + "[solid]\nmethod = 'sphere_dem'\n" + law + floor_of_rock +
                      body("ball", "sphere = 0.1", "position = [0, 0, 0.5]"));
    };
    const End hertz = end("youngs_modulus = 1e3\n"), springs = end("normal_law = 'linear'\nspring_stiffness = 100\n");
    EXPECT_THAT(hertz.reason, AllOf(HasSubstr("ball"), HasSubstr("ground"), HasSubstr("overlap")));
    EXPECT_THAT(hertz.remedy, HasSubstr("solid.youngs_modulus = "));
    EXPECT_THAT(springs.remedy, HasSubstr("solid.spring_stiffness = "));
}

TEST(NothingPasses, AsItIsTooFastForTheStep) {
    const End end = end_of(gravity + "end = 0.05\n" + rock("1e7") + floor_of_rock +
                           body("block", "cube = 1", "position = [0, 0, 3]\nvelocity = [0, 0, -2000]"));
    EXPECT_THAT(end.reason, AllOf(HasSubstr("block"), HasSubstr("ground")));
    EXPECT_LT(end.time, 0.002);
}

TEST(NothingPasses, UnseenWithinAStepThatTheCaseFixes) {
    // 60 mm a step against a plate 20 mm thick: there was never a contact.
    const End end = end_of("gravity = [0, 0, 0]\nend = 0.02\ntime_step = 2e-4\n" + rock("1e5") +
                           body("plate", "box = [1, 1, 0.02]", "fixed = true") +
                           body("cube", "cube = 0.1", "position = [0, 0, 1.0]\nvelocity = [0, 0, -300]"));
    EXPECT_THAT(end.reason, AllOf(HasSubstr("cube"), HasSubstr("time_step")));
}

TEST(NothingPasses, BetweenALidThatIsDrivenAndAFloor) {
    const End end = end_of(gravity + "end = 0.15\n" + rock("1e7") + floor_of_rock +
                           body("block", "cube = 1", "position = [0, 0, 0.5]") +
                           body("lid", "half_space = { normal = [0, 0, -1] }",
                                "position = [0, 0, 1.05]\nmotion = { linear = { velocity = [0, 0, -10] } }"));
    EXPECT_THAT(end.reason, HasSubstr("block"));
    EXPECT_LT(end.time, 0.1);
}

// Methods other than the distance potential: each bullet comes to a plate that cannot hold it.
const std::string bullet = body("plate", "box = [1, 1, 0.02]", "fixed = true") +
                           body("cube", "cube = 0.1", "position = [0, 0, 0.2]\nvelocity = [0, 0, -30]");
std::string solids(const std::string& method, const std::string& more) {
    return "gravity = [0, 0, 0]\nend = 0.02\n[solid]\nmethod = '" + method + "'\n" + more + "\n" + rock("1e7");
}

TEST(NothingPasses, InExplicitDda) {
    const End end = end_of(solids("explicit_dda", "contact_stiffness = 1000.0\nyoungs_modulus = 1e7") + bullet);
    EXPECT_THAT(end.reason, AllOf(HasSubstr("cube"), HasSubstr("plate")));
    EXPECT_LT(end.time, 0.0055);
}

TEST(NothingPasses, InImplicitDda) {
    const End end = end_of(solids("implicit_dda", "contact_stiffness = 1000.0\nyoungs_modulus = 1e7") + bullet);
    EXPECT_THAT(end.reason, AllOf(HasSubstr("cube"), HasSubstr("plate")));
    EXPECT_LT(end.time, 0.0055);
}

TEST(NothingPasses, InPlanarDda) {
    const std::string plane =
        "dimension = 2\ngravity = [0, 0]\nend = 0.02\n[solid]\nmethod = 'planar_dda'\n"
        "contact_stiffness = 1000.0\nyoungs_modulus = 1e7\n";
    const End end = end_of(plane + rock("1e7") + body("plate", "box = [1, 0.02]", "fixed = true") +
                           body("cube", "box = [0.1, 0.1]", "position = [0, 0.2]\nvelocity = [0, -30]"));
    EXPECT_THAT(end.reason, AllOf(HasSubstr("cube"), HasSubstr("plate")));
    EXPECT_LT(end.time, 0.0075);
}

TEST(NothingPasses, OfBodiesThatMeetBySpheres) {
    const End end = end_of(solids("sphere_dem", "youngs_modulus = 1e4") + bullet);
    EXPECT_THAT(end.reason, AllOf(HasSubstr("cube"), HasSubstr("plate")));
    EXPECT_LT(end.time, 0.0055);
}

TEST(NothingPasses, AsWaterThatALidPressesThroughTheWalls) {
    const std::string wall = "fixed = true";
    const End end = end_of("dimension = 2\ngravity = [0, -9.81]\nend = 0.5\n" + rock("1e7") +
                           "[fluid]\nspacing = 0.05\ndomain = { low = [-0.5, -0.5], high = [4, 2] }\n"
                           "[[fluid.region]]\nbox = { low = [0, 0], high = [1, 0.5] }\n" +
                           body("ground", "half_space = { normal = [0, 1] }", wall) +
                           body("left", "half_space = { normal = [1, 0] }", wall) +
                           body("right", "half_space = { normal = [-1, 0] }", wall + "\nposition = [1, 0]") +
                           body("lid", "half_space = { normal = [0, -1] }",
                                "position = [0, 0.55]\nmotion = { linear = { velocity = [0, -1] } }"));
    EXPECT_THAT(end.reason, HasSubstr("water"));
    EXPECT_LT(end.time, 0.45);
}

/// A planar tank of water between walls so thick, and a lid that presses it out.
std::string press(const std::string& method, double thickness, const std::string& treatment = "boundary_particles") {
    const std::string wall = "fixed = true";
    return "dimension = 2\ngravity = [0, -9.81]\nend = 0.45\n" + rock("1e7") + "[fluid]\nmethod = '" + method +
           "'\nwall = '" + treatment +
           "'\nspacing = 0.05\ndomain = { low = [-3, -3], high = [4, 14] }\n"
           "[[fluid.region]]\nbox = { low = [0, 0], high = [1, 0.5] }\n" +
           body("bottom", fmt::format("box = [1.4, {}]", thickness),
                wall + fmt::format("\nposition = [0.5, {}]", -thickness / 2)) +
           body("left", fmt::format("box = [{}, 2]", thickness),
                wall + fmt::format("\nposition = [{}, 1]", -thickness / 2)) +
           body("right", fmt::format("box = [{}, 2]", thickness),
                wall + fmt::format("\nposition = [{}, 1]", 1 + thickness / 2)) +
           body("lid", fmt::format("box = [1, {}]", thickness),
                fmt::format("position = [0.5, {}]\nmotion = {{ linear = {{ velocity = [0, -1] }} }}",
                            0.55 + thickness / 2));
}

TEST(NothingPasses, AsWaterThatALidPressesThroughWallsTooThinToBeFoundIn) {
    for (const std::string method : {"sph", "wcmps", "mps"}) {
        for (const double thickness : {0.1, 0.02}) {
            const End end = end_of(press(method, thickness));
            // Whichever is seen first: the water that went through, or the room that the lid leaves to the rest.
            EXPECT_THAT(end.reason, AnyOf(HasSubstr("have gone through walls"), HasSubstr("closed pocket")))
                << method << ' ' << thickness;
            EXPECT_LT(end.time, 0.4) << method << ' ' << thickness;
        }
    }
}

TEST(NothingPasses, AsWaterThatALidPressesAlongTheSeamsOfWallsThatPush) {
    // In by one wall and out by another: one in ten was outside, none was counted, and the run ended with 0.
    for (const std::string method : {"sph", "wcmps"}) {
        const End end = end_of(press(method, 0.06, "penalty"));
        EXPECT_THAT(end.reason, AnyOf(HasSubstr("have gone through walls"), HasSubstr("closed pocket"))) << method;
        EXPECT_LT(end.time, 0.25) << method;
    }
}

TEST(NothingPasses, ACubeAtAHundredMetresASecondIsComputedOrRefused) {
    const auto fall = [](const std::string& stiffness) {
        return gravity + "end = 0.02\n" + rock(stiffness) + floor_of_rock +
               body("block", "cube = 1", "position = [0, 0, 1]\nvelocity = [0, 0, -100]");
    };
    EXPECT_THAT(end_of(fall("1e9")).reason, IsEmpty());
    EXPECT_THAT(check_case(scene::read_case_text(fall("1e9"), "case.toml", ".")).refusal, IsEmpty());
    EXPECT_THAT(end_of(fall("1e7")).reason, AllOf(HasSubstr("block"), HasSubstr("ground")));
    EXPECT_THAT(check_case(scene::read_case_text(fall("1e7"), "case.toml", ".")).refusal, HasSubstr("'block'"));
}

TEST(NothingPasses, CheckRefusesNoImpactThatComesAfterTheEndOrThatWaterMaySoften) {
    const std::string soft = rock("1e5"), plate = body("plate", "box = [1, 1, 0.02]", "fixed = true");
    const auto refusal = [&](const std::string& end, const std::string& more) {
        const std::string text = "gravity = [0, 0, 0]\nend = " + end + "\n" + soft + plate +
                                 body("cube", "cube = 0.1", "position = [0, 0, 1]\nvelocity = [0, 0, -30]") + more;
        return check_case(scene::read_case_text(text, "case.toml", ".")).refusal;
    };
    EXPECT_THAT(refusal("0.1", ""), HasSubstr("'cube'"));
    EXPECT_THAT(refusal("0.02", ""), IsEmpty());  // it would be there at 0.031 s
    EXPECT_THAT(refusal("0.1",
                        "[fluid]\nspacing = 0.05\ndomain = { low = [-1, -1, -1], high = [1, 1, 2] }\n"
                        "[[fluid.region]]\nbox = { low = [-0.2, -0.2, 0.1], high = [0.2, 0.2, 0.4] }\n"),
                IsEmpty());
}

TEST(LedgerVerdict, JudgesTheFirstStepsToo) {
    // Seven steps, thirty times too long: 13 MJ from nowhere, and the run ended with 0.
    const End end = end_of(gravity + "end = 1\ntime_step = 0.147\nforce_time_step = true\n" + rock("1e7") +
                           floor_of_rock + body("block", "cube = 1", "position = [0, 0, 0.6]"));
    EXPECT_THAT(end.reason, HasSubstr("block"));
}

TEST(LedgerVerdict, JudgesTheFirstStepsOfMethodsThatBookOverSeveralStepsByAllThatThereIs) {
    // Ten steps, far too long for spheres: 29 kJ from nowhere, of 27 kJ, and the run ended with 0.
    const End end = end_of(gravity +
                           "end = 0.5\ntime_step = 0.05\nforce_time_step = true\n[solid]\nmethod = 'sphere_dem'\n"
                           "youngs_modulus = 1e7\n" +
                           rock("1e7") + floor_of_rock + body("block", "cube = 1", "position = [0, 0, 0.6]"));
    EXPECT_THAT(end.reason, HasSubstr("ledger"));
}

TEST(LedgerVerdict, LeavesAPaddleAloneThatTouchesStillWaterWithoutGravity) {
    // At the first touch 1e-13 J are turned over, and half of it is missing.
    for (const std::string method : {"sph", "wcmps"}) {
        const End end =
            end_of("dimension = 2\ngravity = [0, 0]\nend = 0.1\n" + rock("1e7") + "[fluid]\nmethod = '" + method +
                   "'\nspacing = 0.025\ndomain = { low = [-3, -3], high = [4, 4] }\n"
                   "[[fluid.region]]\nbox = { low = [0, -0.3], high = [0.5, 0.3] }\n" +
                   body("pad", "box = [0.1, 2]", "position = [-0.3, 0]\nmotion = { linear = { velocity = [5, 0] } }"));
        EXPECT_THAT(end.reason, IsEmpty()) << method;
    }
}

TEST(LedgerVerdict, LeavesABodyThatSpinsWithoutGravityAlone) {
    // Nothing is turned over but the error of the motion, some 1e-9 of 8 J.
    const End end = end_of("gravity = [0, 0, 0]\nend = 3\ntime_step = 5e-4\n" + rock("1e7") +
                           body("top", "box = [0.3, 0.2, 0.1]", "angular_velocity = [7, 1, 3]"));
    EXPECT_THAT(end.reason, IsEmpty());
}

TEST(LedgerVerdict, GoesBackToWhereTheLedgerClosedAndTriesAShorterStep) {
    // The longest step that the bound allows misses more of a hard impact than this case accepts; half of it does not.
    const std::string text =
        "gravity = [0, 0, 0]\nend = 0.3\ntime_step_factor = 1\n[output]\nledger_tolerance = 0.003\n" + rock("3e7") +
        body("wall", "cube = 1", "fixed = true") +
        body("block", "cube = 1", "position = [0, 0, 1.5]\nvelocity = [0, 0, -12]");
    const End end = end_of(text);
    EXPECT_THAT(end.reason, IsEmpty());
    EXPECT_GE(end.retries, 1);
    EXPECT_NEAR(end.time, 0.3, 1e-12);
}

}  // namespace
}  // namespace riprap::run
