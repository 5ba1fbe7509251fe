// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

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
        const Ending ending = run({"run", entry.path().string(), "--out", out(name), "--threads", "2", "--set",
                                   "max_steps=40", "--set", "output.probe_interval=1e-9"});
        EXPECT_THAT(ending.code, ::testing::AnyOf(0, 1)) << name << ": " << ending.err;  // 1: its end is not reached
        EXPECT_EQ(summary_of(name).at("steps"), 40) << name;
        ++count;
    }
    EXPECT_GE(count, 10);
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
        // What was stopped goes on to the same State as what was not.
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

TEST_F(Runs, NothingIsWrittenOverUnasked) {
    ASSERT_EQ(run({"run", case_file(), "--out", out("a"), "--set", "max_steps=3"}).code, 0);
    EXPECT_EQ(run({"run", case_file(), "--out", out("a")}).code, 0);  // goes on where max_steps stopped it
    const std::string before = text_of(in("a", "summary.json"));
    const Ending again = run({"run", case_file(), "--out", out("a")});
    EXPECT_EQ(again.code, 5);
    EXPECT_THAT(again.err, HasSubstr("--force"));
    EXPECT_EQ(text_of(in("a", "summary.json")), before);

    std::filesystem::create_directories(out("mine"));
    write_file("mine/thesis.txt", "years of work");
    EXPECT_EQ(run({"run", case_file(), "--out", out("mine")}).code, 5);
    EXPECT_EQ(run({"run", case_file(), "--out", out("mine"), "--set", "max_steps=3", "--force"}).code, 0);
    EXPECT_EQ(text_of(in("mine", "thesis.txt")), "years of work");

    EXPECT_EQ(run({"run", in("mine", "case/case.toml"), "--out", out("mine"), "--force"}).code, 5);
    EXPECT_TRUE(std::filesystem::exists(in("mine", "case/case.toml")));
}

TEST_F(Runs, FilesWithTheNamesOfARunAreTheUsersWhereNoRunWroteThem) {
    // A folder that held a user's own case/, frames/ and bodies.csv was emptied of them without a word.
    const std::vector<std::string> mine{"case/notes.txt", "frames/photo.png", "checkpoint/latest", "bodies.csv"};
    const auto expect_untouched = [&](const std::string& name, const std::vector<std::string>& options) {
        std::vector<std::string> words{"run", case_file(), "--out", out(name), "--set", "max_steps=3"};
        words.insert(words.end(), options.begin(), options.end());
        const Ending ending = run(words);
        EXPECT_EQ(ending.code, 5) << ending.out;
        EXPECT_THAT(ending.err, HasSubstr("--out"));
        for (const std::string& file : mine) {
            EXPECT_EQ(text_of(in(name, file)), "years of work") << file;
        }
    };
    for (const char* ticket : {"", "{\"run\": \"of another program\"}", "[1, 2"}) {
        for (const char* part : {"case", "frames", "checkpoint"}) {
            std::filesystem::create_directories(in("mine", part));
        }
        for (const std::string& file : mine) {
            write_file("mine/" + file, "years of work");
        }
        if (*ticket != 0) {
            write_file("mine/run.json", ticket);
        }
        expect_untouched("mine", {});
        expect_untouched("mine", {"--resume"});
        expect_untouched("mine", {"--force"});
        EXPECT_EQ(text_of(in("mine", "run.json")), ticket);
    }
}

TEST_F(Runs, ARunThatWasKilledWhileItWasPutInPlaceIsBegunAgain) {
    ASSERT_EQ(run({"run", case_file(), "--out", out("a"), "--set", "max_steps=3"}).code, 0);
    EXPECT_FALSE(std::filesystem::exists(in("a", ".riprap_starting")));
    // As between removing the old ticket and writing the new one.
    write_file("a/.riprap_starting", "");
    std::filesystem::remove(in("a", "run.json"));
    for (const char* option : {"--resume", "--quiet"}) {
        EXPECT_EQ(run({"run", case_file(), "--out", out("b"), "--set", "max_steps=3"}).code, 0);
        std::filesystem::remove_all(out("c"));
        std::filesystem::copy(out("a"), out("c"), std::filesystem::copy_options::recursive);
        EXPECT_EQ(run({"run", case_file(), "--out", out("c"), "--set", "max_steps=3", option}).code, 0);
        EXPECT_EQ(summary_of("c").at("state_hash"), summary_of("b").at("state_hash"));
        EXPECT_FALSE(std::filesystem::exists(in("c", ".riprap_starting")));
        std::filesystem::remove_all(out("b"));
    }
}

TEST_F(Runs, ABadCaseTouchesNoRun) {
    ASSERT_EQ(run({"run", case_file(), "--out", out("a"), "--set", "max_steps=3"}).code, 0);
    const std::string before = text_of(in("a", "summary.json"));
    const std::string bad = write_case("bad.toml", case_text() + "\nnonsense = 1\n");
    EXPECT_EQ(run({"run", bad, "--out", out("a"), "--force"}).code, 3);
    EXPECT_EQ(text_of(in("a", "summary.json")), before);
    EXPECT_EQ(run({"run", "no_such_case", "--out", out("b")}).code, 5);
    EXPECT_FALSE(std::filesystem::exists(out("b")));
}

