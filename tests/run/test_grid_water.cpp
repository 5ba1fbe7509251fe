// SPDX-License-Identifier: Apache-2.0
// The grid as the fluid of a case.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "io/temporary_folder.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/run/folder/run_folder.hpp"
#include "riprap/run/simulate/restart.hpp"
#include "riprap/run/simulate/simulation.hpp"

namespace riprap::run {
namespace {

/// A box 0.26 m wide and 0.2 m high that stands `height` above the bed of a tank 1 m wide, `density` over that of
/// water, and water 0.4 m deep with the box out of it.
std::string floating_box(double height, double density, const std::string& more = "") {
    return fmt::format(R"(
dimension = 2
gravity = [0.0, -9.81]
end = 10.0
[material.wood]
density = {}
normal_stiffness = 1.0e6
[[body]]
name = "box"
material = "wood"
shape = {{ box = [0.26, 0.2] }}
position = [0.5, {}]
[fluid]
method = "grid"
spacing = 0.04
domain = {{ low = [0.0, 0.0], high = [1.0, 0.8] }}
[[fluid.region]]
box = {{ low = [0.0, 0.0], high = [1.0, 0.4] }}
{})",
                       density, height, more);
}

std::string with_key(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

struct Walk {
    explicit Walk(const std::string& text) : simulation(scene::read_case_text(text, "case.toml", ".")) {}
    void go(std::int64_t last) {
        while (simulation.state().step < last) {
            const StepOutcome outcome = simulation.step(sim::Measure::energy);
            ASSERT_TRUE(outcome.is_accepted()) << outcome.why.text;
        }
    }
    double value(const char* column) const {
        return sim::evaluate(*sim::find_column(simulation.model(), column), simulation.now());
    }
    std::uint64_t hash() const { return sim::state_hash(simulation.state()); }
    Simulation simulation;
};

// A sheet of water 0.08 m thick hangs 0.24 m above a pool 0.2 m deep.
TEST(GridWater, GaugesReadAirBelowWaterAndNoTurbulenceOfLaminarFlow) {
    const std::string gauge = "[[output.gauge]]\npoint = [0.5, 0.0]\nend = [0.5, 0.8]\nname = ";
    const Walk walk(
        R"(
dimension = 2
gravity = [0.0, -9.81]
end = 1.0
[fluid]
method = "grid"
spacing = 0.04
domain = { low = [0.0, 0.0], high = [1.0, 0.8] }
[[fluid.region]]
box = { low = [0.0, 0.0], high = [1.0, 0.2] }
[[fluid.region]]
box = { low = [0.0, 0.44], high = [1.0, 0.52] }
)" + gauge +
        "\"air\"\nkind = \"overhang\"\n" +
        "[[output.gauge]]\npoint = [0.0, 0.0]\nend = [1.0, 0.8]\nname = \"k\"\nkind = \"turbulent_energy\"\n");
    EXPECT_NEAR(walk.value("air"), 0.32, 1e-3);  // from 0.2 to 0.52 m
    EXPECT_EQ(walk.value("k"), 0);
}

// Story: a step that was refused is taken again from the last good state, with nothing listed yet and without asking
// for the stable step first; a grid without bodies had no capacities then, and the program ended.
TEST(GridWater, water_without_bodies_steps_at_once_from_a_state) {
    std::string text = floating_box(0.4, 500);
    text.erase(text.find("[material"), text.find("[fluid]") - text.find("[material"));
    const scene::LoadedCase loaded =
        scene::read_case_text(with_key(text, "high = [1.0, 0.4]", "high = [0.3, 0.4]"), "case.toml", ".");
    const auto hash_after = [&loaded](bool is_dropped) {
        sim::State state = loaded.state;
        sim::initialise(loaded.model, state);
        sim::Scratch scratch;
        for (int step = 0; step < 5; ++step) {
            sim::Scratch fresh;
            EXPECT_TRUE(advance(loaded.model, state, is_dropped ? fresh : scratch, 0.001).status.ok());
        }
        return sim::state_hash(state);
    };
    EXPECT_EQ(hash_after(true), hash_after(false));
}

TEST(GridWater, a_box_at_its_draft_stays_there) {
    Walk walk(floating_box(0.4, 500, "[output]\nledger_tolerance = 0.9\n"));  // nothing turns over
    walk.go(30);
    EXPECT_NEAR(walk.value("box.position.y"), 0.4, 5e-4);  // accelerations agree to a hundredth of gravity
    EXPECT_NEAR(walk.value("box.fluid_force.y"), 500 * 0.26 * 0.2 * 9.81, 0.05 * 255);
}

TEST(GridWater, a_light_box_that_is_let_go_under_water_starts_with_buoyancy_over_its_own_and_added_mass) {
    Walk walk(floating_box(0.2, 50));
    walk.go(3);
    const double area = 0.26 * 0.2, up = walk.value("box.velocity.y") / walk.simulation.state().time;
    const double added = area * (950 * 9.81 / up - 50);  // of the box in the tank [kg/m]
    EXPECT_GT(added, 0.8 * 1000 * area);
    EXPECT_LT(added, 3 * 1000 * area);
}

// Story: where water takes several steps in one of implicit DDA, it expected a box that it had stopped in the first to
// come on with its old speed in the second, and stopped it again: a seventh of the energy that turned over was missing.
TEST(GridWater, a_box_that_is_pushed_gives_its_momentum_once_where_water_takes_several_steps_in_one_of_the_solid) {
    const auto after_a_millisecond = [](const std::string& method) {
        Walk walk(with_key(floating_box(0.4, 500, "[solid]\nmethod = \"" + method + "\"\n"),
                           "shape = ", "velocity = [0.0, 0.1]\nshape = "));
        while (walk.simulation.state().time < 0.000999) {
            walk.go(walk.simulation.state().step + 1);
        }
        const sim::Ledger& ledger = walk.simulation.report().ledger;
        EXPECT_LT(std::abs(ledger.residual), 0.03 * ledger.turnover) << method;
        return walk.value("box.velocity.y");
    };
    const double speed = after_a_millisecond("distance_potential_dem");
    EXPECT_GT(speed, 0.02);
    EXPECT_LT(speed, 0.06);
    EXPECT_NEAR(after_a_millisecond("implicit_dda"), speed, 0.05 * speed);
    EXPECT_NEAR(after_a_millisecond("planar_dda"), speed, 0.05 * speed);
}

// Story: cells that the surface cuts counted the water of both regions, and the overlap stood up to a cell too high.
TEST(GridWater, where_two_regions_overlap_is_there_once) {
    const std::string one = with_key(floating_box(0.7, 500), "high = [1.0, 0.4]", "high = [1.0, 0.41]");
    Walk walk(with_key(one, "box = { low = [0.0, 0.0], high = [1.0, 0.41] }",
                       "box = { low = [0.0, 0.0], high = [0.61, 0.41] }\n[[fluid.region]]\n"
                       "box = { low = [0.3, 0.0], high = [1.0, 0.41] }"));
    walk.go(1);
    EXPECT_NEAR(walk.simulation.report().ledger.fluid.mass, 1000 * 0.41, 1e-7);
}

TEST(GridWater, the_water_that_a_box_displaces_rises_and_none_is_lost) {
    Walk walk(floating_box(0.45, 500));
    walk.go(60);
    const sim::Ledger& ledger = walk.simulation.report().ledger;
    EXPECT_NEAR(ledger.fluid.mass, 1000 * (0.4 - 0.26 * 0.05), 1e-7);
    EXPECT_LT(std::abs(ledger.residual), 0.02 * ledger.turnover);
    const double let_go = 0.5 * 1000 * 9.81 * 0.26 * 0.05 * 0.05;  // energy over that of the draft [J]
    EXPECT_GT(ledger.fluid.own.front(), -0.1 * let_go);
    EXPECT_LT(ledger.fluid.own.front(), let_go);
}

/// A piston in a shaft that reaches down into the water of a tank, and air between both.
std::string piston_over_air() {
    return R"(
dimension = 2
gravity = [0.0, -9.81]
end = 10.0
[material.wood]
density = 600.0
normal_stiffness = 1.0e6
[[body]]
name = "piston"
material = "wood"
shape = { box = [0.298, 0.2] }
position = [0.5, 0.7]
[[body]]
name = "left"
material = "wood"
shape = { box = [0.1, 0.9] }
position = [0.3, 0.65]
fixed = true
[[body]]
name = "right"
material = "wood"
shape = { box = [0.1, 0.9] }
position = [0.7, 0.65]
fixed = true
[fluid]
method = "grid"
spacing = 0.05
domain = { low = [0.0, 0.0], high = [1.0, 1.2] }
[[fluid.region]]
box = { low = [0.0, 0.0], high = [1.0, 0.4] }
)";
}

