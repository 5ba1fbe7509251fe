// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "fluid/sph/water.hpp"
#include "riprap/core/fields.hpp"
#include "riprap/core/parallel.hpp"

namespace riprap::fluid::testing {
namespace {

/// A column of water beside a dry floor in a closed corner.
Water dam_break(int spacings_per_height) {
    const double height = 0.5;
    Water water;
    water.settings = settings_2d(height / spacings_per_height, 20 * std::sqrt(9.81 * height));
    water.gravity = {0, -9.81, 0};
    add_tank(water, 1.0, 0.6, true);
    add_still_water(water, 0.5, height);
    return water;
}

/// In double to its round-off. Fast sums round each pair's force to float, 6e-8 of it, from either side: what is left
/// of a momentum is below 1e-7 of all that was exchanged.
class MomentumOfFluid : public ::testing::TestWithParam<bool> {
 protected:
    double tolerance() const { return GetParam() ? 1e-12 : 1e-7; }
};
INSTANTIATE_TEST_SUITE_P(PlainAndFast, MomentumOfFluid, ::testing::Values(true, false));

TEST_P(MomentumOfFluid, is_kept_when_two_blocks_collide) {
    Water water;
    water.settings = settings_2d(0.02, 30);
    water.settings.is_plain = GetParam();
    for_lattice(0.02, 0.3, 0.3, [&](double x, double y) {
        water.add_particle({x, y, 0}, {1.5, 0.2, 0});
        water.add_particle({x + 0.32, y + 0.1, 0}, {-1, 0, 0});
    });
    water.step();
    const Vec3 start = water.report.momentum;
    water.run_until(0.15);
    ASSERT_EQ(water.report.problem, "");
    const double scale = water.report.mass * 1.5;
    double slowest = 1.5;  // of the block from the left, whose particles have the even ids
    for (std::size_t i = 0; i < water.state.position.size(); i += 2) {
        slowest = std::min(slowest, water.state.velocity[i].x);
    }
    EXPECT_LT(slowest, 0.5);  // they did collide
    EXPECT_LT(norm(water.report.momentum - start), tolerance() * scale);
    EXPECT_EQ(water.impulse, Vec3{});
}

TEST_P(MomentumOfFluid, is_what_gravity_and_walls_gave) {
    Water water = dam_break(12);
    water.settings.is_plain = GetParam();
    water.step();
    const Vec3 start = water.report.momentum - water.impulse;
    water.run_until(0.4);
    ASSERT_EQ(water.report.problem, "");
    const double given = water.report.mass * 9.81 * water.time;
    EXPECT_LT(norm(water.report.momentum - water.impulse - start), tolerance() * given);
}

TEST(Conservation, every_joule_of_a_dam_break_is_booked) {
    Water water = dam_break(12);
    water.step();
    const double start = water.closure();
    const double fallen_from = water.report.potential;
    double largest = 0;
    while (water.time < 0.8 && water.report.problem.empty()) {
        water.step();
        largest = std::max(largest, std::abs(water.closure() - start));
    }
    ASSERT_EQ(water.report.problem, "");
    const double turnover = fallen_from - water.report.potential;
    EXPECT_LT(largest, 0.01 * turnover);
    EXPECT_GT(water.dissipated_viscous, 0.02 * turnover);
}

TEST(Conservation, one_step_of_fast_sums_is_one_of_plain_sums_to_float_round_off) {
    Water fast = dam_break(16), plain = dam_break(16);
    fast.run_until(0.15);
    plain.state = fast.state;
    plain.time = fast.time;
    plain.last_dt = fast.last_dt;
    plain.settings.is_plain = true;
    const std::vector<Vec3> velocity = fast.state.velocity;
    fast.step();
    plain.step();
    double largest = 0, error = 0, density_error = 0;
    for (std::size_t i = 0; i < velocity.size(); ++i) {
        largest = std::max(largest, norm(plain.state.velocity[i] - velocity[i]));
        error = std::max(error, norm(plain.state.velocity[i] - fast.state.velocity[i]));
        density_error = std::max(density_error, std::abs(plain.state.density[i] - fast.state.density[i]));
    }
    // some 40 pairs a particle, each force rounded to 6e-8 of its size, which is up to ten times that of their sum
    EXPECT_LT(error, 1e-5 * largest);
    EXPECT_LT(density_error, 1e-5);  // of the 2 kg/m^3 by which density varies here
}

TEST(Conservation, bits_do_not_depend_on_threads_or_on_buffers_kept) {
    const auto run = [](int threads, bool keeps_buffers) {
        parallel::set_thread_count(threads);
        Water water = dam_break(12);
        while (water.time < 0.1) {
            water.step();
            if (!keeps_buffers) {
                water.scheme.reset();
            }
        }
        return hash_fields(water.state);
    };
    const int before = parallel::thread_count();
    const std::uint64_t one = run(1, true);
    EXPECT_EQ(run(2, true), one);
    EXPECT_EQ(run(4, false), one);
    parallel::set_thread_count(before);
}

TEST(Conservation, a_particle_faster_than_sound_is_named_with_place_and_time) {
    Water water = dam_break(12);
    water.state.velocity[7] = {3e3, 0, 0};
    water.state.id[7] = 1234;
    water.step(1e-9);
    EXPECT_EQ(water.report.worst_particle, 1234);
    EXPECT_NE(water.report.problem.find("faster than the sound speed"), std::string::npos);
    EXPECT_NE(water.report.problem.find("at t = "), std::string::npos);
}

TEST(Conservation, a_particle_that_is_not_finite_or_outside_is_reported_and_nothing_is_dropped) {
    Water lost = dam_break(12);
    const auto count = lost.state.size();
    lost.state.position[3].x = std::nan("");
    lost.step();
    EXPECT_EQ(lost.report.worst_particle, 3);
    EXPECT_NE(lost.report.problem.find("no finite place"), std::string::npos);

    Water outside = dam_break(12);
    outside.state.position[5].x = 200;
    outside.step();
    EXPECT_EQ(outside.report.worst_particle, 5);
    EXPECT_NE(outside.report.problem.find("left the domain"), std::string::npos);
    EXPECT_EQ(outside.state.size(), count);
}

}  // namespace
}  // namespace riprap::fluid::testing
