// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "fluid/sph/water.hpp"
#include "riprap/fluid/sph/gradient_correction.hpp"

namespace riprap::fluid::testing {
namespace {

/// v = A x
struct LinearFlow {
    Vec3 row_x, row_y, row_z;  ///< of A [1/s]
    double divergence() const { return row_x.x + row_y.y + row_z.z; }
    Vec3 at(const Vec3& x) const { return {dot(row_x, x), dot(row_y, x), dot(row_z, x)}; }
};

constexpr double denser = 1.025;

/// A block of water of so many particles a side, its particles up to 0.03 spacings off a lattice
/// that is 2.5 % denser than at rest, so that none counts as one in reach of a surface.
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
    water.update_density({}, dt);
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

TEST(GradientCorrection, is_bounded_and_continuous_where_neighbours_stand_in_a_line) {
    const GradientCorrection line = gradient_correction(2, {2.05, 0, 0, 0, 0, 0});
    EXPECT_DOUBLE_EQ(line.tensor[1], 2);
    EXPECT_EQ(line.share, 0);
    const GradientCorrection nearly = gradient_correction(2, {2.05, 1e-9, 0, 0, 0, 0});
    EXPECT_NEAR(nearly.tensor[1], line.tensor[1], 1e-8);
    EXPECT_NEAR(nearly.share, 0, 1e-8);
}

TEST(GradientCorrection, can_be_left_out_of_a_case) {
    const LinearFlow shear{{0, 2, 0}, {}, {}};
    Water water = disordered(2, 16, shear);
    water.settings.gradient_correction = false;
    EXPECT_GT(largest_error(water, 16, shear), 1e-3);
}

/// Disordered water between two slabs of wall, with a velocity and a pressure of its own for every particle.
Water shaken(int dimension, int side) {
    Water water = disordered(dimension, side, {{}, {}, {}});
    water.settings.shifting = 0;
    water.settings.viscosity.get<ArtificialViscosity>().alpha = 0;
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (std::size_t i = 0; i < water.state.position.size(); ++i) {
        water.state.velocity[i] = {unit(random), unit(random), dimension == 3 ? unit(random) : 0};
        water.state.density[i] = density_of(water.settings, 1000 + 500 * unit(random));
    }
    const double dp = water.settings.spacing;
    for (int layer = 0; layer < 3; ++layer) {
        for (int k = 0; k < (dimension == 3 ? side : 1); ++k) {
            for (int i = 0; i < side; ++i) {
                water.add_wall_particle({(i + 0.5) * dp, -(layer + 0.5) * dp, dimension == 3 ? (k + 0.5) * dp : 0},
                                        true);
            }
        }
    }
    return water;
}

TEST(GradientCorrection, leaves_the_pressure_force_the_adjoint_of_the_rate_of_density) {  // with heat of damped sound
    for (const int dimension : {2, 3}) {
        Water water = shaken(dimension, dimension == 2 ? 14 : 10);
        const double dt = 1e-6;  // forces see volumes this much later
        const std::vector<double> rho = water.state.density;
        const std::vector<Vec3> v = water.state.velocity;
        water.update_density({}, dt);
        const std::vector<double> later = water.state.density;
        water.accelerate({}, dt);
        double force = 0, compression = 0, size = 0;
        for (std::size_t i = 0; i < v.size(); ++i) {
            const double m = water.settings.particle_mass, rate = (later[i] / rho[i] - 1) / dt;
            const double stored = m / later[i] * pressure_of(water.settings, later[i]) * rate;
            force += m * dot((water.state.velocity[i] - v[i]) / dt, v[i]);
            compression += stored;
            size += std::abs(stored);
        }
        const double heat = 2 * water.report.dissipated_viscous / dt;  // half of it is due after the kick
        EXPECT_NEAR(force + compression + heat + (water.report.wall_exchange + water.report.earlier_exchange) / dt, 0,
                    1e-4 * size)
            << dimension;
        EXPECT_GT(std::abs(force), 1e-2 * size) << dimension;
        EXPECT_GT(heat, 1e-2 * size) << dimension;
    }
}

TEST(GradientCorrection, in_fast_sums_is_that_of_plain_sums) {
    Water plain = shaken(3, 10), fast = shaken(3, 10);
    fast.settings.is_plain = false;
    const std::vector<Vec3> before = plain.state.velocity;
    const std::vector<double> density = plain.state.density;
    plain.step(1e-5);
    fast.step(1e-5);
    double change = 0, error = 0, density_change = 0, density_error = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
        change = std::max(change, norm(plain.state.velocity[i] - before[i]));
        error = std::max(error, norm(plain.state.velocity[i] - fast.state.velocity[i]));
        density_change = std::max(density_change, std::abs(plain.state.density[i] - density[i]));
        density_error = std::max(density_error, std::abs(plain.state.density[i] - fast.state.density[i]));
    }
    EXPECT_LT(error, 1e-5 * change);
    EXPECT_LT(density_error, 1e-5 * density_change);
}

}  // namespace
}  // namespace riprap::fluid::testing
