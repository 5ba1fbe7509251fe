// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/sph/tearing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fluid/sph/water.hpp"

namespace riprap::fluid::testing {
namespace {

constexpr double spacing = 0.01, sound_speed = 40;

/// A cube of 3 x 3 x 3 particles that flies apart, v = rate x, with 1e-4 rate^2 J/kg. Tension of 0.01 rho_0 c_0^2 takes
/// 16 J/kg while its volume doubles, and fades from there on. Without diffusion only tearing takes from compression.
Water torn_drop(double rate) {
    Water water;
    water.settings = settings_2d(spacing, sound_speed);
    water.settings.domain.dimension = 3;
    water.settings.density_diffusion = 0;
    water.settings.domain.low.z = -100;
    water.settings.domain.high.z = 100;
    water.settings.particle_mass = water.settings.rest_density * spacing * spacing * spacing;
    for (int k = 0; k < 27; ++k) {
        const Vec3 x = spacing * Vec3{k % 3 - 1.0, k / 3 % 3 - 1.0, k / 9 - 1.0};
        water.add_particle(x + 1e-3 * spacing * Vec3{k % 5 - 2.0, k % 7 - 3.0, k % 4 - 1.5}, rate * x);
    }
    return water;
}

double kinetic_energy(const Water& water) {
    double energy = 0;
    for (const Vec3& v : water.state.velocity) {
        energy += 0.5 * water.settings.particle_mass * norm_squared(v);
    }
    return energy;
}

double closest_pair(const Water& water) {
    double closest = 1e9;
    for (std::size_t i = 0; i < water.state.position.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            closest = std::min(closest, norm(water.state.position[i] - water.state.position[j]));
        }
    }
    return closest;
}

TEST(Tearing, limits_the_tension_of_a_surface_and_of_nothing_else) {
    EXPECT_EQ(density_by_tearing(1, false, 991, 1000), 0);
    EXPECT_EQ(density_by_tearing(1, false, 1020, 1000), 0);
    EXPECT_EQ(density_by_tearing(0, false, 900, 1000), 0);
    EXPECT_DOUBLE_EQ(density_by_tearing(1, false, 900, 1000), 90);
    EXPECT_DOUBLE_EQ(density_by_tearing(0.5, false, 900, 1000), 80);
    EXPECT_EQ(density_by_tearing(0.1, false, 901, 1000), 0);
}

TEST(Tearing, leaves_no_tension_where_water_may_leave_a_wall) {
    EXPECT_DOUBLE_EQ(density_by_tearing(0.5, true, 999, 1000), 1);
    EXPECT_EQ(density_by_tearing(0.5, true, 1001, 1000), 0);
    EXPECT_TRUE(may_leave_walls(0.2, 1, 0.8));
    EXPECT_FALSE(may_leave_walls(0, 1, 1.0)) << "deep down no air can come between water and wall";
    EXPECT_FALSE(may_leave_walls(1, 1, 0.6)) << "the surface of a jet has no wall to leave";
}

TEST(Tearing, lets_a_drop_fly_apart_that_is_faster_than_its_tension) {
    Water water = torn_drop(500);
    water.run_until(0.04);
    const double in_flight = kinetic_energy(water);
    water.run_until(0.05);
    EXPECT_EQ(water.report.problem, "");
    EXPECT_GT(closest_pair(water), 3 * spacing);
    EXPECT_DOUBLE_EQ(kinetic_energy(water), in_flight);
    for (const double density : water.state.density) {
        EXPECT_NEAR(density, 1000, 10.001);
    }
}

TEST(Tearing, holds_a_drop_together_that_is_slower_than_its_tension) {
    Water water = torn_drop(60);
    const double at_first = kinetic_energy(water);
    water.run_until(0.05);
    EXPECT_LT(kinetic_energy(water), 0.1 * at_first);
    EXPECT_LT(closest_pair(water), 1.3 * spacing);
}

/// A sheet, four spacings thick, slides at 1 m/s along a slippery ledge y < 0 that ends at x = 0.
Water sheet_on_ledge() {
    Water water;
    water.settings = settings_2d(spacing, 10);
    for_lattice(spacing, 0.4, 0.04, [&](double x, double y) { water.add_particle({x - 0.4, y, 0}, {1, 0, 0}); });
    for_lattice(spacing, 1, 0.04, [&](double x, double y) { water.add_wall_particle({x - 1, y - 0.04, 0}, true); });
    return water;
}

TEST(Tearing, lets_a_sheet_fly_straight_on_from_the_end_of_a_ledge) {
    Water water = sheet_on_ledge();
    water.run_until(0.8);
    EXPECT_EQ(water.report.problem, "");
    for (const Vec3& v : water.state.velocity) {
        EXPECT_NEAR(v.x, 1, 0.02);
        EXPECT_NEAR(v.y, 0, 0.05);
    }
}

TEST(Tearing, leaves_water_at_rest_alone) {
    Water water;
    water.settings = settings_2d(0.02, 10 * std::sqrt(9.81 * 0.4));
    water.settings.density_diffusion = 0;
    water.gravity = {0, -9.81, 0};
    add_tank(water, 0.4, 0.5, true);
    add_still_water(water, 0.4, 0.4);
    while (water.time < 0.5) {
        water.step();
        ASSERT_GT(*std::min_element(water.state.density.begin(), water.state.density.end()), 992) << water.time;
    }
}

TEST(Tearing, lets_the_pressure_of_a_particle_alone_between_two_walls_go_with_sound) {
    EXPECT_EQ(caught_share(0, 0.9), 1);
    EXPECT_EQ(caught_share(0.08, 0.9), 0);  // in a row with twice the spacing, by which water leaves
    EXPECT_EQ(caught_share(0, 0.6), 0);     // a drop at one wall
    EXPECT_NEAR(caught_share(0.025, 0.725), 0.25, 1e-12);
    EXPECT_NEAR(caught_share(0.05, 1), 0.8, 1e-12);  // two spacings from another where walls have met
    EXPECT_DOUBLE_EQ(density_by_escape(1, 1010, 1000, escape_in_step(1)), -10 * (1 - std::exp(-1)));
    EXPECT_DOUBLE_EQ(density_by_escape(0.75, 990, 1000, escape_in_step(1)), 5 * (1 - std::exp(-1)));
    EXPECT_EQ(density_by_escape(0.5, 1010, 1000, 1), 0);
}

/// By how much the density of a particle rises at most while a wall comes nearer by 0.025 spacings, from 0.3 below it,
/// with another as near above it or without.
double squeezed(bool is_between) {
    constexpr double distance = 0.3 * spacing, speed = 0.1;
    Water water;
    water.settings = settings_2d(spacing, sound_speed);
    water.add_particle({}, {});
    for (int k = -4; k <= 4; ++k) {
        for (int row = 0; row < 4; ++row) {
            const double away = distance + (row + 0.5) * spacing;
            water.add_wall_particle({k * spacing, -away, 0}, true);
            water.walls.velocity.back() = {0, speed, 0};
            if (is_between) {
                water.add_wall_particle({k * spacing, away, 0}, true);
            }
        }
    }
    double most = 0;
    while (water.time < 0.025 * spacing / speed) {
        water.step(0.25 * spacing / sound_speed);
        most = std::max(most, water.state.density[0] - water.settings.rest_density);
    }
    return most;
}

TEST(Tearing, a_particle_alone_between_two_walls_does_not_hold_them_apart_but_stops_at_one) {
    EXPECT_GT(squeezed(false), 1);
    EXPECT_LT(squeezed(true), 0.01);
}

TEST(Tearing, gives_the_energy_of_the_tension_to_the_ledger) {
    Water water = torn_drop(500);
    water.step(1e-6);
    const double before = water.closure();
    while (water.time < 0.02) {
        water.step(1e-5);
    }
    EXPECT_GT(water.dissipated_diffusion, 0.1 * before);
    EXPECT_NEAR(water.closure(), before, 0.01 * before);
}

}  // namespace
}  // namespace riprap::fluid::testing
