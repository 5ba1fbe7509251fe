// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/run_fixture.hpp"

namespace riprap {
namespace {

using ::testing::HasSubstr;

class Sweep : public RunFixture {
 protected:
    Ending sweep(const std::vector<std::string>& more) const {
        std::vector<std::string> words{"sweep", case_file(), "--out", out("study"), "--jobs", "2"};
        words.insert(words.end(), more.begin(), more.end());
        return run(words);
    }
};

TEST_F(Sweep, RunsEveryPointIntoOneTableAndOnePage) {
    const Ending ending = sweep({"--vary", "end=0.005,0.01,0.02"});
    EXPECT_EQ(ending.code, 0) << ending.err;
    const nlohmann::json study = nlohmann::json::parse(text_of(in("study", "sweep.json")));
    ASSERT_EQ(study.at("runs").size(), 3U);
    EXPECT_EQ(study.at("runs")[1].at("set").at("end"), "0.01");
    EXPECT_EQ(study.at("runs")[2].at("status"), "finished");
    EXPECT_THAT(text_of(in("study", "sweep.csv")), HasSubstr("run,status,end,"));
    EXPECT_THAT(text_of(in("study", "index.html")), HasSubstr("run_003"));
    const auto summary = nlohmann::json::parse(text_of(in("study", "run_001/summary.json")));
    EXPECT_THAT(text_of(in("study", "index.html")), HasSubstr("\"title\":" + summary.at("title").dump()));
    EXPECT_EQ(text_of(in("study", "index.html")).find("http://") == std::string::npos ||
                  text_of(in("study", "index.html")).find("http://www.w3.org") != std::string::npos,
              true);
}

TEST_F(Sweep, TheSameCommandAgainLeavesFinishedRunsAndGoesOnWithTheOthers) {
    ASSERT_EQ(sweep({"--vary", "end=0.005,0.01"}).code, 0);
    const std::string before = text_of(in("study/run_001", "run.jsonl"));
    std::filesystem::remove_all(in("study", "run_002"));
    const Ending again = sweep({"--vary", "end=0.005,0.01"});
    EXPECT_EQ(again.code, 0) << again.err;
    EXPECT_THAT(again.out, HasSubstr("run_001  end=0.005  finished before"));
    EXPECT_EQ(text_of(in("study/run_001", "run.jsonl")), before);
    EXPECT_EQ(summary_of("study/run_002").at("status"), "finished");
    EXPECT_EQ(sweep({"--vary", "end=0.005,0.03"}).code, 5);  // another study
}

TEST_F(Sweep, AKeyThatNoRunCanHaveIsToldBeforeAnythingIsWritten) {
    const Ending ending = sweep({"--vary", "body.lone.masss=1,2"});
    EXPECT_EQ(ending.code, 3);
    EXPECT_THAT(ending.err, HasSubstr("did you mean 'mass'?"));
    EXPECT_FALSE(std::filesystem::exists(out("study")));
}

TEST_F(Sweep, ARunThatFailsIsInTheTableAndDoesNotStopTheOthers) {
    const Ending ending = sweep({"--vary", "end=-1,0.005"});
    EXPECT_EQ(ending.code, 3);
    const nlohmann::json study = nlohmann::json::parse(text_of(in("study", "sweep.json")));
    EXPECT_EQ(study.at("runs")[0].at("status"), "not run");
    EXPECT_EQ(study.at("runs")[1].at("status"), "finished");
}

}  // namespace
}  // namespace riprap
