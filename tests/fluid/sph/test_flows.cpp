// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>

#include "fluid/sph/water.hpp"

namespace riprap::fluid::testing {
namespace {

/// A channel 0 < y < gap along periodic x, between two no-slip walls of which the upper one may move.
Water channel(double gap, int across, double nu, double body_force, double wall_speed, double sound_speed) {
    Water water;
    const double dp = gap / across;
    water.settings = settings_2d(dp, sound_speed);
    water.settings.domain = {{0, -gap, 0}, {10 * dp, 2 * gap, 0}, {true, false, false}, 2};
    water.settings.viscosity = Viscosity::laminar_sps;
    water.settings.kinematic_viscosity = nu;
    water.settings.smagorinsky = 0;
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

TEST(Flows, poiseuille_flow_starts_up_as_the_series_says) {  // E2, at 20 spacings across
    const double gap = 1e-3;
    Water water = channel(gap, 20, 1e-6, 1e-4, 0, 2e-4);
    const std::array<double, 3> time{0.0225, 0.1125, 0.225}, speed{2.232738e-6, 8.249914e-6, 1.109980e-5};
    for (std::size_t k = 0; k < time.size(); ++k) {
        water.run_until(time[k]);
        ASSERT_EQ(water.report.problem, "");
        EXPECT_NEAR(mid_speed(water, gap), speed[k], 0.02 * speed[k]);
    }
}

TEST(Flows, couette_flow_starts_up_as_the_series_says) {  // E3, at 20 spacings across
    const double gap = 1e-3;
    Water water = channel(gap, 20, 1e-6, 0, 1.25e-5, 2e-4);
    const std::array<double, 3> time{0.045, 0.1125, 0.225}, speed{1.194752e-6, 3.628441e-6, 5.386287e-6};
    for (std::size_t k = 0; k < time.size(); ++k) {
        water.run_until(time[k]);
        ASSERT_EQ(water.report.problem, "");
        EXPECT_NEAR(mid_speed(water, gap), speed[k], 0.02 * speed[k]);
    }
}

TEST(Flows, a_drop_strained_in_its_plane_follows_its_ellipse) {  // E12
    const double dp = 0.05;
    Water water;
    water.settings = settings_2d(dp, 1400);
    water.settings.artificial_alpha = 0.02;
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
