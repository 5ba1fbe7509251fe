// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "cli/run_fixture.hpp"

namespace riprap {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class Runs : public RunFixture {};

TEST_F(Runs, ARunLeavesEverythingThatTheManualLists) {
    const Ending ending = run({"run", case_file(), "--out", out("a"), "--threads", "1"});
    EXPECT_EQ(ending.code, 0) << ending.err;
    for (const char* name : {"run.json", "case/case.toml", "resolved.toml", "run.log", "run.jsonl", "out.pvd",
                             "contacts.pvd", "probes.csv", "ledger.csv", "bodies.csv", "summary.json",
                             "checkpoint/latest", "frames/bodies_000000.vtp", "frames/contacts_000000.vtp"}) {
        EXPECT_TRUE(std::filesystem::exists(in("a", name))) << name;
    }
    const nlohmann::json summary = summary_of("a");
    EXPECT_EQ(summary.at("status"), "finished");
    EXPECT_EQ(summary.at("state_hash").get<std::string>().size(), 16U);
    EXPECT_EQ(summary.at("steps"), full_steps);
    EXPECT_GT(summary.at("time").get<double>(), 0.0);
    EXPECT_GT(summary.at("wall_seconds").get<double>(), 0.0);
    EXPECT_TRUE(summary.at("ledger").at("solid.kinetic").is_number());
    EXPECT_TRUE(summary.at("build").at("march").is_string());
    EXPECT_THAT(text_of(in("a", "probes.csv")), HasSubstr("time [s],high.displacement.x [m]"));
    EXPECT_THAT(ending.out, Not(HasSubstr("\r")));  // not a terminal: plain lines
    EXPECT_THAT(ending.out, HasSubstr("ns per body-step"));
}

// The dam break with floating blocks once stopped at its twelfth step: no test took it so far.
TEST_F(Runs, EveryExampleGetsThroughItsFirstStepsWithItsLedgerLookedAt) {
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator("cases")) {
        const std::string name = entry.path().filename().string();
        std::vector<std::string> words{
            "run",   entry.path().string(),       "--out", out(name), "--threads", "2", "--set", "max_steps=40",
            "--set", "output.probe_interval=1e-9"};
        if (name == "breakwater_3d") {  // whose settling takes a minute
            words.insert(words.end(), {"--set", "settle=0.5"});
        }
        const Ending ending = run(words);
        EXPECT_THAT(ending.code, ::testing::AnyOf(0, 1)) << name << ": " << ending.err;  // 1: its end is not reached
        EXPECT_EQ(summary_of(name).at("steps"), 40) << name;
        ++count;
    }
    EXPECT_GE(count, 10);
}

// The breakwater once lost a unit, and later ended in a pocket of water that its units closed; nobody ran it to its
// end.
TEST_F(Runs, EveryExampleGivesTheAnswersThatItExpects) {
    std::vector<std::string> names{"arch", "armour_unit", "breakwater", "dam_break", "hello_block", "sliding_block"};
    if (std::getenv("RIPRAP_FULL") != nullptr) {  // half an hour
        names.clear();
        for (const auto& entry : std::filesystem::directory_iterator("cases")) {
            names.push_back(entry.path().filename().string());
        }
    }
    const std::set<std::string> red{"ice_jam"};  // 0.1 % above its band downstream: water that is stirred swells
    for (const std::string& name : names) {
        const Ending ending = run({"run", "cases/" + name, "--out", out(name), "--threads", "2"});
        EXPECT_EQ(ending.code, red.contains(name) ? 1 : 0) << name << ": " << ending.out << ending.err;
    }
}

TEST_F(Runs, ARunStoppedByMaxStepsPredictsWhatTheWholeTakes) {
    const Ending ending =
        run({"run", "cases/floating_box", "--out", out("a"), "--threads", "1", "--end", "3.5", "--max-steps", "5"});
    EXPECT_THAT(ending.out, HasSubstr(" s, at most "));
    EXPECT_THAT(ending.out, HasSubstr("(sound in water)"));
    EXPECT_THAT(ending.out, HasSubstr("  5 steps to t = "));
    EXPECT_THAT(ending.out, Not(HasSubstr("to t = 0 s")));
    EXPECT_THAT(ending.out, HasSubstr("bodies take steps of their own within its steps"));
    EXPECT_THAT(ending.out, HasSubstr("ns per particle-step"));
    EXPECT_THAT(ending.out, HasSubstr("stopped by max_steps: "));
    EXPECT_THAT(ending.out, HasSubstr("predicted total "));
    const nlohmann::json summary = summary_of("a");
    const double per_step = summary.at("seconds_per_step"), total = summary.at("predicted_seconds");
    EXPECT_GT(per_step, 0);
    EXPECT_GT(total, 100 * per_step);  // the case takes thousands of steps
    EXPECT_GT(summary.at("particles").get<double>(), 0);
    EXPECT_LE(summary.at("time_step_min").get<double>(), summary.at("time_step_mean").get<double>());
    EXPECT_LE(summary.at("time_step_mean").get<double>(), summary.at("time_step_max").get<double>());
    EXPECT_THAT(text_of(in("a", "run.log")), HasSubstr("predicted total "));
    EXPECT_THAT(ending.out, HasSubstr("t = 3.5 s"));
    EXPECT_EQ(summary.at("status"), "interrupted");
    EXPECT_EQ(summary.at("reason"), "stopped by max_steps");
}

