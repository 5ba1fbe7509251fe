// SPDX-License-Identifier: Apache-2.0
// Answers to mistakes on the command line, and warnings repeated at the end of a run.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <nlohmann/json.hpp>

#include "cli/run_fixture.hpp"
#include "riprap/io/atomic_file.hpp"

namespace riprap {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

class Mistakes : public RunFixture {};

TEST_F(Mistakes, UnknownCommandsAndOptionsAreNamedWithTheNearestOnes) {
    const Ending command = run({"chekc", "hello_block"});
    EXPECT_EQ(command.code, 2);
    EXPECT_THAT(command.err, HasSubstr("there is no command 'chekc'; did you mean 'check'?"));
    const Ending option = run({"run", case_file(), "--thread", "2"});
    EXPECT_EQ(option.code, 2);
    EXPECT_THAT(option.err, HasSubstr("`riprap run` has no option '--thread'; did you mean '--threads'?"));
    EXPECT_THAT(run({"--verison"}).err, HasSubstr("did you mean '--version'?"));
    EXPECT_THAT(run({"check", "hello_blok"}).err, HasSubstr("did you mean 'hello_block'?"));
    const Ending validation = run({"validate", "zhao/inclin"});
    EXPECT_EQ(validation.code, 2);
    EXPECT_THAT(validation.err, HasSubstr("did you mean 'zhao/incline'?"));
}

// Story: of two values of one key the last one counted, without a word.
TEST_F(Mistakes, TwoValuesOfOneKeyAreRefused) {
    for (const char* const command : {"check", "run"}) {
        const Ending twice = run({command, case_file(), "--set", "end=0.01", "--set", "end=0.02"});
        EXPECT_EQ(twice.code, 2);
        EXPECT_THAT(twice.err, HasSubstr("'end=0.01' and 'end=0.02' give one key two values; give it once"));
    }
    EXPECT_EQ(run({"run", case_file(), "--out", out("a"), "--set", "end=0.01", "--set", "end_ms=20"}).code, 2);
    EXPECT_EQ(run({"run", case_file(), "--out", out("a"), "--end", "0.01", "--set", "end=0.02"}).code, 2);
    EXPECT_EQ(run({"run", case_file(), "--out", out("a"), "--set", "body.block.fixed=true", "--set",
                   "body.block.fixed=false"})
                  .code,
              2);
    EXPECT_EQ(run({"check", case_file(), "--set", "end=0.01", "--set", "end=0.01", "--set", "seed=2"}).code, 0);
}

TEST_F(Mistakes, AnOldCaseIsRewrittenOnceAndKeptBesideAsItWas) {
    const std::filesystem::path file = folder.path() / "old" / "case.toml";
    std::filesystem::create_directories(file.parent_path());
    std::filesystem::copy_file("tests/data/upgrade/ledger_of_0_2.toml", file);
    const std::string before = io::read_file(file, 1 << 20);
    const Ending refused = run({"check", file.string()});
    EXPECT_EQ(refused.code, 3);
    EXPECT_THAT(refused.err, HasSubstr("is called \"fluid.kinetic\" since version 0.3"));

    const Ending printed = run({"upgrade", file.string(), "--print"});
    EXPECT_EQ(io::read_file(file, 1 << 20), before);
    const Ending upgraded = run({"upgrade", (folder.path() / "old").string()});
    EXPECT_EQ(upgraded.code, 0) << upgraded.err;
    EXPECT_THAT(upgraded.out, HasSubstr(":37:48: 'work_external' is now 'solid.external'"));
    EXPECT_EQ(io::read_file(file, 1 << 20), printed.out);
    EXPECT_EQ(io::read_file(file.string() + ".old", 1 << 20), before);
    EXPECT_EQ(run({"check", file.string()}).code, 0);

    EXPECT_THAT(run({"upgrade", file.string()}).out, HasSubstr("no name of an older version"));
    std::filesystem::copy_file(file.string() + ".old", file, std::filesystem::copy_options::overwrite_existing);
    const Ending again = run({"upgrade", file.string()});
    EXPECT_EQ(again.code, 5);
    EXPECT_THAT(again.err, HasSubstr("case.toml.old' exists already"));
    EXPECT_EQ(io::read_file(file, 1 << 20), before);

    const std::filesystem::path kept = folder.path() / "run" / "case" / "case.toml";  // by a run
    std::filesystem::create_directories(kept.parent_path());
    std::filesystem::copy_file(file, kept);
    EXPECT_EQ(run({"upgrade", (folder.path() / "run").string()}).code, 0);
    EXPECT_EQ(io::read_file(kept, 1 << 20), printed.out);
}

TEST_F(Mistakes, TheVersionIsAlsoAnOption) {
    const Ending ending = run({"--version"});
    EXPECT_EQ(ending.code, 0);
    EXPECT_THAT(ending.out, StartsWith("riprap "));
}

TEST_F(Mistakes, ARunDoesNotGoBackToAnEarlierEnd) {
    ASSERT_EQ(run({"run", case_file(), "--out", out("a")}).code, 0);
    const Ending ending = run({"resume", out("a"), "--end", "0.05"});
    EXPECT_EQ(ending.code, 3);
    EXPECT_THAT(ending.err, HasSubstr("the run is at t = 0.1 s (step 400) already, beyond the end 0.05 s"));
    EXPECT_EQ(summary_of("a").at("steps"), full_steps);
    EXPECT_EQ(run({"resume", out("a"), "--end", "0.1"}).code, 0);
}

TEST_F(Mistakes, AReaderThatHasSeenEnoughEndsAListingWithoutAWord) {
    std::array<int, 2> ends{};
    ASSERT_EQ(pipe(ends.data()), 0);
    close(ends[0]);
    Program program(folder.path(), {"schema"}, [&] { dup2(ends[1], 1); });
    close(ends[1]);
    EXPECT_THAT(program.wait().err, IsEmpty());
}

TEST_F(Mistakes, WarningsAndOverridesOfARunAreInItsSummaryAndCountedAtItsEnd) {
    std::string text = case_text();
    text += "\n[material.air]\ndensity = 1.0\nnormal_stiffness = 1.0\nfriction_angle = \"30 deg\"\n";
    const std::string file = write_case("warns.toml", text);
    const Ending ending = run({"run", file, "--out", out("a"), "--set", "end=0.01"});
    EXPECT_EQ(ending.code, 0);
    EXPECT_THAT(ending.out, AllOf(HasSubstr("1 warning of this run is in"), HasSubstr("summary.json")));
    const nlohmann::json summary = summary_of("a");
    EXPECT_EQ(summary.at("set"), nlohmann::json({"end=0.01"}));
    ASSERT_EQ(summary.at("warnings").size(), 1U);
    EXPECT_EQ(summary.at("warnings").at(0), "material 'air' is not used");
    ASSERT_EQ(run({"resume", out("a"), "--end", "0.02"}).code, 0);  // said again, listed once
    EXPECT_EQ(summary_of("a").at("warnings"), summary.at("warnings"));
}

TEST_F(Mistakes, ABadCaseSaysWhatWasNotLookedAt) {
    const std::string bad = write_case("bad.toml", "gravity = [0, 0, -9.81]\nend = \"3 kg\"\n");
    EXPECT_THAT(run({"check", bad}).err,
                HasSubstr("not looked at: bodies, water, records and the time step; more may be"));
    EXPECT_TRUE(nlohmann::json::parse(run({"check", bad, "--json"}).out).at("unseen").is_string());
}

}  // namespace
}  // namespace riprap