// Story: a tetrapod that fell on others with air shut in below it had a load that swung from step to step, -4 and +1
// times its weight: by its dry surface it had no added mass, so its load was that of the acceleration of the step
// before.
TEST(GridWater, a_piston_that_falls_on_a_cushion_of_air_has_the_water_below_to_move) {
    Walk walk(piston_over_air());
    walk.go(3);
    const double acceleration = -walk.value("piston.velocity.y") / walk.simulation.state().time;
    double before = walk.value("piston.fluid_force.y");
    const double weight = 600 * 0.298 * 0.2 * 9.81;
    for (int step = 4; step <= 12; ++step) {
        walk.go(step);
        const double force = walk.value("piston.fluid_force.y");
        EXPECT_NEAR(force / weight, before / weight, 0.15) << step;
        before = force;
    }
    // columns: 0.2 m in the shaft and, by (0.3/0.5)^2 for their width, 0.2 m beside it, at least: 60 + 36 kg/m over 36
    EXPECT_LT(acceleration, 9.81 * 36 / (36 + 96));
    EXPECT_GT(acceleration, 9.81 * 36 / (36 + 3 * 96));
}

/// A channel 4 m long with water 0.5 m deep, and something more.
std::string channel(const std::string& more) {
    return R"(
dimension = 2
gravity = [0.0, -9.81]
end = 10.0
[material.wood]
density = 600.0
normal_stiffness = 1.0e6
[fluid]
method = "grid"
spacing = 0.1
domain = { low = [0.0, 0.0], high = [4.0, 1.0] }
[[fluid.region]]
level = 0.53
)" + more;
}

