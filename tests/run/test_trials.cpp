// SPDX-License-Identifier: Apache-2.0
// Trials of the solids in water that cannot give way: what they leave behind, how many there are, whose time it is.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <vector>

#include "io/temporary_folder.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/core/timer.hpp"
#include "riprap/run/simulate/restart.hpp"
#include "riprap/scene/read_case.hpp"
#include "riprap/sim/advance.hpp"
#include "riprap/sim/trial.hpp"

namespace riprap::run {
namespace {

constexpr std::int64_t steps = 14;

/// Water by mps about a block that lies in its bed by a ten-thousandth of a metre.
scene::LoadedCase block_in_water(const std::string& solid) {
    const std::vector<std::string> overrides{fmt::format("solid.method='{}'", solid),
                                             "body.block.position=[0.5,0.0999]", "fluid.spacing=0.025"};
    return scene::read_case("tests/run/methods/fluid-mps.toml", overrides);
}

/// A run that can be stopped, its Scratch dropped and its State put back.
class Walk {
 public:
    explicit Walk(const std::string& solid) : loaded_(block_in_water(solid)) {
        sim::initialise(loaded_.model, loaded_.state);
        initial_ = state = loaded_.state;
    }
    void go(std::int64_t last, std::int64_t dropped_every = 0) {
        while (state.step < last) {
            if (dropped_every > 0 && state.step % dropped_every == 0) {
                scratch.forget();
            }
            const double dt = choose_time_step(loaded_.model, state, scratch).dt;
            const sim::StepReport report = advance(loaded_.model, state, scratch, dt, sim::Measure::flow);
            ASSERT_TRUE(report.status.ok()) << report.status.text;
            hashes.push_back(state_hash(state));
        }
    }
    /// Writes a checkpoint, and reads it into a fresh run.
    void resume_in(Walk& other, std::int64_t at_step) {
        const TemporaryFolder place;
        const RunFolder folder{place.path()};
        io::make_folder(folder.checkpoint_latest().parent_path());
        go(at_step);
        RunRecord record;
        record.end = record.frame_interval = record.row_interval = 1;
        record.csv_bytes = {0, 0};
        save_checkpoint(folder, loaded_.model, state, record);
        other.state = load_checkpoint(folder, other.loaded_.model, other.initial_).state;
    }

    sim::State state;
    sim::Scratch scratch;
    std::vector<std::uint64_t> hashes;

 private:
    scene::LoadedCase loaded_;
    sim::State initial_;
};

class Trials : public ::testing::TestWithParam<std::string> {
 protected:
    ~Trials() override { parallel::set_thread_count(1); }
};

TEST_P(Trials, leave_every_bit_as_it_is_without_scratch_and_after_a_resume) {
    parallel::set_thread_count(1);
    Walk straight(GetParam());
    ASSERT_NO_FATAL_FAILURE(straight.go(steps));
    parallel::set_thread_count(2);
    for (const std::int64_t every : {1, 3}) {
        Walk walk(GetParam());
        ASSERT_NO_FATAL_FAILURE(walk.go(steps, every));
        EXPECT_EQ(walk.hashes, straight.hashes) << "dropped every " << every;
    }
    for (const std::int64_t stop : {4, 9}) {
        Walk first(GetParam()), second(GetParam());
        ASSERT_NO_FATAL_FAILURE(first.resume_in(second, stop));
        ASSERT_NO_FATAL_FAILURE(second.go(steps));
        EXPECT_EQ(second.hashes, std::vector<std::uint64_t>(straight.hashes.begin() + stop, straight.hashes.end()))
            << "stopped at step " << stop;
    }
}

TEST_P(Trials, count_as_time_of_the_solids_alone) {
    Walk walk(GetParam());
    const Timer all;
    ASSERT_NO_FATAL_FAILURE(walk.go(steps));
    const double passed = all.seconds();
    const sim::StageTimes times = stage_times(walk.scratch);
    EXPECT_GT(times.fluid, 0);
    EXPECT_LE(
        times.find_pairs + times.find_contacts + times.contact_loads + times.move_bodies + times.measure + times.fluid,
        passed);
}

INSTANTIATE_TEST_SUITE_P(Solids, Trials,
                         ::testing::Values("distance_potential_dem", "sphere_dem", "explicit_dda", "implicit_dda",
                                           "planar_dda"),
                         [](const auto& solid) { return solid.param; });

TEST(TrialsOfAStep, end_when_bodies_go_as_the_water_was_told_or_after_sixteen) {
    for (const int others : {0, 3, 15, 16, 100}) {
        int trials = 0, loads = 0;
        const bool is_settled = sim::settle_ways([&] { return trials++ < others; }, [&] { ++loads; });
        EXPECT_EQ(is_settled, others < 16) << others;
        EXPECT_EQ(trials, std::min(others + 1, 16)) << others;
        EXPECT_EQ(loads, std::min(others, 16)) << others;
    }
}

TEST(TrialsOfAStep, take_a_way_for_another_from_a_thousandth_of_gravity_and_of_the_acceleration_on) {
    scene::LoadedCase loaded = block_in_water("distance_potential_dem");
    sim::State& state = loaded.state;
    sim::initialise(loaded.model, state);
    const std::size_t count = state.bodies.position.size(), block = 1;
    const double dt = 1e-3, gravity = 9.81;
    const auto is_other = [&](double more, double guessed) {
        sim::State told = state;
        sim::Scratch scratch;
        sim::BoundMethods bound(loaded.model, told, scratch.data());
        sim::StepContext step = begin_step(loaded.model, told, scratch.data(), bound, dt, sim::Measure::flow, {});
        scratch.data().span_loads.clear(count, false);
        sim::Prediction& prediction = scratch.data().prediction;
        update_kinematics(loaded.model.bodies, state.bodies, 0, prediction.kinematics);
        prediction.guess.assign(count, {});
        prediction.guess[block].linear = {guessed, 0, 0};
        prediction.middle.velocity.assign(count, {});
        prediction.middle.angular_velocity.assign(count, {});
        prediction.middle.velocity[block] = {2, 0, 0};
        told.coupling.dry_acceleration[block] = {guessed, 0, 0};
        body::BodyState after = state.bodies;
        after.position[block] += Vec3{2 * dt, 0.5 * dt * dt * more, 0};
        const bool result = go_another_way(step, after, {});
        EXPECT_NEAR(prediction.guess[block].linear.y, more, 1e-6 * gravity);  // where the trial went
        return result;
    };
    for (const double guessed : {0.0, 30.0}) {
        EXPECT_FALSE(is_other(0.0009 * (gravity + guessed), guessed));
        EXPECT_TRUE(is_other(0.0011 * (gravity + guessed), guessed));
    }
}

}  // namespace
}  // namespace riprap::run
