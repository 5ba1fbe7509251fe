// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "riprap/core/fields.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/solid/affine/bonds.hpp"
#include "riprap/solid/planar_dda/bond_faces.hpp"
#include "solid/planar_dda/blocks.hpp"

namespace riprap::solid::planar_dda {
namespace {

constexpr double g = 9.81;
constexpr double degree = std::numbers::pi / 180;

/// Energy of a state beside that at the start and what the accounts say was put in and lost.
double imbalance(const Blocks& blocks, double at_start) {
    const Accounts& a = blocks.state.accounts;
    const double given = a.work_gravity + a.work_loads + a.work_driven + a.constraint_work + a.linearization;
    const double lost = a.friction_loss + a.dashpot_loss + a.bond_loss + a.newmark_loss + a.static_loss;
    return energies_of(blocks.model, blocks.state).total() - at_start - (given - lost);
}

TEST(PlanarDda, AConstantForceIsFollowedExactlyAtAnyStep) {
    for (const double dt : {0.5, 0.1, 0.002}) {  // 500 steps: half a unit in the last place of g each is 4e-13
        Blocks blocks;
        blocks.settings.displacement_limit = 100;
        const std::int32_t block = blocks.add({{0, 0}, {2, 0}, {1.2, 1.7}});
        blocks.state.rates[0] = 3;
        const Vec2 start{blocks.state.x[0], blocks.state.y[0]};
        ASSERT_TRUE(blocks.run(static_cast<int>(std::lround(1 / dt)), dt, {0.5, -g}));
        EXPECT_NEAR(blocks.state.x[at(block)] - start.x, 3.25, 1e-12);
        EXPECT_NEAR(blocks.state.y[at(block)] - start.y, -0.5 * g, 1e-12);
        EXPECT_NEAR(blocks.state.rates[1], -g, 1e-12);
        EXPECT_NEAR(blocks.state.angle[0], 0, 1e-14);
    }
}

TEST(PlanarDda, ATurningBlockKeepsItsAreaAndShape) {
    Blocks blocks;
    blocks.settings.displacement_limit = 1;
    blocks.add({{0, 0}, {2, 0}, {1.2, 1.7}});
    blocks.state.rates[2] = 1;
    ASSERT_TRUE(blocks.run(6283, 0.01));  // ten turns
    EXPECT_NEAR(blocks.state.angle[0], 62.83, 1e-10);
    EXPECT_NEAR(volume_of(blocks.model, blocks.state, 0), 1.7, 1e-12);
    EXPECT_NEAR(blocks.state.rates[2], 1, 1e-12);
}

TEST(PlanarDda, ALoadStrainsABlockByHookesLaw) {
    Blocks blocks({}, {1000, 1e6, 0.3});
    blocks.settings = settings_for(10, 0.1);
    blocks.settings.dynamic_factor = 0;
    blocks.add_box({-1, -0.5}, {2, 1});
    blocks.loads = {{0, 0, 0, 200, 0, 0}};  // 100 N at either end, 1 m from the middle
    ASSERT_TRUE(blocks.run(40, 10.0));
    EXPECT_NEAR(blocks.state.stress_x[0], 100, 0.05);
    EXPECT_NEAR(blocks.state.stress_y[0], 0, 1e-6);
    EXPECT_NEAR(blocks.state.stretch_xx[0] - 1, 1e-4, 1e-7);
    EXPECT_NEAR(blocks.state.stretch_yy[0] - 1, -0.3e-4, 1e-7);
}

TEST(PlanarDda, ABlockAtRestStandsOnItsSpringsAndTheirForceIsItsWeight) {
    Blocks blocks({.normal_stiffness = 1e8, .shear_stiffness = 4e7, .friction = 0.5, .damping_ratio = 0.3});
    blocks.add_box({-5, -1}, {10, 1}, true);
    blocks.add_box({-0.5, 0}, {1, 1});
    ASSERT_TRUE(blocks.run(400, 1e-3, {0, -g}));
    const double weight = 2500 * g;
    ASSERT_EQ(blocks.state.contact_force.size(), 2u);
    EXPECT_NEAR(blocks.state.contact_force[0] + blocks.state.contact_force[1], weight, 1e-6 * weight);
    EXPECT_NEAR(blocks.state.contact_force[0], blocks.state.contact_force[1], 1e-6 * weight);
    EXPECT_NEAR(blocks.state.stress_y[0 + 1], -0.5 * weight, 1e-3 * weight) << "mean of 0 above and the weight below";
}

TEST(PlanarDda, ABlockSlidesDownAnInclineAsCoulombSays) {
    for (const double angle : {0.0, 10.0, 20.0, 35.0}) {
        const double slope = 30 * degree, friction = std::tan(angle * degree);
        Blocks blocks({.normal_stiffness = 1e8, .shear_stiffness = 4e7, .friction = friction, .damping_ratio = 0.5});
        blocks.add_box({-5, -1}, {30, 1}, true);
        blocks.add_box({0, 0}, {1, 0.5});
        const Vec2 down{g * std::sin(slope), -g * std::cos(slope)};
        ASSERT_TRUE(blocks.run(200, 1e-3, {0, down.y}));  // settles
        ASSERT_TRUE(blocks.run(100, 1e-3, down));         // the shear springs give way, then the block slides
        const double speed = blocks.state.rates[6], place = blocks.state.x[1];
        ASSERT_TRUE(blocks.run(500, 1e-3, down));
        const double a = std::max(0.0, down.x + down.y * friction);
        if (a > 0) {
            EXPECT_NEAR((blocks.state.rates[6] - speed) / 0.5, a, 1e-6) << angle;
        } else {
            const double given = 1250 * down.x / (2 * 4e7);  // by the two shear springs
            EXPECT_LT(std::abs(blocks.state.x[1] - place), given) << angle;
        }
    }
}

TEST(PlanarDda, ContactsWhoseFrictionHasNotSettledAreCounted) {
    for (const double tolerance : {1e-6, 1e-30}) {  // the second asks for more than doubles hold
        Blocks blocks({.normal_stiffness = 1e8, .shear_stiffness = 4e7, .friction = 0.3});
        blocks.settings.friction_tolerance = tolerance;
        blocks.settings.max_iterations = tolerance < 1e-20 ? 1 : 7;
        blocks.add_box({-5, -1}, {30, 1}, true);
        blocks.add_box({0, 1e-4}, {1, 0.5});
        blocks.state.rates[6] = 1;
        std::int64_t open = 0;
        for (int k = 0; k < 100; ++k) {
            ASSERT_TRUE(blocks.run(1, 1e-3, {0, -g}));
            open += blocks.report.open_frictions;
        }
        EXPECT_EQ(open > 0, tolerance < 1e-20) << open;
    }
}

TEST(PlanarDda, TheLedgerClosesWhileABlockFallsTiltsSlidesAndStops) {
    Blocks blocks({.normal_stiffness = 1e7, .shear_stiffness = 4e6, .friction = 0.4, .damping_ratio = 0.1},
                  {2500, 1e8, 0.25});
    blocks.add_box({-5, -1}, {10, 1}, true);
    blocks.add({{-0.5, 0.3}, {0.4, 0.5}, {0.3, 1.3}, {-0.6, 1.1}});
    blocks.state.rates[6] = 2;
    // Friction is booked as it was in the last round, up to this share of the push away from that of the solution: no
    // balance is better.
    blocks.settings.friction_tolerance = 1e-9;
    const double before = energies_of(blocks.model, blocks.state).total();
    ASSERT_TRUE(blocks.run(2000, 5e-4, {0, -g}));
    const Accounts& accounts = blocks.state.accounts;
    const double turnover = accounts.friction_loss + accounts.dashpot_loss + accounts.newmark_loss;
    EXPECT_GT(accounts.friction_loss, 0.05 * turnover);
    EXPECT_GT(accounts.dashpot_loss, 0);
    EXPECT_GT(accounts.newmark_loss, 0);
    EXPECT_NEAR(imbalance(blocks, before), 0, 1e-9 * turnover);
    EXPECT_LT(std::abs(accounts.linearization), 0.01 * turnover);
}

TEST(PlanarDda, NumericalDampingFollowsItsLaw) {
    // A mass on a penalty spring: restitution exp(-pi w dt/4) for small w dt (half a period of damping w dt/4).
    const double k = 1e7, m = 2500, w = std::sqrt(2 * k / m);
    for (const double step : {0.02, 0.05, 0.1}) {
        Blocks blocks({.normal_stiffness = k, .shear_stiffness = k}, {m, 5e13, 0.25});
        blocks.add_box({-5, -1}, {10, 1}, true);
        blocks.add_box({-0.5, 1e-9}, {1, 1});
        blocks.state.rates[7] = -1;
        const double dt = step / w;
        ASSERT_TRUE(blocks.run(static_cast<int>(1.5 * std::numbers::pi / step), dt));
        EXPECT_NEAR(blocks.state.rates[7], std::exp(-std::numbers::pi * step / 4), 0.01) << step;
    }
}

TEST(PlanarDda, ABondBreaksOnceAndForGood) {
    Joint joint{.normal_stiffness = 1e8, .shear_stiffness = 4e7, .friction = 0.5, .cohesion = 1e4, .tension = 2e3};
    Blocks blocks(joint);
    blocks.settings.dynamic_factor = 0;
    blocks.add_box({-1, -1}, {2, 1}, true);
    blocks.add_box({-0.5, 0}, {1, 1});
    blocks.settings.bond_share = affine::bond_tolerance;
    bond_faces(blocks.model, blocks.settings, blocks.state);
    ASSERT_EQ(blocks.state.contact_corner.size(), 2u);
    ASSERT_TRUE(blocks.run(20, 0.01, {0, 0.79}));  // pulled with 1975 N
    EXPECT_EQ(blocks.state.contact_corner.size(), 2u);
    EXPECT_NEAR(blocks.state.contact_force[0], -0.5 * 2500 * 0.79, 1);
    blocks.settings.dynamic_factor = 1;
    ASSERT_TRUE(blocks.run(20, 0.01, {0, 0.81}));
    EXPECT_EQ(blocks.state.contact_corner.size(), 0u) << "2025 N tear it off";
    ASSERT_TRUE(blocks.run(200, 0.01, {0, -0.81}));
    ASSERT_EQ(blocks.state.contact_corner.size(), 2u) << "back on its base";
    EXPECT_EQ(blocks.state.contact_is_bonded[0] + blocks.state.contact_is_bonded[1], 0);
}

TEST(PlanarDda, MultipliersRemoveTheOverlapThatAPenaltyLeaves) {
    Blocks blocks({.normal_stiffness = 1e6, .shear_stiffness = 4e5, .friction = 0.5});
    blocks.settings = settings_for(10, 0.05);
    blocks.settings.dynamic_factor = 0;
    blocks.settings.has_multipliers = true;
    blocks.settings.max_augmentations = 200;
    blocks.add_box({-5, -1}, {10, 1}, true);
    blocks.add_box({-0.5, 0}, {1, 1});
    ASSERT_TRUE(blocks.run(30, 0.1, {0, -g}));
    std::vector<Vec2> corners;
    place_corners(blocks.model, blocks.state, corners);
    const auto lowest =
        std::min_element(corners.begin() + 4, corners.end(), [](const Vec2& p, const Vec2& q) { return p.y < q.y; });
    EXPECT_NEAR(lowest->y, 0, 1e-8) << "a penalty alone leaves 12 mm";
    EXPECT_NEAR(blocks.state.contact_multiplier[0] + blocks.state.contact_multiplier[1], 2500 * g, 1);
}

TEST(PlanarDda, CornersMeetAtTheEntranceWithTheLargerGap) {
    Blocks blocks;
    blocks.add_box({0, 0}, {1, 1}, true);
    blocks.add_box({1.01, 1.002}, {1, 1});  // right of it and a little above: the way in is from the right
    blocks.settings.displacement_limit = 0.02;
    std::vector<Vec2> corners;
    ContactSearch search;
    std::vector<Contact> contacts;
    place_corners(blocks.model, blocks.state, corners);
    find_contacts(blocks.model, blocks.state, blocks.settings, corners, search, contacts);
    ASSERT_EQ(contacts.size(), 1u);
    EXPECT_NEAR(contacts[0].gap.value, 0.01, 1e-12);
}

TEST(PlanarDda, CornersThatMeetInLineWithEachOtherBearHalfAtBothOfTheirFaces) {
    // The width of a unit square is 2A/P = 0.5: gaps within 5e-7 are equal.
    for (const double beside : {0.0, 4e-7, 6e-7}) {
        Blocks blocks;
        blocks.add_box({0, 0}, {1, 1}, true);
        blocks.add_box({1.01, 1.01 + beside}, {1, 1});
        blocks.settings.displacement_limit = 0.02;
        std::vector<Vec2> corners;
        ContactSearch search;
        std::vector<Contact> contacts;
        place_corners(blocks.model, blocks.state, corners);
        find_contacts(blocks.model, blocks.state, blocks.settings, corners, search, contacts);
        ASSERT_EQ(contacts.size(), beside < 5e-7 ? 2U : 1U) << beside;
        for (const Contact& contact : contacts) {
            EXPECT_EQ(contact.share, beside < 5e-7 ? 0.5 : 1.0);
            EXPECT_EQ(contact.corner, contacts[0].corner);  // of one corner, so that they make no couple
        }
    }
}

TEST(PlanarDda, FacesThatEndTogetherBearHalfAtEitherCornerAndPreferNoBlock) {
    const auto shares = [](double width) {
        Blocks blocks;
        blocks.add_box({-0.5 * width, -1}, {width, 1}, true);
        blocks.add_box({-0.5, 0}, {1, 1});
        std::vector<Vec2> corners;
        ContactSearch search;
        std::vector<Contact> contacts;
        place_corners(blocks.model, blocks.state, corners);
        find_contacts(blocks.model, blocks.state, blocks.settings, corners, search, contacts);
        std::vector<double> found;
        for (const Contact& contact : contacts) {
            found.push_back(contact.share);
        }
        return found;
    };
    EXPECT_EQ(shares(1), (std::vector<double>{0.5, 0.5, 0.5, 0.5})) << "two corners of either block";
    EXPECT_EQ(shares(3), (std::vector<double>{1, 1}));
}

TEST(PlanarDda, AMirroredSceneStaysMirrored) {
    // Three voussoirs without friction fall in on themselves between two that are fixed.
    Blocks blocks({.normal_stiffness = 1e6, .shear_stiffness = 1e6}, {20, 5e5, 0.2});
    blocks.settings = settings_for(2.5, 0.05);
    constexpr int count = 5;
    for (int i = 0; i < count; ++i) {
        std::vector<Vec2> corners;
        for (const auto& [r, joint] : {std::pair{2.0, i}, {2.5, i}, {2.5, i + 1}, {2.0, i + 1}}) {
            const double angle = std::numbers::pi * joint / count;
            corners.push_back({r * std::cos(angle), r * std::sin(angle)});
        }
        blocks.add(corners, i == 0 || i + 1 == count);
    }
    for (int k = 0; k < 300; ++k) {
        ASSERT_TRUE(blocks.run(1, 1e-3, {0, -g}));
        EXPECT_NEAR(blocks.state.x[1], -blocks.state.x[3], 1e-9) << k;
        EXPECT_NEAR(blocks.state.y[1], blocks.state.y[3], 1e-9) << k;
    }
    EXPECT_LT(blocks.state.y[2], 2.1) << "it falls";
}

TEST(PlanarDda, ACornerInANotchTouchesBothSidesAndTheNotchItselfTouchesNothing) {
    Blocks blocks({.normal_stiffness = 1e8, .shear_stiffness = 4e7, .damping_ratio = 0.5});
    blocks.add({{-2, -1}, {2, -1}, {2, 1}, {0, 0}, {-2, 1}}, true);  // a trough, concave
    blocks.add({{-0.5, 1.002}, {0, 0.002}, {0.5, 1.002}});
    ASSERT_TRUE(blocks.run(600, 1e-3, {0, -g}));
    EXPECT_EQ(blocks.state.contact_corner.size(), 2u);
    EXPECT_NEAR(blocks.state.x[1], 0, 1e-9);
    EXPECT_NEAR(blocks.state.rates[7], 0, 1e-6);
}

TEST(PlanarDda, AnAlignedStackStandsStill) {
    Blocks blocks({.normal_stiffness = 1e8, .shear_stiffness = 4e7, .friction = 0.5, .damping_ratio = 0.2},
                  {2500, 1e8, 0.25});
    blocks.add_box({-0.5, -1}, {1, 1}, true);
    for (int k = 0; k < 5; ++k) {
        blocks.add_box({-0.5, double(k)}, {1, 1});
    }
    blocks.settings.dynamic_factor = 0;
    ASSERT_TRUE(blocks.run(100, 0.02, {0, -g}));
    blocks.settings.dynamic_factor = 1;
    ASSERT_TRUE(blocks.run(2000, 2e-3, {0, -g}));
    for (std::int32_t b = 1; b <= 5; ++b) {
        EXPECT_NEAR(blocks.state.x[at(b)], 0, 1e-9);
        EXPECT_NEAR(blocks.state.rates[6 * at(b) + 1], 0, 1e-6);
    }
}

TEST(PlanarDda, AStepThatIsRefusedLeavesTheStateAsItWas) {
    Blocks blocks;
    blocks.add_box({0, 0}, {1, 1});
    const std::uint64_t before = hash_fields(blocks.state);
    const Outcome outcome = blocks.step(10, {0, -g});
    EXPECT_FALSE(outcome.ok());
    EXPECT_GT(outcome.shorten, 0);
    EXPECT_LT(outcome.shorten, 1);
    EXPECT_EQ(hash_fields(blocks.state), before);
    EXPECT_NE(outcome.problem.find("moves by 490"), std::string::npos) << outcome.problem;
}

TEST(PlanarDda, AFrontThatClosesAStackBlockByBlockIsNoFailure) {
    // Blocks that fall together have no motion against each other: their contacts close one a round, from below.
    Blocks blocks({.normal_stiffness = 1e10, .shear_stiffness = 4e9});
    blocks.settings = settings_for(10);
    blocks.add_box({-0.5, -1}, {1, 1}, true);
    for (int k = 0; k < 20; ++k) {
        blocks.add_box({-0.5, double(k)}, {1, 1});
    }
    ASSERT_TRUE(blocks.step(1e-3, {0, -g}).ok());
    EXPECT_GE(blocks.report.iterations, 20);
    EXPECT_EQ(blocks.report.closed_contacts, 80) << "two halves at either end of every joint";
}

TEST(PlanarDda, TheFarSideOfAThinBlockIsNotTouched) {
    Blocks blocks({.normal_stiffness = 1e8, .shear_stiffness = 4e7, .damping_ratio = 0.3});
    blocks.settings.displacement_limit = 2;  // looks 5 m far
    blocks.add_box({-2, -1}, {60, 1}, true);
    blocks.add_box({0, 0}, {1, 0.5});
    ASSERT_TRUE(blocks.run(300, 1e-3, {0, -g}));
    EXPECT_EQ(blocks.state.contact_corner.size(), 2u);
    EXPECT_NEAR(blocks.state.y[1], 0.25, 1e-3);
}

TEST(PlanarDda, SameBitsAtAnyThreadCountAndWithoutItsBuffers) {
    std::uint64_t first = 0;
    for (const int threads : {1, 2, 4}) {
        parallel::set_thread_count(threads);
        Blocks blocks({.normal_stiffness = 1e7, .shear_stiffness = 4e6, .friction = 0.5, .damping_ratio = 0.1});
        blocks.add_box({-5, -1}, {10, 1}, true);
        for (int k = 0; k < 12; ++k) {
            blocks.add_box({-1.5 + 1.1 * (k % 3), 0.01 + 1.02 * (k / 3)}, {1, 1});
        }
        for (int k = 0; k < 100; ++k) {
            ASSERT_TRUE(blocks.step(1e-3, {0.5, -g}).ok());
            if (threads == 2) {
                blocks.scratch = {};
            }
        }
        const std::uint64_t hash = hash_fields(blocks.state);
        first = first == 0 ? hash : first;
        EXPECT_EQ(hash, first) << threads << " threads";
    }
    parallel::set_thread_count(1);
}

TEST(PlanarDda, StiffnessesThatCannotBeComputedWithAreNamedOnce) {
    Blocks blocks({.normal_stiffness = -1});
    blocks.scene.add_material(blocks.scene.materials.materials[0]);  // the stiffness of another pair is the same
    blocks.add_box({0, 0}, {1, 1});
    ASSERT_EQ(blocks.problems.size(), 1u);
    EXPECT_EQ(blocks.problems[0].message, "contact_stiffness is -1 N/m");
    Blocks stiff({.shear_stiffness = 1.1e6 * 5e10});
    stiff.add_box({0, 0}, {1, 1});
    ASSERT_EQ(stiff.problems.size(), 1u);
    EXPECT_EQ(stiff.problems[0].message, "shear stiffness is 5.5e+16 N/m");
    Blocks sound;
    sound.add_box({0, 0}, {1, 1});
    EXPECT_TRUE(sound.problems.empty());
}

}  // namespace
}  // namespace riprap::solid::planar_dda
