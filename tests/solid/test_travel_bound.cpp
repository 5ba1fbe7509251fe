// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/travel_bound.hpp"

#include <gtest/gtest.h>

#include "riprap/geometry/shapes.hpp"

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
    void add(const char* name, const geometry::Polyhedron& shape, body::Drive drive) {
        body::NewBody body;
        body.name = name;
        body.material = MaterialId{0};
        body.density = 1000;
        body.drive = drive;
        body.parts = {{BodyId{}, shapes.add_convex(shape), {}}};
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

TEST(TravelBound, IsNoneWhereNothingMoves) {
    const Scene scene;
    EXPECT_EQ(approach_limit(scene.bodies, scene.shapes, scene.state), 0);
}

}  // namespace
}  // namespace riprap::solid
