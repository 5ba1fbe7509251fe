// SPDX-License-Identifier: Apache-2.0
// The physics that fixes each constant of the water: a test here fails where the constant is halved or doubled
// (tools/mutations.toml).
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "fluid/sph/water.hpp"
#include "riprap/fluid/particle/kernel.hpp"
#include "riprap/fluid/sph/gradient_correction.hpp"
#include "riprap/fluid/sph/shifting.hpp"
#include "riprap/fluid/sph/tearing.hpp"

namespace riprap::fluid::testing {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double wave = 2 * pi;  ///< k of one length in a box of 1 m [1/m]
constexpr int across = 48;

/// Water that repeats every metre, at rest.
Water box_of_water() {
    Water water;
    water.settings = settings_2d(1.0 / across, 10);
    water.settings.domain = {{0, 0, 0}, {1, 1, 0}, {true, true, false}, 2};
    water.settings.state_equation = StateEquation::linear;
    water.settings.shifting = 0;
    for_lattice(1.0 / across, 1, 1, [&](double x, double y) { water.add_particle({x, y, 0}); });
    return water;
}

constexpr double shear_speed = 0.1;  ///< U [m/s]

/// u = U sin(k y).
Water sheared() {
    Water water = box_of_water();
    for (std::size_t i = 0; i < water.state.position.size(); ++i) {
        water.state.velocity[i].x = shear_speed * std::sin(wave * water.state.position[i].y);
    }
    return water;
}

/// Power that viscosity nu takes from it: rho nu k^2 U^2/2 per square metre [W/m].
double power_of(double nu) { return 0.5 * 1000 * nu * wave * wave * shear_speed * shear_speed; }

double heat_of_one_step(Water& water) {
    water.step();
    EXPECT_EQ(water.report.problem, "");
    return water.report.dissipated_viscous / water.last_dt;
}

TEST(Constants, artificial_viscosity_takes_the_power_of_its_kinematic_viscosity_from_a_shear_flow) {
    // alpha h c/(2 (D + 2)) [Monaghan2005], half of it as pairs that part feel none; alpha = 0.02. On a square lattice
    // an eighth is missing.
    Water water = sheared();
    const double nu = 0.5 * 0.02 * water.settings.smoothing_length() * 10 / 8;
    EXPECT_NEAR(heat_of_one_step(water), power_of(nu), 0.15 * power_of(nu));
}

TEST(Constants, laminar_viscosity_takes_the_power_of_navier_and_stokes) {
    Water water = sheared();
    water.settings.viscosity.choose<LaminarSps>();
    water.settings.viscosity.get<LaminarSps>().kinematic_viscosity = 0.01;
    water.settings.viscosity.get<LaminarSps>().smagorinsky = 0;
    EXPECT_NEAR(heat_of_one_step(water), power_of(0.01), 0.03 * power_of(0.01));
}

TEST(Constants, eddies_below_the_spacing_take_the_power_of_smagorinsky) {
    // integral of rho (C_s dp)^2 |S|^3, |S| = k U |cos ky|, whose cube has the mean 4/(3 pi)
    Water water = sheared();
    water.settings.viscosity.choose<LaminarSps>();
    water.settings.viscosity.get<LaminarSps>().kinematic_viscosity = 0;
    const double mixing = 0.12 / across;  // [Gotoh2001]
    const double power = 1000 * mixing * mixing * std::pow(wave * shear_speed, 3) * 4 / (3 * pi);
    EXPECT_NEAR(heat_of_one_step(water), power, 0.1 * power);
}

TEST(Constants, kinetic_energy_that_viscosity_takes_is_booked_to_a_percent_of_itself) {
    Water water = sheared();
    water.settings.viscosity.choose<LaminarSps>();
    water.settings.viscosity.get<LaminarSps>().kinematic_viscosity = 0.01;
    water.settings.viscosity.get<LaminarSps>().smagorinsky = 0;
    water.step();
    const double before = water.closure(), booked = water.dissipated_viscous;
    water.run_until(0.3);
    ASSERT_EQ(water.report.problem, "");
    const double heat = water.dissipated_viscous - booked;
    EXPECT_GT(heat, 0.2 * before);
    EXPECT_NEAR(water.closure(), before, 0.01 * heat);
}

TEST(Constants, density_spreads_as_by_the_diffusivity_delta_h_c) {
    // d rho/dt = delta h c_0 laplace(rho), delta = 0.1 [Fourtakas2019]
    Water water = box_of_water();
    constexpr double rise = 1e-3, dt = 1e-3;
    const auto mode = [&](double y) { return rise * 1000 * std::sin(wave * y); };
    for (std::size_t i = 0; i < water.state.position.size(); ++i) {
        water.state.density[i] = 1000 + mode(water.state.position[i].y);
    }
    water.update_density({}, dt);
    const double rate = 0.1 * water.settings.smoothing_length() * 10 * wave * wave;
    double fallen = 0, first = 0;
    for (std::size_t i = 0; i < water.state.position.size(); ++i) {
        const double start = mode(water.state.position[i].y);
        fallen += start * (1000 + start - water.state.density[i]);
        first += start * start;
    }
    EXPECT_NEAR(fallen / first, rate * dt, 0.05 * rate * dt);
}

TEST(Constants, in_a_step_acceleration_moves_a_particle_a_thirty_second_of_h) {
    // dt = 0.25 sqrt(h/a) [Monaghan1992]: half a dt^2 is h/32
    Water water = box_of_water();
    water.state.max_acceleration = 1e6;  // far above what sound allows
    const FluidTimeStep step = water.limit();
    EXPECT_EQ(step.limit, step.force);
    EXPECT_NEAR(0.5 * 1e6 * step.force * step.force, water.settings.smoothing_length() / 32,
                1e-9 * water.settings.smoothing_length());
}

TEST(Constants, in_a_step_viscosity_spreads_over_an_eighth_of_h_squared) {
    // explicit diffusion by pairs is stable up to nu dt/h^2 of a quarter [Morris1997], taken twice as safe
    Water water = box_of_water();
    water.settings.viscosity.choose<LaminarSps>();
    water.settings.viscosity.get<LaminarSps>().kinematic_viscosity = 100;
    const double h = water.settings.smoothing_length();
    EXPECT_NEAR(100 * water.limit().limit, h * h / 8, 1e-9 * h * h);
}

TEST(Constants, shifting_evens_out_disorder_of_twenty_smoothing_lengths_in_a_unit_of_strain) {
    // Displacements xi = e sin(q y) make a gradient of concentration q^2 xi and go as exp(-A (q h)^2 S t): A = 10 takes
    // one e-fold for a wave of 2 pi sqrt(10) h = 20 h. Longer ones the flow itself must keep even.
    constexpr int columns = 60;
    Water water;
    water.settings = settings_2d(1.0 / columns, 10);
    water.settings.domain = {{0, 0, 0}, {1, 1, 0}, {true, true, false}, 2};
    const double length = 20 * water.settings.smoothing_length(), q = 2 * pi / length, displaced = 1e-3 / columns;
    ASSERT_NEAR(length, 0.5, 1e-12);
    for_lattice(1.0 / columns, 1, 1, [&](double x, double y) {
        water.add_particle({x, y + displaced * std::sin(q * y), 0}, {0.1 * std::sin(wave * y), 0, 0});
    });
    std::vector<double> before;
    for (const Vec3& x : water.state.position) {
        before.push_back(x.y);
    }
    water.step();
    double evened = 0, expected = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
        const double xi = displaced * std::sin(q * before[i]);
        const double strain = 0.1 * wave * std::abs(std::cos(wave * before[i])) * water.last_dt;
        evened += xi * (before[i] - water.state.position[i].y);
        expected += xi * xi * strain;
    }
    EXPECT_NEAR(evened / expected, 1, 0.25);  // the kernel smooths a fifth of it away
}