TEST(GridWater, beside_still_water_of_the_same_level_stays_still_to_round_off) {
    Walk walk(
        channel("[[fluid.outflow]]\nname = \"sea\"\nlow = [4.0, 0.0]\nhigh = [4.0, 1.0]\ntowards = \"x\"\n"
                "level = 0.53\n"));
    walk.go(20);
    EXPECT_LT(walk.value("max_water_speed"), 1e-9);
}

// Water came in with all the pressure of its level and its speed on top: a tilt of a centimetre grew, and the tank
// filled.
TEST(GridWater, beside_still_water_swings_ever_less_about_its_level) {
    Walk walk(R"(
dimension = 2
gravity = [0.0, -9.81]
end = 10.0
[material.wood]
density = 600.0
normal_stiffness = 1.0e6
[fluid]
method = "grid"
spacing = 0.05
domain = { low = [0.0, 0.0], high = [2.0, 1.0] }
[[fluid.region]]
box = { low = [0.0, 0.0], high = [1.0, 0.61] }
[[fluid.region]]
box = { low = [1.0, 0.0], high = [2.0, 0.59] }
[[fluid.outflow]]
name = "sea"
low = [2.0, 0.0]
high = [2.0, 1.0]
towards = "x"
level = 0.6
)");
    double most = 0;
    for (int step = 1; walk.simulation.state().time < 6; ++step) {
        walk.go(step);
        most = std::max(most, walk.value("water_mass"));
    }
    EXPECT_LT(most, 1200 + 20);
    EXPECT_NEAR(walk.value("water_mass"), 1200, 6);
}

