// SPDX-License-Identifier: Apache-2.0
// Artificial viscosity that spares smooth flow, beside the whole of it.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

#include "fluid/sph/water.hpp"
#include "riprap/fluid/sph/roughness.hpp"

namespace riprap::fluid::testing {
namespace {

constexpr double pi = std::numbers::pi;

SphSettings artificial(int dimension, double spacing, double sound_speed, bool spares_smooth) {
    SphSettings settings = settings_2d(spacing, sound_speed);
    settings.viscosity.get<ArtificialViscosity>().spares_smooth = spares_smooth;
    settings.domain.dimension = dimension;
    settings.particle_mass = settings.rest_density * std::pow(spacing, dimension);
    return settings;
}

/// Heat that the first step makes by viscosity in a periodic box of jittered water with those velocities [J].
double heat(int dimension, bool spares_smooth, const std::function<Vec3(const Vec3&)>& velocity) {
    const long across = dimension == 2 ? 24 : 20;
    const double dp = 1.0 / static_cast<double>(across);
    Water water;
    water.settings = artificial(dimension, dp, 10, spares_smooth);
    water.settings.acoustic_damping = 0;
    water.settings.domain = {{0, 0, 0}, {1, 1, 1}, {true, true, dimension == 3}, dimension};
    std::mt19937 random(3);
    std::uniform_real_distribution<double> jitter(-0.1 * dp, 0.1 * dp);
    for (long k = 0; k < (dimension == 2 ? 1 : across); ++k) {
        for_lattice(dp, 1, 1, [&](double x, double y) {
            const double z = dimension == 2 ? 0 : (static_cast<double>(k) + 0.5) * dp + jitter(random);
            const Vec3 place{x + jitter(random), y + jitter(random), z};
            water.add_particle(place, velocity(place));
        });
    }
    water.step();
    EXPECT_EQ(water.report.problem, "");
    return water.report.dissipated_viscous / water.last_dt;
}

class Roughness : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Dimensions, Roughness, ::testing::Values(2, 3));

TEST_P(Roughness, spares_shear_vortices_and_stagnation_flow_on_disordered_places) {
    const double k = 2 * pi;
    const std::vector<std::function<Vec3(const Vec3&)>> flows{
        [&](const Vec3& x) {
            return Vec3{0.1 * std::sin(k * x.y), 0, 0};
        },
        [&](const Vec3& x) {
            return Vec3{0.1 * std::sin(k * x.x) * std::cos(k * x.y), -0.1 * std::cos(k * x.x) * std::sin(k * x.y), 0};
        },
        [&](const Vec3& x) {
            return Vec3{0.1 * std::sin(k * (x.x + x.y)), -0.1 * std::sin(k * (x.x + x.y)), 0};
        }};
    for (std::size_t flow = 0; flow < flows.size(); ++flow) {
        const double all = heat(GetParam(), false, flows[flow]);
        ASSERT_GT(all, 0);
        EXPECT_LT(heat(GetParam(), true, flows[flow]), 0.1 * all) << flow;
    }
}

TEST_P(Roughness, leaves_nine_tenths_of_the_viscosity_to_velocities_at_random) {
    const auto noise = [](const Vec3& x) {
        const auto one = [&](double a) { return 0.01 * std::sin(1e5 * (x.x + a * x.y + a * a * x.z)); };
        return Vec3{one(1.3), one(2.7), 0};
    };
    const double all = heat(GetParam(), false, noise);
    EXPECT_GT(heat(GetParam(), true, noise), 0.9 * all);
    EXPECT_LE(heat(GetParam(), true, noise), all);
}

TEST(Roughness, of_a_linear_flow_is_none_and_of_pairs_without_a_mean_is_one) {
    const Symmetric shear{0, 0, 0.5, 0, 0, 0}, none{};  // G of v_x = y, 2 G:G = 1
    EXPECT_EQ(roughness(2, shear, 1, 1), 0);
    EXPECT_EQ(roughness(2, none, 1, 1), 1);
    EXPECT_EQ(roughness(2, none, 0, 1), 0);  // at rest
    EXPECT_EQ(roughness(2, shear, 2, 0.5), 0);
    EXPECT_NEAR(roughness(2, shear, 2, 1), 0.5, 1e-12);  // r = 1/2, halfway from 0.3 to 0.7
}

/// Swing of the centre of mass of a standing wave of 40 spacings after two and a half periods, over the first.
double swing_left(bool spares_smooth) {
    const double length = 1, depth = 0.5, amplitude = 0.02, g = 9.81, dp = 2 * length / 40;
    const double k = pi / length, omega = std::sqrt(g * k * std::tanh(k * depth));
    Water water;
    water.settings = artificial(2, dp, 10 * std::sqrt(g * depth), spares_smooth);
    water.gravity = {0, -g, 0};
    add_tank(water, length, 2 * depth, true);
    for_lattice(dp, length, depth, [&](double x, double y) {
        const double speed = amplitude * omega / std::sinh(k * depth);
        water.add_particle({x, y, 0},
                           {-speed * std::cosh(k * y) * std::sin(k * x), speed * std::sinh(k * y) * std::cos(k * x), 0},
                           1000 * g * (depth - y));
    });
    std::vector<double> swings(6, 0.0);
    while (water.time < 3 * 2 * pi / omega && water.report.problem.empty()) {
        water.step();
        double centre = 0;
        for (const Vec3& x : water.state.position) {
            centre += (x.x - 0.5 * length) / static_cast<double>(water.state.size());
        }
        const auto swing = static_cast<std::size_t>(water.time * omega / pi);
        if (swing < swings.size()) {
            swings[swing] = std::max(swings[swing], std::abs(centre));
        }
    }
    EXPECT_EQ(water.report.problem, "");
    return swings[5] / swings[0];
}

TEST(Roughness, lets_waves_keep_their_height) {
    EXPECT_GT(swing_left(true), 0.96);   // 1.5 % a period
    EXPECT_LT(swing_left(false), 0.92);  // and this is what takes the rest
}

}  // namespace
}  // namespace riprap::fluid::testing
