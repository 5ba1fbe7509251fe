// SPDX-License-Identifier: Apache-2.0
// Pins each constant of the turbulence model (tools/mutations.toml).
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "fluid/grid/tank.hpp"
#include "riprap/fluid/grid/boundary.hpp"
#include "riprap/fluid/grid/k_epsilon.hpp"

namespace riprap::fluid::grid {
namespace {

/// A box of water without gravity, k and epsilon the same everywhere.
struct Turbulent {
    GridSettings settings;
    GridState state;
    GridScratch scratch;

    Turbulent(const Vec3& size, const std::array<int, 3>& cells, double k, double e) : settings(tank(size, cells)) {
        settings.has_surface = false;
        settings.gravity = {};
        settings.turbulence = Turbulence::k_epsilon;
        start(k, e);
    }
    void start(double k, double e) {
        state = make_state(settings, [this](const Vec3& x) { return !settings.has_surface || x.y < 0.5; });
        state.turbulent_energy.assign(state.turbulent_energy.size(), k);
        state.dissipation_rate.assign(state.dissipation_rate.size(), e);
    }
    std::size_t cell(int i, int j) const { return at(settings.mesh.box.index(i, j, 0)); }
    double k(int i, int j) const { return state.turbulent_energy[cell(i, j)]; }
    double e(int i, int j) const { return state.dissipation_rate[cell(i, j)]; }
    void flow(int axis, const std::function<double(int, int)>& speed) {
        for_faces(settings.mesh.box, axis,
                  [&](std::int64_t f, int i, int j, int) { state.velocity[at(axis)][at(f)] = speed(i, j); });
    }
};

TEST(Turbulence, without_shear_k_decays_as_the_power_of_time_that_the_model_has) {
    GridSettings settings = tank({1, 1, 1}, {4, 4, 1});
    settings.has_surface = false;
    settings.gravity = {};
    settings.turbulence = Turbulence::k_epsilon;
    GridState state = make_state(settings, [](const Vec3&) { return true; });
    const double k0 = 1e-3, e0 = 1e-3;
    state.turbulent_energy.assign(state.turbulent_energy.size(), k0);
    state.dissipation_rate.assign(state.dissipation_rate.size(), e0);
    GridScratch scratch;
    for (int i = 0; i < 20000; ++i) {
        advance(settings, state, scratch, 5e-4);
    }
    const double exact = k0 * std::pow(1 + 0.92 * e0 * 10 / k0, -1 / 0.92);
    EXPECT_NEAR(state.turbulent_energy[at(settings.mesh.box.index(1, 2, 0))] / exact, 1, 1e-3);
}

TEST(Turbulence, of_a_shear_grows_and_dies_at_the_rates_of_the_model) {
    // dk/dt = P - e, de/dt = (1.44 P - 1.92 e) e/k, P = 0.09 k^2/e S^2, in the middle of a long box
    GridSettings settings = tank({16, 1, 1}, {64, 8, 1});
    settings.has_surface = false;
    settings.gravity = {};
    settings.turbulence = Turbulence::k_epsilon;
    GridState state = make_state(settings, [](const Vec3&) { return true; });
    const double k0 = 1e-3, e0 = 1e-3, shear = 2, dt = 1e-4;
    state.turbulent_energy.assign(state.turbulent_energy.size(), k0);
    state.dissipation_rate.assign(state.dissipation_rate.size(), e0);
    const CellBox& box = settings.mesh.box;
    for_faces(box, 0, [&](std::int64_t f, int i, int j, int) {
        state.velocity[0][at(f)] = i > 0 && i < box.cells[0] ? shear * ((j + 0.5) / 8 - 0.5) : 0;
    });
    GridScratch scratch;
    advance(settings, state, scratch, dt);
    const auto middle = at(box.index(32, 4, 0));
    const double production = 0.09 * k0 * k0 / e0 * shear * shear;
    EXPECT_NEAR((state.turbulent_energy[middle] - k0) / dt, production - e0, 0.02 * production);
    EXPECT_NEAR((state.dissipation_rate[middle] - e0) / dt, (1.44 * production - 1.92 * e0) * e0 / k0,
                0.02 * 1.44 * production * e0 / k0);
}

TEST(GridConstants, shear_along_a_wall_is_laminar_below_where_the_log_law_crosses_it_and_that_of_the_log_law_above) {
    // u/u_tau = y+ below y+ = 11.53, ln(9.8 y+)/0.41 above, which is 5.57 + 2.44 ln y+ [Nikuradse]
    const double nu = 1e-6, distance = 0.01;
    const auto wall_units = [&](double speed) { return shear_velocity(speed, distance, nu) * distance / nu; };
    for (const double y : {2.0, 10.0, 11.5}) {
        EXPECT_NEAR(wall_units(y * y * nu / distance), y, 1e-9);
    }
    for (const double y : {11.6, 30.0, 300.0, 3000.0}) {
        EXPECT_NEAR(wall_units(y * nu / distance * (5.57 + 2.44 * std::log(y))), y, 0.01 * y);
    }
}

TEST(Turbulence, spreads_by_the_eddy_viscosity_over_its_prandtl_numbers) {
    // a mode of k dies at nu_t q^2/1.0, one of epsilon at nu_t q^2/1.3 and by its own sink
    const double k0 = 10, e0 = 1, dt = 1e-6, q = M_PI, nu = 0.09 * k0 * k0 / e0;
    const auto mode = [&](int i) { return 1e-4 * std::cos(q * (i + 0.5) / 32); };
    Turbulent of_k({1, 0.25, 1}, {32, 8, 1}, k0, e0), of_e = of_k;
    for_cells(of_k.settings.mesh.box, [&](std::int64_t c, int i, int, int) {
        of_k.state.turbulent_energy[at(c)] *= 1 + mode(i);
        of_e.state.dissipation_rate[at(c)] *= 1 + mode(i);
    });
    advance(of_k.settings, of_k.state, of_k.scratch, dt);
    advance(of_e.settings, of_e.state, of_e.scratch, dt);
    const auto rate_of = [&](double low, double high) { return (1 - (low - high) / (2 * mode(0))) / dt; };
    EXPECT_NEAR(rate_of(of_k.k(0, 4) / k0, of_k.k(31, 4) / k0), nu * q * q, 0.01 * nu * q * q);
    EXPECT_NEAR(rate_of(of_e.e(0, 4) / e0, of_e.e(31, 4) / e0), nu * q * q / 1.3 + 2 * 1.92 * e0 / k0,
                0.01 * nu * q * q);
}

TEST(Turbulence, of_the_stable_kind_is_bounded_under_strain) {
    // nu_t = 0.6 k/(sqrt(3) S) under a fast shear [Durbin1996]; C_mu k^2/(2 e) where the strain is 30 times the
    // rotation, 0.05 1.92/1.44 30 = 2 [Larsen2018]
    Turbulent fast({1, 1, 1}, {8, 8, 1}, 1, 1), wave = fast;
    fast.settings.turbulence = wave.settings.turbulence = Turbulence::k_epsilon_stable;
    prepare(fast.settings, fast.state, fast.scratch);
    prepare(wave.settings, wave.state, wave.scratch);
    const double shear = 1000;
    fast.flow(0, [&](int, int j) { return shear * j / 8.0; });
    find_eddy_viscosity(fast.settings, fast.state, fast.scratch);
    EXPECT_NEAR(fast.scratch.stress.eddy_viscosity[fast.cell(4, 4)], 0.6 / (std::sqrt(3.0) * shear), 1e-6);
    const double ratio = std::sqrt(30.0), along = 1e-3, across = along * (ratio - 1) / (ratio + 1);
    wave.flow(0, [&](int, int j) { return along * j / 8.0; });
    wave.flow(1, [&](int i, int) { return across * i / 8.0; });
    find_eddy_viscosity(wave.settings, wave.state, wave.scratch);
    EXPECT_NEAR(wave.scratch.stress.eddy_viscosity[wave.cell(4, 4)], 0.09 / 2, 1e-4);
}

TEST(Turbulence, of_a_stream_through_stones_grows_as_the_stones_say) {
    // k_inf = 3.7 (1 - n)/sqrt(n) U^2, e_inf = 39 (1 - n)^(5/2)/n U^3/D
    Turbulent stream({1, 1, 1}, {16, 8, 1}, 1e-3, 1e-3);
    const double n = 0.5, grain = 0.02, speed = 0.1, dt = 1e-6;
    stream.settings.porous = {{{n, grain}, [](const Vec3&) { return true; }}};
    stream.settings.side[0].kind = SideKind::inflow;
    stream.settings.side[0].inflow = [&](const Vec3&, double) { return Inflow{{speed, 0, 0}}; };
    stream.settings.side[1].kind = SideKind::open;
    stream.start(1e-3, 1e-3);
    stream.flow(0, [&](int, int) { return speed; });
    advance(stream.settings, stream.state, stream.scratch, dt);
    const double k_inf = 3.7 * (1 - n) / std::sqrt(n) * speed * speed;
    const double e_inf = 39 * std::pow(1 - n, 2.5) / n * std::pow(speed, 3) / grain;
    EXPECT_NEAR((stream.k(8, 4) - 1e-3) / dt, e_inf - 1e-3, 0.02 * e_inf);
    EXPECT_NEAR((stream.e(8, 4) - 1e-3) / dt, 1.92 * e_inf * e_inf / k_inf, 0.02 * 1.92 * e_inf * e_inf / k_inf);
}

TEST(Turbulence, dies_in_water_under_air_by_what_it_lifts) {
    // -(nu_t/0.85) g d rho/dy/rho, half of it in the cell below the surface
    Turbulent still({1, 1, 1}, {8, 8, 1}, 1, 1);
    still.settings.has_surface = true;
    still.settings.gravity = {0, -9.81, 0};
    still.start(1, 1);
    const double dt = 1e-6, h = 1.0 / 8;
    advance(still.settings, still.state, still.scratch, dt);
    const double sink = 0.09 / 0.85 * 9.81 * (1 - 1.2e-3) / (2 * h);
    EXPECT_NEAR((still.k(4, 3) - 1) / dt, -1 - sink, 0.02 * sink);
}

}  // namespace
}  // namespace riprap::fluid::grid
