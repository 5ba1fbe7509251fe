// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/ensemble.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "io/temporary_folder.hpp"
#include "riprap/io/atomic_file.hpp"
#include "riprap/io/csv_reader.hpp"

namespace riprap::run {
namespace {

constexpr const char* falling = R"(
gravity = [0, 0, -10]
end = 0.02
seed = 7
[material.rock]
density = 2500.0
normal_stiffness = 1.0e5
[[body]]
name = "stone"
shape = { cube = 0.1 }
position = [0, 0, 1]
velocity = [1.0, 0, 0]
material = "rock"
[output]
probe_interval = 0.01
vtk = false
[[output.probe]]
body = "stone"
quantity = "position"
[[spread]]
key = "body.stone.velocity.0"
low = 1.0
high = 2.0
)";

EnsembleOptions options_in(const std::filesystem::path& place, std::int64_t members) {
    io::write_file(place / "case.toml", falling);
    EnsembleOptions options;
    options.run.case_path = (place / "case.toml").string();
    options.run.out = place / "ensemble";
    options.run.threads = 1;
    options.run.silent = true;
    options.run.quiet = true;
    options.members = members;
    return options;
}

TEST(Ensemble, members_fly_as_far_as_the_speeds_that_they_drew) {
    const TemporaryFolder place;
    const EnsembleOptions options = options_in(place.path(), 3);
    ASSERT_EQ(run_ensemble(options), 0);
    const Spread spread{"body.stone.velocity.0", 1.0, 2.0};
    std::istringstream table(io::read_file(options.run.out / "ensemble.csv", 1U << 16U));
    std::string line;
    std::getline(table, line);  // the heading
    double least = 2, most = 1;
    for (std::int64_t k = 1; k <= 3; ++k) {
        const double speed = draw(spread, 7, k);
        std::getline(table, line);
        EXPECT_DOUBLE_EQ(std::stod(line.substr(line.rfind(',') + 1)), speed) << line;
        EXPECT_TRUE(speed >= 1 && speed < 2);
        least = std::min(least, speed);
        most = std::max(most, speed);
    }
    const io::CsvTable bands = io::read_csv(options.run.out / "bands.csv");
    EXPECT_EQ(bands.columns[1].name, "stone.position.x.low");
    EXPECT_NEAR(bands.values[1].back(), 0.02 * least, 1e-9);
    EXPECT_NEAR(bands.values[3].back(), 0.02 * most, 1e-9);
    EXPECT_LT(least, most);
}

TEST(Ensemble, more_members_leave_the_first_ones_as_they_were) {
    const TemporaryFolder place;
    ASSERT_EQ(run_ensemble(options_in(place.path(), 1)), 0);
    const auto summary = place.path() / "ensemble" / "member-1" / "probes.csv";
    const auto written = std::filesystem::last_write_time(summary);
    ASSERT_EQ(run_ensemble(options_in(place.path(), 2)), 0);
    EXPECT_EQ(std::filesystem::last_write_time(summary), written);
    EXPECT_TRUE(std::filesystem::exists(place.path() / "ensemble" / "member-2" / "summary.json"));
}

TEST(Ensemble, normal_draws_have_their_mean_and_deviation) {
    Spread spread;
    spread.key = "x";
    spread.is_normal = true;
    spread.mean = 3;
    spread.deviation = 0.5;
    double sum = 0, squares = 0;
    constexpr int count = 4000;
    for (int k = 1; k <= count; ++k) {
        const double value = draw(spread, 1, k);
        sum += value;
        squares += (value - 3) * (value - 3);
    }
    EXPECT_NEAR(sum / count, 3, 4 * 0.5 / std::sqrt(count));
    EXPECT_NEAR(std::sqrt(squares / count), 0.5, 0.03);
}

TEST(Ensemble, a_case_without_spread_and_a_key_that_there_is_not_are_refused) {
    const TemporaryFolder place;
    EnsembleOptions options = options_in(place.path(), 2);
    options.run.overrides = {"spread=[]"};
    EXPECT_THROW(run_ensemble(options), CaseError);
    options.run.overrides = {"spread.0.key=\"body.stone.colour\""};
    EXPECT_THROW(run_ensemble(options), CaseError);
}

TEST(Ensemble, a_member_that_draws_what_may_not_be_is_told_before_any_runs) {
    const TemporaryFolder place;
    EnsembleOptions options = options_in(place.path(), 6);
    std::string text = falling;
    const std::string spread = text.substr(text.find("key = "));
    text.replace(text.find(spread), spread.size(),
                 "key = \"material.rock.friction_coefficient\"\nmean = 0.1\ndeviation = 1.0\n");
    io::write_file(place.path() / "case.toml", text);
    try {
        run_ensemble(options);
        FAIL() << "accepted";
    } catch (const CaseError& error) {
        const std::string told = to_string(error.problems().front());
        EXPECT_NE(told.find("of 6: friction_coefficient of [material.NAME] = -"), std::string::npos) << told;
    }
    EXPECT_FALSE(std::filesystem::exists(options.run.out));
}

}  // namespace
}  // namespace riprap::run
