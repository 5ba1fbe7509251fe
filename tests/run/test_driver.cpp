// SPDX-License-Identifier: Apache-2.0
// The driver shares a step out between the methods, and cuts pieces that a solid method refuses.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "riprap/scene/read_case.hpp"
#include "riprap/sim/advance.hpp"
#include "riprap/sim/time_step.hpp"

namespace riprap::run {
namespace {

/// A block of implicit DDA, 1 m wide, that falls from 1 m/s on.
/// @param limit  displacement of a corner in a step above which the method refuses the step [m]
scene::LoadedCase falling_block(double limit) {
    scene::LoadedCase loaded = scene::read_case_text(fmt::format(R"(gravity = [0.0, 0.0, -9.81]
end = 1.0
[material.rock]
density = 2500.0
normal_stiffness = 1.0e7
[solid]
method = "implicit_dda"
step = 0.1
max_displacement = {}
[[body]]
name = "block"
material = "rock"
shape = {{ cube = 1.0 }}
velocity = [0.0, 0.0, -1.0]
)",
                                                                 limit),
                                                     "case.toml", "/nonexistent");
    sim::initialise(loaded.model, loaded.state);
    return loaded;
}

sim::StepReport step(scene::LoadedCase& loaded, double dt) {
    sim::Scratch scratch;
    return sim::advance(loaded.model, loaded.state, scratch, dt, sim::Measure::energy);
}

TEST(Driver, takes_a_refused_piece_back_and_takes_its_halves) {
    scene::LoadedCase whole = falling_block(0.1);  // 0.1 s bring it 0.15 m down, 0.05 s less than 0.1 m
    const sim::StepReport cut = step(whole, 0.1);
    ASSERT_TRUE(cut.status.ok()) << cut.status.text;
    scene::LoadedCase halves = falling_block(0.1);
    ASSERT_TRUE(step(halves, 0.05).status.ok());
    const sim::StepReport last = step(halves, 0.05);
    EXPECT_EQ(whole.state.bodies, halves.state.bodies);
    EXPECT_EQ(whole.state.step, 1);
    EXPECT_NEAR(whole.state.bodies.position[0].z, -0.1 - 0.5 * 9.81 * 0.01, 1e-12);
    EXPECT_NEAR(cut.ledger.kinetic, last.ledger.kinetic, 1e-12 * last.ledger.kinetic);
    EXPECT_LT(std::abs(cut.ledger.residual), 1e-9 * cut.ledger.turnover);
}

TEST(Driver, gives_up_after_ten_halvings_with_the_words_of_the_method) {
    scene::LoadedCase loaded = falling_block(1e-6);
    const sim::StepReport report = step(loaded, 0.1);
    EXPECT_FALSE(report.status.ok());
    EXPECT_THAT(report.status.text, testing::HasSubstr("a corner moves"));
}

TEST(Driver, lets_a_fluid_take_several_steps_within_one_of_the_solids_and_keeps_momentum) {
    scene::LoadedCase loaded = scene::read_case_text(R"(dimension = 2
gravity = [0.0, -9.81]
end = 0.5
[material.wood]
density = 700.0
normal_stiffness = 1.0e6
[solid]
method = "planar_dda"
step = 5e-3
[fluid]
method = "sph"
spacing = 0.025
domain = { low = [-0.2, -0.2], high = [0.8, 1.0] }
[[fluid.region]]
box = { low = [0.0, 0.0], high = [0.6, 0.25] }
[[body]]
name = "bottom"
material = "wood"
shape = { half_space = { normal = [0.0, 1.0], offset = 0.0 } }
fixed = true
[[body]]
name = "left"
material = "wood"
shape = { half_space = { normal = [1.0, 0.0], offset = 0.0 } }
fixed = true
[[body]]
name = "right"
material = "wood"
shape = { half_space = { normal = [-1.0, 0.0], offset = -0.6 } }
fixed = true
[[body]]
name = "block"
material = "wood"
shape = { box = [0.2, 0.1] }
position = [0.25, 0.34]
velocity = [0.0, -0.8]
)",
                                                     "case.toml", "/nonexistent");
    sim::initialise(loaded.model, loaded.state);
    sim::Scratch scratch;
    sim::StepReport report;
    constexpr int growing = 114;  // steps to 5 ms from 0.02 ms, by a twentieth each
    for (int i = 0; i < growing + 20; ++i) {
        const double dt = sim::choose_time_step(loaded.model, loaded.state, scratch).dt;
        report = sim::advance(loaded.model, loaded.state, scratch, dt, sim::Measure::energy);
        ASSERT_TRUE(report.status.ok()) << report.status.text;
        EXPECT_EQ(report.substeps, 1);
        if (i > growing) {
            EXPECT_GT(dt, 2 * sim::step_bound(loaded.model, loaded.state).limit);  // the bound of the fluid
        }
    }
    const double passed = report.ledger.fluid.mass * 9.81 * loaded.state.time;  // momentum that gravity has brought
    EXPECT_LT(norm(report.ledger.momentum_residual), 1e-9 * passed);
    EXPECT_LT(norm(report.ledger.fluid.momentum_residual), 1e-5 * passed);  // pair forces are summed in float
    EXPECT_GT(std::abs(loaded.state.bodies.velocity.back().y + 0.8 + 9.81 * loaded.state.time), 0.1);  // water met it
}

}  // namespace
}  // namespace riprap::run
