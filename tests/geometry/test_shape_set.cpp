// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/polyhedra/shape_set.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "geometry/random_shapes.hpp"
#include "riprap/geometry/polyhedra/shapes.hpp"

namespace riprap::geometry {
namespace {

/// Signed distance to the nearest plane, positive inside.
double depth(const ConvexView& view, const Vec3& x) {
    double least = std::numeric_limits<double>::infinity();
    for (int j = 0; j < view.face_count; ++j) {
        least = std::min(least, view.offset[j] - dot(view.normal(j), x));
    }
    return least;
}

bool is_aligned(const void* p) { return reinterpret_cast<std::uintptr_t>(p) % 64 == 0; }

/// Truncated octahedron: 14 faces, 24 vertices, as an average Voronoi block has (15.5 and 27 for random seeds).
Polyhedron voronoi_like_block() {
    Polyhedron shape;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double s : {-2.0, 2.0}) {
            for (const double t : {-1.0, 1.0}) {
                for (const bool second : {false, true}) {
                    Vec3 x{};
                    x[axis] = s;
                    x[(axis + (second ? 1 : 2)) % 3] = t;
                    shape.vertices.push_back(x);
                }
            }
        }
    }
    std::vector<Plane> planes;
    for (const double s : {-1.0, 1.0}) {
        planes.push_back({{s, 0, 0}, 2});
        planes.push_back({{0, s, 0}, 2});
        planes.push_back({{0, 0, s}, 2});
        for (const double t : {-1.0, 1.0}) {
            for (const double u : {-1.0, 1.0}) {
                planes.push_back({Vec3{s, t, u} / std::sqrt(3.0), std::sqrt(3.0)});
            }
        }
    }
    for (const Plane& plane : planes) {
        std::vector<std::int32_t> loop;
        Vec3 centre{};
        for (std::size_t i = 0; i < shape.vertices.size(); ++i) {
            if (std::abs(dot(plane.normal, shape.vertices[i]) - plane.offset) < 1e-12) {
                loop.push_back(static_cast<std::int32_t>(i));
                centre += shape.vertices[i];
            }
        }
        centre = centre / static_cast<double>(loop.size());
        const Vec3 u = normalized(shape.vertices[static_cast<std::size_t>(loop[0])] - centre);
        const Vec3 v = cross(plane.normal, u);
        std::sort(loop.begin(), loop.end(), [&](std::int32_t a, std::int32_t b) {
            const auto angle = [&](std::int32_t i) {
                const Vec3 x = shape.vertices[static_cast<std::size_t>(i)] - centre;
                return std::atan2(dot(v, x), dot(u, x));
            };
            return angle(a) < angle(b);
        });
        shape.faces.push_back(loop);
    }
    return shape;
}

TEST(ShapeSet, StoresAShapeAboutItsCentreOfMass) {
    ShapeSet shapes;
    Vec3 centroid{};
    const ShapeId id = shapes.add_convex(moved(box({2, 4, 6}), {{10, 20, 30}, {}}), false, &centroid);
    EXPECT_EQ(centroid, (Vec3{10, 20, 30}));
    const ConvexView view = shapes.view(id);
    EXPECT_EQ(view.vertex_count, 8);
    EXPECT_EQ(view.face_count, 6);
    EXPECT_EQ(shapes.volume(id), 48);
    EXPECT_EQ(view.inscribed_radius, 1);
    EXPECT_DOUBLE_EQ(view.circumradius, std::sqrt(14.0));
    EXPECT_EQ(depth(view, {0, 0, 0}), 1);
    EXPECT_EQ(depth(view, {0.75, 0, 0}), 0.25);
    EXPECT_EQ(depth(view, {0, 0, 4}), -1);
    EXPECT_DOUBLE_EQ(shapes.second_moment(id)(2, 2), 48 * 36 / 12.0);
    EXPECT_FALSE(shapes.is_half_space(id));
}