TEST_F(Runs, TheStepThatMeetsTheEndDoesNotCountAmongTheShortest) {
    ASSERT_EQ(run({"run", case_file(), "--out", out("a"), "--set", "time_step=\"auto\""}).code, 0);
    const nlohmann::json summary = summary_of("a");
    EXPECT_GT(summary.at("time_step_min").get<double>(), 0);
    EXPECT_NEAR(summary.at("time_step_mean").get<double>(),
                summary.at("time").get<double>() / summary.at("steps").get<double>(), 1e-15);
    EXPECT_NEAR(summary.at("predicted_seconds").get<double>(), summary.at("wall_seconds").get<double>(), 0.05);
}

TEST_F(Runs, ARunResumedAtAnyStepWithAnyThreadsIsTheSameRun) {
    const Whole whole = whole_run("1");
    for (const auto& [steps, threads] : {std::pair{"1", "2"}, {"37", "3"}, {"64", "1"}, {"200", "4"}}) {
        const std::string name = std::string("stopped_at_") + steps;
        ASSERT_EQ(run({"run", case_file(), "--out", out(name), "--set", std::string("max_steps=") + steps}).code, 0);
        ASSERT_EQ(summary_of(name).at("steps").dump(), steps);
        const Ending ending = run({"resume", out(name), "--max-steps", "-1", "--threads", threads});
        ASSERT_EQ(ending.code, 0) << ending.err;
        expect_same(whole, name);
    }
}

TEST_F(Runs, ARunTakenFurtherIsTheRunThatWentThereAtOnce) {
    ASSERT_EQ(run({"run", case_file(), "--out", out("short"), "--set", "end=0.03"}).code, 0);
    ASSERT_EQ(run({"resume", out("short"), "--end", "0.05"}).code, 0);
    ASSERT_EQ(run({"run", case_file(), "--out", out("long"), "--set", "end=0.05"}).code, 0);
    EXPECT_EQ(summary_of("short").at("state_hash"), summary_of("long").at("state_hash"));
}

TEST_F(Runs, ARunThatWasKilledBeforeItsFirstCheckpointGoesToTheEndThatResumeGives) {
    // It began again with the end of its case, said nothing and ended with 0.
    const auto begin_without_checkpoint = [this](const std::string& name) {
        ASSERT_EQ(run({"run", case_file(), "--out", out(name), "--set", "end=0.03", "--max-steps", "3"}).code, 0);
        for (const char* file : {"checkpoint/latest", "checkpoint/previous"}) {
            std::filesystem::remove(in(name, file));
        }
    };
    begin_without_checkpoint("steps");
    ASSERT_EQ(run({"resume", out("steps"), "--max-steps", "7"}).code, 0);
    EXPECT_EQ(summary_of("steps").at("steps"), 7);
    ASSERT_EQ(run({"resume", out("steps"), "--max-steps", "-1"}).code, 0);
    EXPECT_EQ(summary_of("steps").at("status"), "finished");

    begin_without_checkpoint("short");
    ASSERT_EQ(run({"resume", out("short"), "--end", "0.05", "--max-steps", "-1"}).code, 0);
    ASSERT_EQ(run({"run", case_file(), "--out", out("long"), "--set", "end=0.05"}).code, 0);
    EXPECT_EQ(summary_of("short").at("state_hash"), summary_of("long").at("state_hash"));
}

TEST_F(Runs, FoldersOfFramesAndCheckpointsThatWereRemovedAreMadeAgain) {
    ASSERT_EQ(run({"run", case_file(), "--out", out("whole"), "--set", "end=0.03"}).code, 0);
    for (const char* removed : {"frames", "checkpoint"}) {
        for (const bool is_named : {true, false}) {
            ASSERT_EQ(
                run({"run", case_file(), "--out", out("a"), "--force", "--set", "end=0.03", "--max-steps", "3"}).code,
                0);
            std::filesystem::remove_all(in("a", removed));
            const Ending ending = is_named ? run({"resume", out("a"), "--max-steps", "-1"})
                                           : run({"run", case_file(), "--out", out("a"), "--set", "end=0.03"});
            EXPECT_EQ(ending.code, 0) << removed << ending.err;
            EXPECT_EQ(summary_of("a").at("state_hash"), summary_of("whole").at("state_hash")) << removed;
        }
    }
}

