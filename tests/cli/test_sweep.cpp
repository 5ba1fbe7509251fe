// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sys/file.h>

#include "cli/run_fixture.hpp"
#include "riprap/core/timer.hpp"

namespace riprap {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class Sweep : public RunFixture {
 protected:
    /// A study of three runs, two at a time, each of some seconds.
    std::vector<std::string> long_study() const {
        return {"sweep", case_file(), "--out",   out("study"), "--jobs",
                "2",     "--set",     "end=0.5", "--vary",     "solid.max_speed=80,90,100"};
    }
    /// Waits until all processes have let the folders of the runs go. @returns how long [s]
    double wait_until_free() const {
        const Timer timer;
        for (const char* name : {"study/run_001", "study/run_002", "study/run_003"}) {
            const int lock = open(in(name, ".lock").c_str(), O_RDONLY);
            while (lock >= 0 && flock(lock, LOCK_EX | LOCK_NB) != 0 && timer.seconds() < 60) {
                std::this_thread::sleep_for(std::chrono::milliseconds(5));
            }
            close(lock);
        }
        return timer.seconds();
    }
    /// Goes on with the study; its runs end as if they had never been stopped.
    void expect_whole() const {
        const Ending again = run(long_study());
        EXPECT_EQ(again.code, 0) << again.out << again.err;
        ASSERT_EQ(run({"run", case_file(), "--out", out("straight"), "--force", "--set", "end=0.5", "--set",
                       "solid.max_speed=80"})
                      .code,
                  0);
        for (const char* name : {"study/run_001", "study/run_002", "study/run_003"}) {
            EXPECT_EQ(summary_of(name).at("status"), "finished") << name;
            EXPECT_EQ(summary_of(name).at("state_hash"), summary_of("straight").at("state_hash")) << name;
        }
    }
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

TEST_F(Sweep, AStopSignalReachesTheRunsAtOnceAndNothingIsLeftRunning) {
    // The sweep waited for a run to end before it looked at the signal.
    for (const int signal : {SIGTERM, SIGINT, SIGHUP}) {
        std::filesystem::remove_all(out("study"));
        const Program program(folder.path(), long_study());
        wait_for_steps("study/run_001");
        wait_for_steps("study/run_002");
        const Timer timer;
        program.send(signal);
        const Ending ending = program.wait();
        EXPECT_LT(timer.seconds(), 2);
        EXPECT_EQ(ending.code, 128 + signal) << ending.err;
        EXPECT_LT(wait_until_free(), 0.1);
        EXPECT_EQ(summary_of("study/run_001").at("status"), "interrupted");
        EXPECT_GE(summary_of("study/run_001").at("steps"), 1);
        EXPECT_FALSE(std::filesystem::exists(in("study", "run_003")));
    }
    expect_whole();
}

TEST_F(Sweep, CtrlCIsOneSignalForEveryRun) {
    const Program program(folder.path(), long_study(), [] { setpgid(0, 0); });
    wait_for_steps("study/run_001");
    wait_for_steps("study/run_002");
    kill(-program.number(), SIGINT);  // as a terminal does
    EXPECT_EQ(program.wait().code, 128 + SIGINT);
    EXPECT_EQ(summary_of("study/run_001").at("status"), "interrupted");
    EXPECT_EQ(summary_of("study/run_002").at("status"), "interrupted");
}

TEST_F(Sweep, OneThatIsKilledLeavesNoRunBehindAndGoesOn) {
    for (const int second : {SIGKILL, SIGTERM}) {
        std::filesystem::remove_all(out("study"));
        const Program program(folder.path(), long_study());
        wait_for_steps("study/run_001");
        wait_for_steps("study/run_002");
        if (second == SIGTERM) {
            program.send(SIGTERM);  // an impatient user
        }
        program.send(second);
        program.wait();
        // The same command at once: its runs wait for those that are about to end.
        expect_whole();
    }
}

TEST_F(Sweep, ADamagedFileOfOneRunIsToldAndTheOthersStayInTheTable) {
    struct Damage {
        const char *file, *text;
    };
    for (const Damage& damage : {Damage{"summary.json", "[]"},
                                 {"summary.json", "{\"status\": 7}"},
                                 {"summary.json", ""},
                                 {"summary.json", "{\"status\": \"finished\", \"expects\": {}}"},
                                 {"probes.csv", "x,y"},
                                 {"probes.csv", ""},
                                 {"probes.csv", "time [s],a [m]\n0,1\n0.001"},
                                 {"run.json", "{}"}}) {
        std::filesystem::remove_all(out("study"));
        ASSERT_EQ(sweep({"--vary", "end=0.005,0.01"}).code, 0);
        write_file(std::string("study/run_001/") + damage.file, damage.text);
        const Ending told = sweep({"--vary", "end=0.005,0.01"});
        const std::string why = std::string(damage.file) + " = " + damage.text + told.out + told.err;
        if (std::string(damage.file) == "run.json") {
            EXPECT_EQ(told.code, 0) << why;  // the run is finished, and nothing reads it
            continue;
        }
        EXPECT_EQ(told.code, 5) << why;
        EXPECT_THAT(told.err, AllOf(HasSubstr("run_001"), HasSubstr(damage.file), HasSubstr("remove the folder")))
            << why;
        const nlohmann::json study = nlohmann::json::parse(text_of(in("study", "sweep.json")));
        EXPECT_EQ(study.at("runs")[0].at("status"), "unreadable") << why;
        EXPECT_EQ(study.at("runs")[1].at("status"), "finished") << why;
        std::filesystem::remove_all(in("study", "run_001"));  // the remedy of the message
        EXPECT_EQ(sweep({"--vary", "end=0.005,0.01"}).code, 0) << why;
    }
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
