// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/travel_bound.hpp"

#include <gtest/gtest.h>

#include "riprap/geometry/polyhedra/shapes.hpp"

namespace riprap::solid {
namespace {

/// A plate 2 cm thick that stands still, and two cubes.
struct Scene {
    geometry::ShapeSet shapes;
    body::BodySet bodies;
    body::BodyState state;

    Scene() {
        add("plate", geometry::box({1, 1, 0.02}), body::Drive::fixed);
        add("fast", geometry::box({0.1, 0.1, 0.1}), body::Drive::free);
        add("slow", geometry::box({0.1, 0.1, 0.1}), body::Drive::free);
    }
    void add(const char* name, const geometry::Polyhedron& shape, body::Drive drive, bool is_planar = false) {
        body::NewBody body;
        body.name = name;
        body.material = MaterialId{0};
        body.density = 1000;
        body.drive = drive;
        body.parts = {{BodyId{}, shapes.add_convex(shape, is_planar), {}}};
        add_body(bodies, state, shapes, body);
    }
};

TEST(TravelBound, IsOfTheTwoFastestBodiesAndTheThinnest) {
    Scene scene;
    scene.state.velocity[1] = {0, 0, -3};
    scene.state.velocity[2] = {0, 0, 1};
    EXPECT_NEAR(fastest_approach(scene.bodies, scene.shapes, scene.state), 3 + 1, 1e-15);
    EXPECT_NEAR(smallest_radius(scene.bodies, scene.shapes), 0.01, 1e-15);
}

TEST(TravelBound, CountsTheFarthestCornerOfABodyThatSpins) {
    Scene scene;
    scene.state.angular_momentum[1] =
        angular_momentum_of(scene.bodies, BodyId{1}, scene.state.orientation[1], {0, 0, 10});
    const double approach = fastest_approach(scene.bodies, scene.shapes, scene.state);
    EXPECT_NEAR(approach, 10 * 0.05 * std::sqrt(3.0), 1e-12);
    EXPECT_GE(approach_limit(scene.bodies, scene.shapes, scene.state), approach * (1 - 1e-12));
}

// Half of its length of a metre counted as a lever: a spinning grain made steps 800 times as short.
TEST(TravelBound, APrismThatTurnsAboutItsLengthMovesByItsRadius) {
    Scene scene;
    scene.bodies.is_planar = true;
    scene.add("grain", geometry::box({0.006, 0.008, 1}), body::Drive::free, true);
    scene.state.angular_momentum[3] =
        angular_momentum_of(scene.bodies, BodyId{3}, scene.state.orientation[3], {0, 0, 500});
    EXPECT_NEAR(fastest_approach(scene.bodies, scene.shapes, scene.state), 500 * 0.005, 1e-9);
    EXPECT_NEAR(approach_limit(scene.bodies, scene.shapes, scene.state), 500 * 0.005, 1e-9);
}

TEST(TravelBound, IsNoneWhereNothingMoves) {
    const Scene scene;
    EXPECT_EQ(approach_limit(scene.bodies, scene.shapes, scene.state), 0);
}

}  // namespace
}  // namespace riprap::solid
