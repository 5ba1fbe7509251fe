// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/law/hertz.hpp"

#include <gtest/gtest.h>

#include "riprap/contact/law/linear_spring.hpp"

namespace riprap::contact {
namespace {

/// A mass that meets a wall: rebound speed over impact speed, largest force and depth, duration.
struct Impact {
    double restitution, depth, force, duration;
};

template <class Law>
Impact impact(const Law& law, double mass, double speed, double dt, bool allows_pull) {
    double x = 0, v = speed, depth = 0, most = 0, time = 0;
    for (;;) {
        x += 0.5 * dt * v;
        const NormalResponse<double> normal = law(x > 0 ? x : 0);
        double force = normal.elastic + normal.damping * v;
        if (!allows_pull && force < 0) {
            force = 0;
        }
        v -= dt * force / mass;
        depth = std::max(depth, x);
        most = std::max(most, force);
        x += 0.5 * dt * v;
        time += dt;
        if (x <= 0 || (!allows_pull && v < 0 && force == 0)) {
            return {-v / speed, depth, most, time};
        }
    }
}

auto hertz_law(HertzPair<double> pair) {
    return [pair](double overlap) { return hertz(pair, overlap); };
}

// Chung and Ooi (2011), test 1: R* = 5 mm, m* = m/2, closing at 20 m/s.
TEST(Hertz, TwoGlassSpheresReachTheirPublishedForceOverlapAndDuration) {
    const double modulus = effective_modulus({48e9, 0.2}, {48e9, 0.2});
    const double mass = 0.5 * 2800 * 4.0 / 3 * M_PI * 1e-6;
    EXPECT_NEAR(hertz_largest_overlap(modulus, 0.005, mass, 20), 274.113e-6, 1e-9);
    // 4/5 sqrt(pi) Gamma(2/5)/Gamma(9/10) is 2.943275; tables made with 2.9432 read 40.338 us.
    EXPECT_NEAR(hertz_contact_time(modulus, 0.005, mass, 20), 40.3395e-6, 1e-9);
    EXPECT_NEAR(hertz<double>({modulus, 0.005, mass, 0}, 274.113e-6).elastic, 10.6969e3, 0.1);
}

TEST(Hertz, AnElasticImpactReachesTheAnalyticalOverlapAndLosesNoSpeed) {
    const HertzPair<double> pair{7e7, 0.05, 0.6, 0};
    const double duration = hertz_contact_time(pair.modulus, pair.radius, pair.mass, 3);
    const Impact result = impact(hertz_law(pair), pair.mass, 3, duration / 400, true);
    EXPECT_NEAR(result.restitution, 1, 1e-3);
    EXPECT_NEAR(result.depth, hertz_largest_overlap(pair.modulus, pair.radius, pair.mass, 3), 1e-4 * result.depth);
    EXPECT_NEAR(result.duration, duration, 0.01 * duration);
}

TEST(Hertz, TheContactRatioGivesTheRestitutionAskedForAtEverySpeed) {
    for (const double e : {0.2, 0.5, 0.65, 0.9}) {
        EXPECT_NEAR(restitution_of(contact_ratio(e)), e, 1e-12);
        for (const double speed : {0.01, 5.0}) {
            HertzPair<double> pair{7e7, 0.05, 0.6, contact_ratio(e)};
            const double dt = hertz_contact_time(pair.modulus, pair.radius, pair.mass, speed) / 4000;
            EXPECT_NEAR(impact(hertz_law(pair), pair.mass, speed, dt, true).restitution, e, 0.002) << e;
            pair.ratio = contact_ratio_without_pull(e);
            EXPECT_NEAR(impact(hertz_law(pair), pair.mass, speed, dt, false).restitution, e, 0.002) << e;
        }
    }
}

TEST(Hertz, TheCalibratedContactRatioOfTheThesisIsTheMeanOfItsRestitutions) {
    EXPECT_NEAR(contact_ratio(0.65), 0.1432, 5e-5);
    EXPECT_NEAR(contact_ratio(0.5), 0.2271, 5e-5);
    EXPECT_NEAR(restitution_of(0.3), 0.393, 5e-4);
}

TEST(Hertz, ASphereOnAPlaneOfAluminiumLastsAsPublished) {
    // Test 2: R = 100 mm, 0.2 m/s, a plane that does not give.
    const double modulus = 70e9 / (1 - 0.09), mass = 2699 * 4.0 / 3 * M_PI * 1e-3;
    EXPECT_NEAR(hertz_largest_overlap(modulus, 0.1, mass, 0.2), 49.7172e-6, 1e-9);
    EXPECT_NEAR(hertz_contact_time(modulus, 0.1, mass, 0.2), 731.657e-6, 1e-9);
}

/// Work of the elastic force up to an overlap by midpoints [J].
template <class Law>
double work_of(const Law& law, double overlap) {
    constexpr int pieces = 1000;
    double work = 0;
    for (int k = 0; k < pieces; ++k) {
        work += law((k + 0.5) * overlap / pieces).elastic * overlap / pieces;
    }
    return work;
}

TEST(Hertz, StoresTheWorkOfItsElasticForce) {
    const auto law = hertz_law({7e7, 0.05, 0.6, 0.1});
    EXPECT_NEAR(law(1e-3).energy, work_of(law, 1e-3), 1e-5 * law(1e-3).energy);
}

TEST(LinearSpring, StoresTheWorkOfItsElasticForce) {
    const auto law = [](double overlap) { return linear_spring(1e5, 0.3, 0.1, overlap); };
    EXPECT_NEAR(law(1e-3).energy, work_of(law, 1e-3), 1e-9 * law(1e-3).energy);
}

TEST(LinearSpring, RestitutionAndDurationDoNotDependOnTheSpeed) {
    const double k = 1e5, mass = 0.3, ratio = linear_damping_ratio(0.6);
    const double duration = linear_contact_time(k, mass, ratio);
    for (const double speed : {0.01, 10.0}) {
        const Impact result = impact([&](double overlap) { return linear_spring(k, mass, ratio, overlap); }, mass,
                                     speed, duration / 5000, true);
        EXPECT_NEAR(result.restitution, 0.6, 1e-3);
        EXPECT_NEAR(result.duration, duration, 1e-3 * duration);
    }
}

TEST(LinearSpring, RestitutionIsKeptWhereTheForceMayNotPull) {
    const double k = 1e5, mass = 0.3;
    for (const double e : {0.05, 0.3, 0.6, 0.95}) {
        const double ratio = linear_damping_ratio_without_pull(e), dt = linear_contact_time(k, mass, 0) / 20000;
        const Impact result =
            impact([&](double overlap) { return linear_spring(k, mass, ratio, overlap); }, mass, 2, dt, false);
        EXPECT_NEAR(result.restitution, e, 2e-3) << e;
        EXPECT_NEAR(linear_restitution_without_pull(ratio), e, 1e-12);
    }
    EXPECT_NEAR(linear_restitution_without_pull(1), std::exp(-2.0), 1e-12);  // critical damping
}

}  // namespace
}  // namespace riprap::contact
