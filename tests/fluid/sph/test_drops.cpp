// SPDX-License-Identifier: Apache-2.0
// Drops of a few particles, as spray has them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "fluid/sph/water.hpp"

namespace riprap::fluid::testing {
namespace {

/// 27 particles thrown together: places up to a fifth of a spacing off, velocities and densities of spray.
Water drop(unsigned seed) {
    Water water;
    const double dp = 1.0 / 60;
    water.settings = settings_2d(dp, 28);
    water.settings.domain.dimension = 3;
    water.settings.domain.low = {-10, -10, -10};
    water.settings.domain.high = {10, 10, 10};
    water.settings.particle_mass = 1000 * dp * dp * dp;
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> off(-0.2 * dp, 0.2 * dp), speed(-2, 2), density(970, 1010);
    for (int k = 0; k < 27; ++k) {
        const Vec3 place{(k % 3) * dp + off(random), (k / 3 % 3) * dp + off(random), (k / 9) * dp + off(random)};
        water.add_particle(place, {speed(random), speed(random), speed(random)}, 0);
        water.state.density.back() = density(random);
    }
    return water;
}

double fastest(const Water& water) {
    double most = 0;
    for (const Vec3& v : water.state.velocity) {
        most = std::max(most, norm(v));
    }
    return most;
}

TEST(Drops, of_a_few_particles_neither_fall_together_into_a_point_nor_gain_speed) {
    for (const unsigned seed : {1U, 2U, 3U, 4U}) {
        Water water = drop(seed);
        const double before = fastest(water);
        water.step(1e-4);
        const double closure = water.closure(), kinetic = water.report.kinetic;
        for (int step = 0; step < 1500; ++step) {
            water.step(1e-4);
            ASSERT_TRUE(water.report.problem.empty()) << seed << ": " << water.report.problem;
        }
        EXPECT_NEAR(water.closure(), closure, 0.02 * kinetic) << seed;
        EXPECT_LT(fastest(water), 1.5 * before) << seed;
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < 27; ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                nearest = std::min(nearest, norm(water.state.position[i] - water.state.position[j]));
            }
        }
        EXPECT_GT(nearest, 0.2 * water.settings.spacing) << seed;
    }
}

}  // namespace
}  // namespace riprap::fluid::testing
