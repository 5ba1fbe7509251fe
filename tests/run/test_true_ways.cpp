// SPDX-License-Identifier: Apache-2.0
// Ledgers of bodies with water close in every step: walls make up for the way that they missed, leapfrog keeps its own
// energy, and what blocks get by straining has an account.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "riprap/run/simulate/ledger_verdict.hpp"
#include "riprap/run/simulate/simulation.hpp"
#include "riprap/scene/read_case.hpp"
#include "riprap/sim/prediction.hpp"

namespace riprap::run {
namespace {

/// A block in a tank 1 m wide with water 0.6 m deep.
constexpr const char* tank = R"(dimension = 2
gravity = [0.0, -9.81]
end = {}
[material.rock]
density = 2500.0
normal_stiffness = 1.0e7
friction_coefficient = 0.4
damping_ratio = 0.2
[solid]
method = "{}"
[fluid]
spacing = 0.05
domain = {{ low = [-0.3, -0.3], high = [1.3, 1.0] }}
method = "{}"
[[fluid.region]]
box = {{ low = [0.0, 0.0], high = [1.0, 0.6] }}
[[body]]
name = "bottom"
shape = {{ half_space = {{ normal = [0.0, 1.0] }} }}
material = "rock"
fixed = true
[[body]]
name = "left"
shape = {{ half_space = {{ normal = [1.0, 0.0] }} }}
material = "rock"
fixed = true
[[body]]
name = "right"
shape = {{ half_space = {{ normal = [-1.0, 0.0] }} }}
position = [1.0, 0.0]
material = "rock"
fixed = true
[[body]]
name = "block"
shape = {{ {} }}
position = [0.5, {}]
density = {}
material = "rock"
)";

struct Trial {
    const char *name, *solid, *fluid, *shape;
    double height, density, end;
    double most;  ///< of what is looked at, over what is turned over [-]
};

sim::Ledger ledger_after(const Trial& trial) {
    Simulation simulation(scene::read_case_text(
        fmt::format(fmt::runtime(tank), trial.end, trial.solid, trial.fluid, trial.shape, trial.height, trial.density),
        "case.toml", "."));
    while (simulation.steps_left() > 0) {
        const StepOutcome outcome = simulation.step(sim::Measure::energy);
        EXPECT_TRUE(outcome.is_accepted()) << outcome.why.text;
        if (!outcome.is_accepted()) {
            break;
        }
    }
    return simulation.report().ledger;
}

const auto name_of = [](const auto& trial) { return std::string(trial.param.name); };

// What water works on the way foreseen and a body on its own differed by F dt^2 (a_end - a_0)/2 and by each impact:
// 6e-4 (mps, planar 7e-4, blocks that strain 4e-3) and 4e-4 (sph).
class WaterUnderALid : public ::testing::TestWithParam<Trial> {};
INSTANTIATE_TEST_SUITE_P(
    Methods, WaterUnderALid,
    ::testing::Values(
        Trial{"rigid_on_mps", "distance_potential_dem", "mps", "box = [1.0, 0.25]", 0.725, 1900, 0.1, 1e-4},
        Trial{"planar_on_mps", "planar_dda", "mps", "box = [1.0, 0.25]", 0.725, 1900, 0.1, 1e-4},
        Trial{"elastic_on_mps", "explicit_dda", "mps", "box = [1.0, 0.25]", 0.725, 1900, 0.1, 1e-4},
        Trial{"rigid_on_sph", "distance_potential_dem", "sph", "box = [1.0, 0.25]", 0.725, 1900, 0.1, 1e-4}),
    name_of);

TEST_P(WaterUnderALid, works_along_the_way_that_the_lid_went) {
    const sim::Ledger ledger = ledger_after(GetParam());
    EXPECT_LT(std::abs(ledger.fluid.coupling_gap), GetParam().most * ledger.turnover);
    EXPECT_GT(ledger.turnover, 1);  // [J/m]
}

// More is what an impact within a step leaves out: walls that made up for that went on with the speed that the body
// lost.
TEST(WaysThatWallsMissed, AreMadeUpForByNoMoreThanGravityDoesInAStep) {
    scene::LoadedCase loaded = scene::read_case_text(
        fmt::format(fmt::runtime(tank), 0.1, "distance_potential_dem", "mps", "box = [0.4, 0.3]", 0.5, 1900),
        "case.toml", ".");
    sim::initialise(loaded.model, loaded.state);
    constexpr double dt = 1e-3, most = 0.5 * 9.81 * dt;  // [s], [m/s]
    sim::Scratch scratch;
    sim::BoundMethods bound(loaded.model, loaded.state, scratch.data());
    sim::StepContext step = begin_step(loaded.model, loaded.state, scratch.data(), bound, dt, sim::Measure::flow, {});
    const auto catch_up = [&](double way, double turn) {
        loaded.state.coupling.missed_way[3] = {0, way, 0};
        loaded.state.coupling.missed_turn[3] = {0, 0, turn};
        begin_prediction(step);
        return scratch.data().prediction.catch_up[3];
    };
    const body::Acceleration small = catch_up(0.5 * most * dt, most * dt), large = catch_up(1, 1);
    EXPECT_NEAR(small.linear.y, 0.5 * most, 1e-12);
    EXPECT_NEAR(small.angular.z, most, 1e-12);
    EXPECT_NEAR(large.linear.y, most, 1e-12);
    EXPECT_NEAR(large.angular.z * std::hypot(0.4, 0.3) / std::sqrt(12.0), most, 1e-12);  // by the radius of gyration
}

// The rate at which a block rang at mid-step counted as work that walls never did: 1.1e-3 for a disc in sph.
class BlockThatRings : public ::testing::TestWithParam<Trial> {};
INSTANTIATE_TEST_SUITE_P(
    Methods, BlockThatRings,
    ::testing::Values(Trial{"disc_in_sph", "explicit_dda", "sph", "sphere = 0.15", 0.3, 1500, 0.1, 1e-4},
                      Trial{"disc_in_wcmps", "explicit_dda", "wcmps", "sphere = 0.15", 0.3, 1500, 0.1, 1e-4},
                      Trial{"box_on_the_floor", "implicit_dda", "sph", "box = [0.4, 0.25]", 0.125, 1900, 0.1, 5e-4}),
    name_of);

TEST_P(BlockThatRings, is_strained_from_an_account_of_its_own) {
    const sim::Ledger ledger = ledger_after(GetParam());
    EXPECT_LT(std::abs(ledger.fluid.coupling_gap), GetParam().most * ledger.turnover);
    const double straining = ledger.fluid.own[6];
    EXPECT_LT(straining, 0);  // still water presses the block together
    EXPECT_GT(straining, -0.01 * ledger.turnover);
}

// Compression by walls went with the velocity of bodies at the beginning of the step, their work with that of mid-step:
// 4.4e-3 of what a block on the floor turns over.
class BlockInWaterOfParticles : public ::testing::TestWithParam<Trial> {};
INSTANTIATE_TEST_SUITE_P(
    Density, BlockInWaterOfParticles,
    ::testing::Values(Trial{"planar_in_wcmps", "planar_dda", "wcmps", "box = [0.4, 0.25]", 0.125, 1900, 0.1, 6e-4},
                      Trial{"elastic_in_wcmps", "explicit_dda", "wcmps", "box = [0.4, 0.25]", 0.125, 1900, 0.1, 6e-4},
                      Trial{"elastic_in_sph", "explicit_dda", "sph", "box = [0.4, 0.25]", 0.125, 1900, 0.1, 3e-4}),
    name_of);
// Water that cannot give way met bodies that went on where a contact had stopped them: 3.4e-3, 2.3e-3, 3.4e-3 and, by
// the block that falls, 2.8e-2.
INSTANTIATE_TEST_SUITE_P(
    Contacts, BlockInWaterOfParticles,
    ::testing::Values(Trial{"implicit_in_mps", "implicit_dda", "mps", "box = [0.4, 0.25]", 0.125, 1900, 0.1, 3e-4},
                      Trial{"elastic_in_mps", "explicit_dda", "mps", "box = [0.4, 0.25]", 0.125, 1900, 0.1, 3e-4},
                      Trial{"spheres_in_mps", "sphere_dem", "mps", "box = [0.4, 0.25]", 0.125, 1900, 0.1, 3e-4},
                      Trial{"falls_in_mps", "distance_potential_dem", "mps", "box = [0.4, 0.25]", 0.127, 2500, 0.1,
                            1e-3}),
    name_of);

TEST_P(BlockInWaterOfParticles, misses_nothing_of_what_it_turns_over) {
    const sim::Ledger ledger = ledger_after(GetParam());
    EXPECT_LT(std::abs(ledger.residual), GetParam().most * ledger.turnover);
    EXPECT_GT(ledger.turnover, 1e-2);  // [J/m]
}

/// A tank 0.8 m wide with water 0.5 m deep, of which a wall is driven.
constexpr const char* beside_a_wall = R"(dimension = 2
gravity = [0.0, -9.81]
end = 0.1
[material.rock]
density = 2500.0
normal_stiffness = 1.0e7
[solid]
method = "distance_potential_dem"
[fluid]
spacing = 0.05
domain = {{ low = [-0.3, -0.3], high = [1.3, 1.0] }}
method = "{}"
[[fluid.region]]
box = {{ low = [0.0, 0.0], high = [0.8, 0.5] }}
[[body]]
name = "bottom"
shape = {{ half_space = {{ normal = [0.0, 1.0] }} }}
material = "rock"
fixed = true
[[body]]
name = "left"
shape = {{ half_space = {{ normal = [1.0, 0.0] }} }}
material = "rock"
fixed = true
[[body]]
name = "wall"
shape = {{ box = [0.2, 4.0] }}
position = [0.9, 0.0]
material = "rock"
motion = {{ linear = {{ velocity = [{}] }} }}
)";

