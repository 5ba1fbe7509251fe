// SPDX-License-Identifier: Apache-2.0
#include "riprap/bench/pile_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace riprap::bench {
namespace {

double mean_speed(const Pile& pile) {
    double sum = 0;
    for (const Vec3& v : pile.state.bodies.velocity) {
        sum += norm(v);
    }
    return sum / static_cast<double>(pile.state.bodies.velocity.size());
}

double support_over_weight(Pile pile, int steps) {
    sim::Scratch scratch;
    double sum = 0, weight = 0;
    for (int i = 0; i < steps; ++i) {
        advance(pile, scratch, 1);
        for (std::size_t body = 0; body < pile.model.bodies.drive.size(); ++body) {
            if (pile.model.bodies.drive[body] == body::Drive::fixed) {
                sum -= scratch.contact_force()[body].z;
            } else {
                weight += 9.81 * pile.model.bodies.mass[body];
            }
        }
    }
    return sum / weight;
}

TEST(PileScene, DroppedCubesLieStillAndTheFloorCarriesTheirWeight) {
    Pile pile = drop_cubes(2, 3, 2);
    sim::Scratch scratch;
    advance(pile, scratch, 88000);  // one that came down on a corner hops over others before it lies
    ASSERT_EQ(std::ranges::count(pile.model.bodies.drive, body::Drive::free), 12);
    EXPECT_LT(mean_speed(pile), 0.01);  // [m/s]; one that falls its own height reaches 0.14
    EXPECT_NEAR(support_over_weight(pile, 4000), 1, 0.1);
    for (const Vec3& x : pile.state.bodies.position) {
        EXPECT_LT(x.z, 2.5e-3) << "a cube has not come down";
    }
}

TEST(PileScene, APileIsTheSameWheneverItIsMade) {
    EXPECT_EQ(sim::state_hash(drop_cubes(2, 1, 1).state), sim::state_hash(drop_cubes(2, 1, 1).state));
}

TEST(PileScene, AVoronoiPackHasShapesOfItsOwn) {
    const Pile pack = voronoi_pack(50);
    EXPECT_EQ(pack.model.bodies.size(), 55);
    EXPECT_EQ(pack.model.shapes.size(), 55);
    double mass = 0;
    for (std::size_t body = 0; body < pack.model.bodies.drive.size(); ++body) {
        mass += pack.model.bodies.drive[body] == body::Drive::free ? pack.model.bodies.mass[body] : 0;
    }
    EXPECT_NEAR(mass, 2500 * 50e-9, 1e-9 * mass);
}

}  // namespace
}  // namespace riprap::bench