TEST_F(Runs, OneFolderBelongsToOneProcess) {
    const Program program(folder.path(), {"run", case_file(), "--out", out("a"), "--set", "end=10000"});
    wait_for_steps("a");
    const TemporaryFolder elsewhere;
    const Ending second = run_program(elsewhere.path(), {"resume", out("a")});
    program.send(SIGTERM);
    program.wait();
    EXPECT_EQ(second.code, 5);
    EXPECT_THAT(second.err, HasSubstr("another riprap"));
}

TEST_F(Runs, ACaseThatIsNoRegularFileIsRefusedWithoutWaitingForIt) {
    ASSERT_EQ(mkfifo(out("pipe.toml").c_str(), 0600), 0);
    for (const std::string& file : {out("pipe.toml"), std::string("/dev/zero"), std::string("/dev/tty")}) {
        for (const char* command : {"run", "check"}) {
            const Ending ending = Program(folder.path(), {command, file}, [] { alarm(20); }).wait();
            EXPECT_EQ(ending.code, 5) << file;
            EXPECT_THAT(ending.err, HasSubstr("regular file")) << file;
        }
    }
}

TEST_F(Runs, AnUnwritablePlaceIsNamed) {
    write_file("file", "x");
    EXPECT_EQ(run({"run", case_file(), "--out", out("file")}).code, 5);
    const Ending ending = run({"run", case_file(), "--out", "/proc/riprap"});
    EXPECT_EQ(ending.code, 5);
    EXPECT_THAT(ending.err, AllOf(HasSubstr("/proc/riprap"), HasSubstr("check that the path exists")));
}

/// Gives up the rights of an administrator, who may write anywhere.
void become_nobody() {
    if (geteuid() == 0 && (setgid(65534) != 0 || setuid(65534) != 0)) {
        _exit(126);
    }
}

TEST_F(Runs, AFolderThatMayNotBeEnteredOrWrittenIsNamed) {
    // Was "internal error, please report it" with 70: asking whether a file exists throws where a folder is locked.
    std::filesystem::permissions(folder.path(),
                                 std::filesystem::perms::others_exec | std::filesystem::perms::others_read,
                                 std::filesystem::perm_options::add);
    for (const auto& [name, mode] : {std::pair{"locked", 0000}, {"sealed", 0555}}) {
        std::filesystem::create_directories(in(name, "inside"));
        ASSERT_EQ(chmod(out(name).c_str(), static_cast<mode_t>(mode)), 0);
        for (const std::string& place : {out(name), in(name, "a"), in(name, "a/b")}) {
            const Ending ending =
                Program(folder.path(), {"run", case_file(), "--force", "--out", place}, become_nobody).wait();
            if (ending.code == 126 || ending.code == 127) {
                GTEST_SKIP() << "the program cannot be started with fewer rights here";
            }
            EXPECT_EQ(ending.code, 5) << place << ending.err;
            EXPECT_THAT(ending.err, AllOf(HasSubstr(name), HasSubstr("ermission"), HasSubstr("--out"))) << place;
        }
        ASSERT_EQ(chmod(out(name).c_str(), 0755), 0);
    }
}

TEST_F(Runs, AFileLimitStopsTheRunWithItsNameAndNothingIsLost) {
    const Whole whole = whole_run("1");
    const Ending ending =
        Program(folder.path(), {"run", case_file(), "--out", out("a")}, [] { limit_file_size(20'000); }).wait();
    EXPECT_EQ(ending.code, 5);
    EXPECT_THAT(ending.err, AllOf(HasSubstr(".csv"), HasSubstr("ulimit -f")));
    ASSERT_EQ(run({"resume", out("a")}).code, 0);
    expect_same(whole, "a");
}

TEST_F(Runs, DamagedAndForeignCheckpointsAreRefusedWithSix) {
    ASSERT_EQ(run({"run", case_file(), "--out", out("a"), "--set", "max_steps=3"}).code, 0);
    ASSERT_EQ(run({"run", case_file(), "--out", out("b"), "--set", "max_steps=3", "--set", "gravity=[0,0,-1]"}).code,
              0);
    std::filesystem::copy_file(in("b", "checkpoint/latest"), in("a", "checkpoint/latest"),
                               std::filesystem::copy_options::overwrite_existing);
    const Ending foreign = run({"resume", out("a"), "--max-steps", "9"});
    EXPECT_EQ(foreign.code, 6);
    EXPECT_THAT(foreign.err, HasSubstr("another case"));
    std::filesystem::resize_file(in("a", "checkpoint/latest"), 100);
    std::filesystem::resize_file(in("a", "checkpoint/previous"), 100);
    const Ending truncated = run({"resume", out("a"), "--max-steps", "9"});
    EXPECT_EQ(truncated.code, 6);
    EXPECT_THAT(truncated.err, HasSubstr("truncated"));
    EXPECT_EQ(run({"resume", out("nowhere")}).code, 5);
}

TEST_F(Runs, TheSchemaIsJson) {
    const nlohmann::json schema = nlohmann::json::parse(run({"schema"}).out);
    EXPECT_TRUE(schema.contains("properties"));
}

}  // namespace
}  // namespace riprap
