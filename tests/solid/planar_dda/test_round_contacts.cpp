// SPDX-License-Identifier: Apache-2.0
// Discs touch as circles in planar DDA, not as the polygons of 64 sides that stand for them. Every scene is judged as
// drawn and turned by 37 degrees.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "riprap/core/index.hpp"
#include "riprap/geometry/polyhedra/round_shapes.hpp"
#include "riprap/solid/planar_dda/plane.hpp"
#include "riprap/solid/planar_dda/round_touch.hpp"
#include "riprap/solid/planar_dda/seams.hpp"
#include "solid/planar_dda/blocks.hpp"

namespace riprap::solid::planar_dda {
namespace {

constexpr double g = 9.81;
constexpr double degree = std::numbers::pi / 180;

/// A scene whose axes are turned.
struct Turned : Blocks {
    double turn;

    explicit Turned(double angle, const Joint& joint = {}) : Blocks(joint), turn(angle) {}
    Vec2 out(const Vec2& v) const { return turned(turn, v); }
    Vec2 back(const Vec2& v) const { return turned(-turn, v); }
    std::int32_t polygon(std::vector<Vec2> corners, bool is_fixed = true) {
        for (Vec2& p : corners) {
            p = out(p);
        }
        return add(corners, is_fixed);
    }
    std::int32_t box(const Vec2& low, const Vec2& size, bool is_fixed = true) {
        return polygon({low, {low.x + size.x, low.y}, low + size, {low.x, low.y + size.y}}, is_fixed);
    }
    /// A disc as `shape = { sphere = radius }` makes it, with a corner at an odd angle.
    std::int32_t disc(double radius, const Vec2& center, const Vec2& velocity = {}, double spin = 0) {
        constexpr int sides = 64;
        std::vector<Vec2> corners;
        for (int k = 0; k < sides; ++k) {
            const double angle = 2 * std::numbers::pi * k / sides + 0.03;
            const double from = geometry::circumradius_of_equal_area(sides) * radius;
            corners.push_back(center + from * Vec2{std::cos(angle), std::sin(angle)});
        }
        const std::int32_t b = polygon(corners, false);
        const Vec2 v = out(velocity);
        for (const auto& [k, rate] : {std::pair{0, v.x}, {1, v.y}, {2, spin}}) {
            state.rates[6 * at(b) + at(k)] = rate;
        }
        return b;
    }
    /// Runs to a time in steps that are halved where they do not settle.
    void run_to(double end, double dt, const Vec2& gravity = {}) {
        settings.displacement_limit = 0.05;
        for (double t = 0, piece = dt; t < end - 1e-12; t += piece, piece = std::min(dt, end - t)) {
            while (!step(piece, out(gravity)).ok()) {
                piece *= 0.5;
                ASSERT_GT(piece, 1e-9);
            }
        }
    }
    Vec2 place(std::int32_t b) const { return back({state.x[at(b)], state.y[at(b)]}); }
    Vec2 velocity(std::int32_t b) const { return back({state.rates[6 * at(b)], state.rates[6 * at(b) + 1]}); }
    double spin(std::int32_t b) const { return state.rates[6 * at(b) + 2]; }
    /// Normal force between two blocks in the last step [N].
    double normal_force(std::int32_t a, std::int32_t b) const {
        double sum = 0;
        for (std::size_t k = 0; k < scratch.contacts.size(); ++k) {
            const auto pair = std::minmax(scratch.contacts[k].a, scratch.contacts[k].b);
            sum += pair.first == std::min(a, b) && pair.second == std::max(a, b) ? scratch.trials[k].normal : 0;
        }
        return sum;
    }
    double imbalance() const {
        const Accounts& a = state.accounts;
        return energies_of(model, state).total() -
               (a.work_gravity + a.linearization - a.friction_loss - a.newmark_loss - a.static_loss - a.dashpot_loss);
    }
};

constexpr double turns[] = {0, 37 * degree};
Vec2 down_slope(double angle) { return g * Vec2{std::sin(angle), -std::cos(angle)}; }
double mass_of(double radius) { return 2500 * std::numbers::pi * radius * radius; }

TEST(RoundContacts, ADiscRollsDownASlope) {
    // a = 2/3 g sin; from the second tenth on, when it has settled on its springs
    for (const double turn : turns) {
        for (const double angle : {10 * degree, 20 * degree, 37 * degree}) {
            Turned blocks(turn, {.friction = 0.5});
            blocks.box({-1, -0.5}, {5, 0.5});
            const std::int32_t disc = blocks.disc(0.25, {0, 0.25});
            blocks.run_to(0.6, 1e-3, down_slope(angle));
            const double acceleration = 2.0 / 3 * g * std::sin(angle);
            EXPECT_NEAR(blocks.place(disc).x / (0.5 * acceleration * 0.36), 1, 1e-3) << angle;
            EXPECT_NEAR(blocks.spin(disc) * 0.25 / (-acceleration * 0.6), 1, 1e-3) << angle;
            EXPECT_NEAR(blocks.imbalance(), 0, 1e-8);
            ASSERT_EQ(blocks.state.contact_lock.size(), 1U);
            // it has wound up no more than what friction holds: m g sin/3
            const double friction = mass_of(0.25) * g * std::sin(angle) / 3;
            EXPECT_NEAR(std::abs(blocks.state.contact_lock[0]) * 4e8 / friction, 1, 0.02);
        }
    }
}

TEST(RoundContacts, ADiscThatSlidRollsWithTwoThirdsOfItsSpeedWhateverItsDashpots) {
    for (const double turn : turns) {
        for (const double ratio : {0.0, 0.2}) {
            Turned blocks(turn, {.friction = 0.5, .damping_ratio = ratio});
            blocks.box({-2, -1}, {5, 1});
            const std::int32_t disc = blocks.disc(0.2, {-1, 0.2}, {2, 0});
            const double start = energies_of(blocks.model, blocks.state).total();
            blocks.run_to(0.6, 1e-3, {0, -g});
            EXPECT_NEAR(blocks.velocity(disc).x / (4.0 / 3), 1, 2e-3) << ratio;
            EXPECT_NEAR(blocks.imbalance() / start, 1, 1e-7);
        }
    }
}

TEST(RoundContacts, ADiscSlidesWhereFrictionIsLessThanAThirdOfTheSlope) {
    const double angle = 20 * degree, limit = std::tan(angle) / 3;
    for (const double turn : turns) {
        for (const double share : {0.5, 0.97, 1.03}) {
            Turned blocks(turn, {.friction = share * limit});
            blocks.box({-1, -0.5}, {5, 0.5});
            const std::int32_t disc = blocks.disc(0.25, {0, 0.25});
            blocks.run_to(0.5, 1e-3, down_slope(angle));
            const double held = std::min(share, 1.0) * limit * g * std::cos(angle);
            EXPECT_NEAR(blocks.velocity(disc).x / (0.5 * (g * std::sin(angle) - held)), 1, 2e-3) << share;
            EXPECT_NEAR(blocks.spin(disc) / (-0.5 * 2 * held / 0.25), 1, 4e-3) << share;
        }
    }
}

/// Thrust of a frictionless pyramid of discs on a wall beside its lowest layer, over the weight of a disc.
double thrust_of_pyramid(double turn, int layers) {
    const double r = 0.2;
    Turned blocks(turn);
    blocks.box({-1, -0.5}, {2 + 2 * layers * r, 0.5});
    const std::int32_t left = blocks.box({-0.5, 0}, {0.5, 2}), right = blocks.box({2 * layers * r, 0}, {0.5, 2});
    std::int32_t first = -1, last = -1;
    for (int layer = 0; layer < layers; ++layer) {
        for (int k = 0; k < layers - layer; ++k) {
            const std::int32_t disc = blocks.disc(r, {r * (1 + 2 * k + layer), r * (1 + std::sqrt(3) * layer)});
            first = first < 0 ? disc : first;
            last = layer == 0 ? disc : last;
        }
    }
    blocks.settings.dynamic_factor = 0.9;
    blocks.run_to(0.5, 1e-3, {0, -g});
    const double thrust = blocks.normal_force(right, last);
    EXPECT_NEAR(blocks.normal_force(left, first) / thrust, 1, 1e-6);
    return thrust / (mass_of(r) * g);
}

TEST(RoundContacts, APyramidOfDiscsThrustsAsStaticsTell) {
    // Every disc bears on two at 30 degrees, and none pushes its neighbour above the floor. Of vertical parts in
    // weights: the top gives 1/2, 1/2; the next layer 1, 1/2 outside and inside; the third 3/2, 1/2 and 1, 1 in the
    // middle. The floor's layer is pushed outwards by tan 30 times 3/2 at its outer discs and by 1 - 1/2 at its inner
    // ones.
    for (const double turn : turns) {
        EXPECT_NEAR(thrust_of_pyramid(turn, 2) / (0.5 * std::tan(30 * degree)), 1, 2e-3);
        EXPECT_NEAR(thrust_of_pyramid(turn, 4) / (2 * std::tan(30 * degree)), 1, 2e-3);
    }
}

TEST(RoundContacts, ADiscSettlesOnTheCornersOfASlot) {
    const double r = 0.06;
    for (const double turn : turns) {
        for (const double share : {0.05, 0.5, 0.9}) {
            const double half = share * r, height = std::sqrt(r * r - half * half);
            Turned blocks(turn);
            blocks.box({-0.5 - half, -0.3}, {0.5, 0.3});
            blocks.box({half, -0.3}, {0.5, 0.3});
            const std::int32_t disc = blocks.disc(r, {0, height + 1e-4});
            blocks.settings.dynamic_factor = 0.9;
            blocks.run_to(0.3, 1e-3, {0, -g});
            const double sunk = mass_of(r) * g / (2 * 1e9 * std::pow(height / r, 2));
            EXPECT_NEAR(blocks.place(disc).x, 0, 1e-9);
            EXPECT_NEAR(blocks.place(disc).y, height - sunk, 0.05 * sunk) << share;
        }
    }
}

TEST(RoundContacts, ADiscInAVOfTwoBlocksBearsOnBoth) {
    const double r = 0.25, half = 40 * degree, c = std::cos(half), s = std::sin(half);
    for (const double turn : turns) {
        Turned blocks(turn);
        const std::int32_t right = blocks.polygon({{0, 0}, {2 * c, -2 * s}, {2 * c + s, 2 * c - 2 * s}, {s, c}});
        blocks.polygon({{0, 0}, {-s, c}, {-2 * c - s, 2 * c - 2 * s}, {-2 * c, -2 * s}});
        const std::int32_t disc = blocks.disc(r, {0, r / s});
        blocks.settings.dynamic_factor = 0.9;
        blocks.run_to(0.3, 1e-3, {0, -g});
        const double push = 0.5 * mass_of(r) * g / s;
        EXPECT_NEAR(blocks.normal_force(right, disc) / push, 1, 2e-3);
        EXPECT_NEAR(blocks.place(disc).x, 0, 1e-9);
        EXPECT_NEAR(blocks.place(disc).y, r / s, 2 * push / 1e9 / s);
    }
}

/// A row of blocks along y = 0 with a disc that comes rolling, or slides where there is no friction.
double speed_after_seams(double turn, double gap, bool is_free, double friction, double dt = 1e-3) {
    const double r = 0.25, length = 0.4;
    Turned blocks(turn, {.friction = friction});
    blocks.box({-2, -1}, {8, 0.5});
    double x = -0.6;
    for (int k = 0; k < 10; ++k, x += length + gap) {
        blocks.box({x, -0.5}, {length, 0.5}, !is_free);
    }
    const std::int32_t disc = blocks.disc(r, {-0.3, r}, {3, 0}, friction > 0 ? -3 / r : 0);
    blocks.run_to(1, dt, {0, -g});
    EXPECT_NEAR(blocks.place(disc).y, r, 2e-4);
    return blocks.velocity(disc).x;
}

TEST(RoundContacts, ADiscKeepsItsSpeedOverSeams) {
    for (const double turn : turns) {
        for (const double friction : {0.0, 0.5}) {
            EXPECT_NEAR(speed_after_seams(turn, 0, false, friction), 3, 1e-3) << friction;
            EXPECT_NEAR(speed_after_seams(turn, 1e-3, false, friction), 3, 2e-3) << friction;
            EXPECT_NEAR(speed_after_seams(turn, 0, true, friction), 3, 6e-3) << friction;
            EXPECT_NEAR(speed_after_seams(turn, 0, false, friction, 2.5e-4), 3, 1e-3) << friction;
        }
    }
}

TEST(RoundContacts, DiscsThatMeetWithAnOffsetChangeTheSpeedAlongTheLineOfTheirCentres) {
    // Equal masses, no friction, no loss: v' = v - (v . n) n. The springs give way by 0.4 v sqrt(m/2k), 1e-3 of r, over
    // which the line turns; the integration takes half of omega dt, 4e-3.
    const double r = 0.25, before = 1e-3, v = 0.2;
    for (const double turn : turns) {
        for (const double offset : {0.0, 0.5, 0.9}) {
            Turned blocks(turn);
            const Vec2 n{std::sqrt(1 - offset * offset), offset};
            const std::int32_t a = blocks.disc(r, {-before * v, 0}, {v, 0});
            const std::int32_t b = blocks.disc(r, 2 * r * n + Vec2{before * v, 0}, {-v, 0});
            blocks.run_to(6e-3, 4e-6);
            EXPECT_NEAR(norm(blocks.velocity(a) - Vec2{v, 0} + 2 * v * n.x * n) / v, 0, 0.015) << offset;
            EXPECT_NEAR(norm(blocks.velocity(a) + blocks.velocity(b)), 0, 1e-9);
            EXPECT_NEAR(blocks.spin(a), 0, 1e-6);
        }
    }
}

TEST(RoundContacts, ADiscLeavesACornerOfABlockAlongTheLineToItsCentre) {
    const double r = 0.25, before = 1e-3, v = 0.2;
    for (const double turn : turns) {
        for (const double offset : {0.1, 0.5, 0.9}) {
            Turned blocks(turn);
            blocks.box({-1, -1}, {1, 1});
            const Vec2 n{offset, std::sqrt(1 - offset * offset)};
            const std::int32_t disc = blocks.disc(r, r * n + Vec2{0, before * v}, {0, -v});
            blocks.run_to(6e-3, 4e-6);
            EXPECT_NEAR(norm(blocks.velocity(disc) + Vec2{0, v} - 2 * v * n.y * n) / v, 0, 0.015) << offset;
        }
    }
}

TEST(RoundContacts, ADiscAtRestStays) {
    for (const double turn : turns) {
        Turned blocks(turn, {.friction = 0.5});
        blocks.box({-2, -1}, {4, 0.5});
        blocks.box({-1, -0.5}, {2, 0.5}, false);
        const std::int32_t disc = blocks.disc(0.25, {0, 0.25});
        blocks.run_to(1, 1e-3, {0, -g});
        EXPECT_NEAR(norm(blocks.velocity(disc)), 0, 1e-6);
        EXPECT_NEAR(blocks.place(disc).x, 0, 1e-9);
        EXPECT_NEAR(blocks.imbalance(), 0, 1e-8);
    }
}

TEST(RoundContacts, AStrainedDiscIsAnEllipse) {
    Turned blocks(0);
    const std::int32_t floor = blocks.box({-1, -0.5}, {2, 0.5}), disc = blocks.disc(0.25, {0, 0.25});
    blocks.state.stretch_yy[at(disc)] = 1 - 1e-3;
    blocks.state.stretch_xx[at(disc)] = 1 + 1e-3;
    std::vector<Vec2> corners;
    place_corners(blocks.model, blocks.state, corners);
    const auto gap = [&] {
        double least = 1;
        for (std::int32_t edge = blocks.model.corner_begin[at(floor)]; edge < blocks.model.corner_begin[at(disc)];
             ++edge) {
            const RoundTouch touch =
                touch_round(blocks.model, blocks.state, corners, blocks.model.corner_begin[at(disc)], edge);
            least = touch.normal.y > 0.9 ? std::min(least, touch.gap) : least;
        }
        return least;
    };
    EXPECT_NEAR(gap(), 0.25e-3, 1e-12);
    blocks.state.angle[at(disc)] += 90 * degree;
    EXPECT_NEAR(gap(), -0.25e-3, 1e-12);
    blocks.state.angle[at(disc)] += 45 * degree;
    EXPECT_NEAR(gap(), 0, 2e-7);
}

/// Contacts of a disc that lies in a floor along y = 0 by an overlap, a gap and a step up at x = 0 beside or under it.
std::size_t contacts_at_seam(double overlap, double disc_at, double gap, double step) {
    Turned blocks(37 * degree);
    blocks.box({-1, -0.5}, {1, 0.5});
    blocks.box({gap, step - 0.5}, {1, 0.5});
    blocks.disc(0.25, {disc_at, 0.25 - overlap});
    std::vector<Vec2> corners;
    place_corners(blocks.model, blocks.state, corners);
    blocks.settings.displacement_limit = 1e-5;
    find_contacts(blocks.model, blocks.state, blocks.settings, corners, blocks.scratch.search, blocks.scratch.contacts);
    return blocks.scratch.contacts.size();
}

TEST(RoundContacts, ACornerThatContinuesTheFaceIsNone) {
    const double overlap = 1e-4, joint = joint_share * 0.25;  // half a patch is sqrt(2 r overlap) = 7e-3 m
    for (const double at : {-1e-3, 1e-3, 0.0}) {
        EXPECT_EQ(contacts_at_seam(overlap, at, 0, 0), 1U) << at;
    }
    EXPECT_EQ(contacts_at_seam(overlap, -1e-3, 0, 0.8 * overlap), 1U);
    EXPECT_EQ(contacts_at_seam(overlap, -1e-3, 0, 1.2 * overlap), 2U);
    EXPECT_EQ(contacts_at_seam(overlap, -1e-4, 0.9 * joint, 0), 1U);
    EXPECT_EQ(contacts_at_seam(overlap, -1e-4, 1.1 * joint, 0), 2U);
    EXPECT_EQ(contacts_at_seam(overlap, 5e-4, 1e-3, 0), 2U);  // over the gap both corners bear
}

TEST(RoundContacts, TheNormalHalfWayTellsTheGapAfterAStep) {
    const double r = 0.25, dt = 1e-3;
    for (const Vec2& velocity : {Vec2{5, -0.5}, {-5, 0}}) {
        Turned blocks(37 * degree);
        blocks.box({-1, -1}, {1, 1});
        const std::int32_t disc = blocks.disc(r, {0.1, 0.23}, velocity);
        std::vector<Contact> contacts;
        std::vector<Vec2> corners;
        const auto find = [&] {
            place_corners(blocks.model, blocks.state, corners);
            find_contacts(blocks.model, blocks.state, blocks.settings, corners, blocks.scratch.search, contacts, dt);
        };
        find();
        ASSERT_EQ(contacts.size(), 1U);
        Unknowns moved = rates_of(blocks.state, disc);
        for (double& u : moved) {
            u *= dt;
        }
        const double told = contacts[0].gap.after(moved, {});
        blocks.state.x[at(disc)] += moved[0];
        blocks.state.y[at(disc)] += moved[1];
        find();
        EXPECT_NEAR(told, contacts[0].gap.value, 1e-7);  // w^2/2r is 5e-5
    }
}

TEST(RoundContacts, FrictionGoesOnOverASeamAndAroundACorner) {
    // held by friction on a slope that it rolls down: m g sin/3 throughout
    const double angle = 20 * degree, held = mass_of(0.25) * g * std::sin(angle) / 3;
    for (const double turn : turns) {
        Turned blocks(turn, {.friction = 0.5});
        for (int k = 0; k < 10; ++k) {
            blocks.box({-0.2 + 0.1 * k, -0.5}, {0.1, 0.5});
        }
        blocks.polygon({{0.8, -0.5}, {4, -0.5}, {4, -1e-4}, {1, 0}, {0.8, 0}});
        const std::int32_t disc = blocks.disc(0.25, {0, 0.25});
        blocks.run_to(0.3, 1e-3, down_slope(angle));
        double least = 1e9, largest = 0;
        while (blocks.place(disc).x < 1.2) {
            blocks.run_to(1e-3, 1e-3, down_slope(angle));
            double sum = 0;
            for (const double slip : blocks.state.contact_lock) {
                sum += 4e8 * std::abs(slip);
            }
            least = std::min(least, sum);
            largest = std::max(largest, sum);
        }
        EXPECT_NEAR(least / held, 1, 0.05);
        EXPECT_NEAR(largest / held, 1, 0.05);
    }
}

TEST(RoundContacts, ARollingDiscGoesOnFromItsStateAlone) {
    const auto start = [] {
        Turned blocks(0.2, {.friction = 0.5});
        blocks.polygon({{-1, -0.5}, {2, -0.5}, {2, 0.3}, {0.3, 0}, {-1, 0}});  // it rolls into the foot of a slope
        blocks.disc(0.25, {0, 0.25}, {2, 0}, -8);
        return blocks;
    };
    Turned whole = start(), cut = start();
    for (int k = 0; k < 400; ++k) {
        whole.run_to(1e-3, 1e-3, {0, -g});
        cut.run_to(1e-3, 1e-3, {0, -g});
        cut.scratch = k % 50 == 0 ? Scratch{} : std::move(cut.scratch);
    }
    EXPECT_GT(whole.place(1).x, 0.3);
    EXPECT_EQ(whole.state.x, cut.state.x);
    EXPECT_EQ(whole.state.contact_lock, cut.state.contact_lock);
}

}  // namespace
}  // namespace riprap::solid::planar_dda