TEST(GridWater, that_comes_in_through_an_opening_is_what_its_speed_brings) {
    Walk walk(
        channel("[[fluid.inflow]]\nname = \"spring\"\nlow = [0.0, 0.1]\nhigh = [0.0, 0.35]\ntowards = \"x\"\n"
                "speed = 0.4\n[[fluid.outflow]]\nname = \"drain\"\nlow = [4.0, 0.0]\nhigh = [4.0, 0.15]\n"
                "towards = \"x\"\nspeed = 0.2\n"));
    walk.go(25);
    const double time = walk.simulation.state().time;
    EXPECT_NEAR(walk.value("water_mass"), 1000 * (4 * 0.53 + (0.25 * 0.4 - 0.15 * 0.2) * time), 0.01);
}

TEST(GridWater, takes_openings_on_sides_of_the_domain_alone_and_whole_sides_where_no_speed_is_given) {
    const auto refused = [](const std::string& more, const std::string& why) {
        try {
            Walk walk(channel(more));
            ADD_FAILURE() << "accepted";
        } catch (const CaseError& error) {
            EXPECT_NE(std::string(error.what()).find(why), std::string::npos) << error.what();
        }
    };
    refused("[[fluid.inflow]]\nname = \"a\"\nlow = [1.0, 0.1]\nhigh = [1.0, 0.35]\ntowards = \"x\"\nspeed = 0.4\n",
            "an opening at x = 1 m, where the domain ends at 0 m");
    refused("[[fluid.outflow]]\nname = \"a\"\nlow = [4.0, 0.2]\nhigh = [4.0, 1.0]\ntowards = \"x\"\n",
            "a part of its side");
}

TEST(GridWater, that_does_not_feel_bodies_lifts_one_with_what_it_displaced_at_the_start) {
    Walk walk(with_key(floating_box(0.2, 50), "method = \"grid\"", "method = \"grid\"\ncoupling = \"one_way\""));
    walk.go(2);  // the first step had no acceleration to guess from
    const double gap = walk.value("coupling_gap");
    walk.go(8);
    const double upwards = (1000.0 / 50 - 1) * 9.81;  // no added mass
    EXPECT_NEAR(walk.value("box.velocity.y"), upwards * walk.simulation.state().time,
                1e-6 * upwards * walk.simulation.state().time);
    EXPECT_LT(walk.value("max_water_speed"), 1e-9);
    EXPECT_NEAR(walk.value("coupling_gap"), gap, 1e-9 * walk.simulation.report().ledger.turnover);
}

TEST(GridWater, that_does_not_feel_bodies_presses_a_deformable_block_as_still_water_does) {
    // As heavy as water, it stays; its mean stress is the pressure at its centre, 0.2 m deep.
    const std::string block = with_key(floating_box(0.2, 1000, "[output]\nledger_tolerance = 0.9\n"), "[fluid]",
                                       "[solid]\nmethod = \"planar_dda\"\nyoungs_modulus = \"10 MPa\"\n"
                                       "contact_stiffness = 1e6\nstep = \"5 ms\"\n[fluid]");
    Walk walk(with_key(block, "method = \"grid\"", "method = \"grid\"\ncoupling = \"one_way\""));
    walk.go(25);
    EXPECT_NEAR(walk.value("box.fluid_force.y"), 1000 * 9.81 * 0.26 * 0.2, 1e-6 * 510);
    EXPECT_NEAR(walk.value("box.stress_xx"), -1000 * 9.81 * 0.2, 0.01 * 1962);
    EXPECT_NEAR(walk.value("box.stress_yy"), -1000 * 9.81 * 0.2, 0.01 * 1962);
    EXPECT_NEAR(walk.value("box.position.y"), 0.2, 1e-9);
}

