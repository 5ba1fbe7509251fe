// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/polyhedra/polyhedron.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/random_shapes.hpp"
#include "riprap/geometry/polyhedra/merge_faces.hpp"
#include "riprap/geometry/polyhedra/shapes.hpp"

namespace riprap::geometry {
namespace {

void expect_near(const Mat3& value, const Mat3& exact, double tolerance) {
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            EXPECT_NEAR(value(i, j), exact(i, j), tolerance) << "entry " << i << ',' << j;
        }
    }
}

/// R S R^T.
Mat3 turned(const Mat3& s, const Quat& q) {
    const Mat3 r = to_matrix(q);
    return r * s * transpose(r);
}

struct NamedShape {
    const char* name;
    Polyhedron shape;
    double volume;         // closed form
    double second_moment;  // trace / 3 of the second moments about the centroid, closed form; < 0: not isotropic
};

std::vector<NamedShape> regular_solids() {
    const double phi = std::numbers::phi;
    // Second moments of regular solids of edge 1: a Platonic solid is isotropic, integral of x^2 dV = V k.
    return {
        {"cube", cube(1), 1, 1.0 / 12},
        {"tetrahedron", regular_tetrahedron(1), 1 / (6 * std::sqrt(2.0)), 1 / (6 * std::sqrt(2.0)) / 40},
        {"octahedron", octahedron(1), std::sqrt(2.0) / 3, std::sqrt(2.0) / 3 / 20},
        {"icosahedron", icosahedron(1), 5 * (3 + std::sqrt(5.0)) / 12, 5 * (3 + std::sqrt(5.0)) / 12 * phi * phi / 20},
        {"dodecahedron", dodecahedron(1), (15 + 7 * std::sqrt(5.0)) / 4,
         (15 + 7 * std::sqrt(5.0)) / 4 * (95 + 39 * std::sqrt(5.0)) / 600}};
}

TEST(MassProperties, OfRegularSolidsAreTheClosedForms) {
    for (const NamedShape& solid : regular_solids()) {
        SCOPED_TRACE(solid.name);
        const MassProperties mass = mass_properties(solid.shape);
        EXPECT_NEAR(mass.volume, solid.volume, 1e-14 * solid.volume);
        EXPECT_NEAR(norm(mass.centroid), 0, 1e-15);
        expect_near(mass.second_moment, solid.second_moment * Mat3::identity(), 1e-14 * solid.second_moment * 4);
    }
}

TEST(MassProperties, OfABoxAreExactEvenFarFromTheOrigin) {
    const Vec3 size{2, 3, 5}, centre{1e6, -2e6, 3e6};
    const MassProperties mass = mass_properties(moved(box(size), {centre, {}}));
    EXPECT_EQ(mass.volume, 30);
    EXPECT_EQ(mass.centroid, centre);
    expect_near(mass.second_moment, Mat3::diagonal({30 * 4 / 12.0, 30 * 9 / 12.0, 30 * 25 / 12.0}), 1e-13);
    const Mat3 inertia = inertia_from_second_moment(mass.second_moment);
    expect_near(inertia, Mat3::diagonal({30 * 34 / 12.0, 30 * 29 / 12.0, 30 * 13 / 12.0}), 1e-13);
}

TEST(MassProperties, OfACornerTetrahedronAreTheTextbookIntegrals) {
    // Corner (0,0,0), (a,0,0), (0,b,0), (0,0,c): integral of x^2 = V a^2/10, of x y = V a b/20, about the corner.
    const Vec3 s{1, 2, 4};
    const auto corner = tetrahedron({0, 0, 0}, {s.x, 0, 0}, {0, s.y, 0}, {0, 0, s.z});
    const MassProperties mass = mass_properties(corner.value());
    const double volume = s.x * s.y * s.z / 6;
    EXPECT_NEAR(mass.volume, volume, 1e-15);
    EXPECT_NEAR(norm(mass.centroid - s / 4.0), 0, 1e-15);
    Mat3 exact = volume * (outer(s, s) - Mat3::diagonal({s.x * s.x, s.y * s.y, s.z * s.z}));
    exact = (1.0 / 20) * exact + (volume / 10) * Mat3::diagonal({s.x * s.x, s.y * s.y, s.z * s.z});
    expect_near(mass.second_moment, exact - volume * outer(s / 4.0, s / 4.0), 1e-14);
}

TEST(MassProperties, OfAConcaveSolidAreThoseOfItsConvexParts) {
    // An L of two boxes sharing a face, as one surface; faces of the notch are plane but the L faces are not convex.
    const Polyhedron l{{{0, 0, 0},
                        {2, 0, 0},
                        {2, 1, 0},
                        {1, 1, 0},
                        {1, 3, 0},
                        {0, 3, 0},
                        {0, 0, 1},
                        {2, 0, 1},
                        {2, 1, 1},
                        {1, 1, 1},
                        {1, 3, 1},
                        {0, 3, 1}},
                       {{5, 4, 3, 2, 1, 0},
                        {6, 7, 8, 9, 10, 11},
                        {0, 1, 7, 6},
                        {1, 2, 8, 7},
                        {2, 3, 9, 8},
                        {3, 4, 10, 9},
                        {4, 5, 11, 10},
                        {5, 0, 6, 11}},
                       {}};
    const MassProperties whole = mass_properties(l);
    const Vec3 c1{1, 0.5, 0.5}, c2{0.5, 2, 0.5};  // 2x1x1 and 1x2x1
    const Vec3 centre = 0.5 * (c1 + c2);
    EXPECT_NEAR(whole.volume, 4, 1e-14);
    EXPECT_NEAR(norm(whole.centroid - centre), 0, 1e-15);
    const Mat3 parts = mass_properties(box({2, 1, 1})).second_moment + mass_properties(box({1, 2, 1})).second_moment +
                       2.0 * (outer(c1 - centre, c1 - centre) + outer(c2 - centre, c2 - centre));
    expect_near(whole.second_moment, parts, 1e-14);
}

