// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "fluid/sph/water.hpp"
#include "riprap/fluid/particle/kernel.hpp"
#include "riprap/fluid/sph/acoustic_damping.hpp"

namespace riprap::fluid::testing {
namespace {

constexpr double wave = 2 * std::numbers::pi;  // one wave in a periodic square of 1 m [1/m]

/// Water without walls that swings to and fro in a standing wave of sound, or not at all.
Water periodic_water(double spacing, double speed, double sound_speed, double damping) {
    Water water;
    water.settings = settings_2d(spacing, sound_speed);
    water.settings.domain = {{0, 0, 0}, {1, 1, 0}, {true, true, false}, 2};
    water.settings.viscosity.get<ArtificialViscosity>().alpha = 0;
    water.settings.density_diffusion = 0;
    water.settings.shifting = 0;
    water.settings.acoustic_damping = damping;
    water.settings.is_plain = true;
    for_lattice(spacing, 1, 1, [&](double x, double y) {
        water.add_particle({x, y, 0}, {speed * std::sin(wave * x), 0, 0});
    });
    return water;
}

/// Energy that is left after two periods, over that at the start, and what the ledger misses of the rest.
struct Rest {
    double left, missed;
};
Rest after_two_periods(Water& water) {
    water.step();
    const double start = water.report.kinetic + water.report.internal, closure = water.closure();
    const double from = water.time;
    water.run_until(from + 2 / water.settings.sound_speed);  // a period is 1 m/c
    EXPECT_EQ(water.report.problem, "");
    return {(water.report.kinetic + water.report.internal) / start, (water.closure() - closure) / start};
}

TEST(AcousticDamping, sound_decays_as_bulk_viscosity_says) {
    const double spacing = 1.0 / 40, c = 20;
    for (const double damping : {0.25, 1.0}) {
        Water water = periodic_water(spacing, 0.02, c, damping);
        const Rest rest = after_two_periods(water);
        const double bulk_viscosity = damping * water.inside().corrections_.damped[0] * c *
                                      water.settings.smoothing_length();  // over rho_0 [m^2/s]
        const double expected = -bulk_viscosity * wave * wave * 2 / c;
        EXPECT_NEAR(std::log(rest.left), expected, 0.03 * std::abs(expected)) << damping;
        EXPECT_NEAR(rest.missed, 0, 0.02) << damping;  // heat is that of the velocity before the kick
    }
    Water undamped = periodic_water(spacing, 0.02, c, 0);
    EXPECT_NEAR(after_two_periods(undamped).left, 1, 0.01);
}

TEST(AcousticDamping, what_the_ledger_misses_falls_with_the_time_step) {
    Water coarse = periodic_water(1.0 / 40, 0.02, 20, 1), fine = periodic_water(1.0 / 40, 0.02, 20, 1);
    fine.settings.courant = 0.125 * coarse.settings.courant;
    const double missed = std::abs(after_two_periods(coarse).missed);
    EXPECT_LT(std::abs(after_two_periods(fine).missed), 0.35 * missed);
}

TEST(AcousticDamping, flow_without_divergence_does_not_feel_it) {
    const auto sheared = [](double damping) {
        Water water = periodic_water(1.0 / 40, 0, 20, damping);
        for (std::size_t i = 0; i < water.state.position.size(); ++i) {
            water.state.velocity[i].y = 0.5 * std::sin(wave * water.state.position[i].x);
        }
        water.step();
        const double start = water.report.kinetic;
        water.run_until(0.1);
        EXPECT_EQ(water.report.problem, "");
        return water.report.kinetic / start;
    };
    EXPECT_NEAR(sheared(1), 1, 1e-3);
    EXPECT_NEAR(sheared(1), sheared(0), 1e-3);
}

/// Velocities and forces on walls after a step of water that draws together, in the air or in a box it fills.
struct Feeling {
    std::vector<Vec3> velocity, force;
};
Feeling after_a_step(double side, bool has_box, double damping) {
    constexpr double spacing = 0.1;
    Water water;
    water.settings = settings_2d(spacing, 20);
    water.settings.acoustic_damping = damping;
    for_lattice(spacing, side, side, [&](double x, double y) {
        water.add_particle({x, y, 0}, {-0.1 * (x - 0.5 * side), -0.1 * (y - 0.5 * side), 0});
    });
    if (has_box) {
        for_lattice(spacing, side + 6 * spacing, side + 6 * spacing, [&](double x, double y) {
            const Vec3 place{x - 3 * spacing, y - 3 * spacing, 0};
            if (place.x < 0 || place.x > side || place.y < 0 || place.y > side) {
                water.add_wall_particle(place, true);
            }
        });
    }
    water.step();
    return {water.state.velocity, water.walls.pressure_force};
}

TEST(AcousticDamping, at_a_surface_there_is_none) {
    // all 16 particles see the air, of 49 those in the middle do not
    EXPECT_EQ(after_a_step(0.4, false, 1).velocity, after_a_step(0.4, false, 0).velocity);
    EXPECT_NE(after_a_step(0.7, false, 1).velocity, after_a_step(0.7, false, 0).velocity);
}

TEST(AcousticDamping, neighbours_stand_evenly_inside_a_lattice_and_not_at_its_face) {
    for (const int dimension : {2, 3}) {
        for (const double ratio : {1.2, 1.5, 1.732, 2.0}) {
            Water water;
            water.settings = settings_2d(0.1, 20);
            water.settings.domain = {{-100, -100, -100}, {100, 100, 100}, {}, dimension};
            water.settings.particle_mass = water.settings.rest_density * std::pow(0.1, dimension);
            water.settings.smoothing_ratio = ratio;
            const auto add_layer = [&](double z) {
                for_lattice(0.1, 0.9, 0.9, [&](double x, double y) { water.add_particle({x, y, z}); });
            };
            const int layers = dimension == 3 ? 9 : 1;
            for (int layer = 0; layer < layers; ++layer) {
                add_layer(0.1 * layer);
            }
            water.step();
            const auto share_of = [&](std::size_t i) {
                const Vec3 gradient = water.inside().water_.concentration_gradient.vector(i);
                return even_share(water.settings.smoothing_length() * norm(gradient));
            };
            const auto middle = static_cast<std::size_t>(water.state.size() / 2), face = middle - 4;  // nine in a row
            EXPECT_EQ(share_of(middle), 1) << dimension << ", " << ratio;
            EXPECT_EQ(share_of(face), 0) << dimension << ", " << ratio;
        }
    }
}

TEST(AcousticDamping, is_whole_in_water_whose_particles_stand_a_tenth_of_a_spacing_off_a_lattice) {
    constexpr int across = 24;
    Water water = periodic_water(1.0 / across, 0, 20, 1);
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> off(-0.1 / across, 0.1 / across);
    for (Vec3& x : water.state.position) {
        x += Vec3{off(random), off(random), 0};
    }
    water.step();
    int even = 0;
    const Numbers<3>& gradients = water.inside().water_.concentration_gradient;
    for (std::size_t i = 0; i < gradients.size(); ++i) {
        const Vec3 gradient = gradients.vector(i);
        even += even_share(water.settings.smoothing_length() * norm(gradient)) == 1 ? 1 : 0;
    }
    EXPECT_GT(even, 0.99 * across * across);
}

TEST(AcousticDamping, is_three_quarters_beside_a_hole_of_one_particle) {
    // Without the neighbour at dp, h |grad C| of a lattice is that neighbour's share.
    const SphSettings settings = settings_2d(0.1, 20);
    const double dp = settings.spacing, h = settings.smoothing_length();
    const WendlandC2 kernel(h, 2);
    EXPECT_NEAR(even_share(h * dp * dp * dp * std::abs(kernel.slope_over_r(dp))), 0.75, 0.1);
}

// In the crest of a breaking wave a particle of the surface had, crowded, tr M/D of the inside. A step of damping
// turned its divergence round, -1.8 times as large, step after step, and a twentieth of the energy turned over was
// booked as heat that nothing had lost.
TEST(AcousticDamping, at_a_crowded_surface_there_is_none_either) {
    constexpr double spacing = 0.1;
    const auto crowd = [](double damping) {
        Water water;
        water.settings = settings_2d(spacing, 20);
        water.settings.acoustic_damping = damping;
        for_lattice(0.77 * spacing, 1, 1, [&](double x, double y) {
            water.add_particle({x, y, 0}, {0.1 * (0.5 - x), 0.1 * (0.5 - y), 0});
        });
        water.step();
        return water;
    };
    const Water damped = crowd(1);
    const Corrections& made = damped.inside().corrections_;
    double corrected = 0, damped_most = 0;
    for (std::size_t i = 0; i < damped.state.position.size(); ++i) {
        corrected = std::max(corrected, made.share[i]);
        damped_most = std::max(damped_most, made.damped[i]);
    }
    EXPECT_GT(corrected, 0.3);  // taken for the inside
    EXPECT_EQ(damped_most, 0);
    EXPECT_EQ(damped.state.velocity, crowd(0).state.velocity);
}

TEST(AcousticDamping, walls_feel_it_only_through_the_water) {
    // else a light body would be shaken to pieces: a force in proportion to its velocity and to the water beside it
    const Feeling damped = after_a_step(1.2, true, 1), undamped = after_a_step(1.2, true, 0);
    EXPECT_NE(damped.velocity, undamped.velocity);
    for (std::size_t w = 0; w < damped.force.size(); ++w) {
        EXPECT_LT(norm(damped.force[w] - undamped.force[w]), 1e-6 + 1e-6 * norm(undamped.force[w])) << w;
    }
}

}  // namespace
}  // namespace riprap::fluid::testing