TEST(Constants, a_step_of_shifting_changes_pressure_by_at_most_a_fifth_of_rho_v_squared) {
    // v = c_0/10, the fastest water that c_0 is chosen for: dp = c_0^2 d rho
    const SphSettings settings = settings_2d(0.01, 10);
    const Vec3 crowded{0.5 / settings.smoothing_length(), 0, 0};  // half of what a surface has
    const Vec3 shift = shift_of_particle(settings.shifting, settings.smoothing_length(), crowded, {}, 0, 100, 1e-3);
    const double taken = 10 * 10 * 1000 * dilution_by_shift(shift, crowded, 0);
    EXPECT_NEAR(taken, 0.2 * 1000 * 1 * 1, 1e-9);
    // and disorder of a twentieth of that is evened out at the rate of the law
    const Vec3 even = 0.05 * crowded;
    const double h = settings.smoothing_length();
    EXPECT_NEAR(shift_of_particle(settings.shifting, settings.smoothing_length(), even, {}, 0, 100, 1e-3).x,
                -10 * h * h * 100 * 1e-3 * even.x, 1e-15);
}

/// A column of water 0.5 m wide and 1 m high in the corner of a tank 2 m wide.
Water falling_column() {
    Water water;
    water.settings = settings_2d(0.05, 10 * std::sqrt(9.81));
    water.gravity = {0, -9.81, 0};
    add_tank(water, 2, 3, true);
    add_still_water(water, 0.5, 1);
    return water;
}

