// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <filesystem>

#include "riprap/validation/case_trial.hpp"
#include "riprap/validation/water/water_trial.hpp"

namespace riprap::validation::water {
namespace {

const std::vector<double> x{0, 1, 3}, y{0, 2, -2};

TEST(WaterRecord, integral_is_exact_for_straight_lines_and_cuts_its_ends) {
    EXPECT_DOUBLE_EQ(integral(x, y, 0, 2), 0.5 * 1 * 2 + 0.5 * 1 * 2);
    EXPECT_DOUBLE_EQ(integral(x, y, 0.5, 3), 0.5 * 0.5 * (1 + 2) + 0);
}

TEST(WaterRecord, values_lie_on_the_line_between_rows_and_stay_beyond_the_ends) {
    EXPECT_DOUBLE_EQ(interpolated(x, y, 2), 0);
    EXPECT_DOUBLE_EQ(interpolated(x, y, -1), 0);
    EXPECT_DOUBLE_EQ(interpolated(x, y, 9), -2);
}

TEST(WaterRecord, crossings_are_found_up_and_down) {
    EXPECT_EQ(crossings(x, y, 1), (std::vector<double>{0.5, 1.5}));
    EXPECT_TRUE(crossings(x, y, 3).empty());
}

TEST(WaterTrial, tells_how_far_it_is_after_every_step) {
    CaseSetting setting;
    setting.folder = "validation/water/submerged_square";
    double told = 0;
    setting.after_step = [&told](double time, double end) {
        EXPECT_GT(time, told);
        EXPECT_LE(time, end);
        told = time;
    };
    WaterTrial water(setting, std::vector<std::string>{"end=0.002"});
    water.run();
    EXPECT_EQ(told, water.now());
}

TEST(WaterTrial, saved_on_its_way_ends_as_one_that_was_not_interrupted) {
    CaseSetting setting;
    setting.folder = "validation/water/submerged_square";
    const std::vector<std::string> overrides{"end=0.01", "output.probe_interval=0.001"};
    const auto fastest = [](const WaterTrial& trial) {
        double speed = 0;
        for (const Vec3& v : trial.state().fluid.velocity) {
            speed = std::max(speed, norm(v));
        }
        return speed;
    };
    WaterTrial straight(setting, overrides);
    straight.record("fastest", fastest);
    straight.run();

    const std::filesystem::path path = std::filesystem::temp_directory_path() / "riprap_saved.trial";
    std::filesystem::remove(path);
    for (int part = 0; part < 2; ++part) {  // the first saves before its last row, the second begins there
        int steps = 0;
        setting.after_step = [&steps](double, double) { ++steps; };
        WaterTrial parts(setting, overrides);
        parts.record("fastest", fastest);
        parts.keep_in(path);
        parts.run();
        EXPECT_EQ(parts.time(), straight.time());
        EXPECT_EQ(parts.column("fastest"), straight.column("fastest"));
        EXPECT_EQ(hash_fields(parts.state()), hash_fields(straight.state()));
        EXPECT_LT(part * steps, straight.state().step / 2);
    }
    std::filesystem::remove(path);
}

TEST(WaterTrial, does_not_take_up_what_another_case_or_program_saved) {
    CaseSetting setting;
    setting.folder = "validation/water/submerged_square";
    const std::filesystem::path path = std::filesystem::temp_directory_path() / "riprap_other.trial";
    WaterTrial trial(setting, std::vector<std::string>{"end=0.002"});
    sim::State state = trial.state();
    TrialRecord saved{{0.001}, {1}, 2, 3, 77}, wanted{{}, {}, 0, 0, 78};
    save_trial(path, trial.model(), state, saved);
    EXPECT_FALSE(take_up_trial(path, trial.model(), state, wanted));
    EXPECT_TRUE(wanted.time.empty());
    wanted.program = 77;
    const std::vector<std::string> heavier{"end=0.002", "fluid.density=1001"};
    EXPECT_FALSE(take_up_trial(path, WaterTrial(setting, heavier).model(), state, wanted));
    EXPECT_TRUE(take_up_trial(path, trial.model(), state, wanted));
    EXPECT_EQ(wanted.wall, 2);
    std::filesystem::remove(path);
}

TEST(Trial, of_a_case_file_tells_how_far_it_is_after_every_step) {
    CaseSetting setting;
    setting.folder = "validation/zhao/incline";
    std::vector<double> told;
    setting.after_step = [&told](double time, double) { told.push_back(time); };
    Trial blocks = trial_of(setting);
    blocks.step();
    blocks.step();
    ASSERT_EQ(told.size(), 2U);
    EXPECT_LT(told[0], told[1]);
    EXPECT_EQ(told[1], blocks.time());
}

}  // namespace
}  // namespace riprap::validation::water