TEST(GridWater, that_does_not_feel_bodies_presses_blocks_in_space_as_still_water_does) {
    const std::string scene = R"(
gravity = [0.0, 0.0, -9.81]
end = 10.0
[material.rock]
density = 1000.0
normal_stiffness = 1.0e6
[[body]]
name = "box"
material = "rock"
shape = { box = [0.26, 0.24, 0.2] }
position = [0.3, 0.3, 0.2]
[fluid]
method = "grid"
coupling = "one_way"
spacing = 0.06
domain = { low = [0.0, 0.0, 0.0], high = [0.6, 0.6, 0.6] }
[[fluid.region]]
box = { low = [0.0, 0.0, 0.0], high = [0.6, 0.6, 0.4] }
[output]
ledger_tolerance = 0.9
[solid]
youngs_modulus = "10 MPa"
contact_stiffness = 1e6
)";
    for (const std::string more :
         {"method = \"implicit_dda\"\nstep = \"5 ms\"\n", "method = \"explicit_dda\"\nmass_damping = 500.0\n"}) {
        Walk walk(scene + more);
        while (walk.simulation.state().time < 0.1) {
            walk.go(walk.simulation.state().step + 1);
        }
        EXPECT_NEAR(walk.value("box.fluid_force.z"), 9810 * 0.26 * 0.24 * 0.2, 1e-6 * 122);
        const double pressure = 9810 * (0.4 - 0.2);
        for (const char* stress : {"box.stress_xx", "box.stress_yy", "box.stress_zz"}) {
            EXPECT_NEAR(walk.value(stress), -pressure, 0.01 * pressure) << stress << more;
        }
        EXPECT_NEAR(walk.value("box.position.z"), 0.2, 1e-6);
    }
}

TEST(GridWater, pressure_iterations_of_a_step_are_a_quantity) {
    Walk walk(floating_box(0.45, 500));
    walk.go(3);
    EXPECT_GE(walk.value("solver_iterations"), walk.value("water_passes"));
    EXPECT_LT(walk.value("solver_residual"), 1e-4);
}

// Story: water goes through a step with the velocity of its start, and its potential energy was set against a kinetic
// energy half a step later: all of what a dam break had at the end of its first step was booked as made from nothing.
TEST(GridWater, that_falls_has_the_energy_that_gravity_gave_it_from_the_first_step_on) {
    Walk walk(R"(
dimension = 2
gravity = [0.0, -9.81]
end = 10.0
[material.wood]
density = 600.0
normal_stiffness = 1.0e6
[fluid]
method = "grid"
spacing = 0.04
domain = { low = [0.0, 0.0], high = [0.8, 0.4] }
[[fluid.region]]
box = { low = [0.0, 0.0], high = [0.3, 0.36] }
)");
    sim::State old = walk.simulation.state();  // that of water which has been there for long: its steps are whole
    std::get<coupling::GridFluidFields>(old.fluid_fields).water.time = 10;
    RunRecord record;
    walk.simulation.note(record);
    walk.simulation.restore(std::move(old), record);
    walk.go(1);
    const double kinetic = walk.value("fluid.kinetic");
    EXPECT_GT(kinetic, 1);
    EXPECT_LT(std::abs(walk.value("fluid.dissipated")), 0.05 * kinetic);
}

class GridBits : public ::testing::Test {
 protected:
    ~GridBits() override { parallel::set_thread_count(1); }
};

TEST_F(GridBits, are_the_same_at_any_thread_count_and_after_a_restart) {
    const std::string text = floating_box(0.45, 500);
    parallel::set_thread_count(1);
    Walk straight(text);
    straight.go(10);
    const sim::State stopped = straight.simulation.state();
    straight.go(20);
    for (const int threads : {2, 4}) {
        parallel::set_thread_count(threads);
        Walk walk(text);
        walk.go(20);
        EXPECT_EQ(walk.hash(), straight.hash()) << threads << " threads";
    }
    const TemporaryFolder place;
    const RunFolder folder{place.path()};
    io::make_folder(folder.checkpoint_latest().parent_path());
    Walk walk(text);
    RunRecord record;
    walk.simulation.note(record);
    record.frame_interval = record.row_interval = 1;
    record.csv_bytes = {0, 0};
    save_checkpoint(folder, walk.simulation.model(), stopped, record);
    Restart restart = load_checkpoint(folder, walk.simulation.model(), walk.simulation.initial());
    walk.simulation.restore(std::move(restart.state), record);
    walk.go(20);
    EXPECT_EQ(walk.hash(), straight.hash());
}

}  // namespace
}  // namespace riprap::run
