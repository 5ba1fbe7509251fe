// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/particle_walls/strays.hpp"

#include <gtest/gtest.h>

#include "riprap/geometry/polyhedra/shapes.hpp"

namespace riprap::coupling {
namespace {

TEST(Strays, AreTheParticlesDeeperThanASpacingInABodyThatIsWet) {
    geometry::ShapeSet shapes;
    body::BodySet bodies;
    body::BodyState state;
    const auto add = [&](const char* name, ShapeId shape, const Vec3& place) {
        body::NewBody body;
        body.name = name;
        body.material = MaterialId{0};
        body.density = 1000;
        body.drive = body::Drive::fixed;
        body.pose = {place, {}};
        body.parts = {{BodyId{}, shape, {}}};
        add_body(bodies, state, shapes, body);
    };
    add("floor", shapes.add_half_space({0, 0, 1}, 0), {});
    add("cube", shapes.add_convex(geometry::box({1, 1, 1})), {0, 0, 2});
    const std::vector<Vec3> particles{{5, 0, 0.05}, {5, 0, -0.05}, {5, 0, -0.3}, {0, 0, 2.1}, {0, 0, 1.55}, {0, 0, 3}};

    const Strays all = find_strays(shapes, bodies, state, {}, particles, 0.1);
    EXPECT_EQ(all.count, 2);
    EXPECT_EQ(all.body, BodyId{1});
    EXPECT_NEAR(all.depth, 0.4, 1e-12);
    const std::vector<std::uint8_t> is_dry{0, 1};
    const Strays wet = find_strays(shapes, bodies, state, is_dry, particles, 0.1);
    EXPECT_EQ(wet.count, 1);
    EXPECT_EQ(wet.body, BodyId{0});
}

}  // namespace
}  // namespace riprap::coupling
