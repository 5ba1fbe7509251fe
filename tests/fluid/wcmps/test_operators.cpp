// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <random>

#include "riprap/core/fields.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/fluid/mps_operators/collision.hpp"

#include "fluid/wcmps/pool.hpp"

namespace riprap::fluid::testing {
namespace {

/// A periodic box full of particles; `jitter` in spacings.
Pool periodic_box(int dimension, long cells, double jitter, std::uint64_t seed = 5) {
    Pool pool;
    pool.settings = wcmps_settings(dimension, 0.02, 20);
    const double size = static_cast<double>(cells) * 0.02;
    pool.settings.domain = {{0, 0, 0}, {size, size, size}, {true, true, dimension == 3}, dimension};
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (long k = 0; k < (dimension == 3 ? cells : 1); ++k) {
        for (long j = 0; j < cells; ++j) {
            for (long i = 0; i < cells; ++i) {
                const Vec3 shake{unit(random), unit(random), dimension == 3 ? unit(random) : 0};
                const Vec3 x{static_cast<double>(i) + 0.5, static_cast<double>(j) + 0.5,
                             dimension == 3 ? static_cast<double>(k) + 0.5 : 0};
                const Vec3 v{unit(random), unit(random), dimension == 3 ? unit(random) : 0};
                pool.add_particle(0.02 * (x + jitter * shake), jitter * v, 1000 * jitter * unit(random));
            }
        }
    }
    return pool;
}

class WcmpsDimensions : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(PlaneAndSpace, WcmpsDimensions, ::testing::Values(2, 3));

TEST_P(WcmpsDimensions, continuity_has_the_exact_divergence_of_a_linear_flow_on_the_lattice) {
    const int dimension = GetParam();
    Pool pool;
    pool.settings = wcmps_settings(dimension, 0.02, 20);
    pool.settings.density_diffusion = 0;
    const long half = 4;
    std::size_t middle = 0;
    for (long k = dimension == 3 ? -half : 0; k <= (dimension == 3 ? half : 0); ++k) {
        for (long j = -half; j <= half; ++j) {
            for (long i = -half; i <= half; ++i) {
                const Vec3 x = 0.02 * Vec3{static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)};
                middle = i == 0 && j == 0 && k == 0 ? pool.state.position.size() : middle;
                pool.add_particle(x, {2 * x.x + 3 * x.y, -0.5 * x.y + x.x, dimension == 3 ? x.z : 0});
            }
        }
    }
    pool.update_density({}, 1e-3);
    const double divergence = dimension == 3 ? 2.5 : 1.5;
    EXPECT_NEAR(pool.state.density[middle], 1000 * (1 - 1e-3 * divergence), 1e-4);
}

TEST_P(WcmpsDimensions, forces_in_a_linear_pressure_are_its_gradient_on_the_lattice) {
    const int dimension = GetParam();
    Pool pool;
    pool.settings = wcmps_settings(dimension, 0.02, 200);  // stiff: x = 1 but for 1e-5
    const long half = 4;
    std::size_t middle = 0;
    for (long k = dimension == 3 ? -half : 0; k <= (dimension == 3 ? half : 0); ++k) {
        for (long j = -half; j <= half; ++j) {
            for (long i = -half; i <= half; ++i) {
                const Vec3 x = 0.02 * Vec3{static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)};
                middle = i == 0 && j == 0 && k == 0 ? pool.state.position.size() : middle;
                pool.add_particle(x, {}, 1000 + 300 * x.x - 200 * x.y);
            }
        }
    }
    pool.update_density({}, 0);
    pool.accelerate({}, 1);
    const Vec3 v = pool.state.velocity[middle];
    EXPECT_NEAR(v.x, -0.3, 3e-4);
    EXPECT_NEAR(v.y, 0.2, 3e-4);
}

/// What the strongest shift leaves of a wave of lattice planes `period` spacings long [-].
double left_of_wave(int dimension, MpsWeightLaw law, int period) {
    Pool pool = periodic_box(dimension, 12, 0);
    pool.settings.weight_law = law;
    pool.settings.shifting = 10;
    const double dp = pool.settings.spacing, amplitude = 0.001 * dp;
    const std::vector<Vec3> lattice = pool.state.position;
    const auto plane = [&](std::size_t id) { return std::lround(lattice[id].x / dp - 0.5); };
    const auto wave = [&](std::size_t id) {
        return std::cos(2 * 3.141592653589793 * static_cast<double>(plane(id)) / period);
    };
    for (std::size_t i = 0; i < lattice.size(); ++i) {
        pool.state.position[i].x += wave(i) * amplitude;
        pool.state.velocity[i] = {0, plane(i) % 2 == 0 ? 1.0 : -1.0, 0};  // planes pass each other
    }
    pool.step();
    EXPECT_GT(pool.report.max_shift, 0.4 * amplitude);
    double left = 0, all = 0;
    for (std::size_t k = 0; k < lattice.size(); ++k) {
        const auto id = static_cast<std::size_t>(pool.state.id[k]);
        left += wave(id) * (pool.state.position[k].x + pool.state.shift[k].x - lattice[id].x);
        all += wave(id) * wave(id) * amplitude;
    }
    return left / all;
}