TEST(ShapeSet, PadsArraysToWholeLanesOnCacheLines) {
    ShapeSet shapes;
    std::vector<ShapeId> ids;
    for (int round = 0; round < 5; ++round) {
        ids.push_back(shapes.add_convex(regular_tetrahedron(1)));
        ids.push_back(shapes.add_half_space({0, 0, 1}, 0));
        ids.push_back(shapes.add_convex(prism(5, 1, 1).value()));
        ids.push_back(shapes.add_convex(icosahedron(1)));
    }
    for (const ShapeId id : ids) {
        const ConvexView view = shapes.view(id);
        for (const double* array : {view.vertex_x, view.vertex_y, view.vertex_z, view.normal_x, view.normal_y,
                                    view.normal_z, view.offset, view.fdem_weight}) {
            EXPECT_TRUE(is_aligned(array));
        }
        for (int i = view.vertex_count; i % shape_lanes != 0; ++i) {
            EXPECT_EQ(view.vertex(i), view.vertex(view.vertex_count - 1));
        }
        for (int j = view.face_count; j % shape_lanes != 0; ++j) {
            EXPECT_EQ(view.normal(j), view.normal(view.face_count - 1));
            EXPECT_EQ(view.offset[j], view.offset[view.face_count - 1]);
            EXPECT_EQ(view.is_internal[j], view.is_internal[view.face_count - 1]);
        }
    }
}

TEST(ShapeSet, EveryVertexLiesOnItsFacesAndBelowAllOthers) {
    std::mt19937_64 random(21);
    ShapeSet shapes;
    for (int trial = 0; trial < 100; ++trial) {
        const ConvexView view = shapes.view(shapes.add_convex(testing::random_block(random, 12)));
        for (int i = 0; i < view.vertex_count; ++i) {
            EXPECT_NEAR(depth(view, view.vertex(i)), 0, 1e-14);
        }
        for (int j = 0; j < view.face_count; ++j) {
            EXPECT_NEAR(norm(view.normal(j)), 1, 1e-15);
            for (int k = view.face_start[j]; k < view.face_start[j + 1]; ++k) {
                EXPECT_NEAR(view.offset[j] - dot(view.normal(j), view.vertex(view.face_vertex[k])), 0, 1e-14);
            }
        }
    }
}

TEST(ShapeSet, FdemWeightsOfATetrahedronAreItsInverseAltitudes) {
    ShapeSet shapes;
    const Polyhedron t = tetrahedron({0, 0, 0}, {3, 0, 0}, {0, 2, 0}, {0, 0, 1}).value();
    const ShapeId id = shapes.add_convex(t);
    const ConvexView view = shapes.view(id);
    for (int j = 0; j < 4; ++j) {  // H = 3 V / S
        const double area = norm(vector_area(t.vertices, t.faces[static_cast<std::size_t>(j)]));
        EXPECT_NEAR(view.fdem_weight[j], area / (3 * shapes.volume(id)), 1e-14);
    }
    // Regular: H = 4 r, so that the FDEM field is a quarter of the distance potential.
    const ConvexView regular = shapes.view(shapes.add_convex(regular_tetrahedron(1)));
    EXPECT_NEAR(regular.fdem_weight[0] * 4 * regular.inscribed_radius, 1, 1e-14);
}

TEST(ShapeSet, AreaTensorHasTheSurfaceAsTrace) {
    ShapeSet shapes;
    const ShapeId id = shapes.add_convex(box({1, 2, 3}));
    const Mat3 exact = Mat3::diagonal({12, 6, 4});  // 2 b c, 2 a c, 2 a b
    EXPECT_EQ(shapes.area_tensor(id), exact);
}

