// SPDX-License-Identifier: Apache-2.0
// Words of [[expect]] that set values against each other and against points of another source.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "riprap/core/error.hpp"
#include "riprap/run/figures/expects.hpp"
#include "riprap/scene/read_case.hpp"

namespace riprap {
namespace {

using ::testing::HasSubstr;

/// A stone that falls with 10 m/s^2 and one beside it that is thrown up with 4 m/s, for a second in steps of 1 ms.
constexpr const char* two_stones = R"(
gravity = [0.0, 0.0, -10.0]
end = 1.0
time_step = 0.001
[material.rock]
density = 2000.0
normal_stiffness = 1.0e7
[[body]]
name = "stone"
shape = { cube = 1.0 }
material = "rock"
[[body]]
name = "thrown"
shape = { cube = 1.0 }
position = [5.0, 0.0, 0.0]
velocity = [0.0, 0.0, 4.0]
material = "rock"
)";

std::string expect(const std::string& name, const std::string& more) {
    return "[[expect]]\nname = \"" + name + "\"\ncitation = \"test\"\n" + more;
}

/// Runs the case with more lines and returns its answers; with `stop` the watch is saved and read again at that step.
std::vector<run::ExpectResult> results_of(const std::string& more, int stop = -1) {
    const auto loaded = scene::read_case_text(two_stones + more, "case.toml", ".");
    sim::State state = loaded.state;
    sim::initialise(loaded.model, state);
    const sim::State initial = state;
    sim::Scratch scratch;
    std::optional<run::ExpectWatch> watch(loaded.model);
    watch->look({loaded.model, initial, state, nullptr, nullptr});
    for (int i = 0; i < 1000; ++i) {
        const sim::StepReport report = advance(loaded.model, state, scratch, 0.001);
        watch->look({loaded.model, initial, state, &scratch, &report});
        if (i == stop) {
            const std::vector<double> saved = watch->save();
            watch.emplace(loaded.model);
            watch->load(saved);
        }
    }
    return watch->judge(true);
}

std::string problem_of(const std::string& more) {
    try {
        scene::read_case_text(two_stones + more, "case.toml", "/nonexistent");
    } catch (const CaseError& error) {
        return to_string(error.problems().front());
    }
    return "";
}

TEST(ExpectWords, RelativeToTakesTheOtherQuantityOffAtEveryMoment) {
    const auto results = results_of(expect("apart",
                                           "quantity = 'thrown.position.z'\nrelative_to = 'stone.position.z'\n"
                                           "reduce = 'at'\nat = 0.5\nvalue = 2.0\ntolerance = 1.0e-9\n") +
                                    expect("high",
                                           "quantity = 'thrown.position.z'\nreduce = 'max'\nvalue = 0.8\n"
                                           "tolerance = 0.003\n"));
    EXPECT_EQ(results[0].verdict, run::Verdict::passed) << results[0].value;
    EXPECT_EQ(results[1].verdict, run::Verdict::passed) << results[1].value;
}

// z = -5 t^2 passes -0.2 m at 0.2 s and -1.8 m at 0.6 s.
const std::string events =
    expect("first",
           "quantity = 'time'\nreduce = 'when'\nwhen = 'stone.position.z'\nreaches = -0.2\nreported = true\n") +
    expect("place",
           "quantity = 'stone.position.z'\nreduce = 'when'\nwhen = 'stone.position.z'\nreaches = -0.2\n"
           "reported = true\n");

TEST(ExpectWords, MinusIsATimeBetweenEventsAndAChangeSinceOne) {
    const auto results =
        results_of(events +
                   expect("between",
                          "quantity = 'time'\nreduce = 'when'\nwhen = 'stone.position.z'\nreaches = -1.8\n"
                          "minus = 'first'\nvalue = 0.4\ntolerance = 0.002\n") +
                   expect("since", "quantity = 'stone.position.z'\nminus = 'place'\nvalue = -4.8\ntolerance = 0.01\n") +
                   expect("over",
                          "quantity = 'stone.position.z'\nminus = 'place'\nover = 'place'\nvalue = 24.0\n"
                          "tolerance = 0.05\n") +
                   expect("rate", "quantity = 'stone.position.z'\nover = 'first'\nvalue = -25.0\ntolerance = 0.2\n"));
    EXPECT_EQ(results[0].verdict, run::Verdict::reported);
    EXPECT_EQ(results[2].verdict, run::Verdict::passed) << results[2].value;
    EXPECT_EQ(results[3].verdict, run::Verdict::passed) << results[3].value;
    EXPECT_EQ(results[4].verdict, run::Verdict::passed) << results[4].value;
    EXPECT_EQ(results[4].unit, "-");
    EXPECT_EQ(results[5].verdict, run::Verdict::passed) << results[5].value;
    EXPECT_EQ(results[5].unit, "(m)/(s)");
}

TEST(ExpectWords, AnAnswerThatNeedsAnEventThatNeverCameFails) {
    const auto results =
        results_of(expect("never",
                          "quantity = 'time'\nreduce = 'when'\nwhen = 'stone.position.z'\nreaches = 1.0\n"
                          "reported = true\n") +
                   expect("since", "quantity = 'time'\nminus = 'never'\nlow = -9.0\nhigh = 9.0\n"));
    EXPECT_EQ(results[1].verdict, run::Verdict::failed);
    EXPECT_EQ(results[0].verdict, run::Verdict::failed) << "what is told must have come";
}

// At 0.1, 0.5 and 1 s the stone is at -0.05, -1.25 and -5 m; the points lie off by 0.1, 0.1 and -0.2 m.
const std::string points = "curve = { points = [[0.1, -0.15], [0.5, -1.35], [1.0, -4.8]]";

TEST(ExpectWords, ACurveIsHeldBesideItsPoints) {
    const std::string quantity = "quantity = 'stone.position.z'\nlow = 0.0\nhigh = 9.0\n";
    const std::string text = expect("rms", quantity + "reduce = 'rms'\n" + points + " }\n") +
                             expect("worst", quantity + "reduce = 'worst'\n" + points + " }\n") +
                             expect("a little", quantity + "reduce = 'worst'\n" + points + ", shift = 0.02 }\n") +
                             expect("all", quantity + "reduce = 'worst'\n" + points + ", shift = 9.0 }\n") +
                             expect("mean", quantity + "reduce = 'mean_error'\n" + points + " }\n") +
                             expect("late mean", quantity + "reduce = 'mean_error'\n" + points + ", shift = 9.0 }\n");
    for (const int stop : {-1, 50, 99, 700}) {
        const auto results = results_of(text, stop);
        EXPECT_NEAR(results[0].value, std::sqrt((0.01 + 0.01 + 0.04) / 3), 1e-9);
        EXPECT_NEAR(results[1].value, 0.2, 1e-9);
        EXPECT_NEAR(results[2].value, 0.18, 1e-9);
        EXPECT_NEAR(results[3].value, 0.15, 1e-9);
        EXPECT_NEAR(results[4].value, 0.4 / 3, 1e-9);
        EXPECT_NEAR(results[5].value, 0.1, 1e-9) << "off by 0.1, 0.1 and -0.2 m: the median is taken off";
    }
}

// The time at places: half a second late throughout, as behind a gate.
TEST(ExpectWords, ACurveMayLieAlongAnotherQuantityAndBeLateByAConstant) {
    const std::string late = "curve = { points = [[-0.2, 0.7], [-1.8, 1.1], [-4.05, 1.4]], along = 'stone.position.z'";
    const std::string quantity = "quantity = 'time'\nreduce = 'rms'\nvalue = 0.0\ntolerance = 0.003\n";
    const auto results = results_of(expect("late", quantity + late + ", shift = 0.6 }\n") +
                                    expect("too late", quantity + late + ", shift = 0.1 }\n"));
    EXPECT_EQ(results[0].verdict, run::Verdict::passed) << results[0].value;
    EXPECT_NEAR(results[1].value, 0.4, 0.003);
    EXPECT_EQ(results[1].verdict, run::Verdict::failed);
}

TEST(ExpectWords, ACurveWithAPointThatIsNeverReachedFails) {
    const auto results =
        results_of(expect("high",
                          "quantity = 'time'\nreduce = 'worst'\nlow = 0.0\nhigh = 9.0\n"
                          "curve = { points = [[-0.2, 0.2], [0.5, 0.1]], along = 'stone.position.z' }\n"));
    EXPECT_EQ(results[0].verdict, run::Verdict::failed);
}

TEST(ExpectWords, WhatDoesNotGoTogetherIsToldWithItsPlace) {
    const std::string band = "quantity = 'time'\nlow = 0.0\nhigh = 9.0\n";
    EXPECT_THAT(problem_of(expect("a", band + "reduce = 'rms'\n")), HasSubstr("case.toml:18:1: 'curve' goes with"));
    EXPECT_THAT(problem_of(expect("a", band + points + " }\n")), HasSubstr("case.toml:24:9: 'curve' goes with"));
    EXPECT_THAT(problem_of(expect("a", band + "reduce = 'rms'\n" + points + ", along = 'stone.size' }\n")),
                HasSubstr("there is no quantity 'stone.size'"));
    EXPECT_THAT(problem_of(expect("a", band + "reduce = 'rms'\ncurve = { file = 'none.csv' }\n")),
                HasSubstr("case.toml:25:18"));
    EXPECT_THAT(problem_of(expect("a", band + "relative_to = 'stone.colour'\n")),
                HasSubstr("there is no quantity 'stone.colour'"));
    EXPECT_THAT(problem_of(expect("a", band + "minus = 'b'\n") + expect("b", band)),
                HasSubstr("case.toml:24:9: no [[expect]] before this one is called 'b'"));
    EXPECT_THAT(problem_of(expect("place", band) + expect("b", band + "over = 'plase'\n")),
                HasSubstr("did you mean 'place'?"));
    EXPECT_THAT(problem_of(expect("a", band) + expect("b", band) + expect("a", band)),
                HasSubstr("another [[expect]] is called 'a'"));  // sweep.csv had one column for both
    EXPECT_THAT(problem_of(expect("a", band + "relative_to = 'time'\n")),
                HasSubstr("'time' relative to itself is always 0"));
    EXPECT_THAT(problem_of(expect("a", band + "reported = true\n")), HasSubstr("reported"));
    EXPECT_THAT(problem_of(expect("a", "quantity = 'time'\nreported = false\n")), HasSubstr("says nothing"));
}

TEST(ExpectWords, AnExtremeTellsItsTime) {
    const std::string high = "quantity = 'thrown.position.z'\nreported = true\n";
    for (const int stop : {-1, 200, 700}) {
        const auto results = results_of(expect("top", high + "reduce = 'time_of_max'\n") +
                                            expect("low", high + "reduce = 'time_of_min'\nto = 0.9\n") +
                                            expect("later",
                                                   "quantity = 'thrown.position.z'\nreduce = 'time_of_min'\n"
                                                   "minus = 'top'\nvalue = 0.6\ntolerance = 0.002\n"),
                                        stop);
        EXPECT_NEAR(results[0].value, 0.4, 0.0011);
        EXPECT_EQ(results[0].time, results[0].value);
        EXPECT_EQ(results[0].unit, "s");
        EXPECT_NEAR(results[1].value, 0.9, 0.0011);
        EXPECT_EQ(results[2].verdict, run::Verdict::passed) << results[2].value;
    }
}

// Four more stones fall from 10 m at x = 10, 11, 12 and 13 m.
const std::string row =
    "[[body]]\nname = 'row'\nshape = { cube = 0.5 }\nposition = [10.0, 0.0, 10.0]\nmaterial = 'rock'\n"
    "repeat = { counts = [4, 1, 1], pitch = [1.0, 0.0, 0.0] }\n";

TEST(ExpectWords, BodiesOfEntriesAreTakenTogether) {
    const std::string end = "reported = true\n";
    const auto results =
        results_of(row + expect("mean", "quantity = 'row[mean].position.x'\n" + end) +
                   expect("sum", "quantity = 'row[sum].position.z'\n" + end) +
                   expect("min", "quantity = 'row[min].position.x'\n" + end) +
                   expect("max", "quantity = 'row[max].position.x'\n" + end) +
                   expect("both", "quantity = 'row,thrown[mean].position.x'\n" + end) +
                   expect("above", "quantity = 'row[above 11.5].position.x'\n" + end) +
                   expect("none above", "quantity = 'row[above 1e3].position.x'\n" + end) +
                   expect("apart", "quantity = 'row[mean].position.z'\nrelative_to = 'stone.position.z'\n" + end));
    const std::vector<double> exact{11.5, 20.0, 10.0, 13.0, 51.0 / 5, 2.0, 0.0, 10.0};
    for (std::size_t i = 0; i < exact.size(); ++i) {
        EXPECT_NEAR(results[i].value, exact[i], 0.03) << results[i].name;
        EXPECT_EQ(results[i].verdict, run::Verdict::reported);
        EXPECT_EQ(results[i].unit, results[i].name.ends_with("above") ? "-" : "m");
    }
}

TEST(ExpectWords, TheFrontOfAHeapLeavesOutWhatRolledOffIt) {
    const std::string loose =
        "[[body]]\nname = 'loose'\nshape = { cube = 0.5 }\nposition = [30.0, 0.0, 10.0]\nmaterial = 'rock'\n";
    const std::string end = "reported = true\n";
    const auto results = results_of(row + loose + expect("max", "quantity = 'row,loose[max].position.x'\n" + end) +
                                    expect("one", "quantity = 'row,loose[front 1 1.1].position.x'\n" + end) +
                                    expect("two", "quantity = 'row,loose[front 2 2.1].position.x'\n" + end) +
                                    expect("far", "quantity = 'row,loose[front 1 20].axis_distance'\n" + end));
    const std::vector<double> exact{30.0, 13.0, 12.0, 30.0};
    for (std::size_t i = 0; i < exact.size(); ++i) {
        EXPECT_NEAR(results[i].value, exact[i], 0.03) << results[i].name;
        EXPECT_EQ(results[i].unit, "m");
    }
}

TEST(ExpectWords, GroupsOfWhatIsNotThereAreToldWithTheirPlace) {
    const std::string band = "low = 0.0\nhigh = 9.0\n";
    for (const std::string quantity :
         {"heap[mean].position.x", "row[median].position.x", "row[mean].colour", "row,row[sum].position.x", "row[mean]",
          "row[sum", "row[above].position.x", "row[above high].position.x", "row[above 1 m].position.x",
          "row[sum 1].position.x", "row[front 2].position.x", "row[front 2 0].position.x",
          "row[front 2 1 1].position.x"}) {
        EXPECT_THAT(problem_of(row + expect("a", "quantity = '" + quantity + "'\n" + band)),
                    HasSubstr("case.toml:27:12: there is no quantity '" + quantity + "'"));
    }
    EXPECT_THAT(
        problem_of(row + expect("a", "quantity = 'row]sum[.position.x'\n" + band)),
        HasSubstr("case.toml:27:12: there is no body 'row]sum[' of 'row]sum[.position.x'; did you mean 'row'?"));
    EXPECT_THAT(problem_of(row + expect("a", "quantity = 'row,heap[mean].position.x'\n" + band)),
                HasSubstr("case.toml:27:12: there is no body 'heap' of 'row,heap[mean].position.x'"));
    EXPECT_THAT(problem_of(row + expect("a", "quantity = 'row[mean].stress_xx'\n" + band)),
                HasSubstr("the methods of this case do not have"));
}

}  // namespace
}  // namespace riprap
