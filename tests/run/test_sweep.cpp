// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <string>

#include "io/temporary_folder.hpp"
#include "riprap/core/error.hpp"
#include "riprap/run/folder/run_folder.hpp"
#include "riprap/run/folder/runs_within.hpp"
#include "riprap/run/study/sweep.hpp"
#include "riprap/run/study/sweep_plan.hpp"

namespace riprap {
namespace {

using ::testing::ElementsAre;

TEST(SweepWords, CommasWithinBracketsAndQuotesDoNotPartValues) {
    const run::Variation variation = run::read_variation("gravity = [0,0,-9.81], [0, 0, -1.62],\"a,b\"");
    EXPECT_EQ(variation.key, "gravity");
    EXPECT_THAT(variation.values, ElementsAre("[0,0,-9.81]", "[0, 0, -1.62]", "\"a,b\""));
    EXPECT_THROW(run::read_variation("end"), CaseError);
    EXPECT_THROW(run::read_variation("end=1,,2"), CaseError);
    EXPECT_THROW(run::read_variation("end=0,5;1,5"), CaseError);  // was 0, "5;1" and 5
    EXPECT_EQ(run::read_variation("title='a;b'").values.front(), "'a;b'");
}

TEST(SweepWords, AGridHasEveryCombinationAndAListItsLines) {
    const auto grid = run::grid_of({{"a", {"1", "2"}}, {"b", {"x", "y", "z"}}});
    ASSERT_EQ(grid.size(), 6U);
    EXPECT_EQ(grid[5].name, "run_006");
    EXPECT_THAT(grid[4].overrides, ElementsAre("a=2", "b=y"));
    const auto list = run::list_of("a, b\n# nothing\n1, [2,3]\n4, 5\n", "runs.txt");
    ASSERT_EQ(list.size(), 2U);
    EXPECT_THAT(list[0].overrides, ElementsAre("a=1", "b=[2,3]"));
    EXPECT_THROW(run::list_of("a,b\n1\n", "runs.txt"), CaseError);
}

TEST(SweepWords, AListMayComeFromASpreadsheetAndIsRefusedWithItsPlaceWhereItIsNone) {
    for (const std::string text : {"\xEF\xBB\xBF"
                                   "a,b.c\r\n1,2\r\n",
                                   "a;b.c\n1;2\n", "a\tb.c\n1\t2\n", "a,b.c\r1,2\r", "\"a\",\"b.c\"\n1,2\n"}) {
        const auto list = run::list_of(text, "runs.txt");
        ASSERT_EQ(list.size(), 1U) << text;
        EXPECT_THAT(list[0].overrides, ElementsAre("a=1", "b.c=2")) << text;
    }
    const auto problem = [](const std::string& text) {
        try {
            run::list_of(text, "runs.txt");
            return std::string("none");
        } catch (const CaseError& error) {
            return to_string(error.problems().at(0));
        }
    };
    using namespace std::string_literals;
    EXPECT_THAT(problem("a b\n1 2\n"), ::testing::StartsWith("runs.txt:1:1: 'a b' is no key"));
    EXPECT_THAT(problem("a,b,a\n1,2,3\n"), ::testing::StartsWith("runs.txt:1:5: 'a' stands twice"));
    EXPECT_THAT(problem("end, b, end_ms\n1,2,3\n"),
                ::testing::StartsWith("runs.txt:1:9: 'end' and 'end_ms' give one value"));
    EXPECT_THAT(problem("x.end,end_ms\n1,\n"), ::testing::StartsWith("runs.txt:2:3: no value of 'end_ms'"));
    EXPECT_THAT(problem("a,b\n1,2,3\n"), ::testing::StartsWith("runs.txt:2:5: 3 values for 2 keys"));
    EXPECT_THAT(problem("a,b\n1\n"), ::testing::StartsWith("runs.txt:2:1: 1 values for 2 keys"));
    // Was "0,5", which every run of the study refused.
    for (const std::string text : {"a;b\n1; 0,5\n", "a\tb\n1\t 0,5\n"}) {
        EXPECT_THAT(problem(text),
                    ::testing::StartsWith("runs.txt:2:4: '0,5' has a comma; numbers with decimal points"))
            << text;
    }
    EXPECT_EQ(problem("a;b\n1;[0,5]\n2;\"0,5\"\n"), "none");
    EXPECT_THAT(problem("a\n1\0.5\n"s), ::testing::StartsWith("runs.txt:2:2: a byte 0x00"));  // was read as 1
    EXPECT_THAT(problem("\x1F\x8B\x08"), ::testing::HasSubstr("is compressed (gzip)"));
}

TEST(SweepWords, AKeyIsVariedOnceAndNotSetToo) {
    EXPECT_THROW(run::grid_of({{"end", {"1"}}, {"end", {"2"}}}), CaseError);  // the first one went unread
    run::SweepOptions options;
    options.points = run::grid_of({{"end", {"1", "2"}}});
    options.overrides = {"end=3"};
    EXPECT_THROW(run::refuse_set_and_varied(options), CaseError);
    options.overrides = {"solid.skin=3"};
    EXPECT_NO_THROW(run::refuse_set_and_varied(options));
}

TEST(SweepWords, AKeyInAnotherSpellingIsTheSameKey) {
    // The value set for all runs went unread where the other spelling was varied.
    const TemporaryFolder folder;
    std::ofstream(folder / "case.toml") << "end = 1\n[[body]]\nname = 'a'\n[[body]]\nname = 'b.c'\n";
    run::SweepOptions options;
    options.case_path = folder / "case.toml";
    const auto is_refused = [&](const std::string& varied, const std::string& set) {
        options.points = run::grid_of({{varied, {"1", "2"}}});
        options.overrides = {set};
        try {
            run::refuse_set_and_varied(options);
            return false;
        } catch (const CaseError&) {
            return true;
        }
    };
    EXPECT_TRUE(is_refused("end", "end_ms=5"));
    EXPECT_TRUE(is_refused("end_s", "end_ms=5"));
    EXPECT_TRUE(is_refused("body.a.mass", "body.0.mass_t=5"));
    EXPECT_TRUE(is_refused("body.1.position", "body.b.c.position=[0,0,1]"));
    EXPECT_FALSE(is_refused("body.1.position", "body.a.position=[0,0,1]"));
    EXPECT_FALSE(is_refused("end", "time_step=1"));
    EXPECT_THROW(run::grid_of({{"end", {"1"}}, {"end_ms", {"2"}}}), CaseError);
    options.overrides = {};
    options.points = run::grid_of({{"body.0.mass", {"1"}}, {"body.a.mass", {"2"}}});
    EXPECT_THROW(run::refuse_set_and_varied(options), CaseError);
}

// `riprap resume STUDY` was answered by "start one with `riprap run CASE --out STUDY`".
TEST(SweepWords, TheFolderOfAStudyNamesTheRunsInIt) {
    const TemporaryFolder folder;
    EXPECT_EQ(run::runs_within(folder.path()), "");
    EXPECT_EQ(run::runs_within(folder.path() / "nothing"), "");
    for (const char* const name : {"run_002", "run_001", "tables"}) {
        std::filesystem::create_directories(folder.path() / name);
    }
    for (const char* const name : {"run_002", "run_001"}) {
        std::ofstream(folder.path() / name / "run.json") << "{}";
    }
    EXPECT_EQ(run::runs_within(folder.path()),
              "it holds 2 runs; give one of them, such as " + (folder.path() / "run_001").string());
    EXPECT_THROW(run::load_stored_case(run::RunFolder{folder.path()}), FileError);
}

TEST(SweepTables, RowsThatAFinishedRunHasLostMakeItUnreadable) {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder / "run_001");
    run::SweepOptions options;
    options.points = run::grid_of({{"end", {"1"}}});
    options.out = folder.path();
    std::ofstream(folder / "run_001/summary.json")
        << R"({"status": "finished", "reason": "", "wall_seconds": 1.0, "expects": [], "time": 1.0})";
    const auto status = [&](const std::string& rows) {
        std::ofstream(folder / "run_001/probes.csv") << rows;
        const std::string csv = run::sweep_csv(run::sweep_json(options));
        return csv.substr(csv.find("run_001,") + 8, 10);
    };
    EXPECT_EQ(status("time [s],x [m]\n0,1\n1,2\n"), "finished,1");
    for (const char* rows :
         {"time [s],x [m]\n0,1\n0.5,2\n", "time [s],x [m]\n0,1\n1,2", "time [s],x [m]\n", "time [s],x [m]\n0,1\n1,x2\n",
          "time [s],x [m]\n0,1;1\n1,2\n", "time [s],x [m]\n0,1\n2,3\n1,2\n", "time [s],x [m]\nnan,1\n1,2\n"}) {
        EXPECT_EQ(status(rows), "unreadable") << rows;
    }
    std::filesystem::remove(folder / "run_001/probes.csv");
    EXPECT_THAT(run::sweep_csv(run::sweep_json(options)), ::testing::HasSubstr("run_001,unreadable"));
}

TEST(SweepTables, ADamagedSummaryIsOneRunThatCannotBeRead) {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder / "run_001");
    run::SweepOptions options;
    options.case_path = "case.toml";
    options.points = run::grid_of({{"end", {"1"}}});
    options.out = folder.path();
    for (const char* text : {"{\"status\": ", "[1, 2]", ""}) {
        std::ofstream(folder / "run_001/summary.json") << text;
        EXPECT_THAT(run::sweep_csv(run::sweep_json(options)), ::testing::HasSubstr("run_001,unreadable")) << text;
    }
}

