// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "cli/run_fixture.hpp"
#include "riprap/run/study/sweep_slurm.hpp"

namespace riprap {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class SlurmStudy : public RunFixture {
 protected:
    Ending plan(const std::vector<std::string>& more = {}) const {
        std::vector<std::string> words{
            "sweep",    case_file(), "--out",         out("study"), "--vary", "end=0.005,0.01,0.02",
            "--submit", "slurm",     "--script-only", "--quiet"};
        words.insert(words.end(), more.begin(), more.end());
        return run(words);
    }
};

TEST(SlurmArray, NumbersAreWrittenAsRanges) {
    EXPECT_EQ(run::array_of({1, 2, 3, 7, 9, 10}), "1-3,7,9-10");
    EXPECT_EQ(run::array_of({4}), "4");
    EXPECT_EQ(run::array_of({}), "");
}

TEST_F(SlurmStudy, TheScriptsSayWhatTheClusterIsAskedForAndNothingRuns) {
    const Ending ending = plan({"--partition", "long", "--account", "rock", "--time", "2:00:00", "--memory", "4G",
                                "--jobs", "2", "--threads", "3"});
    ASSERT_EQ(ending.code, 0) << ending.err;
    EXPECT_THAT(
        text_of(in("study", "slurm_task.sh")),
        AllOf(HasSubstr("#SBATCH --partition=long\n"), HasSubstr("#SBATCH --account=rock\n"),
              HasSubstr("#SBATCH --time=2:00:00\n"), HasSubstr("#SBATCH --mem=4G\n"),
              HasSubstr("#SBATCH --cpus-per-task=3\n"), HasSubstr("#SBATCH --requeue\n"), HasSubstr("--point")));
    EXPECT_THAT(text_of(in("study", "slurm_submit.sh")), AllOf(HasSubstr("--array=1-3%2 "), HasSubstr("afterany")));
    EXPECT_FALSE(std::filesystem::exists(in("study", "run_001")));
}

TEST_F(SlurmStudy, ATaskRunsOneRunAndTheGatheringMakesTheTables) {
    ASSERT_EQ(plan().code, 0);
    ASSERT_EQ(run({"sweep", "--out", out("study"), "--point", "2"}).code, 0);
    EXPECT_EQ(summary_of("study/run_002").at("status"), "finished");
    EXPECT_FALSE(std::filesystem::exists(in("study", "run_001")));
    const Ending partly = run({"sweep", "--out", out("study"), "--gather"});
    EXPECT_EQ(partly.code, 1);
    EXPECT_THAT(partly.err, AllOf(HasSubstr("run_001"), HasSubstr("run_003"), Not(HasSubstr("run_002"))));
    EXPECT_THAT(partly.out, HasSubstr("1 of 3 runs are finished"));
    const std::string before = text_of(in("study/run_002", "run.jsonl"));
    for (const char* number : {"1", "2", "3"}) {
        EXPECT_EQ(run({"sweep", "--out", out("study"), "--point", number}).code, 0);
    }
    EXPECT_EQ(text_of(in("study/run_002", "run.jsonl")), before);  // a run that is finished is not run again
    EXPECT_EQ(run({"sweep", "--out", out("study"), "--gather"}).code, 0);
    EXPECT_THAT(text_of(in("study", "sweep.csv")), HasSubstr("run_003,finished,0.02"));
    EXPECT_THAT(text_of(in("study", "index.html")), HasSubstr("run_003"));
}

TEST_F(SlurmStudy, ARunThatIsFinishedIsNotHandedInAgain) {
    ASSERT_EQ(plan().code, 0);
    ASSERT_EQ(run({"sweep", "--out", out("study"), "--point", "2"}).code, 0);
    ASSERT_EQ(plan().code, 0);
    EXPECT_THAT(text_of(in("study", "slurm_submit.sh")), HasSubstr("--array=1,3 "));
}

TEST_F(SlurmStudy, AStudyLongerThanAnArrayBecomesSeveral) {
    run::SweepOptions options;
    options.out = out("long");
    std::filesystem::create_directories(options.out);
    for (int k = 1; k <= 25; ++k) {
        options.points.push_back({"run_" + std::to_string(k), {}});
    }
    run::SlurmOptions slurm;
    slurm.largest_index = 10;
    const run::SlurmScripts scripts = run::write_slurm_scripts(options, slurm);
    EXPECT_THAT(text_of(scripts.submit.string()), AllOf(HasSubstr("--array=1-10 --export=ALL,RIPRAP_FIRST=0 "),
                                                        HasSubstr("--array=1-10 --export=ALL,RIPRAP_FIRST=10 "),
                                                        HasSubstr("--array=1-5 --export=ALL,RIPRAP_FIRST=20 ")));
}

TEST_F(SlurmStudy, WhatDoesNotGoTogetherIsRefused) {
    EXPECT_EQ(run({"sweep", "--point", "1"}).code, 2);
    EXPECT_EQ(run({"sweep", "--out", out("study"), "--point", "1", "--gather"}).code, 2);
    EXPECT_EQ(run({"sweep", case_file(), "--out", out("study"), "--gather"}).code, 2);
    EXPECT_EQ(run({"sweep", case_file(), "--vary", "end=1", "--time", "1:00"}).code, 2);
    EXPECT_EQ(run({"sweep", "--vary", "end=1"}).code, 2);
    EXPECT_EQ(run({"sweep", "--out", out("nothing"), "--gather"}).code, 5);
    EXPECT_EQ(plan({"--partition", "long\nrm"}).code, 5);
    ASSERT_EQ(plan().code, 0);
    const Ending ending = run({"sweep", "--out", out("study"), "--point", "4"});
    EXPECT_EQ(ending.code, 5);
    EXPECT_THAT(ending.err, HasSubstr("has runs 1 to 3"));
}

/// Stands for the programs of a cluster that takes all.
class SlurmCluster : public SlurmStudy {
 protected:
    SlurmCluster() {
        write_program("sbatch", "echo \"$@\" >>" + out("asked") + "\necho $(($(wc -l <" + out("asked") + ") + 40))");
        write_program("squeue", "cat " + out("queue") + " 2>/dev/null\ntrue");
        write_program("scontrol", "echo 'MaxArraySize            = 3'");
        setenv("PATH", (folder.path().string() + ":/usr/bin:/bin").c_str(), 1);
    }
    void write_program(const std::string& name, const std::string& text) const {
        write_file(name, "#!/bin/bash\n" + text + "\n");
        std::filesystem::permissions(out(name), std::filesystem::perms::owner_all);
    }
    Ending hand_in(const std::vector<std::string>& more = {}) const {
        std::vector<std::string> words{"sweep",  case_file(),           "--out",    out("study"),
                                       "--vary", "end=0.005,0.01,0.02", "--submit", "slurm"};
        words.insert(words.end(), more.begin(), more.end());
        return run(words);
    }
};

TEST_F(SlurmCluster, GetsArraysOfAtMostItsSizeAndTheTablesAfterThem) {
    const Ending ending = hand_in();
    EXPECT_EQ(ending.code, 0) << ending.err;
    EXPECT_THAT(ending.out, AllOf(HasSubstr("3 runs; by its first steps run_001 takes"), HasSubstr("jobs 41,42,43")));
    EXPECT_EQ(text_of(out("asked")),
              "--parsable --array=1-2 --export=ALL,RIPRAP_FIRST=0 slurm_task.sh\n"
              "--parsable --array=1 --export=ALL,RIPRAP_FIRST=2 slurm_task.sh\n"
              "--parsable --dependency=afterany:41:42 slurm_gather.sh\n");
}

TEST_F(SlurmCluster, DoesNotGetAStudyTwiceAtATime) {
    ASSERT_EQ(hand_in({"--quiet"}).code, 0);
    write_file("queue", "7\n41\n");
    const Ending ending = hand_in({"--quiet"});
    EXPECT_EQ(ending.code, 5);
    EXPECT_THAT(ending.err, AllOf(HasSubstr("the study is under way: jobs 41,42,43"), HasSubstr("not handed in")));
    write_file("queue", "7\n4\n410\n");  // jobs of other studies
    EXPECT_EQ(hand_in({"--quiet"}).code, 0);
}

TEST_F(SlurmCluster, DoesNotGetAStudyThatItMayRunWhileItsControllerIsAway) {
    // An empty answer of `squeue` was taken for no jobs, and the numbers of those that waited were written over.
    ASSERT_EQ(hand_in({"--quiet"}).code, 0);
    write_program("squeue", "exit 1");
    const Ending ending = hand_in({"--quiet"});
    EXPECT_EQ(ending.code, 5);
    EXPECT_THAT(ending.err, HasSubstr("Slurm does not answer; jobs 41,42,43 may be under way"));
    EXPECT_EQ(text_of(in("study", "slurm_jobs")), "41\n42\n43\n");
}

TEST_F(SlurmCluster, IsMissedWhereThereIsNone) {
    write_program("sbatch", "exit 127");  // as a shell that finds none
    const Ending ending = hand_in({"--quiet"});
    EXPECT_EQ(ending.code, 5);
    EXPECT_THAT(ending.err, HasSubstr("there is no sbatch on this machine"));
}

TEST_F(SlurmCluster, GetsAStudyWhoseFirstRunIsRefused) {
    const Ending ending =
        run({"sweep", case_file(), "--out", out("study"), "--vary", "end=-1,0.01", "--submit", "slurm"});
    EXPECT_EQ(ending.code, 0) << ending.err;
    EXPECT_THAT(ending.out, AllOf(HasSubstr("the first is refused"), HasSubstr("jobs 41,42")));
}

TEST_F(SlurmStudy, AnEnsembleIsAStudyWhoseTablesAreThoseOfMembersThatRanHere) {
    const std::string spread = case_text() + "\n[[spread]]\nkey = \"end\"\nlow = 0.005\nhigh = 0.02\n";
    const std::string file = write_case("spread.toml", spread);
    const auto ensemble = [&](const std::string& place, const std::vector<std::string>& more) {
        std::vector<std::string> words{"run", file, "--ensemble", "3", "--quiet", "--out", out(place)};
        words.insert(words.end(), more.begin(), more.end());
        return run(words).code;
    };
    ASSERT_EQ(ensemble("one", {"--jobs", "1"}), 0);
    ASSERT_EQ(ensemble("beside", {"--jobs", "2"}), 0);
    ASSERT_EQ(ensemble("cluster", {"--submit", "slurm", "--script-only"}), 0);
    EXPECT_THAT(text_of(in("cluster", "slurm_submit.sh")), HasSubstr("--array=1-3 "));
    EXPECT_EQ(run({"sweep", "--out", out("cluster"), "--gather"}).code, 1);
    for (const char* number : {"2", "3", "1"}) {
        EXPECT_EQ(run({"sweep", "--out", out("cluster"), "--point", number, "--quiet"}).code, 0);
    }
    EXPECT_EQ(run({"sweep", "--out", out("cluster"), "--gather"}).code, 0);
    for (const char* place : {"beside", "cluster"}) {
        for (const char* table : {"ensemble.csv", "bands.csv"}) {
            EXPECT_EQ(text_of(in(place, table)), text_of(in("one", table))) << place << '/' << table;
        }
        for (const char* member : {"member-1", "member-2", "member-3"}) {
            EXPECT_EQ(summary_of(std::string(place) + '/' + member).at("state_hash"),
                      summary_of(std::string("one/") + member).at("state_hash"));
        }
        EXPECT_THAT(text_of(in(place, "index.html")), HasSubstr("member-3"));
    }
}

TEST_F(SlurmStudy, AnEnsembleTakesNoFolderOfAStudyNorAStudyThatOfAnEnsemble) {
    ASSERT_EQ(plan().code, 0);
    const std::string file =
        write_case("spread.toml", case_text() + "\n[[spread]]\nkey = \"end\"\nlow = 0.005\nhigh = 0.02\n");
    EXPECT_EQ(run({"run", file, "--ensemble", "2", "--quiet", "--out", out("study")}).code, 5);
    ASSERT_EQ(run({"run", file, "--ensemble", "2", "--quiet", "--out", out("members")}).code, 0);
    EXPECT_EQ(run({"sweep", file, "--vary", "end=0.01", "--quiet", "--out", out("members")}).code, 5);
    EXPECT_EQ(run({"run", file, "--jobs", "2", "--out", out("other")}).code, 2);
    EXPECT_EQ(run({"run", file, "--submit", "slurm", "--out", out("other")}).code, 2);
}

TEST_F(SlurmStudy, APlanSaysWhatItWouldTakeAndWritesNothing) {
    const Ending ending = run({"sweep", case_file(), "--vary", "end=0.005,0.01", "--out", out("later"), "--plan"});
    EXPECT_EQ(ending.code, 0) << ending.err;
    EXPECT_THAT(ending.out, AllOf(HasSubstr("run_002  end=0.01"), HasSubstr("2 runs; by its first steps run_001 takes"),
                                  HasSubstr("run at a time")));
    EXPECT_FALSE(std::filesystem::exists(out("later")));
    EXPECT_EQ(run({"sweep", case_file(), "--vary", "end=1", "--plan", "--submit", "slurm"}).code, 2);
}

/// Speaks to a task as Slurm does, with a run that obeys or is at its end in place of the program.
class SlurmTask : public SlurmStudy {
 protected:
    /// Runs slurm_task.sh, sends it signals one after another. @returns whether it asked to be queued again
    bool is_queued_again(const std::string& program, const std::string& signals) const {
        EXPECT_EQ(plan({"--quiet"}).code, 0);
        std::string task = text_of(in("study", "slurm_task.sh"));
        const std::size_t call = task.find("' sweep "), begin = task.rfind('\'', call - 1);
        task.replace(begin, call + 1 - begin, "'" + out("program") + "'");
        write_script("task", task);
        write_script("program", "#!/bin/bash\n" + program);
        write_script("scontrol", "#!/bin/bash\ntouch " + out("queued_again") + "\n");
        const std::string command =
            "cd " + folder.path().string() + " && export PATH=$PWD:$PATH SLURM_ARRAY_TASK_ID=1 " +
            "SLURM_JOB_ID=7; ./task & task=$!; until [ -e started ]; do sleep 0.05; done; for s in " + signals +
            "; do kill -$s $task; sleep 0.1; done; wait $task";
        EXPECT_EQ(std::system(("bash -c '" + command + "' >/dev/null 2>&1").c_str()) & 0x7f, 0);
        return std::filesystem::exists(out("queued_again"));
    }
    void write_script(const std::string& name, const std::string& text) const {
        write_file(name, text);
        std::filesystem::permissions(out(name), std::filesystem::perms::owner_all);
    }
    const std::string obedient_ = "trap 'exit 143' TERM\ntouch started\nfor i in $(seq 100); do sleep 0.05; done\n";
};

TEST_F(SlurmTask, ARunOutOfTimeIsQueuedAgain) { EXPECT_TRUE(is_queued_again(obedient_, "USR1")); }

TEST_F(SlurmTask, ARunThatIsCancelledStaysStopped) { EXPECT_FALSE(is_queued_again(obedient_, "TERM")); }

TEST_F(SlurmTask, ARunThatIsCancelledWhenItsTimeIsUpStaysStopped) {
    EXPECT_FALSE(is_queued_again(
        "trap 'sleep 0.5; exit 143' TERM\ntouch started\nfor i in $(seq 100); do sleep 0.05; done\n", "USR1 TERM"));
}

TEST_F(SlurmTask, ARunThatEndsAsItsTimeIsUpIsNotQueuedAgain) {
    EXPECT_FALSE(
        is_queued_again("trap 'exit 0' TERM\ntouch started\nfor i in $(seq 100); do sleep 0.05; done\n", "USR1"));
}

}  // namespace
}  // namespace riprap