TEST(Constants, work_of_walls_that_no_body_sees_is_booked_to_a_tenth_of_itself) {
    Water water = falling_column();
    water.step();
    const double before = water.closure(), booked = water.wall_exchange;
    water.run_until(0.7);  // it has hit the far wall
    ASSERT_EQ(water.report.problem, "");
    EXPECT_LT(std::abs(water.closure() - before), 0.05 * std::abs(water.wall_exchange - booked));
}

/// Divergence of position tr M/D of a particle at the origin, with walls and without.
struct Stand {
    double moments{0}, alone{0};
};

constexpr double ratio = 1.5;  // h/dp

/// -V F d.d/D of a neighbour in two dimensions, dp = 1
double moment_of(double x, double y) {
    const WendlandC2 kernel(ratio, 2);
    const double r2 = x * x + y * y, r = std::sqrt(r2);
    return r < 2 * ratio ? -kernel.slope_over_r(r) * r2 / 2 : 0;
}

/// tr M/D of a particle at the origin of a lattice that fills y <= 0, of more rows above, and of what else there is.
double moments_of_rows(int rows_above, const std::vector<Vec3>& more = {}) {
    double sum = 0;
    for (int row = -4; row <= rows_above; ++row) {
        for (int k = -5; k <= 5; ++k) {
            sum += moment_of(k, row);
        }
    }
    for (const Vec3& x : more) {
        sum += moment_of(x.x, x.y);
    }
    return sum;
}

TEST(Constants, shifting_takes_the_first_row_for_the_surface_and_a_row_half_covered_for_half_of_it) {
    const auto bareness = [](double moments) { return bareness_of_particle(2, 2 * moments); };
    EXPECT_EQ(bareness(moments_of_rows(0)), 1);
    EXPECT_EQ(bareness(moments_of_rows(1)), 0);
    // every other place of a row above, over the particle and beside it
    const double over = moments_of_rows(0, {{-2, 1, 0}, {0, 1, 0}, {2, 1, 0}});
    const double beside = moments_of_rows(0, {{-1, 1, 0}, {1, 1, 0}});
    EXPECT_NEAR(0.5 * (bareness(over) + bareness(beside)), 0.5, 0.15);
}

TEST(Constants, shifting_ends_beside_a_bare_particle_and_falls_to_a_quarter_beside_one_that_is_a_quarter_bare) {
    const SphSettings settings = settings_2d(0.01, 10);
    const double h = settings.smoothing_length();
    const WendlandC2 kernel(h, 2);
    const auto share = [&](double bareness) {  // along the surface, the particle a smoothing length away
        const Vec3 along{0.01 / h, 0, 0};
        const Vec3 towards{0, bareness * 1e-4 * std::abs(kernel.slope_over_r(h)) * h, 0};
        return shift_of_particle(settings.shifting, settings.smoothing_length(), along, towards, 0, 10, 1e-3).x /
               shift_of_particle(settings.shifting, settings.smoothing_length(), along, {}, 0, 10, 1e-3).x;
    };
    EXPECT_EQ(share(1), 0);
    EXPECT_NEAR(share(0.25), 0.25, 0.15);
}

/// tr M/D of a particle of a lattice whose rows beyond it stand nearer by `squeezed` spacings, on one side or on two.
double moments_of_squeezed(double squeezed, bool is_corner) {
    double sum = 0;
    for (int row = -5; row <= 5; ++row) {
        for (int k = -5; k <= 5; ++k) {
            sum += moment_of(is_corner && k < 0 ? k + squeezed : k, row < 0 ? row + squeezed : row);
        }
    }
    return sum;
}

