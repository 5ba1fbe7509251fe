// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "fluid/mps/basin.hpp"
#include "riprap/core/fields.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/fluid/mps/mps_neighbours.hpp"
#include "riprap/fluid/mps/rest_density.hpp"

namespace riprap::fluid::testing {
namespace {

Basin still_basin(long cells) {
    const double depth = 0.5, g = 9.81;
    Basin basin;
    basin.settings = mps_settings(2, depth / static_cast<double>(cells), 2 * std::sqrt(g * depth));
    basin.gravity = {0, -g, 0};
    add_tank(
        basin, cells, cells + 4, true, [=](const Vec3& x) { return 1000 * g * (depth - x.y); },
        [=](long, long j) { return j < cells; });
    return basin;
}

Basin dam_break(long cells) {
    const double height = 0.5, g = 9.81;
    Basin basin;
    basin.settings = mps_settings(2, height / static_cast<double>(cells), 2 * std::sqrt(g * height));
    basin.gravity = {0, -g, 0};
    add_tank(
        basin, 2 * cells, 3 * cells / 2, true, [=](const Vec3& x) { return 1000 * g * (height - x.y); },
        [=](long i, long j) { return i < cells && j < cells; });
    return basin;
}

TEST(MpsNeighbours, are_all_within_the_support_in_rising_order_with_their_weights) {
    MpsSettings settings = mps_settings(3, 0.1, 1);
    settings.weight_law = MpsWeightLaw::reciprocal;
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> place(0, 1);
    std::vector<Vec3> points(600);
    for (Vec3& x : points) {
        x = {place(random), place(random), place(random)};
    }
    mps::Neighbours neighbours;
    neighbours.find(settings, points, points, true);
    for (std::size_t i = 0; i < points.size(); ++i) {
        std::int64_t entry = neighbours.first(i);
        for (std::size_t j = 0; j < points.size(); ++j) {
            const double r = norm(points[i] - points[j]);
            if (j != i && r < 0.21) {
                ASSERT_LT(entry, neighbours.end(i));
                ASSERT_EQ(neighbours.index(entry), j);
                const double near = std::max(r, 0.05);  // half a spacing
                ASSERT_NEAR(neighbours.weight(entry++), 0.21 / near - 1, 1e-4 * 0.21 / near);
            }
        }
        ASSERT_EQ(entry, neighbours.end(i));
    }
}

// The second row from above lacks neighbours beyond the surface: 0.5 % of the pressure at the floor. Water that gravity
// accelerates towards the floor must not also count as water that closes a gap: the pressure would be twice as high.
TEST(MpsPressure, of_still_water_on_the_lattice_is_hydrostatic) {
    Basin basin = still_basin(12);
    basin.settings.compressibility = 1e-13;  // incompressible
    basin.settings.relaxation = 1e-9;        // and nothing of the densities at the surface
    basin.settings.tolerance = 1e-10;
    for (double& density : basin.state.density) {
        density = 1000;  // the solve starts from nothing
    }
    basin.find_pressure(basin.gravity, 1e-4);
    const double surface = 0.5 - 0.5 * basin.settings.spacing;  // the top row has p = 0
    for (std::size_t i = 0; i < basin.state.position.size(); ++i) {
        const double y = basin.state.position[i].y;
        EXPECT_NEAR(basin.scheme->pressure()[i], 1000 * 9.81 * (surface - y), 6e-3 * 1000 * 9.81 * 0.5) << "y = " << y;
    }
}

/// Mean height of the water [m].
double mean_height(const Basin& basin) {
    double sum = 0;
    for (const Vec3& x : basin.state.position) {
        sum += x.y;
    }
    return sum / static_cast<double>(basin.state.size());
}

/// Force on the floor over the weight of the water.
double carried(const Basin& basin) {
    double floor = 0;
    for (const Vec3& f : basin.walls.pressure_force) {
        floor -= f.y;
    }
    return floor / (basin.report.mass * 9.81);
}

// By the count of the lattice alone it is carried by 0.8, 0.5 and 0.1 of its weight in the first step, and falls.
TEST(Mps, still_water_that_begins_with_the_pressure_of_its_depth_is_carried_from_the_first_step_on_and_stays) {
    for (const double share_of_step : {1.0, 0.4, 0.1}) {
        Basin basin = still_basin(12);
        mps::begin_with_pressure(basin.settings, 0, basin.state);
        const double dt = share_of_step * basin.limit().limit;
        const double start = mean_height(basin);
        basin.step(dt);
        EXPECT_NEAR(carried(basin), 1, 0.05) << share_of_step;
        while (basin.time < 0.1 && basin.report.problem.empty()) {
            basin.step(dt);
        }
        ASSERT_EQ(basin.report.problem, "");
        EXPECT_NEAR(mean_height(basin), start, 1e-3 * start) << share_of_step;
    }
}

TEST(Mps, a_pressure_to_begin_with_is_that_of_particles_just_placed_and_none_where_only_the_count_makes_pressure) {
    Basin basin;
    basin.settings = mps_settings(2, 0.1, 1);
    basin.add_particle({0, 0, 0}, {}, 5000);
    basin.add_particle({0, 0.1, 0}, {}, 4000);
    mps::begin_with_pressure(basin.settings, 1, basin.state);
    EXPECT_EQ(basin.state.dilution[0], 0);
    EXPECT_NEAR(basin.state.dilution[1], 1e-8 / 0.01 * 4000, 1e-9);  // alpha_c p/gamma
    basin.state.dilution[1] = 0;
    basin.settings.divergence_share = 0;  // as in the source
    mps::begin_with_pressure(basin.settings, 0, basin.state);
    EXPECT_EQ(basin.state.dilution[1], 0);
}

TEST(Mps, still_water_weighs_on_the_floor_what_it_weighs_and_comes_to_rest) {
    Basin basin = still_basin(12);
    double floor_impulse = 0, fastest = 0;
    while (basin.time < 2 && basin.report.problem.empty()) {
        basin.step();
        fastest = std::max(fastest, basin.report.max_speed);
        for (const Vec3& f : basin.walls.pressure_force) {
            floor_impulse -= basin.time > 1 ? f.y * basin.last_dt : 0;
        }
    }
    ASSERT_EQ(basin.report.problem, "");
    const double weight = basin.report.mass * 9.81;
    EXPECT_NEAR(floor_impulse, weight * 1, 0.01 * weight);
    EXPECT_LT(basin.report.max_speed, 0.6 * fastest);
    double height = 0;
    for (const Vec3& x : basin.state.position) {
        height += 2 * x.y / 0.5 / static_cast<double>(basin.state.size());
    }
    EXPECT_NEAR(height, 1, 0.01);  // as deep as it was
}

TEST(Mps, a_dam_break_books_its_energy_and_its_momentum_and_tells_of_its_solver) {
    Basin basin = dam_break(16);
    basin.step();
    const double start = basin.closure(), potential = basin.report.potential;
    const Vec3 momentum = basin.report.momentum - basin.impulse;
    std::int64_t most = 0;
    while (basin.time < 0.5 && basin.report.problem.empty()) {
        basin.step();
        most = std::max(most, basin.report.solver_iterations);
        EXPECT_LE(basin.report.solver_residual, basin.settings.tolerance);
    }
    ASSERT_EQ(basin.report.problem, "");
    const double turnover = potential - basin.report.potential;
    EXPECT_GT(turnover, 0.2 * potential);
    EXPECT_LT(std::abs(basin.closure() - start), 1e-9 * turnover);  // works of halves of steps: an identity
    EXPECT_LT(std::abs(basin.pressure_loss), 0.3 * turnover);
    EXPECT_LT(norm(basin.report.momentum - momentum - basin.impulse), 1e-6 * basin.report.mass * 9.81 * basin.time);
    EXPECT_GT(most, 0);
    EXPECT_LT(most, 60);
}

TEST(Mps, a_dam_break_runs_as_far_as_that_of_sph_and_two_spacings_farther_with_the_corrected_gradient) {
    const auto front = [](MpsGradient gradient) {
        Basin basin = dam_break(16);
        basin.settings.gradient = gradient;
        basin.run_until(0.25);
        EXPECT_EQ(basin.report.problem, "");
        std::vector<double> x;
        for (const Vec3& place : basin.state.position) {
            x.push_back(place.x);
        }
        std::ranges::sort(x);
        return x[static_cast<std::size_t>(0.98 * static_cast<double>(x.size()))];
    };
    const double conservative = front(MpsGradient::conservative);
    EXPECT_NEAR(conservative, 0.89, 0.02);  // of SPH and of weakly compressible MPS, at 16 spacings
    EXPECT_NEAR(front(MpsGradient::corrected), conservative, 2 * 0.5 / 16);  // it gives energy
}

TEST(Mps, a_drop_that_falls_on_a_floor_stays_above_it_and_gives_it_its_momentum) {
    Basin basin;
    basin.settings = mps_settings(2, 0.01, 3);
    for (long i = -10; i < 10; ++i) {
        for (long j = -3; j < 0; ++j) {
            basin.add_wall_particle({(static_cast<double>(i) + 0.5) * 0.01, (static_cast<double>(j) + 0.5) * 0.01, 0},
                                    true);
        }
    }
    basin.add_particle({0.003, 0.05, 0}, {0, -2, 0});
    double impulse = 0;
    for (int k = 0; k < 100; ++k) {
        basin.step();
        for (const Vec3& f : basin.walls.pressure_force) {
            impulse += f.y * basin.last_dt;
        }
    }
    ASSERT_EQ(basin.report.problem, "");
    EXPECT_GT(basin.state.position[0].y, 0);
    EXPECT_GT(basin.state.velocity[0].y, 0);
    EXPECT_NEAR(-impulse, basin.settings.particle_mass * (basin.state.velocity[0].y + 2), 1e-5);
}

TEST(Mps, has_the_same_bits_with_one_two_and_four_threads_and_when_its_scratch_is_lost) {
    const auto hash = [](int threads, bool drops) {
        parallel::set_thread_count(threads);
        Basin basin = dam_break(30);
        for (int k = 0; k < 4; ++k) {
            if (drops) {
                basin.scheme.reset();
            }
            basin.step();
        }
        parallel::set_thread_count(1);
        EXPECT_EQ(basin.report.problem, "");
        return hash_fields(basin.state);
    };
    const std::uint64_t one = hash(1, false);
    EXPECT_EQ(hash(2, false), one);
    EXPECT_EQ(hash(4, false), one);
    EXPECT_EQ(hash(1, true), one);
}

TEST(Mps, an_equation_that_is_not_solved_in_the_iterations_allowed_is_told_with_what_was_reached) {
    Basin basin = dam_break(16);
    basin.settings.max_iterations = 2;
    basin.step();
    EXPECT_THAT(basin.report.problem, ::testing::HasSubstr("not converged in the iterations allowed"));
    EXPECT_THAT(basin.report.problem, ::testing::HasSubstr("after 2 iterations, residual"));
    EXPECT_THAT(basin.report.remedy, ::testing::StartsWith("more fluid.max_iterations"));
}

}  // namespace
}  // namespace riprap::fluid::testing
