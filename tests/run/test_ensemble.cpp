// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/ensemble/ensemble.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "io/temporary_folder.hpp"
#include "riprap/io/atomic_file.hpp"
#include "riprap/io/csv_reader.hpp"
#include "riprap/run/figures/spreads.hpp"

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
    double least = 2, most = 1, sum = 0;
    for (std::int64_t k = 1; k <= 3; ++k) {
        const double speed = draw(spread, 7, k);
        sum += speed;
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
    // Of three values the quantile of 10 % lies a fifth of the way from the least to the middle one.
    const double middle = sum - least - most;
    EXPECT_EQ(bands.columns[4].name, "stone.position.x.p10");
    EXPECT_NEAR(bands.values[4].back(), 0.02 * (0.8 * least + 0.2 * middle), 1e-9);
    EXPECT_NEAR(bands.values[5].back(), 0.02 * middle, 1e-9);
    EXPECT_NEAR(bands.values[6].back(), 0.02 * (0.2 * middle + 0.8 * most), 1e-9);
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

/// The case with another number that is not known exactly.
std::string with_spread(const std::string& spread) {
    const std::string text = falling;
    return text.substr(0, text.find("key = ")) + spread;
}

/// Exit codes of the members, from ensemble.csv.
std::vector<int> codes_of(const EnsembleOptions& options) {
    std::istringstream table(io::read_file(options.run.out / "ensemble.csv", 1U << 16U));
    std::vector<int> codes;
    std::string line;
    for (std::getline(table, line); std::getline(table, line);) {
        const std::size_t second = line.find(',', line.find(',') + 1);
        codes.push_back(std::stoi(line.substr(second + 1)));
    }
    return codes;
}

TEST(Ensemble, a_member_that_draws_what_may_not_be_is_named_before_any_runs_and_the_others_go_on) {
    const TemporaryFolder place;
    EnsembleOptions options = options_in(place.path(), 6);
    options.run.silent = false;
    io::write_file(place.path() / "case.toml",
                   with_spread("key = \"material.rock.friction_coefficient\"\nmean = 0.1\ndeviation = 1.0\n"));
    testing::internal::CaptureStderr();
    EXPECT_EQ(run_ensemble(options), 3);
    const std::string told = testing::internal::GetCapturedStderr();
    EXPECT_NE(told.find("of 6 is refused: "), std::string::npos) << told;
    EXPECT_NE(told.find("friction_coefficient of [material.NAME] = -"), std::string::npos) << told;
    EXPECT_NE(told.find("a narrower [[spread]]"), std::string::npos) << told;
    const std::vector<int> codes = codes_of(options);
    ASSERT_EQ(codes.size(), 6U);
    int refused = 0;
    for (int k = 0; k < 6; ++k) {
        const double drawn = draw({"material.rock.friction_coefficient", 0, 0, true, 0.1, 1.0}, 7, k + 1);
        EXPECT_EQ(codes[static_cast<std::size_t>(k)], drawn < 0 ? 3 : 0) << drawn;
        EXPECT_EQ(std::filesystem::exists(options.run.out / ("member-" + std::to_string(k + 1))), drawn >= 0);
        refused += drawn < 0 ? 1 : 0;
    }
    EXPECT_TRUE(refused > 0 && refused < 6) << refused;
    EXPECT_GT(gather_bands({options.run.out / "member-1", options.run.out / "member-2", options.run.out / "member-3",
                            options.run.out / "member-4"})
                  .time.size(),
              1U);
}

TEST(Ensemble, a_member_whose_table_is_damaged_is_told_and_left_out_of_the_bands) {
    // Bands of a cut table differed with exit code 0; one of other columns ended the program.
    const TemporaryFolder place;
    const EnsembleOptions options = options_in(place.path(), 3);
    ASSERT_EQ(run_ensemble(options), 0);
    const std::filesystem::path table = options.run.out / "member-2/probes.csv";
    const std::string whole = io::read_file(table, 1U << 16U),
                      bands = io::read_file(options.run.out / "bands.csv", 1U << 16U);
    const std::string heading = whole.substr(0, whole.find('\n') + 1);
    std::string garbled = whole;
    garbled[whole.find(',', heading.size())] = ';';
    for (const std::string& damaged :
         {whole.substr(0, whole.size() / 2), whole.substr(0, whole.rfind('\n', whole.size() - 2) + 1), heading,
          std::string("time [s]\n0\n0.02\n"), garbled, std::string("hello\n"), std::string()}) {
        io::write_file(table, damaged);
        EXPECT_EQ(run_ensemble(options), 5) << damaged;
        EXPECT_EQ(
            gather_bands({options.run.out / "member-1", options.run.out / "member-2", options.run.out / "member-3"})
                .left_out.size(),
            1U)
            << damaged;
        EXPECT_NE(io::read_file(options.run.out / "bands.csv", 1U << 16U), bands);
    }
    std::filesystem::remove(table);
    EXPECT_EQ(run_ensemble(options), 5);
    io::write_file(table, whole);  // as the message says
    EXPECT_EQ(run_ensemble(options), 0);
    EXPECT_EQ(io::read_file(options.run.out / "bands.csv", 1U << 16U), bands);
}

TEST(Ensemble, where_all_members_draw_what_may_not_be_nothing_is_written) {
    const TemporaryFolder place;
    const EnsembleOptions options = options_in(place.path(), 3);
    io::write_file(place.path() / "case.toml",
                   with_spread("key = \"material.rock.friction_coefficient\"\nmean = -9.0\ndeviation = 0.1\n"));
    EXPECT_THROW(run_ensemble(options), CaseError);
    EXPECT_FALSE(std::filesystem::exists(options.run.out));
}

TEST(Ensemble, a_member_that_cannot_begin_is_named_and_the_others_go_on) {
    // Its step is above what the stiffness that it drew allows: seen when the run is put together, not from its keys.
    const TemporaryFolder place;
    EnsembleOptions options = options_in(place.path(), 5);
    options.run.silent = false;
    options.run.overrides = {"time_step=1e-3"};
    io::write_file(place.path() / "case.toml",
                   with_spread("key = \"material.rock.normal_stiffness\"\nlow = 1.0e5\nhigh = 1.0e8\n"));
    testing::internal::CaptureStderr();
    EXPECT_EQ(run_ensemble(options), 3);
    const std::string told = testing::internal::GetCapturedStderr();
    EXPECT_NE(told.find("of 5 is refused: "), std::string::npos) << told;
    EXPECT_NE(told.find("time_step = 0.001 s is above"), std::string::npos) << told;
    const std::vector<int> codes = codes_of(options);
    EXPECT_EQ(codes.size(), 5U);
    EXPECT_GT(std::count(codes.begin(), codes.end(), 0), 0);
    EXPECT_GT(std::count(codes.begin(), codes.end(), 3), 0);
}

TEST(Ensemble, a_table_of_a_member_that_is_damaged_or_of_another_run_is_told_and_left_out) {
    const TemporaryFolder place;
    EnsembleOptions options = options_in(place.path(), 3);
    ASSERT_EQ(run_ensemble(options), 0);
    io::write_file(options.run.out / "member-2" / "probes.csv", "no table");
    options.run.silent = false;
    testing::internal::CaptureStderr();
    EXPECT_EQ(run_ensemble(options), 5);
    EXPECT_NE(testing::internal::GetCapturedStderr().find("member-2 is left out of the bands"), std::string::npos);
    const double least =
        std::min(draw({"body.stone.velocity.0", 1, 2}, 7, 1), draw({"body.stone.velocity.0", 1, 2}, 7, 3));
    EXPECT_NEAR(io::read_csv(options.run.out / "bands.csv").values[1].back(), 0.02 * least, 1e-9);
}

TEST(Ensemble, files_of_the_user_are_not_written_over) {
    for (const char* name : {"ensemble.csv", "ensemble.json", "bands.csv", "bands.svg", "index.html"}) {
        const TemporaryFolder place;
        EnsembleOptions options = options_in(place.path(), 2);
        std::filesystem::create_directories(options.run.out);
        io::write_file(options.run.out / "notes.txt", "mine");
        io::write_file(options.run.out / name, "years of work");
        for (const bool force : {false, true}) {
            options.run.force = force;
            EXPECT_THROW(run_ensemble(options), FileError) << name;
            EXPECT_EQ(io::read_file(options.run.out / name, 100), "years of work");
        }
        std::filesystem::rename(options.run.out / name, place.path() / "away");  // the remedy of the message
        EXPECT_EQ(run_ensemble(options), 0) << name;
        EXPECT_EQ(io::read_file(options.run.out / "notes.txt", 100), "mine");
    }
}

TEST(Ensemble, another_ensemble_is_replaced_by_force_alone) {
    const TemporaryFolder place;
    EnsembleOptions options = options_in(place.path(), 2);
    ASSERT_EQ(run_ensemble(options), 0);
    options.run.overrides = {"end=0.03"};
    EXPECT_THROW(run_ensemble(options), FileError);
    options.run.force = true;
    EXPECT_EQ(run_ensemble(options), 0);
    EXPECT_NEAR(io::read_csv(options.run.out / "bands.csv").values[0].back(), 0.03, 1e-9);
}

}  // namespace
}  // namespace riprap::run
