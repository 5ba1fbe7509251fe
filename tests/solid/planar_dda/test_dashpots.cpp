// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "blocks.hpp"
#include "riprap/solid/affine/restitution.hpp"
#include "riprap/solid/planar_dda/dashpots.hpp"

namespace riprap::solid::planar_dda {
namespace {

constexpr double stiffness = 1e8;

/// A square of 0.4 m over a floor, which it meets flat or with a corner; 400 kg.
struct Impact {
    Blocks blocks;
    std::int32_t square{0};

    Impact(double damping_ratio, double height, double speed, bool is_flat = true)
        : blocks({.normal_stiffness = stiffness, .shear_stiffness = 4e7, .damping_ratio = damping_ratio},
                 {.youngs_modulus = 1e12}) {
        blocks.add_box({-2, -1}, {4, 1}, true);
        const double a = 0.2 * std::numbers::sqrt2;
        square = is_flat ? blocks.add_box({-0.2, height}, {0.4, 0.4})
                         : blocks.add({{0, height}, {a, height + a}, {0, height + 2 * a}, {-a, height + a}});
        blocks.state.rates[6 * static_cast<std::size_t>(square) + 1] = -speed;
        blocks.settings.displacement_limit = 0.02;
        blocks.settings.close_tolerance = blocks.settings.open_tolerance = 1e-12;
    }
    double velocity() const { return blocks.state.rates[6 * static_cast<std::size_t>(square) + 1]; }
};

/// Frequency of the square on both corners [1/s].
double frequency() { return std::sqrt(2 * stiffness / 400); }

TEST(Dashpots, AnImpactGivesBackItsRestitutionWhereverItFallsInAStep) {
    for (const double e : {0.3, 0.5, 0.8, 1.0}) {
        for (const bool is_flat : {true, false}) {
            const double dt = 0.2 / frequency();
            for (const double share : {0.05, 0.35, 0.65, 0.95}) {
                Impact impact(std::max(affine::damping_ratio_of(e), 1e-300), share * dt, 1, is_flat);
                impact.blocks.run(60, dt);
                EXPECT_NEAR(impact.velocity(), e, 0.016) << e << ' ' << is_flat << ' ' << share;
            }
        }
    }
}

TEST(Dashpots, AtTwiceThatPhaseItWouldNot) {
    double least = 1;
    for (const double share : {0.05, 0.35, 0.65, 0.95}) {
        const double dt = 0.4 / frequency();
        Impact impact(1e-300, share * dt, 1);
        impact.blocks.run(40, dt);
        least = std::min(least, impact.velocity());
    }
    EXPECT_LT(least, 1 - 0.016);
}

TEST(Dashpots, AnImpactIsResolvedFromAPhaseOfAFifthOn) {
    for (const auto& [phase, is_refused] : {std::pair{0.15, false}, {0.25, true}}) {
        const double dt = phase / frequency();
        Impact impact(0.1, 0.5 * dt, 1);
        impact.blocks.step(dt);
        const std::int64_t found =
            find_unresolved_impact(impact.blocks.model, impact.blocks.state, {}, dt, impact.blocks.scratch);
        EXPECT_EQ(found >= 0, is_refused) << phase;
    }
}

TEST(Dashpots, NumericalDampingIsTakenOffInAnImpactAndOffWhatIsAskedForAtRest) {
    const double overlap = 1e-3, dt = 1e-3, z = 1e-6;
    for (const auto& [share, is_impact] : {std::pair{0.25, false}, {0.45, true}}) {
        Impact impact(z, -overlap, share * overlap * frequency());
        impact.blocks.step(1e-9);
        set_dashpots(impact.blocks.model, impact.blocks.state, {}, dt, impact.blocks.scratch.contacts);
        const Contact& contact = impact.blocks.scratch.contacts.front();
        EXPECT_EQ(contact.dashpot < 0, is_impact) << share;
        if (is_impact) {
            EXPECT_NEAR(contact.dashpot, -0.5 * stiffness * dt, 1e-4 * stiffness * dt);
        }
    }
}

TEST(Dashpots, CornersOfAFaceShareTheMassAndOneCornerTurnsTheBlock) {
    // 2 z sqrt(k m): m/2 for each of two corners; for one corner beside the centre 1/(1/m + r^2/I) = 0.4 m.
    const double dt = 1e-9, z = 0.3;
    Impact flat(z, 0, 1);
    flat.blocks.step(dt);
    EXPECT_NEAR(flat.blocks.scratch.contacts.front().dashpot, 2 * z * std::sqrt(stiffness * 200), 1);
    Impact tilted(z, 0, 1);
    tilted.blocks.state.angle[static_cast<std::size_t>(tilted.square)] = 0.02;
    tilted.blocks.step(dt);
    double least = 1e300;
    for (const Contact& contact : tilted.blocks.scratch.contacts) {
        least = std::min(least, contact.dashpot);
    }
    EXPECT_NEAR(least, 2 * z * std::sqrt(stiffness * 160), 0.02 * least);
}

}  // namespace
}  // namespace riprap::solid::planar_dda
