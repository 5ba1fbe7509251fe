// SPDX-License-Identifier: Apache-2.0
// No published case is judged by answers alone that a world in which nothing moves would give as well.
#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "riprap/scene/text/toml_reader.hpp"
#include "riprap/validation/case_files.hpp"
#include "riprap/validation/cross/scene.hpp"
#include "riprap/validation/validate.hpp"

namespace riprap::validation {
namespace {

std::filesystem::path folder() { return case_folder({}); }

/// Folders of the cases of a suite.
std::vector<std::filesystem::path> cases_of(const std::string& suite) {
    std::vector<std::filesystem::path> cases;
    if (suite == cross::suite) {
        for (const auto& entry : std::filesystem::directory_iterator(folder() / suite)) {
            if (std::filesystem::exists(entry.path() / "case.toml")) {
                cases.push_back(entry.path());
            }
        }
    }
    for (const ValidationCase& one : file_cases()) {
        if (one.suite == suite) {
            cases.push_back(folder() / one.suite / one.name);
        }
    }
    return cases;
}

/// Tells whether all that a case is judged by holds if nothing moves.
/// @param is_plain  without its variations, which may be many
bool holds_still(const std::filesystem::path& one, bool is_plain) {
    CaseReport report{one.filename()};
    CaseSetting setting;
    setting.folder = one;
    setting.is_plain = is_plain;
    setting.is_still = true;
    run_case_file(setting, report);
    const auto fails = [](const Result& row) {
        return row.kind == Kind::physics && row.verdict == Verdict::not_reproduced;
    };
    return std::ranges::none_of(report.results(), fails);
}

/// The case in which something moves beside each that holds still, by "suite/case".
std::map<std::string, std::string> moving_partners() {
    std::ifstream in(folder() / "still.toml");
    std::stringstream text;
    text << in.rdbuf();
    std::vector<Diagnostic> problems;
    const scene::Value list = scene::parse_toml(text.str(), "still.toml", problems);
    std::map<std::string, std::string> partners;
    for (const scene::Value& row : scene::get(list, "beside").items) {
        for (const scene::Value& name : scene::get(row, "cases").items) {
            partners[name.text] = scene::get_text(row, "moves");
        }
    }
    return partners;
}

std::vector<std::string> suites() {
    std::set<std::string> names{std::string(cross::suite)};
    for (const ValidationCase& one : file_cases()) {
        names.emplace(one.suite);
    }
    return {names.begin(), names.end()};
}

class StillWorld : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Suites, StillWorld, testing::ValuesIn(suites()), [](const auto& one) { return one.param; });

TEST_P(StillWorld, IsRightInNoCaseOfASuiteButThoseBesideOneThatMoves) {
    const std::map<std::string, std::string> partners = moving_partners();
    std::set<std::string> still, moving;
    for (const std::filesystem::path& one : cases_of(GetParam())) {
        const bool is_still = holds_still(one, true) && holds_still(one, false);
        (is_still ? still : moving).insert(GetParam() + "/" + one.filename().string());
    }
    for (const std::string& name : still) {
        ASSERT_TRUE(partners.contains(name)) << name << " would be right if nothing moved";
        EXPECT_TRUE(moving.contains(partners.at(name))) << name << " stands beside " << partners.at(name);
    }
    for (const auto& [name, partner] : partners) {
        EXPECT_FALSE(moving.contains(name)) << name << " needs no case beside it";
    }
}

TEST(StillScene, OfTheCrossTableIsJudgedWithoutAStepToo) {
    ValidateOptions options;
    options.selection = {"cross/seam_of_two"};
    options.is_still = true;
    options.results = "";
    std::ostringstream table;
    EXPECT_EQ(validate(options, all_cases(), table, nullptr), 1);
    EXPECT_THAT(table.str(), testing::HasSubstr("way"));
    EXPECT_THAT(table.str(), testing::Not(testing::HasSubstr("planar_dda")));  // nor with any method
}

}  // namespace
}  // namespace riprap::validation