TEST(MassProperties, TurnAndShiftWithTheBody) {
    std::mt19937_64 random(1);
    for (int trial = 0; trial < 200; ++trial) {
        const Polyhedron block = testing::random_block(random, 6 + trial % 8);
        const Pose pose{3.0 * testing::random_point(random), testing::random_orientation(random)};
        const MassProperties before = mass_properties(block), after = mass_properties(moved(block, pose));
        ASSERT_GT(before.volume, 0);
        EXPECT_NEAR(after.volume, before.volume, 1e-12 * before.volume);
        EXPECT_NEAR(norm(after.centroid - to_world(pose, before.centroid)), 0, 1e-12);
        expect_near(after.second_moment, turned(before.second_moment, pose.orientation),
                    1e-12 * trace(before.second_moment));
    }
}

TEST(MassProperties, OfAnInsideOutSurfaceHaveNegativeVolume) {
    Polyhedron shape = cube(1);
    for (auto& loop : shape.faces) {
        std::reverse(loop.begin(), loop.end());
    }
    EXPECT_EQ(mass_properties(shape).volume, -1);
}

TEST(VectorAreas, OfAClosedSurfaceSumToZeroAndGiveTheVolume) {
    std::mt19937_64 random(2);
    for (int trial = 0; trial < 200; ++trial) {
        const Polyhedron block = testing::random_block(random, 12, {1, 0.5, 2});
        Vec3 sum{};
        double three_volumes = 0;
        for (const auto& loop : block.faces) {
            const Vec3 area = vector_area(block.vertices, loop);
            sum += area;
            three_volumes += face_plane(block.vertices, loop).offset * norm(area);  // integral of div x dV
        }
        EXPECT_NEAR(norm(sum), 0, 1e-14);
        EXPECT_NEAR(three_volumes / 3, mass_properties(block).volume, 1e-13);
    }
}

Polyhedron triangulated(const Polyhedron& shape) {
    Polyhedron result{shape.vertices, {}, {}};
    for (const auto& loop : shape.faces) {
        for (std::size_t k = 2; k < loop.size(); ++k) {
            result.faces.push_back({loop[0], loop[k - 1], loop[k]});
        }
    }
    return result;
}

TEST(MergeCoplanarFaces, GivesBackThePolygonsOfATriangulatedSolid) {
    std::mt19937_64 random(3);
    for (const NamedShape& solid : regular_solids()) {
        SCOPED_TRACE(solid.name);
        const Polyhedron turned_solid =
            moved(solid.shape, {testing::random_point(random), testing::random_orientation(random)});
        const Polyhedron merged = merge_coplanar_faces(triangulated(turned_solid));
        EXPECT_EQ(merged.vertices.size(), solid.shape.vertices.size());
        ASSERT_EQ(merged.faces.size(), solid.shape.faces.size());
        EXPECT_EQ(merged.faces[0].size(), solid.shape.faces[0].size());
        EXPECT_NEAR(mass_properties(merged).volume, solid.volume, 1e-13 * solid.volume);
    }
}

TEST(MergeCoplanarFaces, DropsCornersInsideAnEdgeAndUnusedVertices) {
    // A unit cube whose edge 0-1 has a point in the middle and whose bottom is cut in two there; one vertex is spare.
    Polyhedron shape = cube(1);
    shape.vertices.push_back({9, 9, 9});
    shape.vertices.push_back({0, -0.5, -0.5});
    shape.faces[0] = {3, 2, 9};
    shape.faces.push_back({2, 1, 9});
    shape.faces.push_back({0, 3, 9});
    for (auto& loop : shape.faces) {
        if (loop == std::vector<std::int32_t>{0, 1, 5, 4}) {
            loop = {0, 9, 1, 5, 4};
        }
    }
    ASSERT_EQ(mass_properties(shape).volume, 1);
    const Polyhedron merged = merge_coplanar_faces(shape);
    EXPECT_EQ(merged.vertices.size(), 8U);
    EXPECT_EQ(merged.faces.size(), 6U);
    for (const auto& loop : merged.faces) {
        EXPECT_EQ(loop.size(), 4U);
    }
    EXPECT_EQ(mass_properties(merged).volume, 1);
}

TEST(MergeCoplanarFaces, KeepsAnInternalFaceApartFromItsNeighbours) {
    Polyhedron shape = triangulated(cube(1));
    shape.is_internal.assign(12, 0);
    shape.is_internal[0] = 1;
    const Polyhedron merged = merge_coplanar_faces(shape);
    EXPECT_EQ(merged.faces.size(), 7U);
    EXPECT_EQ(std::count(merged.is_internal.begin(), merged.is_internal.end(), 1), 1);
}

TEST(MergeCoplanarFaces, KeepsFacesThatBendByMoreThanRoundOff) {
    Polyhedron shape = triangulated(cube(1));
    shape.vertices[6] += Vec3{1e-7, 1e-7, 1e-7};
    EXPECT_EQ(merge_coplanar_faces(shape).faces.size(), 9U);
}

}  // namespace
}  // namespace riprap::geometry
