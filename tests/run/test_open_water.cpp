// SPDX-License-Identifier: Apache-2.0
// Water that comes and goes, and waves that are taken up: small flumes from case files, a few seconds each.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "io/temporary_folder.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/fluid/gauge/gauge_kinds.hpp"
#include "riprap/run/simulate/passage_verdict.hpp"
#include "riprap/run/simulate/restart.hpp"
#include "riprap/scene/read_case.hpp"
#include "riprap/sim/advance.hpp"
#include "riprap/sim/ledger_table.hpp"

namespace riprap::run {
namespace {

const std::string head = R"(dimension = 2
gravity = [0.0, -9.81]
end = 30.0
[material.rock]
density = 2500.0
normal_stiffness = 1.0e6
friction_coefficient = 0.3
[[body]]
name = "floor"
material = "rock"
shape = { half_space = { normal = [0.0, 1.0], offset = 0.0 } }
fixed = true
)";

/// A stream 0.3 m deep at 0.5 m/s between x = 0 and 1.2 m.
const std::string channel = head + R"([fluid]
spacing = 0.025
domain = { low = [-0.3, -0.2], high = [1.6, 1.0] }
expected_speed = 1.0
[[fluid.region]]
box = { low = [0.0, 0.0], high = [1.2, 0.3] }
velocity = [0.5, 0.0]
[[fluid.inflow]]
name = "upstream"
low = [0.0, 0.0]
high = [0.0, 0.6]
towards = "x"
speed = 0.5
level = 0.3
[[fluid.outflow]]
name = "downstream"
low = [1.2, 0.0]
high = [1.2, 0.6]
towards = "x"
level = 0.3
)";

struct FlumeRun {
    scene::LoadedCase loaded;
    sim::State state;
    sim::Scratch scratch;
    sim::StepReport report;

    explicit FlumeRun(const std::string& text) : loaded(scene::read_case_text(text, "case.toml", "/nonexistent", {})) {
        state = loaded.state;
        initialise(loaded.model, state);
    }
    void step() {
        const double dt = choose_time_step(loaded.model, state, scratch).dt;
        report = advance(loaded.model, state, scratch, dt);
        ASSERT_TRUE(report.status.ok()) << report.status.text;
    }
    template <class Look>
    void until(double time, Look look) {
        while (state.time < time && report.status.ok()) {
            step();
            look();
        }
    }
    double read(const fluid::GaugeKind* kind, const Vec3& point, const Vec3& end) const {
        fluid::Gauge gauge;
        gauge.kind = kind;
        gauge.point = point;
        gauge.end = end;
        gauge.up = {0, 1, 0};
        return read_gauge(gauge, loaded.model.particles()->settings(), state.fluid)[0];
    }
};

TEST(OpenWater, a_channel_carries_what_comes_in_and_keeps_its_level) {
    FlumeRun run(channel);
    const std::int64_t before = run.state.fluid.size();
    const auto volume = [&] { return run.read(&fluid::volume_gauge, {0, 0, 0}, {0.6, 0.8, 0}); };
    const double volume_before = volume();
    double passed = 0, level = 0;
    run.until(2.0, [&] {
        passed += run.report.dt * run.read(&fluid::flow_gauge, {0.6, 0, 0}, {0.6, 0.8, 0});
        level += run.report.dt * run.read(&fluid::surface_gauge, {0.6, 0, 0}, {0.6, 0.8, 0});
    });
    const fluid::OpenState& open = run.state.open;
    EXPECT_EQ(run.state.fluid.size(), before + open.entered[0] - open.left[0] - open.left[1]);
    EXPECT_EQ(open.left[1], 0);  // nothing back through the inflow
    EXPECT_EQ(open.entered[0], 12 * static_cast<std::int64_t>(std::floor(0.5 * run.state.time / 0.025 + 0.5)));
    // The volume past the gauge equals the inflow less the volume stored upstream, to one layer of particles.
    const double came_in = static_cast<double>(open.entered[0]) * 0.025 * 0.025;
    EXPECT_NEAR(passed, came_in - (volume() - volume_before), 12 * 0.025 * 0.025);
    EXPECT_NEAR(passed / run.state.time, 0.15, 0.03 * 0.15);  // speed times depth
    EXPECT_NEAR(level / run.state.time, 0.3, 0.5 * 0.025);    // half a spacing
    EXPECT_NEAR(static_cast<double>(run.state.fluid.size() - before), 0, 0.03 * static_cast<double>(before));
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    EXPECT_NE(text.find(from), std::string::npos) << from;
    return text.replace(text.find(from), from.size(), to);
}

