// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "fluid/sph/water.hpp"
#include "riprap/fluid/sph/gradient_correction.hpp"

namespace riprap::fluid::testing {
namespace {

/// A block of water of so many particles a side that flows as v = A x, its particles up to 0.03 spacings off a lattice
/// that is 2.5 % denser than at rest, so that none counts as one in reach of a surface.
struct LinearFlow {
    Vec3 row_x, row_y, row_z;  ///< of A [1/s]
    double divergence() const { return row_x.x + row_y.y + row_z.z; }
    Vec3 at(const Vec3& x) const { return {dot(row_x, x), dot(row_y, x), dot(row_z, x)}; }
};

constexpr double denser = 1.025;

Water disordered(int dimension, int side, const LinearFlow& flow) {
    Water water;
    const double rest = 0.01, dp = rest * std::pow(denser, -1.0 / dimension);
    water.settings = settings_2d(rest, 10);
    water.settings.is_plain = true;
    water.settings.density_diffusion = 0;
    water.settings.domain.dimension = dimension;
    water.settings.particle_mass = water.settings.rest_density * std::pow(rest, dimension);
    water.settings.domain.low.z = -100;
    water.settings.domain.high.z = 100;
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> off(-0.03 * dp, 0.03 * dp);
    for (int k = 0; k < (dimension == 3 ? side : 1); ++k) {
        for_lattice(dp, side * dp, side * dp, [&](double x, double y) {
            const double z = dimension == 3 ? (k + 0.5) * dp + off(random) : 0;
            const Vec3 place{x + off(random), y + off(random), z};
            water.add_particle(place, flow.at(place), 500);
        });
    }
    return water;
}

/// The largest error of the rate of density over rho [1/s] among particles whose neighbours stand all around.
double largest_error(Water& water, int side, const LinearFlow& flow) {
    const std::vector<double> before = water.state.density;
    const double dt = 1e-3, low = 1.1 * water.settings.support_radius();
    const double high = side * water.settings.spacing * std::pow(denser, -1.0 / water.settings.domain.dimension) - low;
    update_density(water.settings, water.state, water.walls, {}, dt, water.scratch, water.report);
    double error = 0;
    int checked = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
        const Vec3& x = water.state.position[i];
        const bool is_inside = x.x > low && x.x < high && x.y > low && x.y < high &&
                               (water.settings.domain.dimension == 2 || (x.z > low && x.z < high));
        if (is_inside) {
            error = std::max(error, std::abs((water.state.density[i] / before[i] - 1) / dt + flow.divergence()));
            ++checked;
        }
    }
    EXPECT_GT(checked, 60);
    return error;
}

TEST(GradientCorrection, compresses_a_linear_flow_by_its_divergence_wherever_the_neighbours_are) {
    const LinearFlow plane{{0.3, -1.1, 0}, {0.7, 0.4, 0}, {}};
    Water water = disordered(2, 16, plane);
    EXPECT_LT(largest_error(water, 16, plane), 1e-9);
    const LinearFlow space{{0.3, -1.1, 0.2}, {0.7, 0.4, -0.5}, {1.3, 0.1, -0.2}};
    water = disordered(3, 12, space);
    EXPECT_LT(largest_error(water, 12, space), 1e-9);
}

TEST(GradientCorrection, lets_water_shear_and_turn_without_a_change_of_density) {
    const LinearFlow shear{{0, 2, 0}, {}, {}}, turn{{0, 2, 0}, {-2, 0, 0}, {}};
    Water water = disordered(2, 16, shear);
    EXPECT_LT(largest_error(water, 16, shear), 1e-9);
    water = disordered(2, 16, turn);
    EXPECT_LT(largest_error(water, 16, turn), 1e-9);
}

TEST(GradientCorrection, is_the_inverse_of_the_moments_where_neighbours_stand_all_around) {
    const Symmetric m{1.1, 0.95, 0.05, 1.02, -0.04, 0.03}, b = gradient_correction(3, m).tensor;
    const auto row = [](const Symmetric& t, int i) {
        return i == 0 ? Vec3{t[0], t[2], t[4]} : i == 1 ? Vec3{t[2], t[1], t[5]} : Vec3{t[4], t[5], t[3]};
    };
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            EXPECT_NEAR(dot(row(b, i), row(m, j)), i == j ? 1 : 0, 1e-14);
        }
    }
}

TEST(GradientCorrection, is_left_out_in_reach_of_a_surface_and_where_particles_are_squeezed) {
    const Symmetric unit{1, 1, 0, 1, 0, 0};
    const Symmetric first_row{0.90, 0.34, 0, 0, 0, 0}, second_row{1.00, 0.82, 0, 0, 0, 0},
        squeezed{1.5, 0.9, 0, 0, 0, 0};
    for (const Symmetric& m : {first_row, second_row, squeezed}) {
        EXPECT_EQ(gradient_correction(2, m).tensor, unit);
        EXPECT_EQ(gradient_correction(2, m).share, 0);
    }
    EXPECT_EQ(gradient_correction(2, {1, 1, 0, 55, 66, 77}).tensor, unit);  // planar scenes have no third direction
}

TEST(GradientCorrection, is_bounded_where_neighbours_stand_in_a_line) {
    EXPECT_EQ(gradient_correction(2, {2.05, 0, 0, 0, 0, 0}).tensor[1], 1);
    const GradientCorrection nearly = gradient_correction(2, {1.99, 0.05, 0, 0, 0, 0});
    EXPECT_GT(nearly.tensor[1], 1.9);
    EXPECT_LE(nearly.tensor[1], 2);
}

TEST(GradientCorrection, can_be_left_out_of_a_case) {
    const LinearFlow shear{{0, 2, 0}, {}, {}};
    Water water = disordered(2, 16, shear);
    water.settings.gradient_correction = false;
    EXPECT_GT(largest_error(water, 16, shear), 1e-3);
}

}  // namespace
}  // namespace riprap::fluid::testing
