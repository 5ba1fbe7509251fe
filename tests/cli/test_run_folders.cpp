// SPDX-License-Identifier: Apache-2.0
// Folders and files of runs: whose they are, and what happens where they cannot be used.
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

class RunFolders : public RunFixture {};

TEST_F(RunFolders, NothingIsWrittenOverUnasked) {
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

TEST_F(RunFolders, FilesWithTheNamesOfARunAreTheUsersWhereNoRunWroteThem) {
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

TEST_F(RunFolders, ARunThatWasKilledWhileItWasPutInPlaceIsBegunAgain) {
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

TEST_F(RunFolders, ABadCaseTouchesNoRun) {
    ASSERT_EQ(run({"run", case_file(), "--out", out("a"), "--set", "max_steps=3"}).code, 0);
    const std::string before = text_of(in("a", "summary.json"));
    const std::string bad = write_case("bad.toml", case_text() + "\nnonsense = 1\n");
    EXPECT_EQ(run({"run", bad, "--out", out("a"), "--force"}).code, 3);
    EXPECT_EQ(text_of(in("a", "summary.json")), before);
    EXPECT_EQ(run({"run", "no_such_case", "--out", out("b")}).code, 5);
    EXPECT_FALSE(std::filesystem::exists(out("b")));
}

TEST_F(RunFolders, OneFolderBelongsToOneProcess) {
    const Program program(folder.path(), {"run", case_file(), "--out", out("a"), "--set", "end=10000"});
    wait_for_steps("a");
    const TemporaryFolder elsewhere;
    const Ending second = run_program(elsewhere.path(), {"resume", out("a")});
    program.send(SIGTERM);
    program.wait();
    EXPECT_EQ(second.code, 5);
    EXPECT_THAT(second.err, HasSubstr("another riprap"));
}

TEST_F(RunFolders, ACaseThatIsNoRegularFileIsRefusedWithoutWaitingForIt) {
    ASSERT_EQ(mkfifo(out("pipe.toml").c_str(), 0600), 0);
    for (const std::string& file : {out("pipe.toml"), std::string("/dev/zero"), std::string("/dev/tty")}) {
        for (const char* command : {"run", "check"}) {
            const Ending ending = Program(folder.path(), {command, file}, [] { alarm(20); }).wait();
            EXPECT_EQ(ending.code, 5) << file;
            EXPECT_THAT(ending.err, HasSubstr("regular file")) << file;
        }
    }
}

TEST_F(RunFolders, AnUnwritablePlaceIsNamed) {
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

TEST_F(RunFolders, AFolderThatMayNotBeEnteredOrWrittenIsNamed) {
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

TEST_F(RunFolders, AFileLimitStopsTheRunWithItsNameAndNothingIsLost) {
    const Whole whole = whole_run("1");
    const Ending ending =
        Program(folder.path(), {"run", case_file(), "--out", out("a")}, [] { limit_file_size(20'000); }).wait();
    EXPECT_EQ(ending.code, 5);
    EXPECT_THAT(ending.err, AllOf(HasSubstr(".csv"), HasSubstr("ulimit -f")));
    ASSERT_EQ(run({"resume", out("a")}).code, 0);
    expect_same(whole, "a");
}

TEST_F(RunFolders, DamagedAndForeignCheckpointsAreRefusedWithSix) {
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

TEST_F(RunFolders, TheSchemaIsJson) {
    const nlohmann::json schema = nlohmann::json::parse(run({"schema"}).out);
    EXPECT_TRUE(schema.contains("properties"));
}

}  // namespace
}  // namespace riprap