TEST_F(Runs, TheLineOfABatchQueueJudgesARunThatWasTakenFurtherThanItsCase) {
    ASSERT_EQ(run({"run", case_file(), "--out", out("far"), "--set", "end=0.03"}).code, 0);
    ASSERT_EQ(run({"resume", out("far"), "--end", "0.05"}).code, 0);
    const Ending ending = run({"run", case_file(), "--out", out("far"), "--set", "end=0.03", "--resume"});
    EXPECT_EQ(ending.code, 0) << ending.err;
    EXPECT_THAT(ending.out, HasSubstr("nothing left to do"));
}

TEST_F(Runs, AFinishedRunHasNothingLeftToDo) {
    const Whole whole = whole_run("1");
    const Ending ending = run({"resume", out("whole")});
    EXPECT_EQ(ending.code, 0);
    EXPECT_THAT(ending.out, HasSubstr("nothing left to do"));
    expect_same(whole, "whole");
}

TEST_F(Runs, ARunThatMaxStepsHoldsSaysWhatLiftsIt) {
    ASSERT_EQ(run({"run", case_file(), "--out", out("held"), "--set", "max_steps=2"}).code, 0);
    const Ending ending = run({"resume", out("held"), "--end", "10"});
    EXPECT_EQ(ending.code, 0);
    EXPECT_THAT(ending.out, HasSubstr("max_steps = 2 holds it there, --max-steps -1 lifts it"));
}

TEST_F(Runs, AStopSignalWritesACheckpointAndTellsHowToContinue) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        const std::string name = "signal_" + std::to_string(signal);
        const Program program(folder.path(), {"run", case_file(), "--out", out(name), "--set", "end=10000"});
        wait_for_steps(name);
        program.send(signal);
        const Ending ending = program.wait();
        EXPECT_EQ(ending.code, 128 + signal);
        EXPECT_THAT(ending.err, HasSubstr("riprap resume"));
        EXPECT_EQ(summary_of(name).at("status"), "interrupted");
        // A run that was stopped reaches the same State as one that was not.
        const std::string steps = std::to_string(summary_of(name).at("steps").get<int>() + 20);
        ASSERT_EQ(run({"resume", out(name), "--max-steps", steps}).code, 0);
        ASSERT_EQ(run({"run", case_file(), "--out", out("straight"), "--force", "--set", "end=10000", "--set",
                       "max_steps=" + steps})
                      .code,
                  0);
        EXPECT_EQ(summary_of(name).at("state_hash"), summary_of("straight").at("state_hash"));
    }
}

TEST_F(Runs, ASecondSignalEndsAtOnceAndTheCheckpointStaysGood) {
    const Program program(folder.path(), {"run", case_file(), "--out", out("a"), "--set", "end=10000"});
    wait_for_steps("a");
    program.send(SIGINT);
    program.send(SIGTERM);
    const int code = program.wait().code;
    EXPECT_TRUE(code == 128 + SIGINT || code == 128 + SIGTERM) << code;
    EXPECT_EQ(run({"resume", out("a"), "--max-steps", "1"}).code, 0);  // reads it and has nothing left to do
}

TEST_F(Runs, ASignalThatTheParentPassesOnIsNoSecondOne) {
    // A queue signals all processes of a job, and the study that started this run passes it on: it ended at once,
    // without a checkpoint.
    const Program program(folder.path(), {"run", case_file(), "--out", out("a"), "--set", "end=10000"});
    wait_for_steps("a");
    program.send(SIGSTOP);
    const pid_t stranger = fork();
    if (stranger == 0) {
        program.send(SIGTERM);
        _exit(0);
    }
    waitpid(stranger, nullptr, 0);
    program.send(SIGINT);
    program.send(SIGCONT);
    const int code = program.wait().code;
    EXPECT_TRUE(code == 128 + SIGINT || code == 128 + SIGTERM) << code;
    EXPECT_EQ(summary_of("a").at("status"), "interrupted");
}