TEST(OpenWater, a_channel_that_starts_from_rest_comes_to_the_level_it_is_given) {
    FlumeRun run(replaced(replaced(channel, "velocity = [0.5, 0.0]", "velocity = [0.0, 0.0]"), "level = 0.3\n",
                          "level = 0.3\nramp = 1.0\n"));
    double level = 0, time = 0;
    std::size_t most = 0;
    run.until(5.0, [&] {
        most = std::max(most, run.state.open.position.size());
        if (run.state.time > 3) {
            level += run.report.dt * run.read(&fluid::surface_gauge, {0.6, 0, 0}, {0.6, 0.8, 0});
            time += run.report.dt;
        }
    });
    EXPECT_NEAR(level / time, 0.3, 0.5 * 0.025);  // half a spacing
    EXPECT_LE(most, 12U * (4 + 1));               // rows, and the layers of a support with one on its way out
}

TEST(OpenWater, warns_of_a_block_that_drifts_into_an_outflow_when_it_arrives) {
    FlumeRun run(replaced(channel, "[fluid]", R"([[body]]
name = "block"
material = "wood"
shape = { box = [0.2, 0.1] }
position = [0.95, 0.3]
velocity = [0.5, 0.0]
[fluid]
)") + "[material.wood]\ndensity = 500.0\nnormal_stiffness = 1.0e6\nfriction_coefficient = 0.3\n");
    const double spacing = 0.025;
    double front = 0;
    std::string told;
    while (run.state.time < 1.0 && told.empty()) {
        run.step();
        told = run.report.particles.intruder;
        front = run.state.bodies.position[1].x + 0.1;
    }
    EXPECT_EQ(told, "'block' stands behind the opening 'downstream', among the layers of its water");
    EXPECT_NEAR(front, 1.2 + spacing, spacing);  // its outermost boundary particles lie under its face
}

TEST(OpenWater, a_checkpoint_with_impossible_counts_is_refused) {
    const auto is_accepted = [](auto change) {
        FlumeRun run(channel);
        change(run.state.open);
        const TemporaryFolder place;
        const RunFolder folder{place.path()};
        io::make_folder(folder.checkpoint_latest().parent_path());
        RunRecord record;
        record.end = 30;
        record.frame_interval = record.row_interval = 0.01;
        record.csv_bytes = {1, 2};
        record.frame_times = {0};
        save_checkpoint(folder, run.loaded.model, run.state, record);
        try {
            load_checkpoint(folder, run.loaded.model, run.state);
        } catch (const CheckpointError&) {
            return false;
        }
        return true;
    };
    EXPECT_TRUE(is_accepted([](fluid::OpenState&) {}));
    EXPECT_FALSE(is_accepted([](fluid::OpenState& open) { open.next_id = 3; }));
    EXPECT_FALSE(is_accepted([](fluid::OpenState& open) { open.next_id = std::int64_t{1} << 40; }));
    EXPECT_FALSE(is_accepted([](fluid::OpenState& open) { open.layers[0] = -1; }));
    EXPECT_FALSE(is_accepted([](fluid::OpenState& open) { open.entered[0] = -1; }));
    EXPECT_FALSE(is_accepted([](fluid::OpenState& open) { open.left[1] = -1; }));
}

TEST(OpenWater, the_ledgers_close_over_what_comes_in_and_goes) {
    FlumeRun run(channel);
    const double mass = run.loaded.model.particles()->settings().particle_mass;
    while (run.state.time < 1.0 && run.report.status.ok()) {
        const auto count = static_cast<double>(run.state.fluid.size());  // at the kick, before any passes
        run.step();
        ASSERT_EQ(run.report.ledger.fluid.mass, mass * count);
    }
    const sim::FluidLedger& water = run.report.ledger.fluid;
    ASSERT_GT(run.state.open.entered[0], 100);
    EXPECT_LT(std::abs(water.residual),
              0.01 * std::abs(value_of("fluid.flow_work", run.loaded.model, run.report.ledger)));
    EXPECT_LT(norm(water.momentum_residual), 1e-5 * water.mass * 9.81 * run.state.time);
}

TEST(OpenWater, a_run_that_is_continued_has_the_bits_of_one_that_was_not) {
    FlumeRun straight(channel);
    straight.until(0.3, [] {});
    const TemporaryFolder place;
    const RunFolder folder{place.path()};
    io::make_folder(folder.checkpoint_latest().parent_path());
    RunRecord record;
    record.end = 30;
    record.frame_interval = record.row_interval = 0.01;
    record.csv_bytes = {1, 2};
    record.frame_times = {0};
    save_checkpoint(folder, straight.loaded.model, straight.state, record);
    FlumeRun other(channel);
    other.state = load_checkpoint(folder, other.loaded.model, other.state).state;
    for (int k = 0; k < 60; ++k) {
        straight.step();
        other.step();
    }
    EXPECT_NE(straight.state.open.entered[0], 0);
    EXPECT_EQ(state_hash(straight.state), state_hash(other.state));
}

TEST(OpenWater, a_channel_has_the_same_bits_on_one_thread_and_on_three) {
    FlumeRun one(channel);
    parallel::set_thread_count(1);
    one.until(0.15, [] {});
    FlumeRun three(channel);
    parallel::set_thread_count(3);
    three.until(0.15, [] {});
    parallel::set_thread_count(1);
    EXPECT_NE(one.state.open.entered[0], 0);
    EXPECT_EQ(state_hash(one.state), state_hash(three.state));
}

TEST(OpenWater, water_that_falls_over_an_edge_is_gone_and_counted) {
    FlumeRun run(head + R"([[body]]
name = "wall"
material = "rock"
shape = { half_space = { normal = [1.0, 0.0], offset = 0.0 } }
fixed = true
[fluid]
spacing = 0.025
domain = { low = [-0.3, -0.2], high = [1.6, 1.0] }
[[fluid.region]]
box = { low = [0.0, 0.0], high = [0.3, 0.3] }
[[fluid.outflow]]
name = "edge"
low = [0.9, 0.0]
high = [0.9, 0.9]
towards = "x"
)");
    const std::int64_t before = run.state.fluid.size();
    run.until(1.2, [] {});
    EXPECT_EQ(run.state.fluid.size() + run.state.open.left[0], before);
    EXPECT_GT(run.state.open.left[0], before / 2);
    EXPECT_LT(std::abs(run.report.ledger.fluid.residual), 0.01 * run.report.ledger.turnover);
}

/// A flume 2 m long, 0.3 m deep, that a piston at x = 0 sends a solitary wave 0.06 m high into.
std::string flume(const std::string& absorb, const std::string& more) {
    return head + fmt::format(R"([[body]]
name = "piston"
material = "rock"
shape = {{ half_space = {{ normal = [1.0, 0.0] }} }}
motion = {{ wave_maker = {{ wave = "solitary", height = 0.06, depth = 0.3{} }} }}
[[body]]
name = "end"
material = "rock"
shape = {{ half_space = {{ normal = [-1.0, 0.0], offset = -2.0 }} }}
fixed = true
[fluid]
spacing = 0.03333333333333333
expected_speed = 1.0
domain = {{ low = [-0.5, -0.2], high = [2.2, 0.8] }}
[[fluid.region]]
box = {{ low = [0.0, 0.0], high = [2.0, 0.3] }}
{})",
                              absorb, more);
}

