// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "cli/run_fixture.hpp"

namespace riprap {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

/// Runs that are run again, and handed on as one archive.
class HandOn : public RunFixture {
 protected:
    Ending begin(const std::vector<std::string>& more = {}) const {
        std::vector<std::string> words{"run",   case_file(), "--out", out("first"), "--quiet",
                                       "--set", "end=0.02",  "--set", "seed=3"};
        words.insert(words.end(), more.begin(), more.end());
        return run(words);
    }
    int shell(const std::string& command) const {
        return std::system(("cd " + folder.path().string() + " && " + command + " >/dev/null 2>&1").c_str());
    }
    std::vector<std::string> names() const {
        std::vector<std::string> found;
        for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
            found.push_back(entry.path().filename().string());
        }
        return found;
    }
};

TEST_F(HandOn, ARunFolderIsRunAgainAsItWas) {
    ASSERT_EQ(begin().code, 0);
    std::filesystem::remove(case_file());  // the folder has all that it takes
    const Ending again = run({"run", out("first"), "--out", out("second"), "--quiet", "--threads", "2"});
    EXPECT_EQ(again.code, 0) << again.err;
    const std::string hash = summary_of("first").at("state_hash");
    EXPECT_THAT(again.out, HasSubstr("the same State as in 'first': " + hash));
    EXPECT_EQ(summary_of("second").at("state_hash"), hash);
    EXPECT_EQ(summary_of("second").at("set"), summary_of("first").at("set"));
}

TEST_F(HandOn, ARunWithOtherValuesIsNotCompared) {
    ASSERT_EQ(begin().code, 0);
    const Ending longer = run({"run", out("first"), "--out", out("longer"), "--end", "0.03", "--quiet"});
    EXPECT_EQ(longer.code, 0);
    EXPECT_EQ(summary_of("longer").at("set"), nlohmann::json({"end=0.02", "seed=3", "end=0.03"}));
    EXPECT_EQ(run({"resume", out("first"), "--end", "0.03", "--quiet"}).code, 0);
    const Ending again = run({"run", out("first"), "--out", out("second"), "--quiet"});
    EXPECT_EQ(again.code, 0);
    EXPECT_THAT(again.out, HasSubstr("'first' went to 0.03 s, this run to 0.02 s"));
}

TEST_F(HandOn, AnotherStateIsToldWithBothBuilds) {
    ASSERT_EQ(begin().code, 0);
    std::string text = text_of(in("first", "summary.json"));
    const std::string hash = summary_of("first").at("state_hash");
    text.replace(text.find(hash), hash.size(), "0123456789abcdef");
    write_file("first/summary.json", text);
    const Ending again = run({"run", out("first"), "--out", out("second"), "--quiet"});
    EXPECT_EQ(again.code, 1);
    EXPECT_THAT(again.err, AllOf(HasSubstr("another State than in 'first': 0123456789abcdef there, " + hash),
                                 HasSubstr("here the same")));
}

TEST_F(HandOn, DamagedRunFoldersAreRefused) {
    ASSERT_EQ(begin().code, 0);
    EXPECT_EQ(run({"run", out("first"), "--out", out("first"), "--force"}).code, 5);  // over its own case
    write_file("first/run.json", "{\"set\": 3}");
    EXPECT_EQ(run({"run", out("first"), "--out", out("second")}).code, 5);
    const std::string hash = summary_of("first").at("state_hash");
    const Ending damaged = run({"resume", out("first")});
    EXPECT_EQ(damaged.code, 5);
    EXPECT_THAT(damaged.err, AllOf(HasSubstr("is damaged"), HasSubstr("copy 'resolved.toml'")));
    std::filesystem::copy(in("first", "resolved.toml"), in("first", "case/resolved.toml"));
    EXPECT_EQ(run({"run", in("first", "case/resolved.toml"), "--out", out("third")}).code,
              0);  // the remedy of the message
    EXPECT_EQ(summary_of("third").at("state_hash"), hash);
    std::filesystem::remove(in("first", "case/case.toml"));
    const Ending lost = run({"run", out("first"), "--out", out("second")});
    EXPECT_EQ(lost.code, 5);
    EXPECT_THAT(lost.err, HasSubstr("has lost its case"));
}