TEST_F(Runs, AnAbsurdStateEndsTheRunWithinOneStepAndTheLastGoodOneIsKept) {
    const Ending ending = run({"run", case_file(), "--out", out("a"), "--set", "solid.max_speed=1.2"});
    EXPECT_EQ(ending.code, 4);
    EXPECT_THAT(ending.err, AllOf(HasSubstr("velocity of high"), HasSubstr("last good state")));
    const nlohmann::json summary = summary_of("a");
    EXPECT_EQ(summary.at("status"), "failed");
    EXPECT_THAT(summary.at("reason").get<std::string>(), HasSubstr("high"));
    const std::string steps = summary.at("steps").dump();
    ASSERT_EQ(
        run({"run", case_file(), "--out", out("b"), "--set", "solid.max_speed=1.2", "--set", "max_steps=" + steps})
            .code,
        0);
    EXPECT_EQ(summary_of("b").at("state_hash"), summary.at("state_hash"));
    EXPECT_EQ(run({"resume", out("a")}).code, 4);
}

TEST_F(Runs, ContactsThatDoNotSettleCutTheStepAndThenEndTheRunWithTheirPair) {
    // One round of open and close settles no impact, however short the step is.
    const std::string falling = write_case("falling.toml", falling_blocks_text());
    const Ending ending = run({"run", falling, "--out", out("a"), "--set", "solid.method=\"implicit_dda\"", "--set",
                               "solid.open_close=1", "--set", "solid.step=\"1 ms\""});
    EXPECT_EQ(ending.code, 4) << ending.err;
    EXPECT_THAT(ending.out + ending.err, HasSubstr("is taken again"));
    EXPECT_THAT(ending.err, AllOf(HasSubstr("contacts of 'low' and 'high' open and close without end"),
                                  HasSubstr("last good state")));
    const nlohmann::json summary = summary_of("a");
    EXPECT_EQ(summary.at("status"), "failed");
    EXPECT_THAT(summary.at("reason").get<std::string>(), HasSubstr("contacts of 'low' and 'high'"));
    EXPECT_EQ(run({"resume", out("a")}).code, 4);
}

TEST_F(Runs, AnEnergyLedgerThatDoesNotCloseEndsTheRun) {
    const std::vector<std::string> words{"run",    case_file(), "--out",
                                         out("a"), "--set",     "output.ledger_tolerance=1e-9"};
    const Ending ending = run(words);
    EXPECT_EQ(ending.code, 4);
    EXPECT_THAT(ending.err, AllOf(HasSubstr("energy ledger"), HasSubstr("turned over at t = "), HasSubstr("J of")));
    EXPECT_EQ(summary_of("a").at("status"), "failed");
    EXPECT_EQ(run({"resume", out("a")}).code, 4);
    EXPECT_EQ(run({"run", case_file(), "--out", out("a"), "--resume", "--set", "output.ledger_tolerance=0.05"}).code,
              0);
}

TEST_F(Runs, ABodyInFreeFlightNeverFailsTheLedger) {
    // Nothing but round-off is turned over, and nothing but round-off is missing.
    const std::string flight = write_case("flight.toml", R"(
gravity   = [0, 0, 0]
end       = 0.1
time_step = 1e-4
[material.rock]
density          = 2500.0
normal_stiffness = "20 MPa"
[[body]]
name     = "block"
shape    = { box = [1.0, 0.8, 0.5] }
position = [1e3, 0, 0]
velocity = [3, 1, 0]
angular_velocity = [1, 2, 3]
material = "rock"
)");
    const Ending ending = run({"run", flight, "--out", out("flight"), "--set", "output.ledger_tolerance=1e-6"});
    EXPECT_EQ(ending.code, 0) << ending.err;
}

TEST_F(Runs, ExpectedAnswersDecideTheExitCode) {
    const std::string good = write_case("good.toml", case_text() + R"(
[[expect]]
name = "falls"
quantity = "lone.displacement.z"
value = -0.1
tolerance = 0.2
citation = "free fall"
)");
    const std::string bad = write_case("bad.toml", case_text() + R"(
[[expect]]
name = "rises"
quantity = "lone.displacement.z"
reduce = "max"
value = 1.0
tolerance = 0.1
citation = "none: blocks do not rise"
)");
    EXPECT_EQ(run({"run", good, "--out", out("good")}).code, 0);
    const Ending ending = run({"run", bad, "--out", out("bad")});
    EXPECT_EQ(ending.code, 1);
    EXPECT_THAT(ending.out, AllOf(HasSubstr("rises"), HasSubstr("failed")));
    EXPECT_EQ(summary_of("bad").at("expects").at(0).at("verdict"), "failed");
    EXPECT_EQ(run({"resume", out("bad")}).code, 1);
    EXPECT_EQ(run({"run", bad, "--out", out("early"), "--set", "max_steps=3"}).code, 0);
    EXPECT_EQ(summary_of("early").at("expects").at(0).at("verdict"), "not_judged");
}

}  // namespace
}  // namespace riprap
