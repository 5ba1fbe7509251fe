// SPDX-License-Identifier: Apache-2.0
// The physics that fixes the constants of the guard behind boundary particles (tools/mutations.toml).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/coupling/particle_walls/penalty_walls.hpp"
#include "riprap/fluid/sph/sph_settings.hpp"

namespace riprap::coupling {
namespace {

fluid::SphSettings water() {
    fluid::SphSettings settings;
    settings.spacing = 0.05;
    settings.sound_speed = 30;
    settings.particle_mass = 1000 * 0.05 * 0.05;
    settings.domain = {{-10, -10, 0}, {10, 10, 0}, {}, 2};
    return settings;
}

/// A particle that meets a face at `speed`, pushed by the guard alone; y is its distance from the face.
struct Meeting {
    double deepest{std::numeric_limits<double>::infinity()}, leaves{0};
};

Meeting meet(double speed) {
    const fluid::SphSettings settings = water();
    const double dt = 0.05 * settings.spacing / settings.sound_speed, m = settings.particle_mass;
    const PenaltySettings guard = guard_settings(settings, dt);
    Meeting meeting;
    double y = 1.5 * guard.reach, v = -speed;
    for (int i = 0; i < 100000 && y < 2 * guard.reach; ++i) {
        y += 0.5 * dt * v;
        double force = 0;
        if (y < guard.reach) {
            force = std::max(0.0, guard.stiffness * (guard.reach - y) - guard.damping * std::min(0.0, v));
            force = std::clamp(force, 0.0, std::max(0.0, guard.hardest * (guard.fastest_return - v)));
        }
        v += dt * force / m;
        y += 0.5 * dt * v;
        meeting.deepest = std::min(meeting.deepest, y);
    }
    meeting.leaves = v;
    return meeting;
}

TEST(Guard, begins_where_particles_under_pressure_do_not_come) {
    // Particles stand half a spacing off the wall; at the start water begins a quarter of a spacing off.
    const double reach = guard_settings(water(), 1e-4).reach / 0.05;
    EXPECT_LT(reach, 0.25);
    EXPECT_GT(reach, 0.15);
}

TEST(Guard, stops_a_particle_at_an_eighth_of_the_speed_of_sound_before_the_face_and_one_at_a_third_not) {
    // 1.4 dp v/c_0 behind the reach of 0.2 dp: the face is met at v = c_0/7.
    EXPECT_GT(meet(30.0 / 8).deepest, 0);
    EXPECT_LT(meet(30.0 / 3).deepest, 0);
}

TEST(Guard, throws_nothing_back_faster_than_a_twentieth_of_the_speed_of_sound) {
    // Twice that is a pressure of 0.1 rho_0 c_0^2 when it meets the next row, ten times what the model's 1 % allows.
    EXPECT_LT(meet(4).leaves, 0.06 * 30);
    EXPECT_GT(meet(4).leaves, 0.04 * 30);
    EXPECT_NEAR(guard_settings(water(), 1e-4).hardest * 1e-4, water().particle_mass, 1e-12);
}

TEST(Guard, is_stable_at_one_face_at_the_acoustic_step) {
    // omega dt < 2 with omega^2 = k/m at the longest step, 0.8 h/c_0 = 1.2 dp/c_0.
    const fluid::SphSettings settings = water();
    const double dt = 0.8 * settings.smoothing_length() / settings.sound_speed;
    const PenaltySettings guard = guard_settings(settings, dt);
    const double omega = std::sqrt(guard.stiffness / settings.particle_mass);
    // explicit dashpot: (omega dt)^2/4 + zeta omega dt <= 1 would be 0.18 + 0.42
    const double zeta = guard.damping / (2 * omega * settings.particle_mass);
    EXPECT_NEAR(zeta, 0.5, 1e-9);
    EXPECT_LT(0.25 * omega * omega * dt * dt + zeta * omega * dt, 1);
    EXPECT_GT(0.25 * omega * omega * dt * dt + zeta * omega * dt, 0.5);
}

TEST(PenaltyWalls, at_rest_under_their_column_a_particle_stands_a_tenth_of_a_spacing_inside_the_reach) {
    // rho_0 g H dp^(dim-1) over k_s, with c_0 = 10 sqrt(g H)
    const fluid::SphSettings settings = water();
    const PenaltySettings walls = penalty_settings(settings, 0);
    const double pressure = 1000 * settings.sound_speed * settings.sound_speed / 100;
    EXPECT_NEAR(pressure * settings.spacing / walls.stiffness, 0.1 * settings.spacing, 1e-9);
    EXPECT_NEAR(walls.reach, 0.5 * settings.spacing, 1e-12);
}

}  // namespace
}  // namespace riprap::coupling