// Without a bound such a wave in water that is strongly stirred would grow from step to step. C, which gradients take
// with it, is uneven in the longer wave: that adds a tenth.
TEST_P(WcmpsDimensions, the_strongest_shift_halves_the_stiffest_wave_of_planes) {
    EXPECT_NEAR(left_of_wave(GetParam(), MpsWeightLaw::reciprocal, 2), 0.5, 0.02);
    EXPECT_NEAR(left_of_wave(GetParam(), MpsWeightLaw::smooth, 4), 0.5, 0.06);
}

TEST_P(WcmpsDimensions, a_cloud_keeps_its_momentum_to_round_off) {
    Pool pool = periodic_box(GetParam(), 10, 0.25);
    pool.settings.is_plain = true;
    pool.settings.kinematic_viscosity = 1e-3;
    pool.step(1e-9);  // what the first step reports comes after its kick
    const Vec3 before = pool.report.momentum;
    for (int k = 0; k < 5; ++k) {
        pool.step();
    }
    ASSERT_EQ(pool.report.problem, "");
    EXPECT_LT(norm(pool.report.momentum - before), 1e-12 * pool.report.mass * pool.report.max_speed);
}

TEST_P(WcmpsDimensions, fast_sums_are_the_plain_ones_to_the_accuracy_of_floats) {
    Pool fast = periodic_box(GetParam(), 10, 0.1), plain = periodic_box(GetParam(), 10, 0.1);
    plain.settings.is_plain = true;
    for (int k = 0; k < 3; ++k) {
        fast.step(1e-5);
        plain.step(1e-5);
    }
    ASSERT_EQ(fast.report.problem, "");
    for (std::size_t i = 0; i < fast.state.position.size(); ++i) {
        ASSERT_EQ(fast.state.id[i], plain.state.id[i]);
        EXPECT_LT(norm(fast.state.velocity[i] - plain.state.velocity[i]), 2e-5 * plain.report.max_speed);
        EXPECT_NEAR(fast.state.density[i], plain.state.density[i], 1e-3);
    }
}

TEST(Wcmps, has_the_same_bits_with_one_two_and_four_threads) {
    const auto hash = [](int threads) {
        parallel::set_thread_count(threads);
        Pool pool = periodic_box(2, 60, 0.2);
        for (int k = 0; k < 5; ++k) {
            pool.step();
        }
        parallel::set_thread_count(1);
        EXPECT_EQ(pool.report.problem, "");
        return hash_fields(pool.state);
    };
    const std::uint64_t one = hash(1);
    EXPECT_EQ(hash(2), one);
    EXPECT_EQ(hash(4), one);
}

TEST(Wcmps, steps_with_the_same_bits_when_its_scratch_is_lost_between_them) {
    Pool kept = periodic_box(2, 40, 0.2), dropped = periodic_box(2, 40, 0.2);
    for (int k = 0; k < 6; ++k) {
        kept.step();
        dropped.scheme.reset();
        dropped.step();
    }
    EXPECT_EQ(hash_fields(kept.state), hash_fields(dropped.state));
}

TEST(Wcmps, state_equation_and_its_inverse_cancel_and_energy_is_the_integral_of_pressure) {
    const WcmpsSettings settings = wcmps_settings(2, 0.01, 25);
    for (const double x : {0.99, 1.0, 1.003, 1.02}) {
        EXPECT_NEAR(concentration_of(settings, pressure_of(settings, x)), x, 1e-12);
        const double step = 1e-5;
        const double slope =
            (internal_energy_of(settings, x + step) - internal_energy_of(settings, x - step)) / (2 * step);
        EXPECT_NEAR(slope, pressure_of(settings, x) / (1000 * x), 1e-6 * 25 * 25);
    }
    EXPECT_EQ(internal_energy_of(settings, 1), 0);
}

/// Two particles with nobody around, as class F alone collides: called directly.
TEST(WcmpsCollision, a_pair_keeps_its_momentum_and_parts_with_the_share_of_its_approach) {
    const MpsCollision pair{0.9 * 0.9, 1e-8};
    const double share = 0.5 * (1 + 0.5);
    const double a[4] = {1, 0.3, 0, share}, b[4] = {-0.5, 0.1, 0, share}, d[3] = {-0.8, 0, 0};
    double change_a[3]{}, change_b[3]{};
    pair.exchange<2>(a, b, d, 0.64, 0.8, change_a, change_b);
    EXPECT_DOUBLE_EQ(change_a[0], -change_b[0]);
    const double apart = (b[0] + change_b[0]) - (a[0] + change_a[0]);
    EXPECT_NEAR(apart, 0.5 * 1.5, 1e-6);
    EXPECT_EQ(change_a[1], 0);
    double nothing[3]{}, too[3]{};
    pair.exchange<2>(b, a, d, 0.64, 0.8, nothing, too);  // parting already
    EXPECT_EQ(nothing[0], 0);
}

TEST(WcmpsCollision, a_crowd_that_collides_all_at_once_loses_energy) {
    Pool pool = periodic_box(2, 30, 0.4);
    pool.settings.collision_distance = 2;  // everybody collides with a dozen others
    double lost = 0;
    for (int k = 0; k < 3; ++k) {
        pool.step(1e-6);
        lost = pool.report.dissipated_collisions;
        EXPECT_GE(lost, 0);
    }
}

}  // namespace
}  // namespace riprap::fluid::testing
