// SPDX-License-Identifier: Apache-2.0
// Blocks that fill one layer, such as prisms of a planar scene, meet by their sides however deep they are in.
#include <gtest/gtest.h>

#include <cmath>

#include "contact/common_plane_support.hpp"
#include "riprap/solid/affine/layer_plane.hpp"

namespace riprap::solid::affine {
namespace {

using contact::testing::Hull;
using geometry::box;

constexpr double wide = 1e9;

Quat turned(double angle) { return from_rotation_vector({0, 0, angle}); }

TEST(LayerPlane, sections_in_by_more_than_the_layer_is_thick_meet_by_their_sides) {
    const Hull a(box({400, 400, 1}), {{}, {}});
    for (const double overlap : {0.5, 0.9, 1.1, 9.0, 40.0}) {
        const Hull b(box({400, 400, 1}), {{400 - overlap, 30, 0}, {}});
        const contact::CommonPlane plane = plane_between(a.view(), b.view(), {}, 1);
        EXPECT_NEAR(plane.normal.x, 1, 1e-12) << overlap;
        EXPECT_NEAR(plane.gap, -overlap, 1e-9) << overlap;
        const contact::CommonPlane next = plane_between(a.view(), b.view(), plane.feature, 1);
        EXPECT_NEAR(next.normal.x, 1, 1e-12) << overlap;
        const contact::CommonPlane back = plane_between(b.view(), a.view(), {}, 1);
        EXPECT_NEAR(back.normal.x, -1, 1e-12) << overlap;
    }
}

TEST(LayerPlane, that_holds_for_corners_and_for_layers_that_strain_has_made_a_little_unlike) {
    const Hull floor(box({1000, 500, 1}), {{0, -250, 0}, {}});
    for (const double angle : {0.2, M_PI / 4, 1.1}) {
        const double reach = 100 * (std::sin(angle) + std::cos(angle));
        for (const double thick : {0.999, 1.0, 1.001}) {
            const Hull b(box({200, 200, thick}), {{20, reach - 3, 0}, turned(angle)});
            const contact::CommonPlane plane = plane_between(floor.view(), b.view(), {}, 1);
            EXPECT_NEAR(plane.normal.y, 1, 1e-9) << angle << ' ' << thick;
            EXPECT_NEAR(plane.gap, -3, 1e-9) << angle << ' ' << thick;
        }
    }
}

TEST(LayerPlane, a_block_that_lies_on_a_plate_meets_its_face) {
    const Hull plate(box({4, 4, 0.1}), {{}, {}});
    for (const double overlap : {0.001, 0.04, 0.09}) {
        const Hull b(box({1, 1, 0.1}), {{0.3, 0, 0.1 - overlap}, {}});
        const contact::CommonPlane plane = plane_between(plate.view(), b.view(), {}, wide);
        EXPECT_NEAR(plane.normal.z, 1, 1e-12) << overlap;
        EXPECT_NEAR(plane.gap, -overlap, 1e-12) << overlap;
    }
}

}  // namespace
}  // namespace riprap::solid::affine
