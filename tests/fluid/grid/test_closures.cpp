// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "fluid/grid/tank.hpp"
#include "riprap/fluid/grid/surface_tension.hpp"

namespace riprap::fluid::grid {
namespace {

TEST(PorousClosure, drop_of_pressure_of_crushed_rock_is_that_worked_out_by_hand) {
    // n = 0.49, D = 15.9 mm, water at 1e-3 Pa s and U = 0.01 m/s, by hand
    PorousMedium rock{0.49, 0.0159, 50, 2.0, 0.34};
    const auto drop = [&] {
        const Resistance r = resistance_of(rock);
        return r.linear * 1e-3 * 0.01 + r.quadratic * 1000 * 0.01 * 0.01;
    };
    EXPECT_NEAR(drop(), 2.2300 + 54.526, 2e-2);
    rock.closure = PorousClosure::van_gent;
    EXPECT_NEAR(drop(), 2.2300 / 0.51 + 54.526, 2e-2);
    rock.closure = PorousClosure::engelund;
    EXPECT_NEAR(drop(), 2.2300 * 0.49 + 54.526, 2e-2);
    rock.closure = PorousClosure::ding;
    rock.keulegan_carpenter = 7.5;
    EXPECT_NEAR(drop(), 2.2300 + 2 * 54.526, 4e-2);
}

TEST(PorousClosure, adds_its_mass_to_water_that_is_pushed_through_stones) {
    constexpr double n = 0.45, rate = 0.2;
    for (const auto& [closure, added] : {std::pair{PorousClosure::ding, 0.5},
                                         {PorousClosure::van_gent, 0.34 * (1 - n) / n},
                                         {PorousClosure::engelund, 0.34 * (1 - n) / n}}) {
        GridSettings settings = tank({1, 0.1, 0.1}, {20, 2, 1});
        settings.has_surface = false;
        settings.gravity = {};
        settings.water.kinematic_viscosity = 0;
        settings.tolerance = 1e-10;
        PorousMedium stones{n, 0.02, 0, 0, 0.5};
        stones.closure = closure;
        settings.porous.push_back({stones, [](const Vec3& x) { return x.x > 0.3 && x.x < 0.7; }});
        settings.side[0].kind = SideKind::inflow;
        settings.side[0].inflow = [](const Vec3&, double time) { return Inflow{{rate * time, 0, 0}, 1}; };
        settings.side[1].kind = SideKind::open;
        GridState state = make_state(
            settings, [](const Vec3&) { return 1.0; }, [](const Vec3&) { return Vec3{}; });
        GridScratch scratch;
        for (int i = 0; i < 10; ++i) {
            advance(settings, state, scratch, 0.01);
        }
        const auto p = [&](int i) { return state.pressure[at(settings.mesh.box.index(i, 0, 0))]; };
        EXPECT_NEAR((p(8) - p(12)) / 0.2, (1 + added) * 1000 / n * rate, 1e-6 * 1000 / n * rate);
    }
}

TEST(GridConstants, a_step_lets_viscosity_spread_over_less_than_explicit_diffusion_bears) {
    // explicit diffusion in D directions is stable up to nu dt/h^2 = 1/(2 D): four fifths of a half of that in two
    GridSettings settings = tank({1, 1, 1}, {8, 8, 1});
    settings.has_surface = false;
    settings.gravity = {};
    settings.water.kinematic_viscosity = 1;
    GridState state = make_state(settings, [](const Vec3&) { return true; });
    GridScratch scratch;
    EXPECT_NEAR(stable_step(settings, state, scratch), 0.1 / 64, 1e-12);
}

TEST(SurfaceTension, curvature_of_a_disc_and_of_a_ball_is_found) {
    for (const int axes : {2, 3}) {
        const double radius = 0.3;
        const int n = axes == 3 ? 24 : 48;
        GridSettings settings = tank({1, 1, axes == 3 ? 1.0 : 0.1}, {n, n, axes == 3 ? n : 1});
        settings.surface_tension = 1;
        const Vec3 centre{0.51, 0.49, axes == 3 ? 0.5 : 0.05};
        GridState state = make_state(settings, [&](const Vec3& x) { return norm(x - centre) < radius; });
        GridScratch scratch;
        prepare(settings, state, scratch);
        reconstruct_surface(settings.mesh, state.fraction, scratch.moved.plane);
        find_curvature(settings, state, scratch);
        double sum = 0, count = 0;
        for_cells(settings.mesh.box, [&](std::int64_t c, int, int, int) {
            if (scratch.stress.curvature[at(c)] != 0) {
                sum += std::pow(scratch.stress.curvature[at(c)] * radius / (axes - 1) - 1, 2);
                count += 1;
            }
        });
        EXPECT_LT(std::sqrt(sum / count), axes == 3 ? 0.1 : 0.01) << axes;
    }
}

TEST(SurfaceTension, a_drop_at_rest_has_laplaces_pressure_and_weak_currents) {
    GridSettings settings = tank({1, 1, 0.1}, {32, 32, 1});
    settings.gravity = {};
    settings.water = {1000, 1e-3};
    settings.air = {1, 1e-3};
    settings.surface_tension = 1;
    const double radius = 0.25;
    GridState state = make_state(settings, [&](const Vec3& x) { return std::hypot(x.x - 0.5, x.y - 0.5) < radius; });
    GridScratch scratch;
    for (int i = 0; i < 100; ++i) {
        advance(settings, state, scratch, stable_step(settings, state, scratch));
    }
    const CellBox& box = settings.mesh.box;
    const double jump = state.pressure[at(box.index(16, 16, 0))] - state.pressure[at(box.index(0, 0, 0))];
    EXPECT_NEAR(jump * radius, 1, 0.01);
    EXPECT_LT(largest_speed(settings, state) * settings.water.density * 1e-3, 5e-3);  // capillary number
}

}  // namespace
}  // namespace riprap::fluid::grid
