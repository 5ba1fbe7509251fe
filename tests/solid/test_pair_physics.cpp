// SPDX-License-Identifier: Apache-2.0
// The physics of contact is chosen by the kinds of the two bodies; a pair without a physics is refused.
#include "riprap/solid/pair_physics.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "riprap/body/body_set.hpp"
#include "riprap/core/index.hpp"
#include "riprap/geometry/polyhedra/shapes.hpp"
#include "riprap/solid/explicit_dda/explicit_dda.hpp"
#include "riprap/solid/polyhedral_dem/polyhedral_dem.hpp"
#include "riprap/solid/sphere_dem/sphere_dem.hpp"

namespace riprap::solid {
namespace {

using enum BodyKind;

/// Bodies of given kinds, of which some may move.
struct Scene {
    geometry::ShapeSet shapes;
    body::BodySet bodies;
    body::BodyState state;
    std::vector<BodyKind> kinds;

    void add(BodyKind kind, bool may_move) {
        body::NewBody body;
        body.name = "body";
        body.material = MaterialId{0};
        body.density = 1000;
        body.drive = may_move ? body::Drive::free : body::Drive::fixed;
        body.parts.push_back({{}, shapes.add_convex(geometry::cube(1)), {}});
        add_body(bodies, state, shapes, body);
        kinds.push_back(kind);
    }
};

TEST(PairPhysics, OfSpheresAnswersEveryPairOfKinds) {
    for (const BodyKind a : {faces, spheres}) {
        for (const BodyKind b : {faces, spheres}) {
            EXPECT_TRUE(answers(pairs_of<SphereDem>(), a, b));
            EXPECT_EQ(answers(pairs_of<PolyhedralDem>(), a, b), a == faces && b == faces);
            EXPECT_EQ(answers(pairs_of<ExplicitDda>(), a, b), a == faces && b == faces);
        }
    }
}

TEST(PairPhysics, NamesTheFirstBodyOfAPairThatNobodyAnswers) {
    Scene scene;
    scene.add(faces, false);
    scene.add(faces, true);
    EXPECT_TRUE(unanswered_bodies(scene.bodies, scene.kinds, pairs_of<PolyhedralDem>()).empty());
    scene.add(spheres, false);
    scene.add(spheres, false);
    const auto found = unanswered_bodies(scene.bodies, scene.kinds, pairs_of<PolyhedralDem>());
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].body, BodyId{2});
    EXPECT_EQ(found[0].kind, spheres);
    EXPECT_THAT(found[0].others, testing::ElementsAre(faces));  // two fixed bodies never meet
    EXPECT_TRUE(unanswered_bodies(scene.bodies, scene.kinds, pairs_of<SphereDem>()).empty());
}

TEST(PairPhysics, LetsFixedBodiesBe) {
    Scene scene;
    scene.add(faces, false);
    scene.add(spheres, false);
    EXPECT_TRUE(unanswered_bodies(scene.bodies, scene.kinds, {}).empty());
}

}  // namespace
}  // namespace riprap::solid