TEST(Constants, gradients_are_corrected_inside_and_neither_at_a_surface_nor_where_water_is_crowded_into_a_corner) {
    EXPECT_EQ(interior_share(moments_of_rows(1)), 0);
    EXPECT_EQ(interior_share(0.94), 0);  // the second row of a cubic lattice
    EXPECT_GT(interior_share(moments_of_rows(2)), 0.9);
    EXPECT_GT(interior_share(0.98), 0.5);  // the least that flowing water has inside
    // pressed a fifth of a spacing against a wall, it is inside; into a corner, half; three tenths, crowded
    EXPECT_GT(interior_share(moments_of_squeezed(0.2, false)), 0.9);
    EXPECT_NEAR(interior_share(moments_of_squeezed(0.2, true)), 0.5, 0.2);
    EXPECT_EQ(interior_share(moments_of_squeezed(0.3, true)), 0);
}

/// Wall particles above y = `face`, `x_off` along it from the particle.
double moments_of_wall(double face, double x_off = 0) {
    double sum = 0;
    for (int row = 0; row < 4; ++row) {
        for (int k = -5; k <= 5; ++k) {
            sum += moment_of(k + x_off, face + row + 0.5);
        }
    }
    return sum;
}

/// Alone in the middle of a gap; the mean over places along the wall lattice.
Stand in_gap(double gap) {
    Stand stand;
    for (const double off : {0.0, 0.25, 0.5, 0.75}) {
        stand.moments += 2 * moments_of_wall(0.5 * gap, off) / 4;
    }
    return stand;
}

double caught_in_gap(double gap) { return caught_share(0, in_gap(gap).moments); }

TEST(Constants, a_particle_alone_is_caught_in_a_gap_narrower_than_itself_and_free_in_one_and_a_half) {
    EXPECT_EQ(caught_in_gap(0.4), 1);
    EXPECT_GT(caught_in_gap(0.8), 0.7);
    EXPECT_GT(caught_in_gap(1.0), 0.4);  // half a layer of a face away on both sides
    EXPECT_LT(caught_in_gap(1.0), 0.8);
    EXPECT_EQ(caught_in_gap(1.5), 0);
    EXPECT_EQ(caught_share(0, moments_of_wall(0.2)), 0);  // at one wall
}

TEST(Constants, a_particle_with_a_row_of_others_is_not_caught) {
    const double row = 2 * moment_of(2, 0);  // neighbours two spacings away to both sides
    EXPECT_EQ(caught_share(row, in_gap(1.0).moments + row), 0);
    const double far = 2 * moment_of(2.4, 0);  // and almost out of reach
    EXPECT_GT(caught_share(far, in_gap(0.4).moments), 0.2);
    EXPECT_LT(caught_share(far, in_gap(0.4).moments), 0.8);
}

TEST(Constants, walls_that_shut_a_particle_in_from_all_sides_outweigh_a_few_neighbours) {
    // Where walls alone fill the kernel a sixth of it in the water is still no way out; half of it is.
    EXPECT_NEAR(caught_share(0.15, 1.0), 0.4, 0.15);
    EXPECT_EQ(caught_share(0.3, 1.0), 0);
    EXPECT_NEAR(caught_share(0.075, 0.975), 0.5, 0.2);
    EXPECT_EQ(caught_share(0.06, 0.94), 0);  // not shut in: a row of others counts
}

TEST(Constants, the_pressure_of_a_caught_particle_goes_at_the_speed_of_sound) {
    // out of a particle of one spacing by its free sides: a share 1 - 1/e in the time dp/c_0
    EXPECT_NEAR(density_by_escape(1, 1010, 1000, escape_in_step(1)), -10 * (1 - std::exp(-1)), 1e-9);
    EXPECT_EQ(density_by_escape(0.5, 1010, 1000, 1), 0);
}

TEST(Constants, water_at_a_surface_bears_a_hundredth_of_stretch_as_weakly_compressible_water_varies_by_that) {
    EXPECT_EQ(density_by_tearing(1, false, 991, 1000), 0);
    EXPECT_NEAR(density_by_tearing(1, false, 985, 1000), 5, 1e-9);
}

}  // namespace
}  // namespace riprap::fluid::testing
