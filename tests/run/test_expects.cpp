// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "riprap/core/error.hpp"
#include "riprap/run/figures/expects.hpp"
#include "run/falling_blocks.hpp"

namespace riprap::run {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

sim::Expect expect(const std::string& reduce, double at = 0) {
    return {.name = reduce,
            .quantity = "high.position.x",
            .reduce = reduce,
            .at = at,
            .value = 0,
            .low = -1e9,
            .high = 1e9,
            .citation = "",
            .place = "case.toml:1:1"};
}

/// The x position of one block is set to 0, 3, 1 at times 0, 1, 2.
std::vector<ExpectResult> follow(const std::vector<sim::Expect>& expects, bool save_and_load) {
    scene::LoadedCase loaded = falling_blocks();
    loaded.model.expects = expects;
    ExpectWatch watch(loaded.model);
    sim::State state = loaded.state;
    const std::array<double, 3> positions{0, 3, 1};
    for (std::size_t i = 0; i < positions.size(); ++i) {
        state.time = static_cast<double>(i);
        state.bodies.position[2].x = positions[i];
        if (save_and_load) {
            ExpectWatch fresh(loaded.model);
            fresh.load(watch.save());
            fresh.look({loaded.model, loaded.state, state, nullptr, nullptr});
            watch.load(fresh.save());
        } else {
            watch.look({loaded.model, loaded.state, state, nullptr, nullptr});
        }
    }
    return watch.judge(true);
}

TEST(Expects, AMomentThatHasComeIsJudgedInARunThatIsCutAndOneThatHasNotIsNot) {
    sim::Expect reached = expect("when"), missed = expect("when");
    reached.when = missed.when = "high.position.x";
    reached.reaches = 2;
    missed.reaches = 20;
    reached.to = missed.to = 1e9;  // the end of the case
    const auto results = follow({reached, missed}, true);
    EXPECT_EQ(results[0].verdict, Verdict::passed);
    EXPECT_EQ(results[1].verdict, Verdict::not_judged);
}

TEST(Expects, EveryReductionSeesEveryStep) {
    const auto results =
        follow({expect("last"), expect("min"), expect("max"), expect("mean"), expect("at", 1.5)}, false);
    EXPECT_EQ(results[0].value, 1.0);
    EXPECT_EQ(results[1].value, 0.0);
    EXPECT_EQ(results[2].value, 3.0);
    EXPECT_NEAR(results[3].value, (0.5 * 3 + 0.5 * 4) / 2, 1e-15);  // over time
    EXPECT_EQ(results[4].value, 2.0);                               // halfway between 3 and 1
    EXPECT_EQ(results[0].unit, "m");
}

TEST(Expects, TellsWhenAFigureWasThere) {
    const auto results = follow(
        {expect("last"), expect("min"), expect("max"), expect("mean"), expect("at", 1.5), expect("at", 9)}, true);
    EXPECT_EQ(results[0].time, 2);
    EXPECT_EQ(results[1].time, 0);
    EXPECT_EQ(results[2].time, 1);
    EXPECT_TRUE(std::isnan(results[3].time));
    EXPECT_EQ(results[4].time, 1.5);
    EXPECT_TRUE(std::isnan(results[5].time));  // never reached
    EXPECT_THAT(verdict_table(results), HasSubstr("at [s]"));
    EXPECT_THAT(verdict_table(results), Not(HasSubstr("\033")));
    EXPECT_THAT(verdict_table(results, true),
                HasSubstr("m" + std::string(to_string(results[0].verdict)) + "\033[0m\n"));
}

TEST(Expects, AnExtremeIsFarthestFromZeroToEitherSide) {
    const auto up = follow({expect("extreme")}, true);
    EXPECT_EQ(up[0].value, 3);
    EXPECT_EQ(up[0].time, 1);
    sim::Expect down = expect("extreme");
    down.quantity = "high.velocity.y";  // stays at 0
    EXPECT_EQ(follow({down}, false)[0].value, 0);
    scene::LoadedCase loaded = falling_blocks();
    loaded.model.expects = {expect("extreme")};
    ExpectWatch watch(loaded.model);
    sim::State state = loaded.state;
    for (const double x : {2.0, -4.0, 3.0}) {
        state.bodies.position[2].x = x;
        watch.look({loaded.model, loaded.state, state, nullptr, nullptr});
        state.time += 1;
    }
    EXPECT_EQ(watch.judge(true)[0].value, -4);
    EXPECT_EQ(watch.judge(true)[0].time, 1);
}

TEST(Expects, OnlyStepsFromOneTimeToAnotherCount) {
    sim::Expect late = expect("max"), early = expect("last"), never = expect("mean"), mean = expect("mean");
    late.from = 1.5;
    early.to = 1;
    never.from = 0.1;  // between two steps
    never.to = 0.2;
    mean.from = 1;
    const auto results = follow({late, early, never, mean}, true);
    EXPECT_EQ(results[0].value, 1);
    EXPECT_EQ(results[1].value, 3);
    EXPECT_EQ(results[1].time, 1);
    EXPECT_TRUE(std::isnan(results[2].value));
    EXPECT_EQ(results[2].verdict, Verdict::failed);  // what was not seen is not met
    EXPECT_EQ(results[3].value, 2);                  // of 3 and 1
}

TEST(Expects, TellsWhenATriggerReachedItsLevel) {
    sim::Expect passing = expect("when");
    passing.when = "high.position.x";
    passing.reaches = 1.5;
    const auto results = follow({passing}, true);
    EXPECT_EQ(results[0].value, 1.5);
    EXPECT_EQ(results[0].time, 0.5);  // on the way from 0 to 3, not on the way back
}

/// Judges answers over values of x at steps of 1 s; every step goes through a checkpoint.
std::vector<ExpectResult> judge_series(const std::vector<sim::Expect>& expects, const std::vector<double>& values) {
    scene::LoadedCase loaded = falling_blocks();
    loaded.model.expects = expects;
    ExpectWatch watch(loaded.model);
    sim::State state = loaded.state;
    for (const double x : values) {
        state.bodies.position[2].x = x;
        ExpectWatch fresh(loaded.model);
        fresh.load(watch.save());
        fresh.look({loaded.model, loaded.state, state, nullptr, nullptr});
        watch.load(fresh.save());
        state.time += 1;
    }
    return watch.judge(true);
}

TEST(Expects, APeriodIsTheMeanTimeBetweenPassagesOfALevelInOneDirection) {
    sim::Expect period = expect("period"), never = expect("period");
    period.reaches = 1;
    never.reaches = 5;
    const auto results =
        judge_series({period, never}, {0, 4, 4, 0, 4, 4, 0});  // up at 0.25 and 3.25, down at 2.75, 5.75
    EXPECT_DOUBLE_EQ(results[0].value, 3);
    EXPECT_EQ(results[0].unit, "s");
    EXPECT_TRUE(std::isnan(results[0].time));
    EXPECT_TRUE(std::isnan(results[1].value));
    EXPECT_THAT(verdict_table(results), HasSubstr("it passed its level less than three times"));
}

TEST(Expects, FiguresOfACheckpointOfVersion02AreTaken) {
    scene::LoadedCase loaded = falling_blocks();
    loaded.model.expects = {expect("max")};
    ExpectWatch watch(loaded.model);
    watch.look({loaded.model, loaded.state, loaded.state, nullptr, nullptr});
    std::vector<double> numbers = watch.save();
    numbers.resize(13);  // without crossings
    ExpectWatch resumed(loaded.model);
    resumed.load(numbers);
    EXPECT_EQ(resumed.judge(true)[0].value, watch.judge(true)[0].value);
}

TEST(Expects, AMeanIsOverTimeHoweverUnevenTheSteps) {
    scene::LoadedCase loaded = falling_blocks();
    loaded.model.expects = {expect("mean")};
    ExpectWatch watch(loaded.model);
    sim::State state = loaded.state;
    for (const double time : {0.0, 0.1, 0.11, 0.5, 2.0}) {
        state.time = time;
        state.bodies.position[2].x = 3 * time + 1;
        watch.look({loaded.model, loaded.state, state, nullptr, nullptr});
    }
    EXPECT_NEAR(watch.judge(true)[0].value, 4, 1e-14);
}

TEST(Expects, ATimeThatTheLastStepMissesByRoundOffIsSeen) {
    const auto results = follow({expect("at", 2 + 1e-12)}, false);
    EXPECT_NEAR(results[0].value, 1, 1e-10);
}

TEST(Expects, FiguresSurviveACheckpoint) {
    const std::vector<sim::Expect> all{expect("last"), expect("min"), expect("max"), expect("mean"),
                                       expect("at", 0.25)};
    const auto straight = follow(all, false), restarted = follow(all, true);
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_EQ(straight[i].value, restarted[i].value) << all[i].reduce;
    }
}

