// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "riprap/core/error.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/coupling/fill.hpp"
#include "riprap/coupling/samples/sample_shapes.hpp"
#include "riprap/fluid/particle/state_equation.hpp"
#include "riprap/fluid/schemes.hpp"
#include "sim/basin.hpp"

namespace riprap::sim {
namespace {

/// A blob of water in free space that blocks fly into.
Basin collision() {
    Basin basin;
    basin.add_square(0.3, 800, {0.6, 1.25, 0}, {0.5, -2, 0}, 3);
    basin.add_square(0.2, 2000, {-0.2, 0.5, 0}, {3, 0.5, 0}, -5);
    basin.fill({0, 0, 0}, {1, 1, 0}, {5, 5, 0}, 9, {0, 0, 0});
    return basin;
}

TEST(Water, what_water_loses_bodies_gain_to_round_off) {
    Basin basin = collision();
    basin.model.particles()->sph().is_plain = true;
    Scratch scratch;
    const Vec3 before = basin.total_momentum();
    const double water_before = basin.momentum_scale();
    const StepReport report = basin.steps(140, scratch);
    ASSERT_TRUE(report.status.ok()) << report.status.text;
    const double exchanged = basin.momentum_scale();
    ASSERT_GT(exchanged, water_before + 50);  // the blocks have hit the water
    EXPECT_LT(norm(basin.total_momentum() - before), 1e-12 * exchanged);
    EXPECT_LT(norm(report.ledger.fluid.momentum_residual), 1e-12 * exchanged);
}

TEST(Water, walls_that_push_take_what_they_give_to_round_off) {
    Basin basin = collision();
    basin.model.particles()->sph().is_plain = true;
    basin.model.particles()->wall = coupling::WallTreatment::penalty;
    basin.model.particles()->samples = {};
    Scratch scratch;
    const Vec3 before = basin.total_momentum();
    const double water_before = basin.momentum_scale();
    const StepReport report = basin.steps(140, scratch);
    ASSERT_TRUE(report.status.ok()) << report.status.text;
    ASSERT_GT(basin.momentum_scale(), water_before + 50);
    EXPECT_LT(norm(basin.total_momentum() - before), 1e-12 * basin.momentum_scale());
}

TEST(Water, a_box_floats_at_the_draft_of_its_weight_with_either_kind_of_wall) {
    // Let go at its draft on still water; the wave of the first pressure adjustment is damped by mass damping, which
    // leaves the equilibrium alone.
    for (const coupling::WallTreatment wall :
         {coupling::WallTreatment::boundary_particles, coupling::WallTreatment::penalty}) {
        Basin basin;
        basin.add_square(0.4, 500, {0.6, 0.8, 0});
        basin.fill_pool(1.2, 0.8);
        basin.model.dem()->mass_damping = 3;
        basin.model.particles()->wall = wall;
        basin.model.particles()->samples = wall == coupling::WallTreatment::penalty
                                               ? coupling::SampleSet{}
                                               : std::move(basin.model.particles()->samples);
        Scratch scratch;
        basin.model.time.end = 3;
        double height = 0;
        std::int64_t count = 0;
        StepReport report;
        while (basin.state.time < 2.9 && (report = basin.steps(1, scratch)).status.ok()) {
            height += basin.state.time > 1.5 ? basin.state.bodies.position[0].y : 0;
            count += basin.state.time > 1.5 ? 1 : 0;
        }
        ASSERT_TRUE(report.status.ok()) << report.status.text;
        // Archimedes: the box takes the place of half of its area, so its centre lies in the surface.
        const double water = static_cast<double>(basin.state.fluid.size()) * dp * dp;
        const double surface = (water + 0.5 * 0.4 * 0.4) / 1.2;
        RecordProperty(wall == coupling::WallTreatment::penalty ? "penalty" : "boundary",
                       std::to_string(height / static_cast<double>(count) - surface));
        // Boundary particles: a spacing. Walls that push hold particles anywhere from half a spacing, where they
        // started, to the face: the level may fall by that much all along floor, sides and box.
        const double wetted = 1.2 + 2 * 0.8 + 2 * 0.4;
        const double allowed = wall == coupling::WallTreatment::penalty ? 0.5 * dp * wetted / 1.2 : dp;
        EXPECT_NEAR(height / static_cast<double>(count), surface, allowed)
            << (wall == coupling::WallTreatment::penalty ? "penalty" : "boundary particles");
    }
}

TEST(Water, fast_sums_exchange_momentum_to_the_round_off_of_float) {
    Basin basin = collision();
    Scratch scratch;
    const Vec3 before = basin.total_momentum();
    ASSERT_TRUE(basin.steps(140, scratch).status.ok());
    EXPECT_LT(norm(basin.total_momentum() - before), 1e-5 * basin.momentum_scale());
}

TEST(Water, a_block_as_heavy_as_water_hangs_still_in_it) {
    Basin basin;
    basin.add_square(0.4, 1000, {0.6, 0.5, 0});
    basin.fill_pool(1.2, 1.0);
    Scratch scratch;
    basin.model.time.end = 1;
    const StepReport report = basin.steps(300, scratch);
    ASSERT_TRUE(report.status.ok()) << report.status.text;
    const Vec3 force = scratch.fluid_loads().pressure.force[0];
    EXPECT_NEAR(force.y, 1000 * 9.81 * 0.4 * 0.4, 0.1 * 1000 * 9.81 * 0.4 * 0.4);
    EXPECT_NEAR(basin.state.bodies.position[0].y, 0.5, 0.2 * dp);
}

TEST(Water, a_light_block_released_under_water_is_stable) {
    // Explicit exchange of loads blows up where the added mass is larger than the mass.
    for (const double density : {500.0, 100.0, 10.0}) {
        Basin basin;
        basin.add_square(0.2, density, {0.5, 0.4, 0});
        basin.fill_pool(1.0, 0.8);
        Scratch scratch;
        basin.model.time.end = 1;
        double most = 0;
        std::int64_t passes = 0;
        basin.steps(1, scratch);
        for (int i = 0; i < 150; ++i) {
            const StepReport report = basin.steps(1, scratch);
            ASSERT_TRUE(report.status.ok()) << density << ": " << report.status.text;
            most = std::max(most, norm(basin.state.coupling.acceleration[0]));
            passes += report.fluid_passes;
        }
        // With no added mass at all it could reach g (rho/rho_s - 1); with that of a square, 1.19 of its area, far
        // less.
        EXPECT_LT(most, 9.81 * (1000 / density - 1)) << density;
        EXPECT_GT(basin.state.bodies.velocity[0].y, 0) << density;
        EXPECT_LT(static_cast<double>(passes), 6 * 150) << density;
        RecordProperty("passes_at_" + std::to_string(static_cast<int>(density)), static_cast<int>(passes));
    }
}

TEST(Water, solids_take_as_many_steps_within_one_of_the_water_as_their_bound_asks_for) {
    Basin basin = collision();
    basin.rock().normal_stiffness = 1e10;
    basin.mix();
    Scratch scratch;
    const StepReport report = basin.steps(1, scratch);
    const double bound = largest_time_step(basin.model, time_step_bound(basin.model));
    EXPECT_EQ(report.substeps, std::ceil(report.dt / bound));
    EXPECT_GT(report.substeps, 1);
    EXPECT_NEAR(basin.state.time, report.dt, 1e-15);
}

// Loads of the first steps are those of bodies that nothing holds yet.
TEST(Water, steps_grow_from_a_fiftieth_by_a_twentieth_of_the_time_since_bodies_were_let_go) {
    Basin basin = collision();
    Scratch scratch;
    initialise(basin.model, basin.state);
    basin.model.time.end = 1000;
    const double allowed = make_scheme(basin.model.particles()->sph())->limit(basin.state.fluid).limit;
    const auto next = [&](double time) {
        basin.state.time = time;
        return choose_time_step(basin.model, basin.state, scratch).dt / allowed;
    };
    EXPECT_NEAR(next(0), 0.02, 1e-6);
    EXPECT_NEAR(next(4 * allowed), 0.22, 1e-6);
    EXPECT_NEAR(next(30 * allowed), 1, 1e-6);
    const std::size_t block = 0;
    basin.model.bodies.release_time[block] = 100;
    for (body::Drive& drive : basin.model.bodies.drive) {
        drive = body::Drive::fixed;  // the block is held until 100 s
    }
    EXPECT_NEAR(next(0), 1, 1e-6);
    EXPECT_NEAR(next(100), 0.02, 1e-6);
    EXPECT_NEAR(next(100 + 4 * allowed), 0.22, 1e-6);
    basin.model.bodies.drive[block] = body::Drive::driven;
    EXPECT_NEAR(next(4 * allowed), 0.22, 1e-6);
}

TEST(Water, a_fixed_step_that_water_cannot_follow_is_refused) {
    Basin basin = collision();
    Scratch scratch;
    initialise(basin.model, basin.state);
    basin.model.time.time_step = 1;
    EXPECT_THROW(choose_time_step(basin.model, basin.state, scratch), CaseError);
    basin.model.time.force_time_step = true;
    EXPECT_EQ(choose_time_step(basin.model, basin.state, scratch).dt, 1);
}

/// Water let go at one end of a long pool, most of whose walls are dry.
Basin dam_break() {
    Basin basin;
    basin.add_walls(4);
    basin.fill({0, 0, 0}, {0.5, 1, 0}, {4, 2, 0}, 1, {0, -9.81, 0});
    return basin;
}

TEST(Water, a_fixed_step_that_becomes_too_long_on_the_way_ends_the_run_unless_forced) {
    Basin basin = collision();
    Scratch scratch;
    initialise(basin.model, basin.state);
    const double limit = make_scheme(basin.model.particles()->sph())->limit(basin.state.fluid).limit;
    basin.model.time.time_step = 0.95 * limit;
    ASSERT_TRUE(basin.steps(2, scratch).status.ok());
    basin.state.fluid.velocity[0] = {30, 0, 0};  // as fast as sound: the limit is about half as long
    const std::uint64_t before = state_hash(basin.state);
    State last = basin.state;
    const std::string problem = advance(basin.model, last, scratch, 0.95 * limit).status.text;
    EXPECT_NE(problem.find("is above what the water allows, "), std::string::npos) << problem;
    EXPECT_NE(problem.find("at t = "), std::string::npos) << problem;
    EXPECT_EQ(state_hash(basin.state), before);
    basin.model.time.force_time_step = true;
    const StepReport forced = advance(basin.model, basin.state, scratch, 0.95 * limit);
    EXPECT_TRUE(forced.status.ok()) << forced.status.text;
    EXPECT_LT(forced.fluid_dt_bound, 0.6 * limit);
}

TEST(Water, the_memory_that_is_counted_grows_with_the_lists_of_neighbours) {
    Basin basin = collision();
    Scratch scratch;
    initialise(basin.model, basin.state);
    const std::size_t before = memory_bytes(basin.model, basin.state, scratch);
    basin.steps(1, scratch);
    const auto particles = static_cast<std::size_t>(basin.state.fluid.size());
    // Forces, gradients, densities, heat and the rest: some forty numbers of eight bytes for each particle at least.
    EXPECT_GT(memory_bytes(basin.model, basin.state, scratch), before + 40 * 8 * particles);
}

TEST(Water, a_run_continued_from_its_state_takes_the_same_bits) {
    for (const auto& scene : {collision, dam_break}) {
        Basin whole = scene(), halves = scene();
        Scratch scratch;
        whole.steps(30, scratch);
        {
            Scratch first;
            halves.steps(17, first);
        }
        Scratch second;
        halves.steps(13, second);
        EXPECT_EQ(state_hash(whole.state), state_hash(halves.state));
    }
}

TEST(Water, feels_all_walls_in_its_reach_wherever_it_has_come_and_is_spared_the_rest) {
    Basin basin = dam_break();
    Scratch scratch;
    const coupling::SampleSet& samples = basin.model.particles()->samples;
    const double reach = basin.model.particles()->settings().support_radius();
    int renewals = 0;
    std::vector<std::int32_t> before;
    for (int step = 0; step < 120; ++step) {
        ASSERT_TRUE(basin.steps(1, scratch).status.ok());
        const std::vector<std::int32_t>& near = basin.state.coupling.near_samples;
        renewals += near == before ? 0 : 1;
        before = near;
        for (std::int32_t i = 0; i < samples.size(); ++i) {
            if (!std::binary_search(near.begin(), near.end(), i)) {
                for (const Vec3& x : basin.state.fluid.position) {
                    ASSERT_GT(norm(x - samples.anchor[static_cast<std::size_t>(i)]), reach - 0.1 * dp) << step;
                }
            }
        }
        ASSERT_LT(std::ssize(near), samples.size() / 2);
    }
    EXPECT_GE(renewals, 3);
    EXPECT_LE(renewals, 30);
}

TEST(Water, looks_for_walls_anew_in_a_state_from_when_samples_had_another_order) {
    Basin basin = dam_break(), anew = dam_break();
    {
        Scratch first;
        basin.steps(3, first);
    }
    anew.state = basin.state;
    anew.state.coupling.near_travel = -1;  // as in a state without any
    std::vector<std::int32_t>& near = basin.state.coupling.near_samples;
    near.erase(near.begin() + 5);
    Scratch of_basin, of_anew;
    basin.steps(1, of_basin);
    anew.steps(1, of_anew);
    EXPECT_EQ(near, anew.state.coupling.near_samples);
    EXPECT_EQ(state_hash(basin.state), state_hash(anew.state));
}

TEST(Water, steps_have_the_same_bits_at_any_thread_count) {
    const int threads = parallel::thread_count();
    std::array<std::uint64_t, 2> hash{};
    for (const int count : {1, 2}) {
        parallel::set_thread_count(count);
        Basin basin = collision();
        Scratch scratch;
        basin.steps(15, scratch);
        hash[static_cast<std::size_t>(count - 1)] = state_hash(basin.state);
    }
    parallel::set_thread_count(threads);
    EXPECT_EQ(hash[0], hash[1]);
}

TEST(Water, a_particle_that_leaves_the_domain_ends_the_step_with_its_name) {
    Basin basin;
    basin.fill({0, 0, 0}, {0.5, 0.5, 0}, {dp, dp, 0}, 9, {0, -9.81, 0});  // there is no floor
    Scratch scratch;
    const StepReport report = basin.steps(1000, scratch);
    EXPECT_NE(report.status.text.find("fluid particle"), std::string::npos) << report.status.text;
    EXPECT_NE(report.status.text.find("has left the domain at t = "), std::string::npos) << report.status.text;
    EXPECT_TRUE(report.status.remedy.starts_with("a wall there holds the water, ")) << report.status.remedy;
}

}  // namespace
}  // namespace riprap::sim
