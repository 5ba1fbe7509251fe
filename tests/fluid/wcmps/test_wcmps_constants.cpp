// SPDX-License-Identifier: Apache-2.0
// Pins each constant of weakly compressible MPS: a test here fails where the constant is halved or doubled
// (tools/mutations.toml).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fluid/wcmps/pool.hpp"
#include "riprap/fluid/particle/pair_sums.hpp"

namespace riprap::fluid::testing {
namespace {

constexpr double wave = 2 * std::numbers::pi;  ///< k of one length in a box of 1 m [1/m]
constexpr int across = 48;

/// Water that repeats every metre, at rest.
Pool box_of_water() {
    Pool pool;
    pool.settings = wcmps_settings(2, 1.0 / across, 10);
    pool.settings.domain = {{0, 0, 0}, {1, 1, 0}, {true, true, false}, 2};
    for (int j = 0; j < across; ++j) {
        for (int i = 0; i < across; ++i) {
            pool.add_particle({(i + 0.5) / across, (j + 0.5) / across, 0});
        }
    }
    return pool;
}

TEST(WcmpsConstants, viscosity_takes_the_power_of_navier_and_stokes_from_a_shear_flow) {
    Pool pool = box_of_water();
    pool.settings.kinematic_viscosity = 0.01;
    pool.settings.shifting = 0;
    for (std::size_t i = 0; i < pool.state.position.size(); ++i) {
        pool.state.velocity[i].x = 0.1 * std::sin(wave * pool.state.position[i].y);
    }
    pool.step(1e-6);
    const double power = 0.5 * 1000 * 0.01 * wave * wave * 0.1 * 0.1;  // rho nu k^2 U^2/2
    EXPECT_NEAR(pool.report.dissipated_viscous / pool.last_dt, power, 0.05 * power);
}

TEST(WcmpsConstants, density_spreads_as_by_the_diffusivity_delta_l_c_courant) {
    // dx/dt = delta CFL c_0 l_0 laplace(x), delta = 0.35 [JandaghianShakibaeinia2020]
    Pool pool = box_of_water();
    constexpr double rise = 1e-5, dt = 1e-4;
    const auto mode = [&](const Vec3& x) { return rise * 1000 * std::sin(wave * x.y); };
    for (std::size_t i = 0; i < pool.state.position.size(); ++i) {
        pool.state.density[i] = 1000 + mode(pool.state.position[i]);
    }
    pool.update_density({}, dt);
    double fallen = 0, first = 0;
    for (std::size_t i = 0; i < pool.state.position.size(); ++i) {
        const double start = mode(pool.state.position[i]);
        fallen += start * (1000 + start - pool.state.density[i]);
        first += start * start;
    }
    const double rate = 0.35 * 0.5 * 10 / across * wave * wave;
    EXPECT_NEAR(fallen / first, rate * dt, 0.05 * rate * dt);
}

/// A standing wave of sound in that water, or in a basin of it with a surface; what is left of its energy after some
/// periods, and what the ledger misses, over that at the start.
struct Sound {
    double left, missed;
};
Sound sound_after(double damping, double periods) {
    Pool pool = box_of_water();
    pool.settings.acoustic_damping = damping;
    pool.settings.density_diffusion = 0;
    pool.settings.shifting = 0;
    for (std::size_t i = 0; i < pool.state.position.size(); ++i) {
        pool.state.velocity[i].x = 0.01 * std::sin(wave * pool.state.position[i].x);
    }
    pool.step();
    const auto energy = [&] { return pool.report.kinetic + pool.report.internal; };
    const double start = energy(), closure = pool.closure(), from = pool.time;
    pool.run_until(from + periods / pool.settings.sound_speed);  // a period is 1 m/c
    EXPECT_EQ(pool.report.problem, "");
    return {energy() / start, (pool.closure() - closure) / start};
}

TEST(WcmpsConstants, sound_decays_as_by_a_bulk_viscosity_of_half_the_support_radius_times_the_sound_speed) {
    for (const double damping : {0.25, 1.0}) {
        const double bulk_viscosity = damping * 1.55 / across * 10;  // a h c, over rho_0 [m^2/s]
        const Sound sound = sound_after(damping, 2);
        const double expected = -bulk_viscosity * wave * wave * 2 / 10;
        EXPECT_NEAR(std::log(sound.left), expected, 0.05 * std::abs(expected)) << damping;
        EXPECT_NEAR(sound.missed, 0, 2e-3) << damping;
    }
    EXPECT_NEAR(sound_after(0, 2).left, 1, 0.01);
}

TEST(WcmpsConstants, sound_is_damped_from_the_third_row_under_a_surface_on_and_beside_walls_that_stand_still) {
    const auto damped = [](bool has_surface, bool wall_moves) {
        Pool pool;
        pool.settings = wcmps_settings(2, 0.02, 20);
        pool.settings.domain = {{0, -1, 0}, {0.4, 1, 0}, {true, false, false}, 2};
        for (int i = 0; i < 20; ++i) {
            for (int j = has_surface ? 0 : -4; j < 12; ++j) {
                const Vec3 x{(i + 0.5) * 0.02, (j + 0.5) * 0.02, 0};
                if (j < 0) {
                    pool.add_wall_particle(x, true);
                    pool.walls.velocity.back().x = wall_moves ? 0.1 : 0;
                } else {
                    pool.add_particle(x, {0, -x.y, 0}, 0);
                }
            }
        }
        pool.update_density({}, 1e-9);
        const WcmpsContinuity& found = pool.scheme->continuity_;
        std::vector<double> shares;
        for (std::size_t row = 0; row < 6; ++row) {
            shares.push_back(found.damped[row] / (-pool.settings.lattice().first_order() * found.rate[row]));
        }
        return shares;
    };
    for (const std::vector<double>& bare : {damped(true, false), damped(false, true)}) {
        EXPECT_EQ(bare[0], 0);
        EXPECT_EQ(bare[1], 0);
        EXPECT_NEAR(bare[2], 1, 1e-3);
    }
    EXPECT_NEAR(damped(false, false)[0], 1, 1e-3);
    EXPECT_NEAR(damped(false, false)[1], 1, 1e-3);
}

TEST(WcmpsConstants, in_a_step_acceleration_moves_a_particle_a_thirty_second_of_a_spacing_and_viscosity_an_eighth) {
    Pool pool = box_of_water();
    const double l = pool.settings.spacing;
    pool.state.max_acceleration = 1e6;  // far above what sound allows
    FluidTimeStep step = pool.limit();
    EXPECT_EQ(step.limit, step.force);
    EXPECT_NEAR(0.5 * 1e6 * step.limit * step.limit, l / 32, 1e-9 * l);
    pool.settings.kinematic_viscosity = 1000;
    step = pool.limit();
    EXPECT_EQ(step.limit, step.viscous);
    EXPECT_NEAR(1000 * step.limit, l * l / 8, 1e-9 * l * l);
}

/// From i to j, by the shorter way around the box.
Vec3 apart(const Vec3& i, const Vec3& j) {
    const Vec3 d = i - j;
    return {d.x - std::round(d.x), d.y - std::round(d.y), 0};
}

/// u: sqrt(sum |v_i - v_j|^2 W/n_0), pair by pair.
std::vector<double> stir_of(const Pool& pool) {
    const MpsWeight weight = pool.settings.weight();
    const ParticleState& state = pool.state;
    std::vector<double> stir(state.position.size());
    for (std::size_t i = 0; i < stir.size(); ++i) {
        for (std::size_t j = 0; j < stir.size(); ++j) {
            const double r2 = norm_squared(apart(state.position[i], state.position[j]));
            stir[i] += i == j ? 0 : norm_squared(state.velocity[i] - state.velocity[j]) * weight.value(r2);
        }
        stir[i] = std::sqrt(stir[i] / pool.settings.lattice().number_density);
    }
    return stir;
}

TEST(WcmpsConstants, density_returns_to_that_of_places_as_fast_as_neighbours_pass_each_other) {
    // on the lattice C = 1, and a shear flow neither closes nor opens anything: dx/dt = -u/l_0 (x - 1)
    Pool pool = box_of_water();
    constexpr double rise = 1e-4, dt = 1e-4;
    for (std::size_t i = 0; i < pool.state.position.size(); ++i) {
        pool.state.velocity[i].x = std::sin(wave * pool.state.position[i].y);
        pool.state.density[i] = 1000 * (1 + rise);
    }
    const std::vector<double> stir = stir_of(pool);
    pool.update_density({}, dt);
    double fallen = 0, expected = 0;
    for (std::size_t i = 0; i < stir.size(); ++i) {
        fallen += 1 + rise - pool.state.density[i] / 1000;
        expected += dt * stir[i] / pool.settings.spacing * rise;
    }
    EXPECT_NEAR(fallen, expected, 0.02 * expected);
}

TEST(WcmpsConstants, a_shift_goes_by_the_speed_at_which_neighbours_pass_each_other) {
    // -2 l_0 dt u grad C, grad C = -D/n_0 sum (C_i + C_j) W d/r^2 [Mellado2021, eqs. 5.33, 5.36]
    Pool pool = box_of_water();
    const double dp = pool.settings.spacing;
    for (std::size_t i = 0; i < pool.state.position.size(); ++i) {
        pool.state.velocity[i].x = std::sin(wave * pool.state.position[i].y);
        pool.state.position[i].y += 0.02 * dp * std::sin(4 * wave * pool.state.position[i].y);
    }
    const std::vector<Vec3> before = pool.state.position;
    const std::vector<double> stir = stir_of(pool);
    pool.step();
    const double factor = 2 * dp * pool.last_dt;
    ASSERT_LT(factor * *std::max_element(stir.begin(), stir.end()), 0.5 / pool.settings.lattice().wave_stiffness);
    const MpsWeight weight = pool.settings.weight();
    const auto for_near = [&](std::size_t i, const auto& f) {
        for (std::size_t j = 0; j < before.size(); ++j) {
            const Vec3 d = apart(before[i], before[j]);
            if (norm_squared(d) < 10 * dp * dp) {  // beyond the support of 3.1 spacings
                f(j, d, weight.value(norm_squared(d)));
            }
        }
    };
    const double number_density = pool.settings.lattice().number_density;
    std::vector<double> crowding(before.size());
    for (std::size_t i = 0; i < before.size(); ++i) {
        for_near(i, [&](std::size_t, const Vec3&, double w) { crowding[i] += w / number_density; });
    }
    double product = 0, square = 0;
    for (std::size_t k = 0; k < before.size(); k += 7) {
        const auto i = static_cast<std::size_t>(pool.state.id[k]);
        Vec3 gradient{};
        for_near(i, [&](std::size_t j, const Vec3& d, double w) {
            gradient += (-(crowding[i] + crowding[j]) * weight.over_square(norm_squared(d), w)) * d;
        });
        const Vec3 expected = (-factor * stir[i] * pool.settings.lattice().first_order()) * gradient;
        product += dot(2.0 * pool.state.shift[k], expected);
        square += dot(expected, expected);
    }
    EXPECT_GT(square, 0);
    EXPECT_NEAR(product / square, 1, 0.02);
}

TEST(WcmpsConstants, no_shift_is_longer_than_a_tenth_of_a_spacing) {
    Pool pool = box_of_water();
    pool.settings.shifting = 10;
    pool.settings.weight_law = MpsWeightLaw::reciprocal;  // whose gradients are steep enough
    const double dp = pool.settings.spacing;
    for (std::size_t i = 0; i < pool.state.velocity.size(); ++i) {
        pool.state.velocity[i].x = (i / across) % 2 == 0 ? 1 : -1;  // rows pass each other
    }
    pool.state.position[pool.state.position.size() / 2].x += 0.45 * dp;
    pool.step();
    EXPECT_NEAR(pool.report.max_shift, 0.1 * dp, 1e-6 * dp);
}

TEST(WcmpsConstants, two_particles_of_the_surface_that_meet_part_with_half_of_their_approach) {
    Pool pool;
    pool.settings = wcmps_settings(2, 0.02, 20);
    pool.add_particle({0, 0, 0}, {1, 0.3, 0});
    pool.add_particle({0.016, 0, 0}, {-0.5, 0.1, 0});
    OpenWcmps& scheme = pool.verbs();
    scheme.surface_.classes = {SurfaceClass::surface, SurfaceClass::near};
    const auto place = [&] {
        scheme.lists_.place(reach_of(pool.settings), pool.state.blocks(), pool.state.position, {});
    };
    place();
    ASSERT_TRUE(scheme.find_collisions(pool.state));
    const std::vector<Vec3>& change = scheme.collisions_.change;
    EXPECT_NEAR(1 + change[0].x, -0.5 + change[1].x - 0.5 * 1.5, 1e-5);
    EXPECT_NEAR(change[0].x + change[1].x, 0, 1e-6);
    pool.state.position[1].x = 0.0185;  // farther than 0.9 spacings
    place();
    EXPECT_FALSE(scheme.find_collisions(pool.state));
}

/// Rows of water 40 wide, the highest at y = 0, `squeezed` spacings apart.
Pool rows_of_water(int rows, double squeezed = 1) {
    Pool pool;
    pool.settings = wcmps_settings(2, 0.02, 20);
    for (int j = 0; j < rows; ++j) {
        for (int i = -20; i <= 20; ++i) {
            pool.add_particle(0.02 * squeezed * Vec3{static_cast<double>(i), static_cast<double>(-j), 0});
        }
    }
    return pool;
}

double kinetic_of(const Pool& pool) {
    double energy = 0;
    for (const Vec3& v : pool.state.velocity) {
        energy += 0.5 * pool.settings.particle_mass * norm_squared(v);
    }
    return energy;
}

TEST(WcmpsConstants, a_particle_that_falls_on_the_surface_loses_in_collisions_what_is_booked) {
    Pool pool = rows_of_water(12);
    pool.add_particle(0.02 * Vec3{0.5, 0.7, 0}, {0.2, -1, 0});
    const double before = kinetic_of(pool);
    pool.step(1e-9);  // no force has time to act
    const double lost = before - kinetic_of(pool);
    EXPECT_GT(lost, 0.1 * before);
    EXPECT_NEAR(pool.report.earlier_collisions, lost, 1e-3 * lost);
}

/// The particle nearest to a place given in spacings.
SurfaceClass class_at(Pool& pool, double x, double y) {
    pool.step(1e-9);
    const auto classes = pool.scheme->surface_classes();
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < pool.state.position.size(); ++i) {
        const Vec3 wanted{0.02 * x, 0.02 * y, 0};
        nearest = norm(pool.state.position[i] - wanted) < norm(pool.state.position[nearest] - wanted) ? i : nearest;
    }
    return classes[nearest];
}

void take_away(Pool& pool, double x, double y) {
    for (Vec3& place : pool.state.position) {
        if (norm(place - Vec3{0.02 * x, 0.02 * y, 0}) < 0.002) {
            place = {5, 5, 0};
        }
    }
}

TEST(WcmpsConstants, one_row_of_particles_is_splash_and_two_have_a_surface) {
    // C is 0.24 in a single row and 0.52 in two
    Pool one = rows_of_water(1), two = rows_of_water(2);
    EXPECT_EQ(class_at(one, 0, 0), SurfaceClass::splash);
    EXPECT_EQ(class_at(two, 0, 0), SurfaceClass::surface);
}

TEST(WcmpsConstants, a_face_of_water_is_its_surface_unless_it_is_squeezed) {
    // C is 0.64 in the highest row and 1.0 where rows are 0.8 spacings apart: such a face holds its pressure
    Pool even = rows_of_water(10), squeezed = rows_of_water(10, 0.8);
    EXPECT_EQ(class_at(even, 0, 0), SurfaceClass::surface);
    EXPECT_NE(class_at(squeezed, 0, 0), SurfaceClass::surface);
}

TEST(WcmpsConstants, a_particle_under_one_that_stands_out_is_of_the_surface_and_one_beside_a_hole_is_not) {
    // 18 and 21 of 28 neighbours
    Pool standing = rows_of_water(10), hole = rows_of_water(10);
    standing.add_particle({0, 0.02, 0});
    take_away(hole, 1, 0);
    EXPECT_EQ(class_at(standing, 0, 0), SurfaceClass::surface);
    EXPECT_NE(class_at(hole, 0, -1), SurfaceClass::surface);
}

}  // namespace
}  // namespace riprap::fluid::testing
