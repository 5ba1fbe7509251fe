// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "cli/program.hpp"
#include "io/temporary_folder.hpp"

namespace riprap {
namespace {

using ::testing::HasSubstr;

std::set<std::string> matches(const std::string& text, const std::string& pattern) {
    std::set<std::string> found;
    const std::regex regex(pattern);
    for (auto match = std::sregex_iterator(text.begin(), text.end(), regex); match != std::sregex_iterator(); ++match) {
        found.insert((*match)[1]);
    }
    return found;
}

/// Lines of one section of the help, from its heading to the next empty line.
std::string section(const std::string& help, const std::string& heading) {
    const std::size_t begin = help.find(heading);
    return begin == std::string::npos ? "" : help.substr(begin, help.find("\n\n", begin) - begin);
}

class Help : public ::testing::Test {
 protected:
    const TemporaryFolder folder;
    const std::string page = text_of("docs/howto/command-line.md");
    std::string help(const std::vector<std::string>& words) const { return run_program(folder.path(), words).out; }
};

TEST_F(Help, EveryCommandAndOptionIsOnThePageAndThePageNamesNoOther) {
    const std::set<std::string> commands = matches(section(help({"--help"}), "Subcommands:"), "\n  ([a-z]+) ");
    EXPECT_EQ(commands, matches(page, "\nriprap ([a-z]+)"));
    std::set<std::string> options = matches(section(help({"--help"}), "Options:"), "(--[a-z-]+)");
    for (const std::string& command : commands) {
        options.merge(matches(section(help({command, "--help"}), "Options:"), "(--[a-z-]+)"));
    }
    EXPECT_EQ(options, matches(page, "(--[a-z][a-z-]*)"));
}

TEST_F(Help, StandsWhereNothingIsAskedFor) {
    const Ending bare = run_program(folder.path(), {});
    EXPECT_EQ(bare.code, 0);
    EXPECT_EQ(bare.out, help({"--help"}));
}

TEST_F(Help, OfEveryCommandEndsWithAnExampleOfThatCommand) {
    for (const std::string& command : matches(section(help({"--help"}), "Subcommands:"), "\n  ([a-z]+) ")) {
        EXPECT_THAT(section(help({command, "--help"}), "Example:"), HasSubstr("riprap " + command)) << command;
    }
}

TEST_F(Help, CompletionAndManualPagesNameEveryCommandAndOption) {
    const std::set<std::string> commands = matches(section(help({"--help"}), "Subcommands:"), "\n  ([a-z]+) ");
    for (const std::string shell : {"bash", "zsh", "fish"}) {
        const std::string script = help({"completion", shell});
        for (const std::string& command : commands) {
            EXPECT_THAT(script, HasSubstr(command)) << shell;
        }
        EXPECT_THAT(script, HasSubstr("max-steps")) << shell;
    }
    EXPECT_THAT(help({"man"}), HasSubstr(".B resume\n"));
    EXPECT_THAT(help({"man", "run"}), HasSubstr("\\-\\-max\\-steps"));
}

TEST_F(Help, ANewCaseChecksWithoutAWord) {
    for (const std::string kind : {"dry", "wet", "spheres"}) {
        std::vector<std::string> words{"new", (folder.path() / kind).string()};
        if (kind != "dry") {
            words.emplace_back(kind == "wet" ? "--water" : "--spheres");
        }
        ASSERT_EQ(run_program(folder.path(), words).code, 0);
        const Ending check = run_program(folder.path(), {"check", (folder.path() / kind).string()});
        EXPECT_EQ(check.code, 0) << check.err << check.out;
        EXPECT_EQ(run_program(folder.path(), words).code, 5);  // never over another
    }
}

TEST_F(Help, ANewCaseRunsUntilItsWaterHasHitTheWallAndItsBodiesLie) {
    for (const std::string kind : {"dry", "wet", "spheres"}) {
        std::vector<std::string> words{"new", (folder.path() / kind).string()};
        if (kind != "dry") {
            words.emplace_back(kind == "wet" ? "--water" : "--spheres");
        }
        ASSERT_EQ(run_program(folder.path(), words).code, 0);
        const std::string end = kind == "wet"   ? "1.2"
                                : kind == "dry" ? "2"
                                                : "1.5";  // what splashes highest is back before
        const Ending run = run_program(folder.path(), {"run", (folder.path() / kind).string(), "--end", end, "--out",
                                                       (folder.path() / (kind + "_run")).string()});
        EXPECT_EQ(run.code, 0) << run.err << run.out;
    }
}

TEST_F(Help, EveryExitCodeIsOnThePageWithTheSameWords) {
    const std::string codes = section(help({"--help"}), "Exit codes:");
    std::istringstream lines(codes.substr(codes.find('\n') + 1));
    std::string line;
    int count = 0;
    while (std::getline(lines, line)) {
        const std::size_t begin = line.find_first_not_of(' '), end = line.find(' ', begin);
        const std::string meaning = line.substr(line.find_first_not_of(' ', end));
        EXPECT_THAT(page, HasSubstr("| " + line.substr(begin, end - begin) + " | " + meaning + " |"));
        ++count;
    }
    EXPECT_EQ(count, 9);
}

}  // namespace
}  // namespace riprap
