// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "riprap/body/body_set.hpp"
#include "riprap/contact/placed_parts.hpp"
#include "riprap/geometry/polyhedra/shapes.hpp"

namespace riprap::contact {
namespace {

/// A free cube and two held ones.
struct Trio {
    geometry::ShapeSet shapes;
    body::BodySet bodies;
    body::BodyState state;

    Trio() {
        const ShapeId cube = shapes.add_convex(geometry::cube(1), false, nullptr);
        for (int i = 0; i < 3; ++i) {
            body::NewBody block;
            block.name = "block";
            block.material = MaterialId{0};
            block.density = 2000;
            block.drive = i == 0 ? body::Drive::free : body::Drive::fixed;
            block.pose = {{3.0 * i, 0, 0}, {}};
            block.parts = {{BodyId{}, cube, Pose{}}};
            add_body(bodies, state, shapes, block);
        }
    }
};

TEST(PlacedParts, FollowABodyThatStartsToMoveAndLeaveOneThatRests) {
    Trio trio;
    PlacedParts placed;
    place_parts(trio.shapes, trio.bodies, trio.state, placed);
    EXPECT_EQ(placed.restless, std::vector<std::int32_t>{0});
    trio.state.position[0] = {0, 0, 0.5};
    trio.state.position[2] = {6, 0, 0.25};
    place_parts(trio.shapes, trio.bodies, trio.state, placed);
    EXPECT_EQ(placed.restless, (std::vector<std::int32_t>{0, 2}));
    trio.state.position[2] = {6, 0, 0.75};
    place_parts(trio.shapes, trio.bodies, trio.state, placed);
    PlacedParts anew;
    place_parts(trio.shapes, trio.bodies, trio.state, anew);
    EXPECT_EQ(placed.centers, anew.centers);
    EXPECT_EQ(placed.centers[2], (Vec3{6, 0, 0.75}));
    EXPECT_NE(placed.scene, anew.scene);
}

}  // namespace
}  // namespace riprap::contact
