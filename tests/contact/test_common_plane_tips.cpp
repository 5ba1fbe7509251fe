// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "contact/common_plane_support.hpp"

namespace riprap::contact {
namespace {

using namespace testing;

/// A pyramid whose tip is at the origin and looks along x, on a regular polygon.
geometry::Polyhedron spike(int sides, double half_angle) {
    std::vector<Vec3> points{{0, 0, 0}};
    for (int k = 0; k < sides; ++k) {
        const double angle = 2 * M_PI * k / sides;
        points.push_back(Vec3{-1, std::tan(half_angle) * std::cos(angle), std::tan(half_angle) * std::sin(angle)});
    }
    return geometry::convex_hull(points).value();
}

/// The plane of two tips that overlap along x, after a link; all turned.
CommonPlane plane_of_tips(const geometry::Polyhedron& one, const geometry::Polyhedron& other, double twist,
                          const Vec3& offset, const Quat& turned, PlaneKind before = PlaneKind::link) {
    const Quat back = from_rotation_vector({0, 0, M_PI}), twisted = from_rotation_vector({twist, 0, 0});
    const Hull a(one, {{}, turned}), b(other, {rotate(turned, offset), turned * twisted * back});
    CommonPlane plane = common_plane(a.view(), b.view(), {before, -1, -1}, 1);
    plane.normal = rotate_back(turned, plane.normal);
    return plane;
}

TEST(CommonPlane, of_aligned_tips_is_across_their_axis) {
    for (const Quat& turned : {Quat{}, from_rotation_vector({0.3, -0.5, 0.2})}) {
        for (const double twist : {0.0, 0.3, 1.0}) {
            for (const int sides : {3, 4, 5}) {
                for (const double half : {0.35, 0.6, 0.8}) {
                    const CommonPlane plane =
                        plane_of_tips(spike(sides, half), spike(sides, half), twist, {-0.01, 0, 0}, turned);
                    EXPECT_NEAR(plane.normal.x, 1, 1e-6) << sides << " " << half << " " << twist;
                    EXPECT_NEAR(plane.gap, -0.01, 1e-6);
                }
            }
            EXPECT_NEAR(plane_of_tips(spike(3, 0.4), spike(3, 0.7), twist, {-0.01, 0, 0}, turned).normal.x, 1, 1e-6);
        }
    }
}

TEST(CommonPlane, of_tips_that_pass_beside_each_other_is_a_face_or_a_pair_of_edges) {
    // Beside the axis by more than a millionth of the size one plane is better than all others.
    const CommonPlane plane = plane_of_tips(spike(4, 0.6), spike(4, 0.6), 0, {-0.01, 1e-4, 0.5e-4}, {});
    EXPECT_LT(plane.normal.x, 0.9);
    EXPECT_GT(plane.gap, -0.01 * std::cos(0.6));
    // And the face by which a pair has met already stays.
    const Quat back = from_rotation_vector({0, 0, M_PI});
    const Hull a(spike(4, 0.6), {}), b(spike(4, 0.6), {{-0.01, 0, 0}, back});
    for (std::int32_t f = 0; f < 5; ++f) {
        if (a.normals[static_cast<std::size_t>(f)].x > 0) {
            const Vec3 n = common_plane(a.view(), b.view(), {PlaneKind::face_a, f, -1}, 1).normal;
            EXPECT_GT(dot(n, a.normals[static_cast<std::size_t>(f)]), 1 - 1e-12);
        }
    }
}

TEST(CommonPlane, of_corners_is_across_their_diagonal_within_a_millionth_of_their_size) {
    const Hull a(geometry::cube(1), {});  // its size is sqrt(3)/2
    for (const double beside : {7e-7, 10e-7}) {
        const Hull b(geometry::cube(1), {{0.99, 0.99 + beside, 0.2}, {}});
        const Vec3 n = common_plane(a.view(), b.view(), {}, 1).normal;
        EXPECT_NEAR(n.x, beside < 8e-7 ? std::sqrt(0.5) : 0, 1e-9) << beside;
    }
}

TEST(CommonPlane, of_faces_that_meet_is_theirs_whether_they_were_linked_before_or_not) {
    const Hull a(geometry::cube(1), {}), b(geometry::cube(1), {{0.2, 0.1, 0.99}, {}});
    EXPECT_NEAR(common_plane(a.view(), b.view(), {PlaneKind::link, -1, -1}, 1).normal.z, 1, 1e-15);
}

}  // namespace
}  // namespace riprap::contact