TEST(SweepTables, ASummaryThatSaysFinishedAndNoMoreIsNoFinishedRun) {
    const TemporaryFolder folder;
    run::SweepOptions options;
    options.case_path = "case.toml";
    options.points = run::grid_of({{"end", {"1", "2", "3"}}});
    options.out = folder.path();
    const std::string whole = R"({"status": "finished", "reason": "", "wall_seconds": 1.0, "expects": []})";
    const std::array<std::string, 3> texts{whole, R"({"status":"finished"})", R"({"status":"finished","expects":[]})"};
    for (std::size_t k = 0; k < texts.size(); ++k) {
        const std::string name = "run_00" + std::to_string(k + 1);
        std::filesystem::create_directories(folder / name);
        std::ofstream(folder / (name + "/summary.json")) << texts[k];
        std::ofstream(folder / (name + "/probes.csv")) << "time [s]\n0\n";
    }
    testing::internal::CaptureStdout();
    EXPECT_NE(run::gather_study(options), 0);
    EXPECT_THAT(testing::internal::GetCapturedStdout(), ::testing::HasSubstr("1 of 3 runs are finished"));
}

TEST(SweepTables, WhatIsMissingIsNeitherTheLeastNorTheLargestValueOfAColumn) {
    // The least value of a column that began empty was empty.
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder / "run_001");
    run::SweepOptions options;
    options.points = run::grid_of({{"end", {"1"}}});
    options.out = folder.path();
    const auto figures = [&](const std::string& rows) {
        std::ofstream(folder / "run_001/probes.csv") << "time [s],force [N]\n" << rows;
        const std::string csv = run::sweep_csv(run::sweep_json(options));
        const std::string row = csv.substr(csv.find('\n') + 1);
        return row.substr(row.find(",1,") + 3, row.rfind(',') - row.find(",1,") - 3);  // last, min, max
    };
    EXPECT_EQ(figures("0,\n1,5\n2,3\n3,4\n"), "4,3,5");
    EXPECT_EQ(figures("0,5\n1,\n2,3\n3,4\n"), "4,3,5");
    EXPECT_EQ(figures("0,-5\n1,-3\n2,\n"), ",-5,-3");
    EXPECT_EQ(figures("0,\n1,\n"), ",,");
}

}  // namespace
}  // namespace riprap
