// SPDX-License-Identifier: Apache-2.0
#include "riprap/bench/step_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "riprap/core/parallel.hpp"

namespace riprap::bench {
namespace {

constexpr StepSize coarse{2.5, 4};  // tens of blocks

std::int64_t free_blocks(const StepScene& scene) {
    return std::ranges::count(scene.model.bodies.drive, body::Drive::free);
}

/// Some steps of a scene.
struct Taken {
    sim::State state;
    std::string problem;
};
Taken take(StepScene scene, int steps) {
    sim::Scratch scratch;
    sim::StepReport report;
    for (int k = 0; k < steps && report.status.ok(); ++k) {
        const double dt = sim::full_time_step(scene.model, scene.state, scratch).dt;
        report = sim::advance(scene.model, scene.state, scratch, dt, sim::Measure::flow);
    }
    return {std::move(scene.state), report.status.text};
}

TEST(StepScene, EverySceneTakesStepsWithTheSameBitsOnAnyNumberOfThreads) {
    for (const StepScene& scene : {dam_break_on_box(coarse), dam_break_with_floes({2.5, 1}),
                                   rubble_in_basin(Rubble::in_basin, 1.0 / 3, coarse), slide_into_water(coarse)}) {
        EXPECT_GT(scene.state.fluid.size(), 50);
        parallel::set_thread_count(1);
        const Taken one = take(scene, 3);
        parallel::set_thread_count(2);
        const Taken two = take(scene, 3);
        parallel::set_thread_count(1);
        EXPECT_EQ(one.problem, "");
        EXPECT_EQ(sim::state_hash(one.state), sim::state_hash(two.state));
    }
}

TEST(StepScene, WaterWithAndWithoutTheRubbleInItIsTheSame) {
    const StepScene with = rubble_in_basin(Rubble::in_basin, 0.5, coarse),
                    none = rubble_in_basin(Rubble::none, 0.5, coarse);
    EXPECT_EQ(with.state.fluid.position, none.state.fluid.position);
    EXPECT_EQ(free_blocks(with), 4 * 4 * 3);
    EXPECT_EQ(free_blocks(none), 0);
    // Story: water whose blocks are taken away was counted as lost, and the bench stopped in its first step.
    EXPECT_EQ(take(none, 1).problem, "");
    const auto of_blocks = with.model.particles()->samples.size() - none.model.particles()->samples.size();
    EXPECT_GT(of_blocks, 48);
}

TEST(StepScene, WaterFeelsNoSampleOfBlocksThatStandFarAway) {
    constexpr StepSize size{2, 4};  // finer, so that the blocks are out of reach
    const StepScene scene = rubble_in_basin(Rubble::far_dry, 0.5, size);
    const Taken far = take(scene, 2), none = take(rubble_in_basin(Rubble::nowhere, 0.5, size), 2);
    EXPECT_EQ(far.problem, "");
    const coupling::SampleSet& samples = scene.model.particles()->samples;
    std::int64_t of_blocks = 0;
    for (const std::int32_t i : far.state.coupling.near_samples) {
        const auto body = static_cast<std::size_t>(samples.body[static_cast<std::size_t>(i)].value);
        of_blocks += scene.model.bodies.drive[body] != body::Drive::fixed ? 1 : 0;
    }
    ASSERT_LE(of_blocks, 3);  // samples go in fours: the last ones of the basin with the first ones of the next body
    ASSERT_EQ(far.state.fluid.size(), none.state.fluid.size());
    for (std::size_t i = 0; i < none.state.fluid.position.size(); ++i) {
        ASSERT_LT(norm(far.state.fluid.position[i] - none.state.fluid.position[i]), 1e-7);
    }
}

}  // namespace
}  // namespace riprap::bench
