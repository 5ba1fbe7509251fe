// SPDX-License-Identifier: Apache-2.0
// Overlaps and impacts that `riprap check` predicts, beside those of a run.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "riprap/run/check/check_case.hpp"
#include "riprap/run/simulate/simulation.hpp"
#include "riprap/scene/read_case.hpp"

namespace riprap::run {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

/// A block of 1 m on a floor or above it, in space or in the plane.
std::string block(const std::string& solid, bool is_planar, double height, double speed, double end,
                  double stiffness = 1e7) {
    const std::string z = is_planar ? "[0, {}]" : "[0, 0, {}]";
    const auto along = [&](double value) { return fmt::format(fmt::runtime(z), value); };
    return fmt::format("{}gravity = {}\nend = {}\n", is_planar ? "dimension = 2\n" : "", along(speed > 0 ? 0 : -9.81),
                       end) +
           fmt::format("[material.rock]\ndensity = 2500\nnormal_stiffness = {}\nfriction_coefficient = 0.5\n",
                       stiffness) +
           "[solid]\n" + solid + "\n[[body]]\nname = 'floor'\nmaterial = 'rock'\nfixed = true\nshape = { box = " +
           (is_planar ? "[4, 1]" : "[4, 4, 1]") + " }\nposition = " + along(-0.5) +
           "\n[[body]]\nname = 'block'\nmaterial = 'rock'\nshape = { box = " + (is_planar ? "[1, 1]" : "[1, 1, 1]") +
           " }\nposition = " + along(0.5 + height) + "\nvelocity = " + along(-speed) + "\n";
}

CaseCheck check_of(const std::string& text) { return check_case(scene::read_case_text(text, "case.toml", ".")); }

/// Largest way that the block goes below the height at which it touches, of all steps [m].
double sinks(const std::string& text, bool is_planar, bool is_last) {
    Simulation simulation(scene::read_case_text(text, "case.toml", "."));
    double deepest = 0, now = 0;
    while (simulation.steps_left() > 0) {
        if (simulation.step(sim::Measure::flow).kind == StepOutcome::Kind::refused) {
            ADD_FAILURE() << "refused";
            break;
        }
        const Vec3 x = simulation.state().bodies.position[1];
        now = 0.5 - (is_planar ? x.y : x.z);
        deepest = std::max(deepest, now);
    }
    return is_last ? now : deepest;
}

struct Kind {
    std::string name, solid;
    bool is_planar;
    double tolerance{0.03};  ///< of the overlap [-]
};
void PrintTo(const Kind& kind, std::ostream* out) { *out << kind.name; }

class Predicted : public ::testing::TestWithParam<Kind> {};

TEST_P(Predicted, TheOverlapOfABlockAtRestIsThatOfItsRun) {
    const Kind& kind = GetParam();
    const std::string text = block(kind.solid, kind.is_planar, 0, 0, 0.6);
    const CaseCheck check = check_of(text);
    ASSERT_TRUE(check.overlap);
    EXPECT_FALSE(check.overlap->found.is_impact);
    // Let go at the height at which it touches it swings between none and twice the overlap at rest.
    const double deepest = sinks(text, kind.is_planar, false);
    EXPECT_GT(deepest, (1 - kind.tolerance) * check.overlap->found.overlap);
    EXPECT_LT(deepest, (2 + kind.tolerance) * check.overlap->found.overlap);
}

TEST_P(Predicted, TheOverlapOfAnImpactIsThatOfItsRun) {
    const Kind& kind = GetParam();
    const std::string text = block(kind.solid, kind.is_planar, 0.01, 0.5, 0.15);
    const CaseCheck check = check_of(text);
    ASSERT_TRUE(check.overlap && check.overlap->found.is_impact);
    EXPECT_NEAR(check.overlap->found.speed, 0.5, 1e-6);
    EXPECT_NEAR(sinks(text, kind.is_planar, false), check.overlap->found.overlap,
                kind.tolerance * check.overlap->found.overlap);
}

INSTANTIATE_TEST_SUITE_P(
    Methods, Predicted,
    ::testing::Values(
        Kind{"faces", "method = 'distance_potential_dem'", false, 0.05},
        Kind{"faces_in_the_plane", "method = 'distance_potential_dem'", true, 0.05},
        Kind{"spheres", "method = 'sphere_dem'\nyoungs_modulus = 1e8\nrestitution = 1.0", false, 0.1},
        Kind{"linear_spheres",
             "method = 'sphere_dem'\nnormal_law = 'linear'\nspring_stiffness = 1e6\nrestitution = 1.0", false, 0.1},
        Kind{"explicit_dda", "method = 'explicit_dda'\ncontact_stiffness = 1e7", false, 0.1},
        Kind{"implicit_dda", "method = 'implicit_dda'\ncontact_stiffness = 1e7\nstep = 1e-4", false, 0.1},
        Kind{"implicit_dda_per_area", "method = 'implicit_dda'\ncontact_stiffness_per_area = 4e7\nstep = 1e-4", false,
             0.1},
        Kind{"implicit_dda_in_the_plane", "method = 'implicit_dda'\ncontact_stiffness = 1e7\nstep = 1e-4", true, 0.1},
        Kind{"planar_dda", "method = 'planar_dda'\ncontact_stiffness = 1e7\nstep = 1e-4", true, 0.1}),
    [](const auto& made) { return made.param.name; });

TEST(PredictedOverlap, IsWarnedOfWhereItIsATenthOfTheBlockWithTheStiffnessThatMakesItOne) {
    const std::string soft = block("method = 'distance_potential_dem'", false, 0, 0, 0.1, 1.2e5);
    EXPECT_THAT(check_of(soft).warnings, Contains(AllOf(HasSubstr("'block' sinks into 'floor'"),
                                                        HasSubstr("material.rock.normal_stiffness = "))));
    const std::string stiff = block("method = 'distance_potential_dem'", false, 0, 0, 0.1, 1e7);
    EXPECT_THAT(check_of(stiff).warnings, Not(Contains(HasSubstr("sinks into"))));
    const CaseCheck check = check_of(soft);
    const double named = 1.2e5 * check.overlap->found.share / large_overlap;
    const CaseCheck mended = check_of(block("method = 'distance_potential_dem'", false, 0, 0, 0.1, named));
    EXPECT_NEAR(mended.overlap->found.share, large_overlap, 0.01 * large_overlap);
}

TEST(PredictedOverlap, OfAStackIsThatOfItsFoot) {
    const std::string one = block("method = 'implicit_dda'\ncontact_stiffness = 1e8", false, 0, 0, 0.1);
    const std::string two =
        one +
        "[[body]]\nname = 'upper'\nmaterial = 'rock'\nshape = { box = [1, 1, 1] }\nposition = [0, 0, "
        "1.5]\n";
    EXPECT_NEAR(check_of(two).overlap->found.overlap, 2 * check_of(one).overlap->found.overlap, 1e-9);
}

/// Speed at which a block comes back from the floor, over that at which it came.
double comes_back(const std::string& text, bool is_planar) {
    Simulation simulation(scene::read_case_text(text, "case.toml", "."));
    while (simulation.steps_left() > 0) {
        simulation.step(sim::Measure::flow);
    }
    const Vec3 v = simulation.state().bodies.velocity[1];
    return is_planar ? v.y : v.z;
}

TEST(PredictedImpact, GivesBackWhatARunGivesBack) {
    for (const double step : {1e-3, 5e-4, 2.5e-4, 1.25e-4}) {
        for (const bool is_planar : {false, true}) {
            const std::string text = block(fmt::format("method = '{}'\ncontact_stiffness = 1e8\nstep = {}",
                                                       is_planar ? "planar_dda" : "implicit_dda", step),
                                           is_planar, 0.0123, 1, 0.1);
            const CaseCheck check = check_of(text);
            ASSERT_TRUE(check.impact);
            EXPECT_NEAR(check.impact->found.back, comes_back(text, is_planar), 0.03) << step << is_planar;
        }
    }
}

TEST(PredictedImpact, NamesTheStepWithWhichItGivesBackNearlyAll) {
    const auto with_step = [](double step) {
        return block(fmt::format("method = 'implicit_dda'\ncontact_stiffness = 1e8\nstep = {}", step), false, 0.0123, 1,
                     0.1);
    };
    const CaseCheck check = check_of(with_step(1e-3));
    EXPECT_THAT(check.warnings, Contains(AllOf(HasSubstr("'block' comes to 'floor'"), HasSubstr("solid.step = "))));
    const CaseCheck mended = check_of(with_step(check.impact->found.step));
    EXPECT_THAT(mended.warnings, Not(Contains(HasSubstr("comes to"))));
    EXPECT_NEAR(comes_back(with_step(check.impact->found.step), false), well_resolved, 0.01);
}

TEST(PredictedTipping, OfASingleBlockIsWarnedOfWhereGravityLeansWithTheMethodsThatTurnAboutEdges) {
    const auto block = [](const std::string& gravity, const std::string& more = "") {
        return gravity +
               "\nend = 1\n[material.rock]\ndensity = 2500\nnormal_stiffness = 1e6\n"
               "[[body]]\nname = 'floor'\nmaterial = 'rock'\nshape = { half_space = { normal = [0, 0, 1] } }\n"
               "fixed = true\n[[body]]\nname = 'brick'\nmaterial = 'rock'\nshape = { box = [0.2, 0.4, 0.6] }\n"
               "position = [0, 0, 0.3]\n" +
               more;
    };
    const auto tips = Contains(AllOf(HasSubstr("'brick' tips at"), HasSubstr("implicit_dda"),
                                     Not(HasSubstr("planar_dda")), Not(HasSubstr("sphere_dem"))));
    // A rigid brick tips at 18.4 degrees, atan(0.1/0.3).
    const std::string leaning = "gravity = [2.04, 0, -9.6]";      // by 12 degrees
    const std::string fields = "[solid]\nsides = 'contactor'\n";  // without corners
    EXPECT_THAT(check_of(block(leaning, fields)).warnings, tips);
    EXPECT_FALSE(check_of(block(leaning)).tipping);
    EXPECT_THAT(check_of(block(leaning, "[solid]\nmethod = 'implicit_dda'\n")).warnings,
                Not(Contains(HasSubstr("tips at"))));
    const std::string upright = "gravity = [0, 0, -9.81]";
    EXPECT_THAT(check_of(block(upright, fields)).warnings, Not(Contains(HasSubstr("tips at"))));
    EXPECT_TRUE(check_of(block(upright, fields)).tipping);
    EXPECT_THAT(
        check_of(block("gravity = { value = [0, 0, -9.81], rotation = { axis = [0, 1, 0], rate = 0.2 } }", fields))
            .warnings,
        tips);
}

}  // namespace
}  // namespace riprap::run