TEST(OpenWater, a_piston_takes_up_the_wave_that_comes_back) {
    // Back at the paddle at 3.9 s, and gone by 5.2 s; a wave does not lose nine tenths of its energy by itself.
    FlumeRun run(flume(", absorb = [0.0, 0.0]", ""));
    double largest = 0, last = 0;
    run.until(6.0, [&] {
        const double now = run.report.ledger.fluid.kinetic;
        largest = std::max(largest, now);
        last = run.state.time > 5.2 ? std::max(last, now) : 0;
    });
    EXPECT_LT(last, 0.1 * largest);
    EXPECT_LT(run.state.bodies.drive_offset[1].x, -0.1);  // it gave way
}

TEST(OpenWater, a_sponge_takes_up_a_wave_and_books_its_energy) {
    FlumeRun run(flume("", "[[fluid.sponge]]\nlow = [0.6, -0.1]\nhigh = [2.0, 0.7]\ntowards = \"x\"\n"));
    double largest = 0;
    run.until(4.5, [&] { largest = std::max(largest, run.report.ledger.fluid.kinetic); });
    const sim::FluidLedger& water = run.report.ledger.fluid;
    EXPECT_LT(water.kinetic, 0.02 * largest);
    EXPECT_GT(value_of("fluid.absorbed", run.loaded.model, run.report.ledger), 0.5 * largest);
    EXPECT_LT(std::abs(water.residual), 0.01 * run.report.ledger.turnover);
}

