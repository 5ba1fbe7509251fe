// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "riprap/core/error.hpp"
#include "riprap/run/figures/expects.hpp"
#include "riprap/scene/read_case.hpp"

namespace riprap {
namespace {

/// A block that falls freely for one second while gravity turns from -z towards +x at 0.5 rad/s.
constexpr const char* falling_block = R"(
end = 1.0
time_step = 0.001
[gravity]
value    = [0.0, 0.0, -10.0]
rotation = { axis = [0.0, -1.0, 0.0], rate = 0.5 }
[material.rock]
density = 2000.0
normal_stiffness = 1.0e7
[[body]]
name     = "block"
shape    = { cube = 1.0 }
material = "rock"
)";

/// Runs the case with one more [[expect]] and returns what it comes to.
run::ExpectResult result_of(const std::string& expect) {
    const auto loaded = scene::read_case_text(
        std::string(falling_block) + "[[expect]]\nname = \"it\"\ncitation = \"test\"\nlow = 0.0\nhigh = 9.0\n" + expect,
        "case.toml", ".");
    sim::State state = loaded.state;
    sim::initialise(loaded.model, state);
    const sim::State initial = state;
    sim::Scratch scratch;
    run::ExpectWatch watch(loaded.model);
    watch.look({loaded.model, initial, state, nullptr, nullptr});
    for (int i = 0; i < 1000; ++i) {
        const sim::StepReport report = advance(loaded.model, state, scratch, 0.001);
        watch.look({loaded.model, initial, state, &scratch, &report});
    }
    return watch.judge(true).at(0);
}

TEST(ExpectWhen, TakesTheTimeAtWhichAFallingBlockPassesAHeight) {
    // z = -(g/w^2) (1 - cos w t) with g = 10 and w = 1/2 is -1 m at t = 2 arccos(39/40)
    const auto result =
        result_of("quantity = 'time'\nreduce = 'when'\nwhen = 'block.displacement.z'\nreaches = -1.0\n");
    EXPECT_NEAR(result.value, 2 * std::acos(39.0 / 40), 1e-6);
    EXPECT_EQ(result.verdict, run::Verdict::passed);
}

TEST(ExpectWhen, GivesTheTiltAtWhichSomethingHasMoved) {
    const auto result = result_of("quantity = 'tilt'\nreduce = 'when'\nwhen = 'max_displacement'\nreaches = 1.25\n");
    // |x| = (g/w^2) sqrt((1 - cos a)^2 + (a - sin a)^2), a = w t the tilt
    const double a = result.value;
    EXPECT_NEAR(40 * std::hypot(1 - std::cos(a), a - std::sin(a)), 1.25, 1e-5);
}

TEST(ExpectWhen, FailsWhenTheLevelIsNeverReached) {
    const auto result = result_of("quantity = 'time'\nreduce = 'when'\nwhen = 'block.displacement.z'\nreaches = 1.0\n");
    EXPECT_TRUE(std::isnan(result.value));
    EXPECT_EQ(result.verdict, run::Verdict::failed);
}

TEST(ExpectWhen, NeedsATriggerAndALevel) {
    EXPECT_THROW(result_of("quantity = 'time'\nreduce = 'when'\n"), CaseError);
    EXPECT_THROW(result_of("quantity = 'time'\nwhen = 'tilt'\nreaches = 1.0\n"), CaseError);
    EXPECT_THROW(result_of("quantity = 'time'\nreduce = 'when'\nwhen = 'tilt'\n"), CaseError);
    EXPECT_THROW(result_of("quantity = 'time'\nreaches = 1.0\n"), CaseError);
    EXPECT_THROW(result_of("quantity = 'time'\nreduce = 'when'\nwhen = 'tillt'\nreaches = 1.0\n"), CaseError);
}

}  // namespace
}  // namespace riprap
