// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "riprap/core/fields.hpp"
#include "riprap/validation/zhao/pile.hpp"

namespace riprap::validation::zhao {
namespace {

Trial few_cubes(const CaseSetting& setting) {
    return trial_of(setting, std::vector<std::string>{"body.cube.repeat.counts=[1,1,2]", "end=0.6"});
}

// A pile of a thousand blocks falls for half a day: what a killed run has done must not be lost.
TEST(Pile, whose_fall_was_cut_off_goes_on_to_the_same_bits) {
    CaseSetting setting;
    setting.folder = "validation/zhao/cubes_in_box";
    Trial straight = few_cubes(setting);
    const PileRun whole = fall_to_rest(straight, 0.004, setting, "pile");

    setting.results = std::filesystem::temp_directory_path() / "riprap_test_pile";
    std::filesystem::remove_all(setting.results);
    Trial cut = few_cubes(setting);
    cut.tell([](double time, double) {
        if (time > 0.53) {
            throw std::runtime_error("cut off");
        }
    });
    EXPECT_THROW(fall_to_rest(cut, 0.004, setting, "pile"), std::runtime_error);

    Trial rest = few_cubes(setting);
    int steps = 0;
    rest.tell([&steps](double, double) { ++steps; });
    const PileRun taken_up = fall_to_rest(rest, 0.004, setting, "pile");
    EXPECT_LT(steps, rest.state().step / 4);  // from the moment 0.5 s on
    EXPECT_EQ(hash_fields(rest.state()), hash_fields(straight.state()));
    EXPECT_EQ(taken_up.times, whole.times);
    EXPECT_EQ(taken_up.kinetic, whole.kinetic);
    EXPECT_EQ(taken_up.share_of_bound, whole.share_of_bound);
    EXPECT_EQ(taken_up.support, whole.support);
    EXPECT_EQ(taken_up.energy_error, whole.energy_error);
    EXPECT_EQ(taken_up.mean_height, whole.mean_height);
    EXPECT_EQ(taken_up.fall, whole.fall);
    std::filesystem::remove_all(setting.results);
}

// Story: a fall that had ended was taken up at its end, with no support and no energy.
TEST(Pile, whose_fall_has_ended_says_the_same_again) {
    CaseSetting setting;
    setting.folder = "validation/zhao/cubes_in_box";
    setting.results = std::filesystem::temp_directory_path() / "riprap_test_pile_ended";
    std::filesystem::remove_all(setting.results);
    const auto fall = [&] {  // the moment 0.5 s is in its last window
        Trial trial = trial_of(setting, std::vector<std::string>{"body.cube.repeat.counts=[1,1,2]", "end=0.505"});
        return fall_to_rest(trial, 0.004, setting, "pile");
    };
    const PileRun first = fall(), again = fall();
    EXPECT_GT(first.support, 0.5);
    EXPECT_EQ(again.support, first.support);
    EXPECT_EQ(again.energy_error, first.energy_error);
    EXPECT_EQ(again.max_potential, first.max_potential);
    std::filesystem::remove_all(setting.results);
}

}  // namespace
}  // namespace riprap::validation::zhao