TEST(Expects, AValueOutsideItsBandOrNeverSeenFails) {
    sim::Expect narrow = expect("last");
    narrow.low = 1.5;
    sim::Expect none = expect("last");
    none.from = 1e-9;
    none.to = 2e-9;  // between two steps
    const auto results = follow({expect("last"), narrow, none}, false);
    EXPECT_EQ(results[0].verdict, Verdict::passed);
    EXPECT_EQ(results[1].verdict, Verdict::failed);
    EXPECT_EQ(results[2].verdict, Verdict::failed);
    EXPECT_TRUE(std::isnan(results[2].value));
    EXPECT_THAT(verdict_table(results), HasSubstr("has no value: no step of its window had one"));
}

TEST(Expects, WhatTheRunDoesNotReachIsNotJudged) {
    sim::Expect late = expect("last"), longer = expect("mean");
    late.from = 17;
    longer.to = 17;
    for (const ExpectResult& result : follow({expect("at", 17), late, longer}, false)) {
        EXPECT_EQ(result.verdict, Verdict::not_judged) << result.reduce;
    }
}

TEST(Expects, ARunThatStopsEarlyIsNotJudged) {
    scene::LoadedCase loaded = falling_blocks();
    loaded.model.expects = {expect("last")};
    EXPECT_EQ(ExpectWatch(loaded.model).judge(false)[0].verdict, Verdict::not_judged);
}

TEST(Expects, UnknownQuantitiesAndReductionsAreAllNamed) {
    scene::LoadedCase loaded = falling_blocks();
    loaded.model.expects = {expect("median"), expect("last")};
    loaded.model.expects[1].quantity = "high.colour";
    try {
        ExpectWatch watch(loaded.model);
        FAIL();
    } catch (const CaseError& error) {
        EXPECT_EQ(error.problems().size(), 2U);
        EXPECT_THAT(error.what(), HasSubstr("reduce = 'median'"));
        EXPECT_THAT(error.what(), HasSubstr("high.colour"));
    }
}

TEST(Expects, AnotherNumberOfFiguresIsRefused) {
    scene::LoadedCase loaded = falling_blocks();
    loaded.model.expects = {expect("last")};
    ExpectWatch watch(loaded.model);
    EXPECT_THROW(watch.load({1, 2, 3}), CheckpointError);
}

}  // namespace
}  // namespace riprap::run
