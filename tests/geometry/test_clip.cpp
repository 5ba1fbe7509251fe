// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/polyhedra/clip.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "geometry/sample_surfaces.hpp"
#include "riprap/geometry/polyhedra/random_bits.hpp"

namespace riprap::geometry {
namespace {

Vec3 random_direction(std::uint64_t key) {
    const double z = 2.0 * unit_interval(mix_bits(key, 1)) - 1.0,
                 turn = 6.283185307179586 * unit_interval(mix_bits(key, 2));
    const double r = std::sqrt(1.0 - z * z);
    return {r * std::cos(turn), r * std::sin(turn), z};
}

/// Every directed edge has exactly one opposite: the surface is closed and oriented.
bool is_closed(const Polyhedron& p) {
    std::map<std::pair<int, int>, int> edges;
    for (const auto& face : p.faces) {
        for (std::size_t k = 0; k < face.size(); ++k) {
            ++edges[{face[k], face[(k + 1) % face.size()]}];
        }
    }
    for (const auto& [edge, count] : edges) {
        if (count != 1 || !edges.contains({edge.second, edge.first})) {
            return false;
        }
    }
    return !edges.empty();
}

TEST(Clip, ACubeCutInTheMiddleGivesTwoBoxesOfSixFaces) {
    const CutPieces pieces = cut_convex(sample_box({0, 0, 0}, {2, 2, 2}), {{1, 0, 0}, 0.5});
    ASSERT_TRUE(pieces.is_cut());
    EXPECT_EQ(pieces.below.faces.size(), 6u);
    EXPECT_EQ(pieces.above.faces.size(), 6u);
    EXPECT_EQ(pieces.below.vertices.size(), 8u);
    EXPECT_DOUBLE_EQ(mass_properties(pieces.below).volume, 2.0);
    EXPECT_DOUBLE_EQ(mass_properties(pieces.above).volume, 6.0);
    const Vec3 cap_area = vector_area(pieces.below.vertices, pieces.below.faces.back());
    EXPECT_EQ(cap_area, (Vec3{4, 0, 0})) << "the cut winds outward";
    EXPECT_EQ(vector_area(pieces.above.vertices, pieces.above.faces.back()), (Vec3{-4, 0, 0}));
}

TEST(Clip, ACutThroughFourVerticesMakesTwoWedgesAndNoNewVertex) {
    const double s = std::sqrt(0.5);
    const CutPieces pieces = cut_convex(sample_box({0, 0, 0}, {1, 1, 1}), {{s, -s, 0}, 0.0});
    ASSERT_TRUE(pieces.is_cut());
    EXPECT_EQ(pieces.below.vertices.size(), 6u);
    EXPECT_EQ(pieces.below.faces.size(), 5u);
    EXPECT_TRUE(is_closed(pieces.below));
    EXPECT_TRUE(is_closed(pieces.above));
    EXPECT_NEAR(mass_properties(pieces.below).volume, 0.5, 1e-15);
}

TEST(Clip, AFaceInThePlaneIsNoCut) {
    const Polyhedron cube = sample_box({0, 0, 0}, {1, 1, 1});
    const CutPieces below = cut_convex(cube, {{0, 0, 1}, 1.0});
    EXPECT_EQ(below.below.faces, cube.faces);
    EXPECT_TRUE(below.above.faces.empty());
    const CutPieces above = cut_convex(cube, {{0, 0, 1}, 0.0});
    EXPECT_TRUE(above.below.faces.empty());
    EXPECT_EQ(above.above.faces, cube.faces);
}

TEST(Clip, RandomCutsOfCutsConserveVolumeAndStayClosed) {
    std::vector<Polyhedron> pieces{sample_box({-1, -2, -0.5}, {2, 1, 1.5})};
    for (std::uint64_t i = 0; i < 60; ++i) {
        const Vec3 normal = random_direction(mix_bits(1, i));
        const double offset = 1.2 * unit_interval(mix_bits(2, i)) - 0.6;
        std::vector<Polyhedron> next;
        for (const Polyhedron& piece : pieces) {
            CutPieces halves = cut_convex(piece, {normal, offset});
            const double whole = mass_properties(piece).volume;
            if (halves.is_cut()) {
                ASSERT_TRUE(is_closed(halves.below) && is_closed(halves.above));
                const double below = mass_properties(halves.below).volume, above = mass_properties(halves.above).volume;
                ASSERT_GT(below, 0.0);
                ASSERT_GT(above, 0.0);
                // A piece this thin against its size carries round-off of its size, not of its volume.
                const double scale = length_scale(piece.vertices);
                ASSERT_NEAR(below + above, whole, 1e-14 * scale * scale * scale);
            }
            for (Polyhedron* half : {&halves.below, &halves.above}) {
                if (!half->faces.empty()) {
                    next.push_back(std::move(*half));
                }
            }
        }
        pieces = std::move(next);
    }
    EXPECT_GT(pieces.size(), 5000u);
    EXPECT_NEAR(total_volume(pieces), 18.0, 18.0 * 1e-14 * 10.0);
}

TEST(Clip, APlaneThroughAVertexWithinRoundOffNeverBreaksTheSurface) {
    const Polyhedron cube = sample_box({0.1, 0.2, 0.3}, {1.1, 1.2, 1.3});
    for (std::uint64_t i = 0; i < 2000; ++i) {
        const Vec3 normal = random_direction(i);
        const Vec3& corner = cube.vertices[i % 8];
        const double nudge = (unit_interval(mix_bits(i, 7)) - 0.5) * 4e-12;
        const CutPieces pieces = cut_convex(cube, {normal, dot(normal, corner) + nudge});
        double sum = 0.0;
        for (const Polyhedron* piece : {&pieces.below, &pieces.above}) {
            if (!piece->faces.empty()) {
                ASSERT_TRUE(is_closed(*piece));
                sum += mass_properties(*piece).volume;
            }
        }
        ASSERT_NEAR(sum, 1.0, 1e-11);
    }
}

TEST(Clip, InternalFacesStayInternalAndTheCutIsNot) {
    Polyhedron cube = sample_box({0, 0, 0}, {1, 1, 1});
    cube.is_internal = {0, 0, 0, 0, 1, 1};
    const CutPieces pieces = cut_convex(cube, {{1, 0, 0}, 0.5});
    EXPECT_EQ(pieces.below.is_internal, (std::vector<std::uint8_t>{0, 0, 0, 1, 1, 0}));
    EXPECT_EQ(pieces.above.is_internal, (std::vector<std::uint8_t>{0, 0, 0, 1, 1, 0}));
}

}  // namespace
}  // namespace riprap::geometry
