// SPDX-License-Identifier: Apache-2.0
#include "riprap/bench/bench.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <nlohmann/json.hpp>
#include <sstream>

#include "riprap/bench/machine.hpp"
#include "riprap/bench/measure.hpp"
#include "riprap/core/parallel.hpp"

namespace riprap::bench {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

MachineLimits some_machine(const std::vector<int>& thread_counts) {
    MachineLimits limits;
    for (const int threads : thread_counts) {
        limits.by_threads.push_back({threads, 20e9, 72e9, 144e9});
    }
    return limits;
}

void answer(const char* name, std::vector<Result>& results) { results.push_back({name, 1, 2.5, "us", "a note"}); }
constexpr std::array benches{
    Bench{"pile.1k", "", false, [](const Setting&, std::vector<Result>& results) { answer("pile.1k", results); }},
    Bench{"pile.10k", "", false, [](const Setting&, std::vector<Result>& results) { answer("pile.10k", results); }},
    Bench{"pile.100k", "", true, [](const Setting&, std::vector<Result>& results) { answer("pile.100k", results); }},
    Bench{"contact.cube_cube", "", false,
          [](const Setting& setting, std::vector<Result>& results) {
              for (const int threads : setting.thread_counts) {
                  results.push_back({"contact.cube_cube", threads, 1, "us", ""});
              }
          }},
};

nlohmann::json run(BenchOptions options) {
    options.as_json = true;
    options.threads = options.threads == 0 ? 1 : options.threads;
    std::ostringstream out;
    EXPECT_EQ(run_benches(options, benches, some_machine, out, nullptr), 0);
    return nlohmann::json::parse(out.str());
}

std::vector<std::string> names(const nlohmann::json& document) {
    std::vector<std::string> all;
    for (const auto& result : document.at("results")) {
        all.push_back(result.at("name"));
    }
    return all;
}

TEST(Bench, ANameSelectsTheBenchAndTheBeginningOfOneItsFamily) {
    EXPECT_THAT(names(run({.selection = {"contact.cube_cube"}})), ElementsAre("contact.cube_cube"));
    EXPECT_THAT(names(run({.selection = {"pile"}})), ElementsAre("pile.1k", "pile.10k"));
    EXPECT_THAT(names(run({.selection = {"pile.10k.memory"}})), ElementsAre("pile.10k"));
    EXPECT_THAT(names(run({})), ElementsAre("pile.1k", "pile.10k", "contact.cube_cube"));
}

TEST(Bench, ALongBenchRunsWhenItIsNamedOrEverythingIsAsked) {
    EXPECT_THAT(names(run({.selection = {"pile.100k"}})), ElementsAre("pile.100k"));
    EXPECT_THAT(names(run({.selection = {"pile"}, .is_full = true})), ElementsAre("pile.1k", "pile.10k", "pile.100k"));
}

TEST(Bench, AWordThatNamesNothingIsABadCommandLineAndIsAnsweredWithTheNames) {
    std::ostringstream out;
    EXPECT_EQ(run_benches({.selection = {"pie"}}, benches, some_machine, out, nullptr), 2);
    EXPECT_THAT(out.str(), AllOf(HasSubstr("pie"), HasSubstr("contact.cube_cube"), HasSubstr("pile.100k")));
}

TEST(Bench, TheJsonDocumentHasTheMachineAndFiveKeysForEveryResult) {
    const nlohmann::json document = run({.selection = {"pile.1k"}});
    EXPECT_EQ(document.size(), 2U);
    const nlohmann::json& result = document.at("results").at(0);
    EXPECT_EQ(result, (nlohmann::json{
                          {"name", "pile.1k"}, {"threads", 1}, {"value", 2.5}, {"unit", "us"}, {"note", "a note"}}));
    const nlohmann::json& limits = document.at("machine").at("limits").at(0);
    EXPECT_EQ(limits, (nlohmann::json{{"threads", 1}, {"triad", 20e9}, {"fma_double", 72e9}, {"fma_single", 144e9}}));
    EXPECT_DOUBLE_EQ(document.at("machine").at("core_speed").get<double>(), 72 / 143.9);
}

TEST(Bench, EveryBenchIsMeasuredWithOneThreadAndWithAsManyAsAsked) {
    const nlohmann::json document = run({.selection = {"contact"}, .threads = 3});
    ASSERT_EQ(document.at("results").size(), 2U);
    EXPECT_EQ(document.at("results").at(0).at("threads"), 1);
    EXPECT_EQ(document.at("results").at(1).at("threads"), 3);
}

TEST(Bench, NamesAreDifferentAndInFamilies) {
    std::vector<std::string_view> seen;
    for (const Bench& bench : all_benches()) {
        EXPECT_THAT(seen, Not(::testing::Contains(bench.name)));
        seen.push_back(bench.name);
    }
    for (const char* name : {"machine", "contact.cube_cube", "pile.735_cubes", "broadphase.slope"}) {
        EXPECT_THAT(seen, ::testing::Contains(name)) << "a name that later comparisons use";
    }
}

TEST(Bench, AMachineDoesMoreInSingleThanInDoublePrecision) {
    const ThreadLimits limits = measure_machine({1}).by_threads.at(0);
    EXPECT_GT(limits.triad, 1e8);
    EXPECT_GT(limits.fma_single, limits.fma_double);
}

TEST(Bench, TheMedianLiesBetweenTheFastestAndTheSlowestAndTheFirstCallIsNotCounted) {
    const ThreadScope two(2);  // wall time
    int calls = 0;
    const Timing timing = time_calls([&] { ++calls; }, {.least_calls = 9, .least_seconds = 0});
    EXPECT_EQ(timing.count, 9);
    EXPECT_EQ(calls, 10);
    EXPECT_LE(timing.low, timing.median);
    EXPECT_LE(timing.median, timing.high);
}

TEST(Bench, ASpeedUpIsOfCallsInTurnOfWhichTheFirstTwoAreNotCounted) {
    std::string calls;
    const Timing ratio = compare_calls([&] { calls += 'a'; }, [&] { calls += 'b'; }, 3);
    EXPECT_EQ(calls, "abababab");
    EXPECT_EQ(ratio.count, 3);
    EXPECT_LE(ratio.low, ratio.median);
    EXPECT_LE(ratio.median, ratio.high);
}

TEST(Bench, TheNumberOfThreadsIsPutBack) {
    const int before = parallel::thread_count();
    { const ThreadScope scope(before + 2); }
    EXPECT_EQ(parallel::thread_count(), before);
}

}  // namespace
}  // namespace riprap::bench
