// SPDX-License-Identifier: Apache-2.0
// Every folder of cases/ loads, resolves and takes a few steps.
#include <algorithm>

#include "case_fixture.hpp"
#include "riprap/core/fields.hpp"
#include "riprap/sim/advance.hpp"

namespace riprap::scene {
namespace {

using namespace test;

std::vector<std::string> case_names() {
    std::vector<std::string> names;
    for (const auto& folder : std::filesystem::directory_iterator(source_folder() / "cases")) {
        if (std::filesystem::exists(folder.path() / "case.toml")) {
            names.push_back(folder.path().filename());
        }
    }
    std::sort(names.begin(), names.end());
    return names;
}

class Cases : public testing::TestWithParam<std::string> {
 protected:
    std::filesystem::path file() const { return source_folder() / "cases" / GetParam() / "case.toml"; }
};

TEST_P(Cases, loads_says_what_it_shows_and_expects_an_answer) {
    const LoadedCase loaded = read_case(file());
    EXPECT_FALSE(loaded.model.title.empty());
    EXPECT_FALSE(loaded.model.expects.empty());
    // Hundreds of blocks, or thin floes, in water that runs in minutes are two spacings thick, and the case says so.
    const std::size_t known = GetParam() == "rock_slide" || GetParam() == "ice_jam" ? 1 : 0;
    EXPECT_EQ(loaded.warnings.size(), known) << (loaded.warnings.empty() ? "" : loaded.warnings.back());
}

TEST_P(Cases, reads_back_from_its_resolved_text) {
    const LoadedCase first = read_case(file());
    const LoadedCase second = read_case_text(first.resolved_toml, "resolved.toml", first.folder);
    EXPECT_EQ(second.resolved_toml, first.resolved_toml);
    EXPECT_EQ(second.model.case_hash, first.model.case_hash);
    EXPECT_EQ(hash_fields(second.state), hash_fields(first.state));
}

TEST_P(Cases, takes_twenty_steps) {
    LoadedCase loaded = read_case(file());
    sim::initialise(loaded.model, loaded.state);
    sim::Scratch scratch;
    for (int step = 0; step < 20; ++step) {
        const double dt = sim::choose_time_step(loaded.model, loaded.state, scratch).dt;
        const sim::StepReport report = sim::advance(loaded.model, loaded.state, scratch, dt);
        ASSERT_TRUE(report.status.ok()) << report.status.text;
    }
    EXPECT_EQ(loaded.state.step, 20);
    EXPECT_TRUE(find_non_finite(loaded.state).name.empty());
}

INSTANTIATE_TEST_SUITE_P(Folder, Cases, testing::ValuesIn(case_names()),
                         [](const auto& instance) { return instance.param; });

}  // namespace
}  // namespace riprap::scene
