// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "riprap/fluid/open/sponge.hpp"
#include "riprap/fluid/sph/sph_settings.hpp"

namespace riprap::fluid {
namespace {

SphSettings settings() {
    SphSettings s;
    s.spacing = 0.1;
    s.particle_mass = 10;
    s.domain = {{-5, -5, 0}, {5, 5, 0}, {}, 2};
    return s;
}

const Sponge sponge{.low = {0, -1, 0}, .high = {2, 1, 0}, .axis = 0, .is_towards_high = true, .rate = 8};

/// A particle at x with velocity v.
ParticleState particle(const Vec3& x, const Vec3& v) {
    ParticleState state;
    state.position = {x};
    state.velocity = {v};
    state.density = {1000};
    state.id = {0};
    return state;
}

/// One step of the kick: force over mass.
void kick(ParticleState& state, const SparseVectors& force, double dt) { state.velocity[0] += dt / 10 * force[0]; }

TEST(Sponge, two_that_overlap_never_turn_water_back) {
    ParticleState state = particle({1, 0, 0}, {3, -1, 0});
    SparseVectors force(1);
    SpongeWork work;
    push_sponges(std::vector{sponge, sponge}, settings(), state, 100.0, force, work);
    kick(state, force, 100.0);
    EXPECT_NEAR(state.velocity[0].x, 0, 1e-12);
    EXPECT_NEAR(state.velocity[0].y, 0, 1e-12);
}

TEST(Sponge, slows_water_by_the_exact_decay_and_leaves_it_alone_outside) {
    for (const double dt : {0.01, 100.0}) {  // no rate is unstable
        ParticleState state = particle({1, 0, 0}, {3, -1, 0});
        SparseVectors force(1);
        SpongeWork work;
        push_sponges(std::vector{sponge}, settings(), state, dt, force, work);
        kick(state, force, dt);
        const double left = std::exp(-8 * 0.25 * dt);  // half way through
        EXPECT_NEAR(state.velocity[0].x, 3 * left, 1e-12);
        EXPECT_NEAR(state.velocity[0].y, -left, 1e-12);
        EXPECT_NEAR(absorbed_energy(state, dt, work), 0.5 * 10 * 10 * (1 - left * left), 1e-9);
    }
    for (const Vec3& x : {Vec3{-0.1, 0, 0}, Vec3{2.1, 0, 0}, Vec3{1, 1.1, 0}}) {
        SparseVectors force(1);
        force.add(0, {1, 2, 0});
        SpongeWork work;
        push_sponges(std::vector{sponge}, settings(), particle(x, {3, 0, 0}), 0.01, force, work);
        EXPECT_EQ(force[0], (Vec3{1, 2, 0}));
    }
}

TEST(Sponge, grows_towards_the_side_that_is_named_and_spares_a_current) {
    Sponge other = sponge;
    other.is_towards_high = false;
    other.velocity = {1, 0, 0};
    SparseVectors force(1);
    SpongeWork work;
    push_sponges(std::vector{other}, settings(), particle({0.5, 0, 0}, {1, 0, 0}), 0.01, force, work);
    EXPECT_EQ(norm(force[0]), 0);
    force.reset(1);
    push_sponges(std::vector{other}, settings(), particle({0.5, 0, 0}, {2, 0, 0}), 1e-6, force, work);
    EXPECT_NEAR(force[0].x, -10 * 8 * 0.75 * 0.75, 1e-3);
}

TEST(Sponge, the_automatic_rate_leaves_a_hundredth_of_a_long_wave) {
    const double length = 4, celerity = std::sqrt(9.81 * 0.5);
    EXPECT_NEAR(std::exp(-sponge_rate(9.81, 0.5, length) * length / (3 * celerity)), 0.01, 1e-12);
}

}  // namespace
}  // namespace riprap::fluid
