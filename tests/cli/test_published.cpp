// SPDX-License-Identifier: Apache-2.0
// Published cases that are case files: listed by source, checked, run and copied as any other.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "cli/program.hpp"
#include "io/temporary_folder.hpp"

namespace riprap {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(Published, CasesAreListedWithTheSourcesThatTheyCite) {
    const TemporaryFolder folder;
    const Ending plain = run_program(folder.path(), {"list", "--published"});
    EXPECT_EQ(plain.code, 0) << plain.err;
    EXPECT_THAT(plain.out, HasSubstr("rigid/keystone  A roof block between two blocks that are pushed together\n"
                                     "    limit equilibrium: W + P t/4 s = 2 H tan(phi - 10)\n"));
    const nlohmann::json list =
        nlohmann::json::parse(run_program(folder.path(), {"list", "--published", "--json"}).out);
    std::set<std::string> suites;
    for (const auto& entry : list) {
        const std::string name = entry.at("name");
        suites.insert(name.substr(0, name.find('/')));
        EXPECT_FALSE(entry.at("citations").empty() && entry.at("source") == "") << name;
    }
    EXPECT_TRUE(suites.contains("rigid") && suites.contains("dda"));
}

TEST(Published, AFigureGivesTheCaseAndTheCommandsThatRunAndCopyItFromAnyFolder) {
    const TemporaryFolder folder;
    const auto elsewhere = [&folder] { std::filesystem::current_path(folder.path()); };
    const auto there = [&](const std::vector<std::string>& words) {
        return Program(folder.path(), words, elsewhere).wait();
    };
    const Ending found = there({"list", "--published", "Ding", "figure", "7.8"});
    EXPECT_EQ(found.code, 0) << found.err;
    EXPECT_THAT(found.out, HasSubstr("ding/planar_arch  Seven voussoirs without friction sink\n"
                                     "    Ding (2021), section 7.2.3, figures 7.7 to 7.9\n"
                                     "    riprap run ding/planar_arch\n"
                                     "    riprap new my_planar_arch --from ding/planar_arch\n"));
    EXPECT_THAT(found.out, Not(HasSubstr("gravity_dam")));
    EXPECT_EQ(there({"new", "my_planar_arch", "--from", "validation/ding/planar_arch"}).code, 0);
    EXPECT_EQ(there({"run", "my_planar_arch", "--max-steps", "3"}).code, 0);
    const auto summary = nlohmann::json::parse(text_of(folder.path() / "runs" / "my_planar_arch" / "summary.json"));
    EXPECT_EQ(summary.at("source"), "Ding (2021), section 7.2.3, figures 7.7 to 7.9");

    const auto list = nlohmann::json::parse(there({"list", "--published", "Ding", "figure", "7.8", "--json"}).out);
    EXPECT_EQ(list.at(0).at("run"), "riprap run " + list.at(0).at("name").get<std::string>());

    const Ending none = there({"list", "--published", "ding", "figure", "70"});
    EXPECT_EQ(none.code, 5);
    EXPECT_THAT(none.err, HasSubstr("no published case is about 'ding figure 70'"));
    EXPECT_NE(there({"list", "ding"}).code, 0) << "words without --published";
}

TEST(Published, ACopyOfACaseChecksAndRunsAndIsNeverMadeOverAnotherFolder) {
    for (const std::string name : {"dda/planar_slope_tip", "rigid/two_cubes", "dda/rocking_3d_small"}) {
        const TemporaryFolder folder;
        const std::string mine = (folder.path() / "mine").string();
        const std::vector<std::string> copy{"new", mine, "--from", "validation/" + name};
        EXPECT_EQ(run_program(folder.path(), copy).code, 0) << name;
        EXPECT_EQ(run_program(folder.path(), copy).code, 5);
        const Ending check = run_program(folder.path(), {"check", mine});
        EXPECT_EQ(check.code, 0) << check.err << check.out;
        const Ending run = run_program(folder.path(), {"run", mine, "--max-steps", "5", "--out", mine + "_run"});
        EXPECT_EQ(run.code, 0) << run.err << run.out;
    }
}

TEST(Published, ACopyOfACaseThatIsNotThereNamesTheNearest) {
    const TemporaryFolder folder;
    const Ending ending = run_program(folder.path(), {"new", "mine", "--from", "validation/dda/planar_slope_tipp"});
    EXPECT_EQ(ending.code, 5);
    EXPECT_THAT(ending.err, HasSubstr("planar_slope_tip"));
}

}  // namespace
}  // namespace riprap