struct WallTrial {
    const char *name, *fluid, *velocity;
    double most;  ///< of what is missed, over what is turned over [-]
};

// What openings of walls exchange at the update of density was booked half a step late: 8.4e-2 and 2.4e-2 of what wcmps
// turned over by then.
class WaterBesideADrivenWall : public ::testing::TestWithParam<WallTrial> {};
INSTANTIATE_TEST_SUITE_P(Motions, WaterBesideADrivenWall,
                         ::testing::Values(WallTrial{"wcmps_down", "wcmps", "0.0, -0.3", 5e-5},
                                           WallTrial{"wcmps_up", "wcmps", "0.0, 0.3", 5e-5},
                                           WallTrial{"wcmps_fast", "wcmps", "0.0, 1.0", 5e-5},
                                           WallTrial{"mps_down", "mps", "0.0, -0.3", 5e-5},
                                           WallTrial{"sph_down", "sph", "0.0, -0.3", 3e-4}),
                         name_of);

TEST_P(WaterBesideADrivenWall, misses_nothing_of_what_the_wall_turns_over) {
    Simulation simulation(scene::read_case_text(
        fmt::format(fmt::runtime(beside_a_wall), GetParam().fluid, GetParam().velocity), "case.toml", "."));
    while (simulation.steps_left() > 0 && simulation.step(sim::Measure::energy).is_accepted()) {
    }
    const sim::Ledger& ledger = simulation.report().ledger;
    EXPECT_LT(std::abs(ledger.residual), GetParam().most * ledger.turnover);
    EXPECT_GT(ledger.turnover, 1e-2);  // [J/m]
}

