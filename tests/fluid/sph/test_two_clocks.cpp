// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "fluid/sph/water.hpp"
#include "riprap/core/fields.hpp"
#include "riprap/fluid/particle/sort.hpp"

namespace riprap::fluid::testing {
namespace {

constexpr double pi = std::numbers::pi, g = 9.81;

std::uint64_t hash_of(const Water& water) { return hash_fields(water.state); }

/// A column of water beside a dry floor in a tank whose walls are rough or smooth.
Water dam_break(int rows, bool is_slippery) {
    Water water;
    const double depth = 0.3, dp = depth / rows;
    water.settings = settings_2d(dp, 10 * std::sqrt(2 * g * depth));
    water.settings.domain = {{-0.5, -0.5, 0}, {2, 2, 0}, {}, 2};
    water.gravity = {0, -g, 0};
    add_tank(water, 0.6, 0.9, is_slippery);
    add_still_water(water, 0.3, depth);
    return water;
}

/// Vortices of Taylor and Green in a box that repeats, places jittered.
Water vortices(int across, double nu) {
    const double dp = 1.0 / across, wave = 2 * pi;
    Water water;
    water.settings = settings_2d(dp, 10);
    water.settings.domain = {{0, 0, 0}, {1, 1, 0}, {true, true, false}, 2};
    water.settings.viscosity.choose<LaminarSps>();
    water.settings.viscosity.get<LaminarSps>().kinematic_viscosity = nu;
    water.settings.viscosity.get<LaminarSps>().smagorinsky = 0;
    std::uint32_t seed = 1;
    const auto jitter = [&] {
        seed = seed * 1664525U + 1013904223U;
        return 0.2 * dp * (static_cast<double>(seed) / 4294967296.0 - 0.5);
    };
    for_lattice(dp, 1, 1, [&](double x, double y) {
        x += jitter();
        y += jitter();
        const double p = -250 * (std::cos(2 * wave * x) + std::cos(2 * wave * y));
        water.add_particle({x, y, 0},
                           {-std::cos(wave * x) * std::sin(wave * y), std::sin(wave * x) * std::cos(wave * y), 0}, p);
    });
    return water;
}

Water still_tank(int rows) {
    Water water;
    const double depth = 0.5;
    water.settings = settings_2d(depth / rows, 10 * std::sqrt(g * depth));
    water.gravity = {0, -g, 0};
    add_tank(water, 0.5, 0.7, true);
    add_still_water(water, 0.5, depth);
    return water;
}

/// A cube of water that falls apart on a plane, periodic sideways.
Water cube_3d() {
    Water water;
    const double dp = 0.05;
    water.settings = settings_2d(dp, 30);
    water.settings.particle_mass = 1000 * dp * dp * dp;
    water.settings.domain = {{0, 0, -1}, {0.6, 0.6, 2}, {true, true, false}, 3};
    water.gravity = {0, 0, -g};
    for (int k = -3; k < 6; ++k) {
        for (int j = 0; j < 12; ++j) {
            for (int i = 0; i < 12; ++i) {
                const Vec3 x{(i + 0.5) * dp, (j + 0.5) * dp, (k + 0.5) * dp};
                if (k < 0) {
                    water.add_wall_particle(x, false);
                } else if (i < 6) {
                    water.add_particle(x, {0.1, 0, 0}, 1000 * g * (0.3 - x.z));
                }
            }
        }
    }
    return water;
}

/// Ten scenes that differ in what the step reads.
std::vector<Water> scenes() {
    std::vector<Water> all;
    all.push_back(dam_break(10, true));
    all.push_back(dam_break(10, false));
    all.push_back(vortices(16, 1e-3));
    all.push_back(still_tank(10));
    all.push_back(cube_3d());
    for (int k = 0; k < 5; ++k) {
        Water water = k % 2 == 0 ? dam_break(8, false) : cube_3d();
        SphSettings& settings = water.settings;
        settings.gradient_correction = k != 0;
        settings.shifting = k == 1 ? 0 : 10;
        settings.is_plain = k == 2;
        settings.density_diffusion = k == 3 ? 0 : 0.1;
        settings.viscosity.get<ArtificialViscosity>().spares_smooth = k == 1 || k == 2;
        if (k == 4) {
            settings.viscosity.choose<LaminarSps>();
        }
        all.push_back(std::move(water));
    }
    return all;
}

TEST(TwoClocks, give_the_bits_of_one_clock_while_walls_may_move) {
    std::vector<Water> one = scenes(), two = scenes();
    for (std::size_t s = 0; s < one.size(); ++s) {
        two[s].settings.sound_steps = 8;
        two[s].are_walls_still = false;
        for (int k = 0; k < 12; ++k) {
            one[s].step();
            two[s].step();
        }
        EXPECT_EQ(hash_of(one[s]), hash_of(two[s])) << s;
        EXPECT_EQ(two[s].renewals, 12);
    }
}

TEST(TwoClocks, give_the_same_bits_after_a_stop_within_a_flow_step) {
    std::vector<Water> whole = scenes(), stopped = scenes();
    for (std::size_t s = 0; s < whole.size(); ++s) {
        whole[s].settings.sound_steps = stopped[s].settings.sound_steps = 5;
        for (int k = 0; k < 14; ++k) {
            whole[s].step();
            stopped[s].scheme = nullptr;  // all that is not State
            stopped[s].step();
            ASSERT_EQ(hash_of(whole[s]), hash_of(stopped[s])) << s << " step " << k;
        }
        EXPECT_LT(whole[s].renewals, 14) << s;
    }
}

/// Story: a sort between flow steps left the weights of the last geometry in the order before it.
TEST(TwoClocks, give_the_same_bits_after_a_stop_behind_a_sort) {
    std::vector<Water> whole = scenes(), stopped = scenes();
    for (std::size_t s = 0; s < whole.size(); ++s) {
        whole[s].settings.sound_steps = stopped[s].settings.sound_steps = 3;
        for (int k = 0; k < 9; ++k) {
            for (Water* water : {&whole[s], &stopped[s]}) {
                if (!water->state.flow.is_under_way()) {
                    sort_by_place(water->state, water->settings.domain, water->settings.spacing);
                }
            }
            stopped[s].scheme = nullptr;
            whole[s].step();
            stopped[s].step();
            ASSERT_EQ(hash_of(whole[s]), hash_of(stopped[s])) << s << " step " << k;
        }
    }
}

/// A wave of sound along x in a box that repeats: what is left of its amplitude after `steps` steps, by the energy.
double left_of_sound(std::int64_t sound_steps, double damping, double diffusion, int steps) {
    Water water;
    const double dp = 1.0 / 40, wave = 2 * pi;
    water.settings = settings_2d(dp, 20);
    water.settings.domain = {{0, 0, 0}, {1, 1, 0}, {true, true, false}, 2};
    water.settings.viscosity.get<ArtificialViscosity>().alpha = 0;
    water.settings.density_diffusion = diffusion;
    water.settings.shifting = 0;
    water.settings.acoustic_damping = damping;
    water.settings.is_plain = true;
    water.settings.sound_steps = sound_steps;
    for_lattice(dp, 1, 1, [&](double x, double y) {
        water.add_particle({x, y, 0}, {1e-4 * std::sin(wave * x), 0, 0});
    });
    water.step();
    const double start = water.report.kinetic + water.report.internal;
    for (int k = 0; k < steps; ++k) {
        water.step();
    }
    EXPECT_EQ(water.renewals, (steps + 1 + sound_steps - 1) / sound_steps);
    return (water.report.kinetic + water.report.internal) / start;
}

TEST(TwoClocks, neither_make_nor_take_sound) {
    EXPECT_NEAR(left_of_sound(1, 0, 0, 160), 1, 1e-5);
    EXPECT_NEAR(left_of_sound(4, 0, 0, 160), 1, 1e-5);
    EXPECT_NEAR(left_of_sound(8, 0, 0, 160), 1, 1e-5);
}

TEST(TwoClocks, damp_sound_as_one_clock_does) {
    const double one = std::log(left_of_sound(1, 1, 0.1, 80));
    EXPECT_LT(one, -0.1);
    EXPECT_NEAR(std::log(left_of_sound(4, 1, 0.1, 80)), one, 0.002 * std::abs(one));
}

/// Root mean square over the particles of what their velocities are off the vortices that decay, over the first speed.
double error_of(const Water& water, double nu) {
    const double wave = 2 * pi, left = std::exp(-2 * nu * wave * wave * water.time);
    double sum = 0;
    for (std::size_t i = 0; i < water.state.position.size(); ++i) {
        const Vec3& x = water.state.position[i];
        const Vec3 exact{-std::cos(wave * x.x) * std::sin(wave * x.y), std::sin(wave * x.x) * std::cos(wave * x.y), 0};
        sum += norm_squared(water.state.velocity[i] - left * exact);
    }
    return std::sqrt(sum / static_cast<double>(water.state.size()));
}

TEST(TwoClocks, let_vortices_decay_as_one_clock_does) {  // Re 100
    const double nu = 0.01;
    Water one = vortices(40, nu), two = vortices(40, nu);
    two.settings.sound_steps = 8;
    one.run_until(0.5);
    two.run_until(0.5);
    ASSERT_EQ(one.report.problem + two.report.problem, "");
    EXPECT_LT(error_of(two, nu), error_of(one, nu) + 0.005);
    EXPECT_NEAR(two.report.kinetic, one.report.kinetic, 0.03 * one.report.kinetic);
}

TEST(TwoClocks, keep_momentum_to_the_last_digit) {
    Water water = vortices(20, 1e-3);
    water.settings.is_plain = true;
    water.settings.sound_steps = 8;
    water.step();
    const Vec3 before = water.report.momentum;
    for (int k = 1; k < 40; ++k) {
        water.step();
    }
    EXPECT_LT(norm(water.report.momentum - before), 1e-12 * 1000);
    EXPECT_LT(water.renewals, 25);
}

TEST(TwoClocks, leave_a_still_tank_as_still_as_one_clock_does) {
    Water one = still_tank(12), two = still_tank(12);
    two.settings.sound_steps = 8;
    one.run_until(2);
    two.run_until(2);
    ASSERT_EQ(one.report.problem + two.report.problem, "");
    EXPECT_LT(two.report.kinetic, 2 * one.report.kinetic + 1e-5);
    EXPECT_LT(two.report.max_speed, 0.01 * std::sqrt(g * 0.5));
}

TEST(TwoClocks, close_the_ledger_of_a_dam_break) {
    double missed[2];
    for (const int n : {1, 8}) {
        Water water = dam_break(20, true);
        water.settings.sound_steps = n;
        water.step();
        const double start = water.closure(), stored = water.stored();
        water.run_until(0.5);
        ASSERT_EQ(water.report.problem, "");
        missed[n == 1 ? 0 : 1] = std::abs(water.closure() - start) / stored;
        RecordProperty("steps" + std::to_string(n), water.renewals);
    }
    EXPECT_LT(missed[1], std::max(1.5 * missed[0], 1e-3));
}

}  // namespace
}  // namespace riprap::fluid::testing
