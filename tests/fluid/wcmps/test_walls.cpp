// SPDX-License-Identifier: Apache-2.0
// Water next to a plane wall of particles, on the lattice.
#include <gtest/gtest.h>

#include <cmath>

#include "fluid/wcmps/pool.hpp"

namespace riprap::fluid::testing {
namespace {

constexpr double spacing = 0.02;
constexpr int rows = 12;

/// Rows of water over a wall below y = 0, which repeat along x, with velocities and pressures by place.
Pool water_over_wall(const std::function<Vec3(const Vec3&)>& velocity, const std::function<double(double)>& pressure,
                     bool repeats = true) {
    Pool pool;
    pool.settings = wcmps_settings(2, spacing, 200);  // stiff: x = 1 but for 1e-5
    pool.settings.density_diffusion = 0;
    const int half = 10;
    pool.settings.domain = {{-half * spacing, -1, 0}, {half * spacing, 1, 0}, {repeats, false, false}, 2};
    for (int i = -half; i < half; ++i) {
        for (int j = -4; j < rows; ++j) {
            const Vec3 x{(i + 0.5) * spacing, (j + 0.5) * spacing, 0};
            if (j < 0) {
                pool.add_wall_particle(x, true);
            } else {
                pool.add_particle(x, velocity(x), pressure(x.y));
            }
        }
    }
    return pool;
}

/// -dx/dt of a row in the middle, by continuity alone [1/s].
double opening_of_row(const std::function<Vec3(const Vec3&)>& velocity, int row, MpsWallPressure walls) {
    Pool pool = water_over_wall(
        velocity, [](double) { return 0.0; }, false);
    pool.settings.wall_pressure = walls;
    constexpr double dt = 1e-9;  // the return to the density of places has no time
    pool.update_density({}, dt);
    for (std::size_t i = 0; i < pool.state.position.size(); ++i) {
        const Vec3& x = pool.state.position[i];
        if (std::abs(x.x - 0.5 * spacing) < 1e-6 && std::abs(x.y - (row + 0.5) * spacing) < 1e-6) {
            return pool.settings.lattice().first_order() * pool.scheme->continuity_.rate[i];
        }
    }
    return std::nan("");
}

// Seen by the operators of the first two rows: 0.96 and 0.97 of the two parts, 1.04 and 1.03.
TEST(WcmpsWalls, water_that_runs_along_a_wall_and_towards_it_opens_by_the_one_and_closes_by_the_other) {
    const auto along = [](const Vec3& x) { return Vec3{2 * (x.x - 0.5 * spacing), 0, 0}; };
    const auto towards = [](const Vec3& x) { return Vec3{0, -2 * x.y, 0}; };
    const auto both = [=](const Vec3& x) { return along(x) + towards(x); };
    for (const int row : {0, 1, 2}) {
        EXPECT_NEAR(opening_of_row(along, row, MpsWallPressure::averaged), 2, 0.06 * 2) << row;
        EXPECT_NEAR(opening_of_row(towards, row, MpsWallPressure::averaged), -2, 0.06 * 2) << row;
        EXPECT_NEAR(opening_of_row(both, row, MpsWallPressure::averaged), 0, 0.02 * 2) << row;
    }
    EXPECT_LT(opening_of_row(both, 0, MpsWallPressure::mirrored), -0.15 * 2);
}

TEST(WcmpsWalls, still_water_on_the_lattice_over_a_wall_is_not_pushed_and_weighs_on_it) {
    const double g = 9.81, depth = rows * spacing;
    Pool pool = water_over_wall([](const Vec3&) { return Vec3{}; }, [=](double y) { return 1000 * g * (depth - y); });
    pool.gravity = {0, -g, 0};
    pool.step(1e-6);
    double weight = 0;
    for (std::size_t i = 0; i < pool.state.position.size(); ++i) {
        if (pool.state.position[i].y < (rows - 4) * spacing) {  // below what the surface is felt in
            EXPECT_LT(norm(pool.state.velocity[i]), 2e-3 * g * pool.last_dt);
        }
        weight += pool.settings.particle_mass * g;
    }
    double load = 0;
    for (const Vec3& f : pool.walls.pressure_force) {
        load -= f.y;
    }
    EXPECT_NEAR(load, weight, 2e-3 * weight);
}

/// Changes of x by continuity in water beside a long wall below y = 0 that ends at a surface on the right and, on the
/// left, at a surface or at a wall across that the long one slides through [1/s].
struct Rates {
    double largest{0}, sum{0};
};
Rates rates_beside(bool has_wall_across, bool knows_normals, const Vec3& along_wall, const Vec3& water) {
    Pool pool;
    pool.settings = wcmps_settings(2, spacing, 200);
    pool.settings.density_diffusion = 0;
    for (int i = -6; i < 16; ++i) {
        for (int j = -4; j < rows; ++j) {
            const Vec3 x{(i + 0.5) * spacing, (j + 0.5) * spacing, 0};
            const bool is_along = j < 0, is_across = i < 0 && j >= 0;
            if (is_along || (is_across && has_wall_across)) {
                pool.add_wall_particle(x, true);
                pool.walls.velocity.back() = is_along ? along_wall : Vec3{};
                if (knows_normals) {
                    const bool is_shared = is_along && i < 0 && has_wall_across;
                    pool.walls.normal.push_back(is_shared ? Vec3{} : is_along ? Vec3{0, 1, 0} : Vec3{1, 0, 0});
                }
            } else if (i >= 0 && i < 10) {
                pool.add_particle(x, water, 0);
            }
        }
    }
    pool.update_density({}, 1e-9);
    Rates found;
    for (const double rate : pool.scheme->continuity_.rate) {
        const double opening = pool.settings.lattice().first_order() * rate;
        found.largest = std::max(found.largest, std::abs(opening));
        found.sum += opening;
    }
    return found;
}

// Without the normals a wall takes the end of the water for an opening: a sum of 0.3 V/l, squeezed and drawn apart.
TEST(WcmpsWalls, water_and_a_wall_that_slide_along_each_other_open_nothing_at_the_end_of_the_water) {
    const double scale = 0.3 / spacing;
    for (const bool has_wall_across : {false, true}) {
        const Rates slides = rates_beside(has_wall_across, true, {0.3, 0, 0}, {});
        EXPECT_LT(slides.largest, 1e-5 * scale) << has_wall_across;
        EXPECT_GT(rates_beside(has_wall_across, false, {0.3, 0, 0}, {}).largest, 0.02 * scale) << has_wall_across;
    }
    EXPECT_LT(rates_beside(false, true, {}, {0.3, 0, 0}).largest, 1e-5 * scale);
    EXPECT_GT(rates_beside(false, false, {}, {0.3, 0, 0}).largest, 0.02 * scale);
    // water and wall that move together, and both towards each other as the operators see it without normals
    EXPECT_LT(rates_beside(false, true, {0.2, 0.2, 0}, {0.2, 0.2, 0}).largest, 1e-5 * scale);
    const double towards = rates_beside(false, true, {0, 0.3, 0}, {}).sum,
                 without = rates_beside(false, false, {0, 0.3, 0}, {}).sum;
    EXPECT_LT(towards, -scale);
    EXPECT_NEAR(towards, without, 0.05 * std::abs(without));
}

// What a wall does to water that passes it, and what the water does to it, is one account: no energy is lost.
TEST(WcmpsWalls, a_wall_that_moves_through_water_gives_and_takes_what_is_booked) {
    Pool pool = water_over_wall(
        [](const Vec3& x) {
            return Vec3{0.1 * std::sin(50 * x.y), 0.05 * x.x, 0};
        },
        [](double) { return 500.0; });
    for (std::size_t w = 0; w < pool.walls.position.size(); ++w) {
        pool.walls.velocity[w] = {0.3, 0, 0};
    }
    pool.step(1e-5);
    const double start = pool.closure();
    for (int k = 0; k < 20; ++k) {
        for (std::size_t w = 0; w < pool.walls.position.size(); ++w) {
            pool.walls.position[w].x += pool.last_dt * 0.3;
        }
        pool.step(1e-5);
    }
    ASSERT_EQ(pool.report.problem, "");
    EXPECT_NEAR(pool.closure(), start, 2e-3 * pool.report.kinetic);
    EXPECT_LT(std::abs(pool.wall_exchange), 1e-6 * pool.report.kinetic);  // nothing carries pressure on without gravity
}

}  // namespace
}  // namespace riprap::fluid::testing
