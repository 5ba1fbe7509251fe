// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "fluid/grid/tank.hpp"
#include "riprap/core/fields.hpp"

namespace riprap::fluid::grid {
namespace {

/// Carries a disc or ball of water with a given velocity and returns the fractions before and after.
struct Carried {
    GridSettings settings;
    GridState state;
    std::vector<double> before;
    double lowest{0}, highest{0};  ///< fraction ever below 0 or above 1
    double volume_error{0};        ///< relative

    template <class Velocity>
    Carried(const Vec3& size, const std::array<int, 3>& cells, VofScheme scheme,
            const std::function<bool(const Vec3&)>& is_water, double end, int steps, const Velocity& velocity)
        : settings(tank(size, cells)), state(make_state(settings, is_water)) {
        settings.vof = scheme;
        before = state.fraction;
        GridScratch scratch;
        prepare(settings, state, scratch);
        const double dt = end / steps, volume = water_volume(settings, state, scratch);
        for (int step = 0; step < steps; ++step) {
            for (int a = 0; a < settings.mesh.box.axes; ++a) {
                for_faces(settings.mesh.box, a, [&](std::int64_t f, int i, int j, int k) {
                    const std::array<int, 3> index{i, j, k};
                    Vec3 x{};
                    for (int b = 0; b < 3; ++b) {
                        x[b] = b == a ? settings.mesh.edge[at(b)][at(index[at(b)])]
                                      : settings.mesh.centre(b, index[at(b)]);
                    }
                    const bool on_rim = index[at(a)] == 0 || index[at(a)] == settings.mesh.box.cells[at(a)];
                    scratch.start.carrier[at(a)][at(f)] = on_rim ? 0 : velocity(x, settings.mesh, a, (step + 0.5) * dt);
                });
            }
            move_water(settings, state, scratch, dt);
            state.step += 1;
            for_cells(settings.mesh.box, [&](std::int64_t c, int, int, int) {
                lowest = std::min(lowest, state.fraction[at(c)]);
                highest = std::max(highest, state.fraction[at(c)] - 1);
            });
        }
        volume_error = water_volume(settings, state, scratch) / volume - 1;
    }
    /// Sum of |change of the fraction| over the water [-].
    double change() const {
        double sum = 0, all = 0;
        for_cells(settings.mesh.box, [&](std::int64_t c, int, int, int) {
            sum += std::abs(state.fraction[at(c)] - before[at(c)]);
            all += before[at(c)];
        });
        return sum / all;
    }
};

/// Velocity through a face from a stream function, so that no cell gains or loses volume.
template <class Psi>
auto from_stream(const Psi& psi) {
    return [psi](const Vec3& x, const Mesh& mesh, int a, double t) {
        const double h = mesh.h(a == 0 ? 1 : 0, 0);
        return a == 0 ? (psi(x.x, x.y + 0.5 * h, t) - psi(x.x, x.y - 0.5 * h, t)) / h
                      : -(psi(x.x + 0.5 * h, x.y, t) - psi(x.x - 0.5 * h, x.y, t)) / h;
    };
}

double rotation(double x, double y, double) { return -M_PI * (std::pow(x - 0.5, 2) + std::pow(y - 0.5, 2)); }

bool slotted_disc(const Vec3& x) {
    return std::hypot(x.x - 0.5, x.y - 0.75) < 0.15 && !(std::abs(x.x - 0.5) < 0.025 && x.y < 0.85);
}

bool disc(const Vec3& x) { return std::hypot(x.x - 0.5, x.y - 0.75) < 0.15; }

TEST(MoveWater, a_slotted_disc_keeps_its_shape_over_a_turn_its_bounds_and_its_volume) {
    const Carried run({1, 1, 0.01}, {64, 64, 1}, VofScheme::plic, slotted_disc, 1, 640, from_stream(rotation));
    EXPECT_LT(run.change(), 0.08);  // the slot is three cells wide; at 100 cells in validation/grid
    EXPECT_GE(run.lowest, 0);
    EXPECT_LE(run.highest, 0);
    EXPECT_NEAR(run.volume_error, 0, 1e-12);
}

TEST(MoveWater, the_compressive_scheme_keeps_bounds_and_volume_and_is_less_sharp) {
    const Carried sharp({1, 1, 0.01}, {32, 32, 1}, VofScheme::plic, disc, 1, 320, from_stream(rotation));
    const Carried run({1, 1, 0.01}, {32, 32, 1}, VofScheme::compressive, disc, 1, 320, from_stream(rotation));
    EXPECT_GT(run.change(), sharp.change());
    EXPECT_LT(run.change(), 0.25);
    EXPECT_GE(run.lowest, 0);
    EXPECT_LE(run.highest, 0);
    EXPECT_NEAR(run.volume_error, 0, 1e-12);
}

TEST(MoveWater, a_disc_in_a_vortex_that_turns_back_returns_at_second_order) {
    std::array<double, 2> errors{};
    for (const int doubling : {0, 1}) {
        const int n = 24 << doubling;
        const Carried run(
            {1, 1, 0.01}, {n, n, 1}, VofScheme::plic, disc, 2, 10 * n, from_stream([](double x, double y, double t) {
                return -std::pow(std::sin(M_PI * x) * std::sin(M_PI * y), 2) / M_PI * std::cos(M_PI * t / 2);
            }));
        errors[at(doubling)] = run.change();
    }
    EXPECT_GT(std::log2(errors[0] / errors[1]), 1.5);
}

TEST(MoveWater, a_ball_carried_along_a_diagonal_of_space_keeps_bounds_and_volume) {
    const Carried run(
        {1, 1, 1}, {20, 20, 20}, VofScheme::plic,
        [](const Vec3& x) {
            return norm(x - Vec3{0.35, 0.35, 0.35}) < 0.2;
        },
        0.3, 45, [](const Vec3&, const Mesh&, int, double) { return 1.0; });
    EXPECT_GE(run.lowest, 0);
    EXPECT_LE(run.highest, 0);
    EXPECT_NEAR(run.volume_error, 0, 1e-12);
    EXPECT_NEAR(run.state.fraction[at(run.settings.mesh.box.index(13, 13, 13))], 1, 1e-9);
    EXPECT_EQ(run.state.fraction[at(run.settings.mesh.box.index(5, 5, 5))], 0);
}

TEST(MoveWater, a_surface_on_faces_of_cells_takes_what_the_books_miss) {
    GridSettings settings = tank({1, 1, 0.1}, {20, 20, 1});
    GridState state = make_state(settings, [](const Vec3& x) { return x.y < 0.5; });
    GridScratch scratch;
    prepare(settings, state, scratch);
    for (const double share : {1 + 1e-6, 1 - 1e-6}) {
        state.water.held *= share;
        settle_volume(settings, state, scratch);
        EXPECT_NEAR(water_volume(settings, state, scratch) / state.water.held, 1, 1e-12);
        for_cells(settings.mesh.box, [&](std::int64_t c, int, int, int) {
            EXPECT_GE(state.fraction[at(c)], 0);
            EXPECT_LE(state.fraction[at(c)], 1);
        });
    }
}

}  // namespace
}  // namespace riprap::fluid::grid
