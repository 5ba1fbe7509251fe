// SPDX-License-Identifier: Apache-2.0
// Pins each constant of semi-implicit MPS: a test here fails where the constant is halved or doubled
// (tools/mutations.toml).
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "fluid/mps/basin.hpp"
#include "riprap/fluid/mps_operators/mps_lattice.hpp"

namespace riprap::fluid::testing {
namespace {

constexpr double wave = 2 * std::numbers::pi;  ///< k of one length in a box of 1 m [1/m]

/// Water that repeats every metre, at rest.
Basin box_of_water(int across = 32) {
    Basin basin;
    basin.settings = mps_settings(2, 1.0 / across, 1);
    basin.settings.domain = {{0, 0, 0}, {1, 1, 0}, {true, true, false}, 2};
    for (int j = 0; j < across; ++j) {
        for (int i = 0; i < across; ++i) {
            basin.add_particle({(i + 0.5) / across, (j + 0.5) / across, 0});
        }
    }
    return basin;
}

TEST(MpsConstants, viscosity_takes_the_power_of_navier_and_stokes_from_a_shear_flow) {
    Basin basin = box_of_water();
    basin.settings.kinematic_viscosity = 0.01;
    for (std::size_t i = 0; i < basin.state.position.size(); ++i) {
        basin.state.velocity[i].x = 0.1 * std::sin(wave * basin.state.position[i].y);
    }
    basin.step(1e-6);
    const double power = 0.5 * 1000 * 0.01 * wave * wave * 0.1 * 0.1;  // rho nu k^2 U^2/2
    EXPECT_NEAR(basin.report.dissipated_viscous / basin.last_dt, power, 0.05 * power);
}

TEST(MpsConstants, water_that_stands_closer_than_it_should_has_the_pressure_gamma_over_alpha_times_the_excess) {
    // Nothing can move apart in a box that repeats: p rho_0 alpha_c/dt^2 = gamma rho_0/dt^2 (n - n_0)/n_0, gamma = 0.01
    Basin basin = box_of_water();
    basin.settings.spacing *= 1.01;
    basin.find_pressure({}, 1e-3);
    // Wendland's kernel over the lattice squeezed by 1.01, the particle itself among it: neighbours at 1, sqrt(2) and 2
    const auto count = [](double reach) {
        double sum = 1;
        for (const double r : {1.0, std::sqrt(2.0), 2.0}) {
            sum += 4 * std::pow(1 - r / reach, 4) * (1 + 4 * r / reach);
        }
        return sum;
    };
    const double excess = count(2.1 * 1.01) / count(2.1) - 1;
    ASSERT_GT(excess, 0.01);
    EXPECT_NEAR(basin.scheme->pressure()[100], 0.01 / 1e-8 * excess, 0.01 * 0.01 / 1e-8 * excess);
}

TEST(MpsConstants, the_pressure_of_a_flow_that_draws_together_is_that_of_its_projection) {
    // laplace(p) - rho alpha/dt^2 p = rho/dt div u for u = U sin(k x), whose divergence is U k cos(k x)
    Basin basin = box_of_water();
    basin.settings.kinematic_viscosity = 0;
    basin.settings.relaxation = 1e-9;  // nothing of densities
    constexpr double speed = 0.1, dt = 1e-4;
    for (std::size_t i = 0; i < basin.state.position.size(); ++i) {
        basin.state.velocity[i].x = speed * std::sin(wave * basin.state.position[i].x);
    }
    basin.find_pressure({}, dt);
    const double largest = 1000 * speed * wave / dt / (wave * wave + 1000 * basin.settings.compressibility / (dt * dt));
    double mode = 0, square = 0;
    for (std::size_t i = 0; i < basin.state.position.size(); ++i) {
        const double c = std::min(0.0, std::cos(wave * basin.state.position[i].x));  // no tension where it parts
        mode -= c * basin.scheme->pressure()[i];
        square += c * c;
    }
    EXPECT_NEAR(mode / square, largest, 0.1 * largest);
}

TEST(MpsConstants,
     water_that_draws_together_along_a_wall_has_the_pressure_of_all_of_its_divergence_in_the_row_beside_it) {
    // Two rows: p = 0 in the upper one, so c p sum W = rho/dt eps in the lower one, W to the row above it.
    Basin basin;
    basin.settings = mps_settings(2, 0.02, 1);
    basin.settings.kinematic_viscosity = 0;
    basin.settings.relaxation = 1e-9;  // nothing of densities
    constexpr double eps = 0.5, dt = 1e-4;
    for (int i = -30; i <= 30; ++i) {
        for (int j = -3; j < 2; ++j) {
            const Vec3 x = 0.02 * Vec3{static_cast<double>(i), j + 0.5, 0};
            if (j < 0) {
                basin.add_wall_particle(x, true);
            } else {
                basin.add_particle(x, {-eps * x.x, 0, 0});
            }
        }
    }
    basin.find_pressure({}, dt);
    double middle = 0;
    for (std::size_t i = 0; i < basin.state.position.size(); ++i) {
        const Vec3& x = basin.state.position[i];
        middle = std::abs(x.x) < 1e-6 && x.y < 0.02 ? basin.scheme->pressure()[i] : middle;
    }
    const auto weight = [](double r) { return r * r / (2.1 * 2.1) * std::pow(1 - r / 2.1, 3); };
    const double above = weight(1) + 2 * weight(std::sqrt(2.0));
    const double stiffness = basin.settings.lattice().second_order() * above + 1000 * 1e-8 / (dt * dt);
    EXPECT_NEAR(middle, 1000 / dt * eps / stiffness, 0.03 * 1000 / dt * eps / stiffness);
}

TEST(MpsConstants, two_particles_that_meet_part_with_a_fifth_of_their_approach) {
    Basin basin;
    basin.settings = mps_settings(2, 0.02, 1);
    basin.settings.kinematic_viscosity = 0;
    basin.add_particle({0, 0, 0}, {1, 0.3, 0});
    basin.add_particle({0.015, 0, 0}, {-0.5, 0.3, 0});
    basin.begin_forces({}, 1e-5);
    EXPECT_NEAR(basin.state.velocity[1].x - basin.state.velocity[0].x, 0.2 * 1.5, 1e-5);
    EXPECT_NEAR(basin.state.velocity[1].x + basin.state.velocity[0].x, 0.5, 1e-6);
}

/// Ten rows of water over a wall, with a velocity along it by height.
Basin water_on_wall(const std::function<double(double)>& velocity) {
    Basin basin;
    basin.settings = mps_settings(2, 0.01, 1);
    basin.settings.kinematic_viscosity = 1e-2;
    basin.settings.domain = {{0, -1, 0}, {0.2, 1, 0}, {true, false, false}, 2};
    for (long i = 0; i < 20; ++i) {
        for (long j = -3; j < 10; ++j) {
            const Vec3 x{(static_cast<double>(i) + 0.5) * 0.01, (static_cast<double>(j) + 0.5) * 0.01, 0};
            if (j < 0) {
                basin.add_wall_particle(x, false);
            } else {
                basin.add_particle(x, {velocity(x.y), 0, 0});
            }
        }
    }
    return basin;
}

TEST(MpsConstants, a_wall_under_an_even_shear_feels_its_stress) {
    Basin basin = water_on_wall([](double y) { return 10 * y; });
    basin.step(1e-7);
    double force = 0;
    for (const Vec3& f : basin.walls.viscous_force) {
        force += f.x;
    }
    const double expected = 1000 * 1e-2 * 10 * 0.2;  // rho nu du/dy per metre of depth
    EXPECT_NEAR(force, expected, 0.15 * expected);
}

TEST(MpsConstants, a_wall_takes_from_a_layer_that_starts_along_it_what_stokes_first_problem_says) {
    Basin basin = water_on_wall([](double) { return 0.1; });
    double sheared = 0;
    while (basin.time < 0.02) {
        basin.step();
        for (const Vec3& f : basin.walls.viscous_force) {
            sheared += f.x * basin.last_dt;
        }
    }
    ASSERT_EQ(basin.report.problem, "");
    const double expected = 2 * 1000 * 0.1 * std::sqrt(1e-2 * basin.time / std::numbers::pi) * 0.2;
    EXPECT_NEAR(sheared, expected, 0.1 * expected);
}

TEST(MpsConstants, in_a_step_viscosity_spreads_over_an_eighth_of_a_spacing_squared) {
    Basin basin = box_of_water();
    basin.settings.kinematic_viscosity = 1000;
    const double l = basin.settings.spacing;
    EXPECT_NEAR(1000 * basin.limit().limit, l * l / 8, 1e-9 * l * l);
}

/// Whether the particle nearest to a place, in spacings, is one of the surface, among rows 40 wide under y = 0.
bool is_surface(double squeezed, const std::vector<Vec3>& without, const Vec3& at) {
    Basin basin;
    basin.settings = mps_settings(2, 0.02, 1);
    for (int j = 0; j < 12; ++j) {
        for (int i = -20; i <= 20; ++i) {
            const Vec3 x{static_cast<double>(i), static_cast<double>(-j), 0};
            if (std::none_of(without.begin(), without.end(), [&](const Vec3& y) { return norm(x - y) < 0.1; })) {
                basin.add_particle(0.02 * squeezed * x);
            }
        }
    }
    basin.begin_forces({}, 1e-6);
    const auto found = basin.scheme->surface_particles();
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < basin.state.position.size(); ++i) {
        const Vec3 wanted = 0.02 * squeezed * at;
        nearest = norm(basin.state.position[i] - wanted) < norm(basin.state.position[nearest] - wanted) ? i : nearest;
    }
    return found[nearest] != 0;
}

TEST(MpsConstants, a_face_of_water_is_its_surface_unless_it_is_squeezed) {
    // n is 0.85 n_0 in the highest row and more than n_0 where rows are 0.8 spacings apart
    EXPECT_TRUE(is_surface(1, {}, {0, 0, 0}));
    EXPECT_FALSE(is_surface(0.8, {}, {0, 0, 0}));
}

TEST(MpsConstants, a_particle_whose_neighbours_lean_by_a_third_of_a_spacing_is_at_a_surface_and_by_a_sixth_inside) {
    // The weighted centre of its neighbours is 0.34 and 0.18 spacings away, n is 0.87 and 0.85 n_0.
    EXPECT_TRUE(is_surface(1, {{1, -6, 0}, {1, -5, 0}}, {0, -6, 0}));
    EXPECT_FALSE(is_surface(1, {{1, -6, 0}, {-1, -5, 0}, {-1, -7, 0}}, {0, -6, 0}));
}

}  // namespace
}  // namespace riprap::fluid::testing
