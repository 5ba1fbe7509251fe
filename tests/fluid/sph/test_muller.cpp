// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <numbers>

#include "fluid/sph/water.hpp"
#include "riprap/fluid/sph/muller_kernels.hpp"

namespace riprap::fluid::testing {
namespace {

constexpr double pi = std::numbers::pi;

/// Integral of f(r) over the disc or ball of a radius, by the midpoint rule
template <class F>
double integral(int dimension, double radius, const F& f) {
    const int steps = 20000;
    double sum = 0;
    for (int k = 0; k < steps; ++k) {
        const double r = radius * (k + 0.5) / steps;
        sum += f(r) * (dimension == 2 ? 2 * pi * r : 4 * pi * r * r) * radius / steps;
    }
    return sum;
}

class MullerKernels : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Dimensions, MullerKernels, ::testing::Values(2, 3));

TEST_P(MullerKernels, poly6_integrates_to_one_and_ends_at_its_radius) {
    const Poly6Kernel kernel(0.3, GetParam());
    EXPECT_NEAR(integral(GetParam(), 0.3, [&](double r) { return kernel.value_at(r * r); }), 1, 1e-7);
    EXPECT_EQ(kernel.value_at(0.3 * 0.3), 0);
    EXPECT_EQ(kernel.value_at(0.1), 0);
}

TEST_P(MullerKernels, the_slope_of_spiky_is_that_of_a_kernel_that_integrates_to_one) {
    // by parts: the integral of W is -1/dimension times that of (dW/dr) r
    const SpikyKernel kernel(0.3, GetParam());
    const double sum = integral(GetParam(), 0.3, [&](double r) { return -kernel.slope_over_r(r) * r * r; });
    EXPECT_NEAR(sum / GetParam(), 1, 1e-4);
}

TEST_P(MullerKernels, the_viscous_weight_has_the_second_moment_of_a_laplacian) {
    const LaplacianKernel kernel(0.3, GetParam());
    EXPECT_NEAR(integral(GetParam(), 0.3, [&](double r) { return kernel.laplacian(r) * r * r; }), 2 * GetParam(), 1e-6);
}

TEST(Muller, water_in_a_tank_weighs_what_it_weighs) {
    const double depth = 0.5, g = 9.81;
    Water water;
    water.settings = settings_2d(depth / 16, 10 * std::sqrt(g * depth));
    water.settings.scheme = SphScheme::muller;
    water.settings.state_equation = StateEquation::linear_without_tension;
    water.settings.smoothing_ratio = 1.2;
    water.settings.viscosity.get<ArtificialViscosity>().alpha =
        0.1;  // less lets its pressure noise grow (docs/theory/sph.md, 9)
    water.gravity = {0, -g, 0};
    add_tank(water, 0.5, 0.8, true);
    add_still_water(water, 0.5, depth);
    double impulse = 0;
    while (water.time < 2 && water.report.problem.empty()) {
        water.step();
        for (const Vec3& f : water.walls.pressure_force) {
            impulse -= water.time > 1 ? f.y * water.last_dt : 0;
        }
    }
    ASSERT_EQ(water.report.problem, "");
    const double weight = 1000 * g * depth * 0.5;
    EXPECT_NEAR(impulse, weight, 0.02 * weight);
    EXPECT_LT(water.report.kinetic, 0.01 * weight * depth);
}

TEST(Muller, keeps_the_momentum_of_two_blocks_that_collide) {
    Water water;
    water.settings = settings_2d(0.02, 30);
    water.settings.scheme = SphScheme::muller;
    water.settings.state_equation = StateEquation::linear_without_tension;
    water.settings.viscosity.choose<LaminarSps>();
    water.settings.viscosity.get<LaminarSps>().kinematic_viscosity = 0.02;
    water.settings.is_plain = true;
    for_lattice(0.02, 0.3, 0.3, [&](double x, double y) {
        water.add_particle({x, y, 0}, {1.5, 0.2, 0});
        water.add_particle({x + 0.32, y + 0.1, 0}, {-1, 0, 0});
    });
    water.step();
    const Vec3 start = water.report.momentum;
    const double energy = water.report.kinetic;
    water.run_until(0.05);
    ASSERT_EQ(water.report.problem, "");
    EXPECT_LT(water.report.kinetic, 0.9 * energy);
    EXPECT_LT(norm(water.report.momentum - start), 1e-12 * water.report.mass * 1.5);
}

}  // namespace
}  // namespace riprap::fluid::testing