/// Water that is thrown up, a part of it through the top of its domain.
std::string fountain(double speed, const std::string& method) {
    return head + fmt::format(R"([fluid]
method = "{}"
spacing = 0.02
domain = {{ low = [-0.3, -0.2], high = [0.7, 0.3] }}
expected_speed = 2.5
[[fluid.region]]
box = {{ low = [0.0, 0.0], high = [0.4, 0.2] }}
velocity = [0.0, {}]
)",
                              method, speed);
}

TEST(Splash, WhatLeavesThroughTheTopIsCountedAndItsEnergyBooked) {
    for (const std::string method : {"sph", "wcmps", "mps"}) {
        SCOPED_TRACE(method);
        FlumeRun run(fountain(0, method));
        const std::int64_t before = run.state.fluid.size();
        run.until(0.01, [] {});
        run.state.fluid.velocity[7] = {0, 15};  // one particle flies off
        run.state.fluid.position[7] = {0.2, 0.28};
        const sim::Ledger early = run.report.ledger;
        run.until(0.02, [] {});
        EXPECT_EQ(run.state.fluid.size(), before - 1);
        EXPECT_THAT(splash_text(run.loaded.model, run.state), testing::HasSubstr("1 particle of water, 0.5 % of it"));
        const double m = run.loaded.model.particles()->settings().particle_mass;
        EXPECT_NEAR(run.report.ledger.fluid.transported - early.fluid.transported, -m * (112.5 + 9.81 * 0.3),
                    0.1 * m * 112.5);
    }
}

TEST(Splash, MoreThanAThousandthEndsTheRun) {
    FlumeRun run(fountain(2, "sph"));
    while (run.state.time < 0.2 && run.report.status.ok()) {
        run.report = advance(run.loaded.model, run.state, run.scratch,
                             choose_time_step(run.loaded.model, run.state, run.scratch).dt);
    }
    EXPECT_THAT(run.report.status.text, testing::HasSubstr("have left through the top of the domain"));
}

}  // namespace
}  // namespace riprap::run
