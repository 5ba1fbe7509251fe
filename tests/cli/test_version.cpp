// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "cli/program.hpp"
#include "io/temporary_folder.hpp"

namespace riprap {
namespace {

using ::testing::HasSubstr;

TEST(CommandLine, TheVersionNamesCompilerAndFlags) {
    const TemporaryFolder folder;
    const Ending ending = run_program(folder.path(), {"version"});
    EXPECT_EQ(ending.code, 0);
    EXPECT_THAT(ending.out, HasSubstr("riprap 0."));
    EXPECT_THAT(ending.out, HasSubstr("-march="));
}

TEST(CommandLine, TheVersionAsJsonHasBuildAndMachine) {
    const TemporaryFolder folder;
    const auto answer = nlohmann::json::parse(run_program(folder.path(), {"version", "--json"}).out);
    EXPECT_TRUE(answer.at("build").at("version").is_string());
    EXPECT_TRUE(answer.at("build").at("march").is_string());
    const auto commit = answer.at("build").at("commit").get<std::string>();
    // A clone on a machine without git, or of another user, has a commit that nothing can tell.
    const bool is_known = std::system("git rev-parse HEAD >/dev/null 2>&1") == 0;
    EXPECT_EQ(std::filesystem::exists(".git") && is_known, !commit.empty()) << commit;
    EXPECT_EQ(commit.find_first_not_of("0123456789abcdef+"), std::string::npos) << commit;
    EXPECT_GE(answer.at("machine").at("hardware_threads").get<int>(), 1);
}

TEST(CommandLine, AnAnswerThatCannotBePrintedIsAFailure) {
    const TemporaryFolder folder;
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"version"},
          {"list"},
          {"schema"},
          {"schema", "--keys"},
          {"--help"},
          {"check", "hello_block"},
          {"run", "hello_block", "--out", folder / "run", "--set", "max_steps=3"}}) {
        const Ending ending = Program(folder.path(), words, [] { dup2(open("/dev/full", O_WRONLY), 1); }).wait();
        EXPECT_EQ(ending.code, 5) << words.front();
        EXPECT_THAT(ending.err, HasSubstr("standard output")) << words.front();
    }
}

TEST(CommandLine, ABadCommandLineIsRefusedWithTwo) {
    const TemporaryFolder folder;
    EXPECT_EQ(run_program(folder.path(), {}).code, 0);  // shows the help
    EXPECT_EQ(run_program(folder.path(), {"frobnicate"}).code, 2);
    EXPECT_EQ(run_program(folder.path(), {"version", "--nonsense"}).code, 2);
    EXPECT_EQ(run_program(folder.path(), {"--help"}).code, 0);
}

}  // namespace
}  // namespace riprap
