// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/law/mindlin.hpp"

#include <gtest/gtest.h>

#include "riprap/contact/law/closest_pair.hpp"
#include "riprap/contact/law/contact_table.hpp"
#include "riprap/contact/law/rolling.hpp"
#include "riprap/contact/law/tanh_friction.hpp"

namespace riprap::contact {
namespace {

using Spring = TangentialSpring<double>;

TEST(Mindlin, AStickingSpringLoadsWithItsDisplacement) {
    Spring spring;
    const auto response = advance_spring<double>(spring, {0.1, 0, 0}, 1e5, 0, 1000, {0.5, 0.5}, 1e-3);
    EXPECT_NEAR(spring.force.x, -10, 1e-12);
    EXPECT_NEAR(response.energy, 100 / 2e5, 1e-15);
    EXPECT_NEAR(response.friction_loss, 0, 1e-15);
}

TEST(Mindlin, StaticFrictionHoldsUntilItsLimitAndKineticFrictionFollows) {
    Spring spring;
    const Friction<double> friction{0.5, 0.3};
    double most = 0;
    Vec3 last{};
    for (int step = 0; step < 200; ++step) {
        last = advance_spring<double>(spring, {0.1, 0, 0}, 1e5, 0, 1000, friction, 1e-3).force;
        most = std::max(most, -last.x);
    }
    EXPECT_NEAR(most, 500, 10.1);
    EXPECT_NEAR(last.x, -300, 1e-9);
    // Turning round, the spring sticks again and may be loaded up to the static limit.
    double back = 0;
    for (int step = 0; step < 85; ++step) {
        back = advance_spring<double>(spring, {-0.1, 0, 0}, 1e5, 0, 1000, friction, 1e-3).force.x;
        back = std::max(back, spring.force.x);
        if (spring.stiffness < 0) {
            break;
        }
    }
    EXPECT_GT(back, 290);
}

TEST(Mindlin, WorkOnTheSpringIsStoredOrLostWhilePressureChanges) {
    Spring spring;
    double work = 0, loss = 0, stored = 0;
    const double dt = 1e-3;
    for (int step = 0; step < 400; ++step) {
        const Vec3 v{0.02 * std::cos(0.03 * step), 0.015 * std::sin(0.05 * step), 0};
        const double pressure = 1000 * (1 + 0.5 * std::sin(0.2 * step)), stiffness = 2e6 * std::cbrt(pressure / 1000);
        const Vec3 before =
            spring.force * (spring.stiffness == 0 ? 1.0 : std::min(1.0, stiffness / std::abs(spring.stiffness)));
        const auto response = advance_spring<double>(spring, v, stiffness, 0, pressure, {0.4, 0.4}, dt);
        work -= 0.5 * dt * dot(v, before + spring.force);
        loss += response.friction_loss;
        EXPECT_GE(response.friction_loss, -1e-12);
        stored = response.energy;
    }
    EXPECT_GT(loss, 0.1 * work);
    EXPECT_NEAR(stored + loss, work, 1e-12 * work);
}

TEST(Mindlin, ATurningNormalCarriesTheSpringWithItsLengthAndWholeTurnsBringItBack) {
    const Vec3 start{3, 0, 4};
    Vec3 force = start, normal{0, 1, 0};
    const int count = 360;
    for (int k = 1; k <= count; ++k) {
        const double angle = 2 * M_PI * k / count;
        const Vec3 next{std::sin(angle), std::cos(angle), 0};
        force = turn_with_normal(force, normal, next, 0.0);
        normal = next;
        EXPECT_NEAR(norm(force), 5, 1e-12);
        EXPECT_NEAR(dot(force, normal), 0, 1e-12);
    }
    EXPECT_NEAR(norm(force - start), 0, 1e-11);
}

TEST(Mindlin, ASpinAboutTheNormalTurnsTheSpringWithoutChangingItsLength) {
    const Vec3 n{0, 0, 1};
    Vec3 force{2, 0, 0};
    for (int k = 0; k < 1000; ++k) {
        force = turn_with_normal(force, n, n, M_PI / 2 / 1000);
    }
    EXPECT_NEAR(norm(force), 2, 1e-12);
    EXPECT_NEAR(force.y, 2, 1e-5);
}

TEST(Mindlin, EightContactsSideBySideHaveTheBitsOfOne) {
    using Eight = Wide<double, 8>;
    TangentialSpring<Eight> wide;
    Eight push, speed;
    std::array<Spring, 8> one;
    for (int lane = 0; lane < 8; ++lane) {
        push.set(lane, 300.0 * lane);
        speed.set(lane, 0.3 - 0.07 * lane);
    }
    for (int step = 0; step < 30; ++step) {
        const auto response = advance_spring<Eight>(wide, {speed, Eight(0.01), Eight(0.0)}, Eight(1e5), Eight(20.0),
                                                    push, {Eight(0.5), Eight(0.4)}, Eight(1e-3));
        for (int lane = 0; lane < 8; ++lane) {
            const auto plain = advance_spring<double>(one[static_cast<std::size_t>(lane)], {speed[lane], 0.01, 0}, 1e5,
                                                      20, push[lane], {0.5, 0.4}, 1e-3);
            EXPECT_EQ(plain.force.x, response.force.x[lane]);
            EXPECT_EQ(plain.friction_loss, response.friction_loss[lane]);
            EXPECT_EQ(plain.dashpot_power, response.dashpot_power[lane]);
        }
    }
}

TEST(TanhFriction, ABlockOnASlopeCreepsAtTheSpeedOfTheFormula) {
    // tan(slope) = 0.3, mu = 0.412: v = atanh(0.3/0.412)/8 = 0.1158 m/s.
    const double v = std::atanh(0.3 / 0.412) / 8;
    EXPECT_NEAR(v, 0.116, 5e-4);
    const auto response = tanh_friction<double>({v, 0, 0}, 1e12, 0, 1000, 0.412, 0.125, 1e-3);
    EXPECT_NEAR(response.force.x, -300, 1e-9);
    EXPECT_NEAR(tanh_friction<double>({v, 0, 0}, 10, 5, 1000, 0.412, 0.125, 1e-3).force.x, -(10 * 1e-3 + 5) * v, 1e-12);
}

TEST(TanhFriction, TheDashpotThatStopsASphereHeadOnStopsItsSlidingToo) {
    // A force F at the surface of a solid sphere moves its contact point by F/m (1 + m R^2/I) = 7/2 F/m: 2/7 of the
    // normal dashpot, and of the normal spring, slow sliding as the whole slows the approach.
    constexpr double mass = 2, dt = 1e-3, v = 1e-3;
    SlidingContact<double> c{};
    c.sliding = {v, 0, 0};
    c.damping = mass / dt;
    c.weight = 1;
    c.normal_force = 1e9;
    c.friction = {1, 1};
    c.dt = dt;
    TangentialSpring<double> spring{};
    EXPECT_NEAR(TanhFriction{}.respond(c, spring).force.x * 3.5 / mass * dt, -v, 1e-12 * v);
    c.damping = 0;
    c.normal_stiffness = mass / (dt * dt);
    EXPECT_NEAR(TanhFriction{}.respond(c, spring).force.x * 3.5 / mass * dt, -v, 1e-12 * v);
}

TEST(Rolling, ASpringIsThatOfTwoHalvesOfAStripWhoseEdgesLimitTheCouple) {
    // Stiffness k_n/2 at either edge of a strip of width B turns with k_n B^2/4; the couple ends at F B/3 = mu_r R F,
    // so k_r = 9/4 k_n (mu_r R)^2 [Ai2011].
    const double arm = 0.1 * 0.01, stiffness = 1e6, width = 3 * arm, angle = 1e-5;
    const auto response = rolling_spring<double>({}, {angle / 1e-3, 0, 0}, 0.1, 0.01, 1000, stiffness, 0, 1e-3);
    EXPECT_NEAR(response.couple.x, -stiffness * width * width / 4 * angle, 1e-12);
}

TEST(Rolling, ASpringLosesEnergyWhileTheContactHardensAndSoftensAndCreatesNone) {
    Vec3 couple{};
    double work = 0, loss = 0, stored = 0, old = 0;
    for (int step = 0; step < 400; ++step) {
        const Vec3 rate{0.5 * std::cos(0.03 * step), 0.2 * std::sin(0.05 * step), 0};
        const double pressure = 1000 * (1 + 0.5 * std::sin(0.2 * step)), stiffness = 1e6 * std::cbrt(pressure / 1000);
        const Vec3 before = couple * (old == 0 ? 1.0 : std::min(1.0, stiffness / old));
        const auto response = rolling_spring<double>(couple, rate, 0.1, 0.01, pressure, stiffness, old, 1e-3);
        work -= 0.5e-3 * dot(rate, before + response.couple);
        loss += response.loss;
        EXPECT_GE(response.loss, -1e-15);
        couple = response.couple;
        stored = response.energy;
        old = stiffness;
    }
    EXPECT_GT(loss, 0.1 * work);
    EXPECT_NEAR(stored + loss, work, 1e-12 * work);
}

TEST(Rolling, ASpringHoldsUpToItsLimitAndStoresOrLosesAllWork) {
    Vec3 couple{};
    double work = 0, loss = 0, stored = 0;
    for (int step = 0; step < 300; ++step) {
        const Vec3 rate{0.5 * std::cos(0.02 * step), 0.2, 0};
        const auto response = rolling_spring<double>(couple, rate, 0.1, 0.01, 1000, 1e6, 1e6, 1e-3);
        work -= 0.5e-3 * dot(rate, couple + response.couple);
        couple = response.couple;
        loss += response.loss;
        stored = response.energy;
        EXPECT_LE(norm(couple), 0.1 * 0.01 * 1000 * (1 + 1e-12));
    }
    EXPECT_NEAR(stored + loss, work, 1e-12 * work);
    EXPECT_NEAR(rolling_constant<double>({0, 3, 0}, 0.1, 0.01, 1000, 1e-3).couple.y, -1, 1e-12);
}

TEST(ClosestPair, FacesGiveTheNormalAndTheOverlapIsMeasuredAlongIt) {
    const Vec3 up{0, 0, 1}, down{0, 0, -1}, none{};
    const Vec3 tilted = normalized(Vec3{0.3, 0, -1});
    EXPECT_EQ(closest_pair_normal(none, up, tilted).z, -1);
    EXPECT_EQ(closest_pair_normal(down, none, tilted).z, -1);
    EXPECT_EQ(closest_pair_normal(none, none, tilted), tilted);
    // Two spheres of 5 mm, one 2 mm aside of the other: the bump of the centre line is not felt.
    EXPECT_NEAR(overlap_along(down, {0.002, 0, -0.009}, 0.005, 0.005), 0.001, 1e-15);
}

TEST(ContactTable, MixingRulesAreThoseAskedForAndAPairCanBeReplaced) {
    const std::vector<ContactMaterial> two{
        {.youngs_modulus = 7e7, .poisson_ratio = 0.1, .restitution = 0.5, .static_friction = 0.75},
        {.youngs_modulus = 2.1e11, .poisson_ratio = 0.3, .restitution = 0.8, .static_friction = 0.45}};
    const ContactTable mean(two, NormalLaw::hertz, {}, true);
    const ContactPair& pair = mean.pair(MaterialId{0}, MaterialId{1});
    EXPECT_NEAR(pair.modulus, 7.0685e7, 1e3);
    EXPECT_NEAR(pair.restitution, 0.65, 1e-15);
    EXPECT_NEAR(pair.ratio, 0.1432, 5e-5);
    EXPECT_NEAR(pair.static_friction, 0.6, 1e-15);
    ContactTable least(two, NormalLaw::hertz, {material::Mixing::minimum, material::Mixing::minimum}, true);
    EXPECT_EQ(least.pair(MaterialId{1}, MaterialId{0}).static_friction, 0.45);
    EXPECT_EQ(least.pair(MaterialId{1}, MaterialId{0}).restitution, 0.5);
    ContactPair other = pair;
    other.static_friction = 0.2;
    least.set_pair(MaterialId{0}, MaterialId{1}, other);
    EXPECT_EQ(least.pair(MaterialId{1}, MaterialId{0}).static_friction, 0.2);
    EXPECT_EQ(least.pair(MaterialId{1}, MaterialId{1}).static_friction, 0.45);
}

}  // namespace
}  // namespace riprap::contact