// Velocities halfway through a kick have an energy that swings with that of every spring: blocks that float or stand
// missed 4e-3 and 8e-4, by their dashpots and friction, too.
class StillWater : public ::testing::TestWithParam<Trial> {};
INSTANTIATE_TEST_SUITE_P(Methods, StillWater,
                         ::testing::Values(Trial{"elastic_float", "explicit_dda", "hydrostatic", "box = [0.4, 0.25]",
                                                 0.6, 500, 0.1, 1e-6},
                                           Trial{"elastic_block_on_the_floor", "explicit_dda", "hydrostatic",
                                                 "box = [0.4, 0.25]", 0.125, 1900, 0.1, 1e-4},
                                           Trial{"elastic_block_that_falls", "explicit_dda", "hydrostatic",
                                                 "box = [0.25, 0.4]", 0.25, 1900, 0.2, 1e-4},
                                           Trial{"rigid_block_on_the_floor", "distance_potential_dem", "hydrostatic",
                                                 "box = [0.4, 0.25]", 0.125, 1900, 0.1, 1e-6}),
                         name_of);

TEST_P(StillWater, misses_nothing_of_what_a_block_turns_over) {
    const sim::Ledger ledger = ledger_after(GetParam());
    EXPECT_LT(std::abs(ledger.residual), GetParam().most * ledger.turnover);
    EXPECT_GT(ledger.turnover, 1e-4);  // [J/m]
}

TEST(MissedShare, is_nothing_up_to_half_a_unit_in_the_last_place_of_the_largest_energy_a_step) {
    sim::Ledger ledger;
    ledger.turnover = 1e-12;
    ledger.potential = 1024;
    ledger.residual = 100 * 1024 * std::ldexp(1.0, -53);
    EXPECT_EQ(missed_share(ledger, 100), 0);
    EXPECT_GT(missed_share(ledger, 99), 1);
    ledger.potential = 1023;
    EXPECT_GT(missed_share(ledger, 100), 1);
    ledger.residual = -ledger.residual;
    EXPECT_LT(missed_share(ledger, 100), -1);
}

}  // namespace
}  // namespace riprap::run
