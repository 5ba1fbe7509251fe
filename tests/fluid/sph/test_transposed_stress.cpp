// SPDX-License-Identifier: Apache-2.0
// The viscous stress of a fluid that ends: mu (grad u + (grad u)^T), of which pairs alone have the first half.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "fluid/sph/water.hpp"

namespace riprap::fluid::testing {
namespace {

constexpr double viscosity = 0.01;  // kinematic [m^2/s]
constexpr double radius = 0.5;      // of a drop 20 spacings in radius [m]

/// A drop in empty space with the velocity u = A x; no pressure, no shifting.
Water drop(const Vec3& row_x, const Vec3& row_y) {
    Water water;
    water.settings = settings_2d(radius / 20, 10);
    water.settings.viscosity.choose<LaminarSps>();
    water.settings.viscosity.get<LaminarSps>().kinematic_viscosity = viscosity;
    water.settings.viscosity.get<LaminarSps>().smagorinsky = 0;
    water.settings.shifting = 0;
    for_lattice(water.settings.spacing, 2 * radius, 2 * radius, [&](double x, double y) {
        const Vec3 place{x - radius, y - radius, 0};
        if (norm(place) < radius) {
            water.add_particle(place, {dot(row_x, place), dot(row_y, place), 0});
        }
    });
    return water;
}

/// Power that viscosity takes over rho nu and the area [1/s^2].
double dissipation_of(Water water) {
    water.step();
    EXPECT_EQ(water.report.problem, "");
    const double area = water.settings.spacing * water.settings.spacing * static_cast<double>(water.state.size());
    return water.report.dissipated_viscous / water.last_dt / (1000 * viscosity * area);
}

TEST(TransposedStress, a_drop_that_stretches_loses_two_mu_s_s_and_not_half_of_it) {
    // u = (x, -y): 2 S:S = 4, |grad u|^2 = 2. A surface layer of a spacing lacks part of its neighbours.
    EXPECT_NEAR(dissipation_of(drop({1, 0, 0}, {0, -1, 0})), 4, 0.35);
}

TEST(TransposedStress, a_drop_that_spins_as_a_solid_loses_next_to_nothing) {
    // u = (-y, x): S = 0, |grad u|^2 = 2, which pairs alone would take. What is left is of the surface.
    const double lost = dissipation_of(drop({0, -1, 0}, {1, 0, 0}));
    EXPECT_GE(lost, 0);
    EXPECT_LT(lost, 0.12);
}

TEST(TransposedStress, a_drop_in_shear_loses_mu_times_the_square_of_its_rate) {
    EXPECT_NEAR(dissipation_of(drop({0, 1, 0}, {0, 0, 0})), 1, 0.06);
}

TEST(TransposedStress, keeps_momentum_to_round_off_with_walls_and_without) {
    Water water;
    water.settings = settings_2d(0.05, 20);
    water.settings.viscosity.choose<LaminarSps>();
    water.settings.viscosity.get<LaminarSps>().kinematic_viscosity = viscosity;
    water.gravity = {0, -9.81, 0};
    add_tank(water, 1, 0.5, false);
    add_still_water(water, 1, 0.5);
    Vec3 momentum{};
    double scale = 0;
    for (std::size_t i = 0; i < water.state.position.size(); ++i) {
        const Vec3& x = water.state.position[i];
        water.state.velocity[i] = {std::sin(7 * x.y), std::cos(5 * x.x), 0};
        momentum += water.settings.particle_mass * water.state.velocity[i];
        scale += water.settings.particle_mass;
    }
    for (int k = 0; k < 3; ++k) {
        water.step();
        EXPECT_LT(norm(water.report.momentum - momentum - water.impulse), 1e-5 * scale);  // pair sums in single
    }
}

TEST(TransposedStress, the_energy_that_it_takes_is_booked) {
    Water water = drop({0.2, 0, 0}, {0, -0.2, 0});
    water.step();
    const double first = water.closure();
    for (int k = 0; k < 100; ++k) {
        water.step();
    }
    EXPECT_GT(water.dissipated_viscous, 0);
    EXPECT_NEAR(water.closure(), first, 0.02 * water.dissipated_viscous);
}

}  // namespace
}  // namespace riprap::fluid::testing
