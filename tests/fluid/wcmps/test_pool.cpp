// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "fluid/sph/water.hpp"
#include "fluid/wcmps/pool.hpp"
#include "riprap/fluid/gauge/gauge_kinds.hpp"

namespace riprap::fluid::testing {
namespace {

Pool still_pool(int dimension, long cells_deep, double depth) {
    const double g = 9.81;
    Pool pool;
    pool.settings = wcmps_settings(dimension, depth / static_cast<double>(cells_deep), 10 * std::sqrt(2 * g * depth));
    pool.gravity = {0, -g, 0};
    add_tank(
        pool, cells_deep, cells_deep + 4, true, [=](const Vec3& x) { return 1000 * g * (depth - x.y); },
        [=](long, long j) { return j < cells_deep; });
    return pool;
}

// The cubic lattice gives way to another arrangement within seconds; with the reciprocal weight it did so within half
// a second, at a tenth of sqrt(g h).
TEST(WcmpsPool, still_water_comes_to_rest_and_weighs_on_the_floor_what_it_weighs) {
    const double depth = 0.5, g = 9.81;
    Pool pool = still_pool(2, 12, depth);
    const double weight = 1000 * g * depth * depth;
    double floor_impulse = 0, potential = 0, fastest = 0, fastest_late = 0;
    while (pool.time < 5 && pool.report.problem.empty()) {
        pool.step();
        potential = potential == 0 ? pool.report.potential : potential;
        (pool.time < 2 ? fastest : fastest_late) =
            std::max(pool.time < 2 ? fastest : fastest_late, pool.report.max_speed);
        for (const Vec3& f : pool.walls.pressure_force) {
            floor_impulse -= pool.time > 2 ? f.y * pool.last_dt : 0;
        }
    }
    ASSERT_EQ(pool.report.problem, "");
    EXPECT_NEAR(floor_impulse, weight * 3, 0.01 * weight * 3);
    EXPECT_LT(std::max(fastest, fastest_late), 0.03 * std::sqrt(g * depth));
    EXPECT_LT(pool.report.max_speed, 0.02 * std::sqrt(g * depth));
    EXPECT_NEAR(pool.report.potential, potential, 5e-3 * potential);  // about twice the share of volume
    double squares = 0;
    for (std::size_t i = 0; i < pool.state.position.size(); ++i) {
        const double error =
            pressure_of(pool.settings, pool.state.density[i] / 1000) - 1000 * g * (depth - pool.state.position[i].y);
        squares += error * error;
    }
    EXPECT_LT(std::sqrt(squares / static_cast<double>(pool.state.size())), 0.02 * 1000 * g * depth);
}

TEST(WcmpsPool, still_water_has_its_surface_in_the_top_row_and_the_next_two_near_it) {
    Pool pool = still_pool(2, 12, 0.5);
    pool.step();
    const double dp = pool.settings.spacing;
    const auto classes = pool.scheme->surface_classes();
    for (std::size_t i = 0; i < pool.state.position.size(); ++i) {
        const auto rows_below = std::lround((0.5 - pool.state.position[i].y) / dp - 0.5);
        const SurfaceClass expected = rows_below == 0   ? SurfaceClass::surface
                                      : rows_below <= 2 ? SurfaceClass::near
                                                        : SurfaceClass::internal;
        EXPECT_EQ(classes[i], expected) << "row " << rows_below << " at x = " << pool.state.position[i].x;
    }
}

/// A column of water beside a dry floor.
Pool dam_break(long cells, long rows) {
    const double height = 0.5, g = 9.81;
    Pool pool;
    pool.settings = wcmps_settings(2, height / static_cast<double>(cells), 20 * std::sqrt(g * height));
    pool.gravity = {0, -g, 0};
    add_tank(
        pool, 2 * cells, rows, true, [=](const Vec3& x) { return 1000 * g * (height - x.y); },
        [=](long i, long j) { return i < cells && j < cells; });
    return pool;
}

TEST(WcmpsPool, a_dam_break_books_its_energy_and_its_momentum) {
    Pool pool = dam_break(16, 24);
    pool.step();
    const double start = pool.closure(), potential = pool.report.potential;
    const Vec3 momentum = pool.report.momentum - pool.impulse;
    pool.run_until(0.5);  // the front has hit the wall and runs up
    ASSERT_EQ(pool.report.problem, "");
    const double turnover = potential - pool.report.potential;
    EXPECT_GT(turnover, 0.2 * potential);
    EXPECT_LT(std::abs(pool.closure() - start), 0.01 * turnover);
    EXPECT_GT(pool.collisions, 0);
    EXPECT_LT(norm(pool.report.momentum - momentum - pool.impulse), 1e-6 * pool.report.mass * 9.81 * pool.time);
}

/// Where 98 % of all particles have not come to [m]
double front(const ParticleState& state) {
    std::vector<double> x;
    for (const Vec3& place : state.position) {
        x.push_back(place.x);
    }
    std::ranges::sort(x);
    return x[static_cast<std::size_t>(0.98 * static_cast<double>(x.size()))];
}

TEST(WcmpsPool, a_dam_break_runs_as_far_as_that_of_sph) {
    const long cells = 16;
    Pool pool = dam_break(cells, 24);
    Water water;
    water.settings = settings_2d(pool.settings.spacing, pool.settings.sound_speed);
    water.gravity = pool.gravity;
    water.walls = pool.walls;
    for_lattice(pool.settings.spacing, 0.5, 0.5, [&](double x, double y) {
        water.add_particle({x, y, 0}, {}, 1000 * 9.81 * (0.5 - y));
    });
    pool.run_until(0.25);
    water.run_until(0.25);
    ASSERT_EQ(pool.report.problem, "");
    EXPECT_GT(front(water.state), 0.8);
    EXPECT_NEAR(front(pool.state), front(water.state), 0.5 * pool.settings.spacing);
}

/// Mean height of the free surface between a support from one wall and one from the other [m].
double mean_surface(const Pool& pool, double width) {
    const double margin = pool.settings.support_radius();
    double sum = 0;
    for (int i = 0; i < 9; ++i) {
        const double x = margin + (width - 2 * margin) * i / 8;
        const Gauge line{.name = "line", .kind = &surface_gauge, .point = {x, 0, 0}, .end = {x, 1, 0}};
        sum += read_gauge(line, pool.settings, pool.state)[0] / 9;
    }
    return sum;
}

// By continuity alone the water came to rest 1.41 times as high: what closes counted as compressed before it was full.
// C of stirred water is not that of the lattice by about 0.01 (docs/decisions/0014-trials-of-wcmps-and-mps.md).
TEST(WcmpsPool, a_dam_break_comes_to_rest_at_the_level_of_its_volume) {
    Pool pool = dam_break(12, 48);
    pool.run_until(4.0);
    double level = 0;
    for (int row = 0; row < 20; ++row) {  // two periods of the sloshing that is left
        pool.run_until(pool.time + 0.1);
        level += mean_surface(pool, 1.0) / 20;
    }
    ASSERT_EQ(pool.report.problem, "");
    EXPECT_NEAR(level, 0.25, 0.02 * 0.25);
}

TEST(WcmpsPool, a_layer_dragged_along_a_wall_loses_what_viscosity_takes) {
    // plane Couette start: total momentum falls by the shear on the floor alone
    Pool pool;
    pool.settings = wcmps_settings(2, 0.01, 10);
    pool.settings.kinematic_viscosity = 1e-2;
    pool.settings.domain = {{0, -1, 0}, {0.2, 1, 0}, {true, false, false}, 2};
    for (long i = 0; i < 20; ++i) {
        for (long j = -4; j < 10; ++j) {
            const Vec3 x{(static_cast<double>(i) + 0.5) * 0.01, (static_cast<double>(j) + 0.5) * 0.01, 0};
            if (j < 0) {
                pool.add_wall_particle(x, false);
            } else {
                pool.add_particle(x, {0.1, 0, 0});
            }
        }
    }
    pool.step(1e-9);
    const double start = pool.report.momentum.x;
    double sheared = 0, pushed = 0;
    while (pool.time < 0.02) {
        pool.step();
        for (const Vec3& f : pool.walls.viscous_force) {
            sheared += f.x * pool.last_dt;
        }
        for (const Vec3& f : pool.walls.pressure_force) {
            pushed += f.x * pool.last_dt;
        }
    }
    ASSERT_EQ(pool.report.problem, "");
    EXPECT_NEAR(start - pool.report.momentum.x, sheared + pushed, 1e-6 * start);
    EXPECT_LT(std::abs(pushed), 1e-3 * sheared);
    // Stokes' first problem: momentum lost per area is 2 rho U sqrt(nu t/pi)
    const double expected = 2 * 1000 * 0.1 * std::sqrt(1e-2 * pool.time / 3.14159265) * 0.2;
    EXPECT_NEAR(sheared, expected, 0.1 * expected);
}

/// A fixed box of wall particles, a third of a still pool wide, in the middle of it: its load over the weight of its
/// water, the mean over half a second.
Vec3 lift_of_submerged_box(long side, WallLoads loads) {
    const double depth = 0.5, g = 9.81, dp = depth / static_cast<double>(3 * side);
    Pool pool;
    pool.settings = wcmps_settings(2, dp, 10 * std::sqrt(2 * g * depth));
    pool.settings.wall_loads = loads;
    pool.gravity = {0, -g, 0};
    const auto is_box = [=](long i, long j) { return i >= side && i < 2 * side && j >= side && j < 2 * side; };
    add_tank(
        pool, 3 * side, 3 * side + 4, true, [=](const Vec3& x) { return 1000 * g * (depth - x.y); },
        [=](long i, long j) { return j < 3 * side && !is_box(i, j); });
    const std::size_t first = pool.walls.position.size();
    pool.walls.outward_area.resize(first);
    for (long j = side; j < 2 * side; ++j) {
        for (long i = side; i < 2 * side; ++i) {
            pool.add_wall_particle({(static_cast<double>(i) + 0.5) * dp, (static_cast<double>(j) + 0.5) * dp, 0}, true);
            const double nx = i == side           ? -1
                              : i == 2 * side - 1 ? 1
                                                  : 0,
                         ny = j == side           ? -1
                              : j == 2 * side - 1 ? 1
                                                  : 0;
            pool.walls.outward_area.push_back(dp * Vec3{nx, ny, 0});
        }
    }
    pool.run_until(0.6);
    Vec3 lift{};
    double seconds = 0;
    while (pool.time < 1.1 && pool.report.problem.empty()) {
        pool.step();
        for (std::size_t w = first; w < pool.walls.position.size(); ++w) {
            lift += pool.last_dt * pool.walls.pressure_force[w];
        }
        seconds += pool.last_dt;
    }
    EXPECT_EQ(pool.report.problem, "");
    return lift / (seconds * 1000 * g * static_cast<double>(side * side) * dp * dp);
}

// Pressures of the source's load are those half a spacing below both faces: seven of eight spacings of height
// [Mellado2021, eq. 5.45]. Rows of wall particles carry some of the weight beside them, 2 % here, 0.4 % with twice as
// many.
TEST(WcmpsPool, a_submerged_box_is_lifted_by_the_weight_of_its_water_and_by_less_from_pressure_times_area) {
    const Vec3 by_pairs = lift_of_submerged_box(8, WallLoads::pair_sum);
    EXPECT_NEAR(by_pairs.y, 1, 0.03);
    EXPECT_NEAR(by_pairs.x, 0, 0.03);
    EXPECT_NEAR(lift_of_submerged_box(8, WallLoads::pressure_area).y, 7.0 / 8, 0.04);
}

// A count that tells arrangements apart takes water that has left its lattice for thinner or thicker than it is: by sum
// W it came to rest 1.2 % too low at k = 2.1, and 1 % too high at 2.6.
TEST(WcmpsPool, a_tank_shaken_for_ten_periods_comes_to_rest_at_the_level_of_its_volume) {
    constexpr double g = 9.81, dp = 0.02, width = 0.48, depth = 0.24, amplitude = 0.012;
    const double wave = std::numbers::pi / width, rate = 0.8 * std::sqrt(g * wave * std::tanh(wave * depth));
    const double still = 10 * 2 * std::numbers::pi / rate;
    for (const double ratio : {1.05, 1.3}) {
        Pool pool;
        pool.settings = wcmps_settings(2, dp, 10 * std::sqrt(2 * g * depth));
        pool.settings.smoothing_ratio = ratio;
        pool.gravity = {0, -g, 0};
        add_tank(
            pool, 24, 36, true, [](const Vec3& x) { return 1000 * g * (depth - x.y); },
            [](long, long j) { return j < 12; });
        const std::vector<Vec3> start = pool.walls.position;
        pool.move_walls = [&](double time) {
            const double way = time < still ? amplitude : 0;
            for (std::size_t w = 0; w < start.size(); ++w) {
                pool.walls.position[w] = start[w] + Vec3{way * std::sin(rate * time), 0, 0};
                pool.walls.velocity[w] = {way * rate * std::cos(rate * time), 0, 0};
                pool.walls.acceleration[w] = {-way * rate * rate * std::sin(rate * time), 0, 0};
            }
        };
        double level = 0, since = 0, fastest = 0;
        while (pool.time < still + 3 && pool.report.problem.empty()) {
            pool.step();
            fastest = std::max(fastest, pool.report.max_speed);
            if (pool.time > still + 1) {  // over a period and more of what sloshes on
                double sum = 0;
                for (const Vec3& x : pool.state.position) {
                    sum += x.y;
                }
                level += 2 * sum / static_cast<double>(pool.state.size()) * pool.last_dt;
                since += pool.last_dt;
            }
        }
        ASSERT_EQ(pool.report.problem, "");
        EXPECT_GT(fastest, 0.2);
        const double squeezed =
            g * depth / (2 * pool.settings.sound_speed * pool.settings.sound_speed);  // by its weight
        EXPECT_NEAR(level / since / depth, 1 - squeezed, 0.005) << ratio;
    }
}

}  // namespace
}  // namespace riprap::fluid::testing
