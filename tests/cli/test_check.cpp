// SPDX-License-Identifier: Apache-2.0
// Predictions of `riprap check`.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/run_fixture.hpp"

namespace riprap {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class Checks : public RunFixture {};

TEST_F(Checks, CheckPredictsARunAndNamesEveryProblem) {
    const nlohmann::json good = nlohmann::json::parse(run({"check", case_file(), "--json"}).out);
    EXPECT_EQ(good.at("bodies"), 4);
    EXPECT_EQ(good.at("free_bodies"), 3);
    EXPECT_EQ(good.at("steps"), full_steps);
    EXPECT_GT(good.at("time_step_limit").get<double>(), good.at("time_step").get<double>());
    EXPECT_GT(good.at("memory_bytes").get<double>(), 0);
    const std::string bad = write_case("bad.toml", "gravty = [0, 0, -9.81]\nend = \"3 kg\"\n");
    const Ending ending = run({"check", bad, "--json"});
    EXPECT_EQ(ending.code, 3);
    const nlohmann::json problems = nlohmann::json::parse(ending.out).at("problems");
    ASSERT_GE(problems.size(), 2U);
    EXPECT_EQ(problems.at(0).at("line"), 1);
    EXPECT_TRUE(problems.at(0).at("allowed").is_string());
    EXPECT_EQ(run({"check", bad}).code, 3);
}

TEST_F(Checks, CheckWarnsOfStepsThatNoMachineGetsThrough) {
    const std::vector<std::string> words{"check", case_file(), "--set", "time_step=1e-9", "--set", "end=1e12"};
    const Ending ending = run(words);
    EXPECT_EQ(ending.code, 0);
    EXPECT_THAT(ending.out, AllOf(HasSubstr("warning: about 1e+21 steps"), HasSubstr("steps         about 1e+21 to")));
    EXPECT_THAT(ending.out, Not(HasSubstr("9000000000000000000")));
    EXPECT_THAT(run({"check", case_file()}).out, Not(HasSubstr("warning")));
}

TEST_F(Checks, CheckWarnsOfAForcedStepThatIsNotStable) {
    const Ending ending =
        run({"check", case_file(), "--set", "time_step=1", "--set", "force_time_step=true", "--set", "end=10"});
    EXPECT_EQ(ending.code, 0) << ending.err;
    EXPECT_THAT(ending.out, AllOf(HasSubstr("warning: the forced step is"), HasSubstr("times what is stable")));
}

TEST_F(Checks, ThePredictedOutputIsWhatARunWrites) {
    const nlohmann::json check = nlohmann::json::parse(run({"check", case_file(), "--json"}).out);
    whole_run("1");
    std::uintmax_t bytes = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(out("whole"))) {
        const std::string extension = entry.path().extension().string();
        bytes += extension == ".vtp" || extension == ".csv" ? entry.file_size() : 0;
    }
    EXPECT_GT(check.at("output_bytes").get<double>(), 0.5 * static_cast<double>(bytes));
    EXPECT_LT(check.at("output_bytes").get<double>(), 2.0 * static_cast<double>(bytes));
}

}  // namespace
}  // namespace riprap
