// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <numbers>

#include "fluid/sph/water.hpp"

namespace riprap::fluid::testing {
namespace {

constexpr double pi = std::numbers::pi;

/// A channel 0 < y < gap along periodic x, between two no-slip walls of which the upper one may move.
Water channel(double gap, int across, double nu, double body_force, double wall_speed, double sound_speed) {
    Water water;
    const double dp = gap / across;
    water.settings = settings_2d(dp, sound_speed);
    water.settings.domain = {{0, -gap, 0}, {10 * dp, 2 * gap, 0}, {true, false, false}, 2};
    water.settings.viscosity.choose<LaminarSps>();
    water.settings.viscosity.get<LaminarSps>().kinematic_viscosity = nu;
    water.settings.viscosity.get<LaminarSps>().smagorinsky = 0;
    water.gravity = {body_force, 0, 0};
    for_lattice(dp, 10 * dp, gap, [&](double x, double y) { water.add_particle({x, y, 0}); });
    for_lattice(dp, 10 * dp, 4 * dp, [&](double x, double y) {
        water.add_wall_particle({x, -y, 0}, false);
        water.add_wall_particle({x, gap + y, 0}, false, {wall_speed, 0, 0});
    });
    return water;
}

/// Mean of v_x over the particles nearest to mid-channel
double mid_speed(const Water& water, double gap) {
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < water.state.position.size(); ++i) {
        if (std::abs(water.state.position[i].y - 0.5 * gap) < 0.6 * water.settings.spacing) {
            sum += water.state.velocity[i].x;
            count += 1;
        }
    }
    return sum / count;
}

TEST(Flows, poiseuille_flow_starts_up_as_the_series_says) {  // at 20 spacings across
    const double gap = 1e-3;
    Water water = channel(gap, 20, 1e-6, 1e-4, 0, 2e-4);
    const std::array<double, 3> time{0.0225, 0.1125, 0.225}, speed{2.232738e-6, 8.249914e-6, 1.109980e-5};
    for (std::size_t k = 0; k < time.size(); ++k) {
        water.run_until(time[k]);
        ASSERT_EQ(water.report.problem, "");
        EXPECT_NEAR(mid_speed(water, gap), speed[k], 0.02 * speed[k]);
    }
}

TEST(Flows, couette_flow_starts_up_as_the_series_says) {  // at 20 spacings across
    const double gap = 1e-3;
    Water water = channel(gap, 20, 1e-6, 0, 1.25e-5, 2e-4);
    const std::array<double, 3> time{0.045, 0.1125, 0.225}, speed{1.194752e-6, 3.628441e-6, 5.386287e-6};
    for (std::size_t k = 0; k < time.size(); ++k) {
        water.run_until(time[k]);
        ASSERT_EQ(water.report.problem, "");
        EXPECT_NEAR(mid_speed(water, gap), speed[k], 0.02 * speed[k]);
    }
}

TEST(Flows, taylor_green_vortices_decay_at_the_viscous_rate) {  // Re = 100, at 40 spacings
    const int across = 40;
    const double dp = 1.0 / across, nu = 0.01;
    Water water;
    water.settings = settings_2d(dp, 10);
    water.settings.domain = {{0, 0, 0}, {1, 1, 0}, {true, true, false}, 2};
    water.settings.viscosity.choose<LaminarSps>();
    water.settings.viscosity.get<LaminarSps>().kinematic_viscosity = nu;
    water.settings.viscosity.get<LaminarSps>().smagorinsky = 0;
    // A perfect lattice stretches along the stagnation lines without any gradient of concentration that shifting could
    // act on, until it tears; places a tenth of a spacing off take that symmetry away.
    std::uint32_t seed = 1;
    const auto jitter = [&] {
        seed = seed * 1664525u + 1013904223u;
        return 0.2 * dp * (static_cast<double>(seed) / 4294967296.0 - 0.5);
    };
    for_lattice(dp, 1, 1, [&](double x, double y) {
        const double wave = 2 * pi;
        x += jitter();
        y += jitter();
        water.add_particle({x, y, 0},
                           {-std::cos(wave * x) * std::sin(wave * y), std::sin(wave * x) * std::cos(wave * y), 0},
                           -250 * (std::cos(2 * wave * x) + std::cos(2 * wave * y)));
    });
    water.step();
    const double start = water.report.kinetic, from = water.time;
    water.run_until(0.5);
    ASSERT_EQ(water.report.problem, "");
    const double speed = std::sqrt(water.report.kinetic / start);
    const double expected = std::exp(-8 * pi * pi * nu * (water.time - from));
    EXPECT_NEAR(speed, expected, 0.03 * expected);
}

TEST(Flows, a_standing_wave_swings_with_the_period_of_the_dispersion_relation) {
    const double length = 1, depth = 0.5, amplitude = 0.02, g = 9.81, dp = depth / 40;
    const double k = pi / length, omega = std::sqrt(g * k * std::tanh(k * depth));
    Water water;
    water.settings = settings_2d(dp, 10 * std::sqrt(g * depth));
    water.gravity = {0, -g, 0};
    add_tank(water, length, 2 * depth, true);
    for_lattice(dp, length, depth, [&](double x, double y) {
        const double speed = amplitude * omega / std::sinh(k * depth);
        water.add_particle({x, y, 0},
                           {-speed * std::cosh(k * y) * std::sin(k * x), speed * std::sinh(k * y) * std::cos(k * x), 0},
                           1000 * g * (depth - y));
    });
    // the centre of the water goes to the left and is back after half a period
    const auto centre = [&] {
        double sum = 0;
        for (const Vec3& x : water.state.position) {
            sum += x.x / static_cast<double>(water.state.size());
        }
        return sum - 0.5 * length;
    };
    double before = 0, now = 0, farthest = 0;
    while (!(before < 0 && now >= 0) && water.time < 1 && water.report.problem.empty()) {
        water.step();
        before = now;
        now = centre();
        farthest = std::min(farthest, now);
    }
    ASSERT_EQ(water.report.problem, "");
    const double half = water.time - water.last_dt * now / (now - before);
    // an error of the spacing: twice as coarse it is 0.8 %; without corrected gradients -1.5 % at this spacing
    EXPECT_NEAR(half, pi / omega, 0.005 * pi / omega);
    EXPECT_NEAR(-farthest, 2 * amplitude * length / (pi * pi * depth),
                0.02 * 2 * amplitude * length / (pi * pi * depth));
}

TEST(Flows, a_drop_strained_in_its_plane_follows_its_ellipse) {
    const double dp = 0.05;
    Water water;
    water.settings = settings_2d(dp, 1400);
    water.settings.viscosity.get<ArtificialViscosity>().alpha = 0.02;
    for_lattice(dp, 2, 2, [&](double x, double y) {
        const double u = x - 1, v = y - 1, rate = 100;
        if (u * u + v * v < 1) {
            // p = rho/2 (A^2 - a'') r^2-like start: incompressible pressure of the strained circle [Monaghan1994]
            water.add_particle({u, v, 0}, {-rate * u, rate * v, 0}, 0.5 * 1000 * rate * rate * (1 - u * u - v * v));
        }
    });
    water.run_until(0.0076);
    ASSERT_EQ(water.report.problem, "");
    double top = 0;
    for (const Vec3& x : water.state.position) {
        top = std::max(top, x.y);
    }
    // the outermost particles stand half a spacing behind the surface, stretched with it
    EXPECT_NEAR(top + 0.5 * dp, 1.944517, 0.02 * 1.944517);
}

}  // namespace
}  // namespace riprap::fluid::testing