TEST(ShapeSet, APlanarPrismCarriesItsFieldOnItsSides) {
    ShapeSet shapes;
    const std::vector<Point2> corners{{0, 0}, {30, 0}, {0, 40}};
    Vec3 centroid{};
    const ShapeId id = shapes.add_convex(extruded_polygon(corners, -0.5, 0.5).value(), true, &centroid);
    EXPECT_EQ(centroid.z, 0);  // to the bit: nothing may push a planar body out of its plane
    const ConvexView view = shapes.view(id);
    ASSERT_EQ(view.face_count, 5);
    int internal = 0;
    for (int j = 0; j < 5; ++j) {
        EXPECT_EQ(view.is_internal[j] != 0, std::abs(view.normal_z[j]) == 1);
        internal += view.is_internal[j];
    }
    EXPECT_EQ(internal, 2);
    EXPECT_NEAR(view.inscribed_radius, 10, 1e-13);
    EXPECT_EQ(shapes.area_tensor(id)(2, 2), 0);
    EXPECT_EQ(shapes.polyhedron(id).is_internal.size(), 5U);
}

TEST(ShapeSet, APartWithAnInternalFaceMeasuresDepthFromTheOthers) {
    // Left half of a 2 x 4 x 4 block: seen from its five outer faces the deepest point is on the cut, 1 deep.
    Polyhedron half = moved(box({1, 4, 4}), {{-0.5, 0, 0}, {}});
    half.is_internal.assign(6, 0);
    for (std::size_t j = 0; j < 6; ++j) {
        half.is_internal[j] = face_plane(half.vertices, half.faces[j]).normal.x > 0.5 ? 1 : 0;
    }
    ShapeSet shapes;
    EXPECT_EQ(shapes.view(shapes.add_convex(half)).inscribed_radius, 1);
    half.is_internal.assign(6, 1);
    EXPECT_EQ(shapes.view(shapes.add_convex(half)).inscribed_radius, 0.5);
}

TEST(ShapeSet, AHalfSpaceIsOnePlane) {
    ShapeSet shapes;
    const ShapeId id = shapes.add_half_space({0, 3, 4}, 10);
    const ConvexView view = shapes.view(id);
    EXPECT_TRUE(shapes.is_half_space(id));
    EXPECT_EQ(view.vertex_count, 0);
    EXPECT_EQ(view.face_count, 1);
    EXPECT_EQ(view.face_start[0], view.face_start[1]);
    EXPECT_DOUBLE_EQ(view.normal_y[0], 0.6);
    EXPECT_DOUBLE_EQ(view.normal_z[0], 0.8);
    EXPECT_DOUBLE_EQ(view.offset[0], 2);
    EXPECT_EQ(view.inscribed_radius, std::numeric_limits<double>::infinity());
    EXPECT_EQ(shapes.volume(id), 0);
    EXPECT_TRUE(shapes.polyhedron(id).faces.empty());
}

TEST(ShapeSet, GivesBackTheSamePolyhedron) {
    std::mt19937_64 random(22);
    ShapeSet shapes;
    const Polyhedron block = testing::random_block(random, 15);
    shapes.add_convex(cube(1));
    Vec3 centroid{};
    const ShapeId id = shapes.add_convex(block, false, &centroid);
    const Polyhedron back = shapes.polyhedron(id);
    ASSERT_EQ(back.faces, block.faces);
    EXPECT_TRUE(back.is_internal.empty());
    for (std::size_t i = 0; i < block.vertices.size(); ++i) {
        EXPECT_EQ(back.vertices[i], block.vertices[i] - centroid);
    }
}

TEST(ShapeSet, AUniqueVoronoiBlockTakesUnderTwoKilobytes) {
    ShapeSet shapes;
    const Polyhedron block = voronoi_like_block();
    ASSERT_EQ(block.vertices.size(), 24U);
    ASSERT_EQ(block.faces.size(), 14U);
    constexpr std::size_t count = 1000;
    for (std::size_t i = 0; i < count; ++i) {
        shapes.add_convex(block);
    }
    EXPECT_LT(shapes.bytes() / count, 4000U);  // with the unused capacity of growth
    shapes.shrink_to_fit();
    std::printf("ShapeSet: %zu bytes for a block of 14 faces, 24 vertices\n", shapes.bytes() / count);
    EXPECT_LT(shapes.bytes() / count, 2000U);
    EXPECT_TRUE(is_aligned(shapes.view({500}).offset));
}

}  // namespace
}  // namespace riprap::geometry