TEST_F(HandOn, AnArchiveIsARunFolderThatIsRunAgain) {
    ASSERT_EQ(begin().code, 0);
    const Ending packed = run({"pack", out("first"), "--out", out("there.tar.gz")});
    ASSERT_EQ(packed.code, 0) << packed.err;
    EXPECT_THAT(packed.out, HasSubstr("there.tar.gz: "));
    ASSERT_EQ(shell("mkdir away && tar xzf there.tar.gz -C away && rm -r first"), 0);
    for (const char* file : {"case/case.toml", "resolved.toml", "run.json", "summary.json", "probes.csv", "ledger.csv",
                             "bodies.csv", "run.log", "pack.json"}) {
        EXPECT_TRUE(std::filesystem::exists(in("away/first", file))) << file;
    }
    EXPECT_FALSE(std::filesystem::exists(in("away/first", "checkpoint")));
    const nlohmann::json list = nlohmann::json::parse(text_of(in("away/first", "pack.json")));
    EXPECT_EQ(list.at("state_hash"), summary_of("away/first").at("state_hash"));
    for (const nlohmann::json& file : list.at("files")) {
        EXPECT_EQ(std::filesystem::file_size(in("away/first", file.at("name"))), file.at("bytes"));
    }
    const Ending again = run({"run", out("away/first"), "--out", out("again"), "--quiet"});
    EXPECT_EQ(again.code, 0) << again.err;
    EXPECT_THAT(again.out, HasSubstr("the same State as in 'first'"));
}

TEST_F(HandOn, AnArchiveWithItsStateGoesOn) {
    ASSERT_EQ(begin().code, 0);
    ASSERT_EQ(run({"pack", out("first"), "--frames", "--checkpoint"}).code, 0);  // beside it
    ASSERT_EQ(shell("mv first whole && tar xzf first.tar.gz"), 0);
    EXPECT_EQ(files_of("first").files, files_of("whole").files);
    EXPECT_EQ(run({"resume", out("first"), "--end", "0.03", "--quiet"}).code, 0);
    EXPECT_EQ(run({"resume", out("whole"), "--end", "0.03", "--quiet"}).code, 0);
    EXPECT_EQ(summary_of("first").at("state_hash"), summary_of("whole").at("state_hash"));
}

TEST_F(HandOn, NothingIsHalfPacked) {
    ASSERT_EQ(begin().code, 0);
    write_file("there.tar.gz", "years of work");
    EXPECT_EQ(run({"pack", out("first"), "--out", out("there.tar.gz")}).code, 2);
    EXPECT_EQ(text_of(out("there.tar.gz")), "years of work");
    EXPECT_EQ(run({"pack", out("first"), "--out", out("first/inside.tar.gz")}).code, 2);
    EXPECT_EQ(run({"pack", out("first"), "--out", out("first.zip")}).code, 2);
    EXPECT_EQ(run({"pack", out("nothing")}).code, 5);
    write_file(
        "tar",
        "#!/bin/bash\nfor w in \"$@\"; do case $w in --file=*) echo half >\"${w#--file=}\";; esac; done\nexit 2\n");
    std::filesystem::permissions(out("tar"), std::filesystem::perms::owner_all);
    setenv("PATH", (folder.path().string() + ":/usr/bin:/bin").c_str(), 1);
    const std::vector<std::string> before = names();
    const Ending failed = run({"pack", out("first"), "--out", out("there.tar.gz"), "--force"});
    EXPECT_EQ(failed.code, 5);
    EXPECT_THAT(failed.err, HasSubstr("tar ended with exit code 2; nothing was packed"));
    EXPECT_EQ(text_of(out("there.tar.gz")), "years of work");
    EXPECT_THAT(names(), ::testing::UnorderedElementsAreArray(before));  // nothing is left behind
}

TEST_F(HandOn, ARunThatIsNotFinishedIsPackedWithAWordAndALinkIsLeftOut) {
    ASSERT_EQ(begin({"--max-steps", "10"}).code, 0);
    std::filesystem::create_symlink("/etc/passwd", in("first", "case/link"));
    const Ending packed = run({"pack", out("first")});
    EXPECT_EQ(packed.code, 0);
    EXPECT_THAT(packed.err, HasSubstr("the run is not finished: interrupted"));
    ASSERT_EQ(shell("mkdir away && tar xzf first.tar.gz -C away"), 0);
    EXPECT_FALSE(std::filesystem::exists(std::filesystem::symlink_status(in("away/first", "case/link"))));
}

}  // namespace
}  // namespace riprap
