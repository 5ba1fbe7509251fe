// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/polyhedra/voronoi.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/sample_surfaces.hpp"
#include "riprap/geometry/polyhedra/clip.hpp"

namespace riprap::geometry {
namespace {

TEST(Voronoi, VolumesOfTheBlocksAddUpToTheBox) {
    const auto blocks = voronoi_blocks(sample_box({-1, 0, 2}, {2, 5, 3}), {.block_count = 500, .seed = 7});
    ASSERT_TRUE(blocks);
    EXPECT_EQ(blocks.value().size(), 500u);
    EXPECT_NEAR(total_volume(blocks.value()), 15.0, 15.0 * 1e-12);
}

TEST(Voronoi, VolumesOfTheBlocksAddUpToAnyConvexRegion) {
    Polyhedron region = sample_box({0, 0, 0}, {4, 3, 2});
    region = clip_convex(region, {normalized(Vec3{1, 1, 1}), 4.0});
    region = clip_convex(region, {normalized(Vec3{-1, 0.3, 0.9}), 0.4});
    const double volume = mass_properties(region).volume;
    const auto blocks = voronoi_blocks(region, {.block_count = 300, .seed = 1, .lloyd_iterations = 2});
    ASSERT_TRUE(blocks);
    EXPECT_NEAR(total_volume(blocks.value()), volume, volume * 1e-12);
}

TEST(Voronoi, EveryBlockHoldsExactlyWhatIsNearestToItsPoint) {
    const Polyhedron region = sample_box({0, 0, 0}, {1, 1, 1});
    const auto points = random_points(region, 60, 3);
    const auto blocks = voronoi_cells(region, points, 0.0);
    ASSERT_TRUE(blocks);
    for (const Vec3& x : random_points(region, 2000, 4)) {
        std::size_t nearest = 0;
        for (std::size_t i = 1; i < points.size(); ++i) {
            nearest = norm_squared(points[i] - x) < norm_squared(points[nearest] - x) ? i : nearest;
        }
        const Polyhedron& block = blocks.value()[nearest];
        for (const auto& face : block.faces) {
            const Plane plane = face_plane(block.vertices, face);
            ASSERT_LE(dot(plane.normal, x), plane.offset + 1e-12);
        }
    }
}

TEST(Voronoi, TheSameSeedGivesTheSameBlocksAndAnotherSeedOthers) {
    const Polyhedron region = sample_box({0, 0, 0}, {1, 2, 1});
    const auto first = voronoi_blocks(region, {.block_count = 50, .seed = 5, .lloyd_iterations = 1});
    const auto again = voronoi_blocks(region, {.block_count = 50, .seed = 5, .lloyd_iterations = 1});
    const auto other = voronoi_blocks(region, {.block_count = 50, .seed = 6, .lloyd_iterations = 1});
    ASSERT_TRUE(first && again && other);
    for (std::size_t i = 0; i < 50; ++i) {
        EXPECT_EQ(first.value()[i].vertices, again.value()[i].vertices);
    }
    EXPECT_NE(first.value()[0].vertices, other.value()[0].vertices);
}

TEST(Voronoi, LloydIterationsMakeTheBlocksMoreAlike) {
    const auto spread = [](int iterations) {
        const auto blocks = voronoi_blocks(sample_box({0, 0, 0}, {1, 1, 1}),
                                           {.block_count = 200, .seed = 2, .lloyd_iterations = iterations});
        double sum = 0.0;
        for (const Polyhedron& block : blocks.value()) {
            const double excess = mass_properties(block).volume * 200.0 - 1.0;
            sum += excess * excess;
        }
        return std::sqrt(sum / 200.0);
    };
    EXPECT_NEAR(spread(0), 0.42, 0.08) << "a Poisson-Voronoi cell has a volume scatter of 0.42, less at the walls";
    EXPECT_LT(spread(5), 0.5 * spread(0));
}

TEST(Voronoi, AGapLeavesJointsOfThatWidth) {
    const Polyhedron region = sample_box({0, 0, 0}, {2, 1, 1});
    const std::vector<Vec3> points{{0.5, 0.5, 0.5}, {1.5, 0.5, 0.5}};
    const auto blocks = voronoi_cells(region, points, 0.1);
    ASSERT_TRUE(blocks);
    EXPECT_NEAR(range_along(blocks.value()[0], {1, 0, 0}).high, 0.95, 1e-15);
    EXPECT_NEAR(range_along(blocks.value()[1], {1, 0, 0}).low, 1.05, 1e-15);
    EXPECT_NEAR(range_along(blocks.value()[0], {1, 0, 0}).low, 0.0, 0.0) << "the boundary stays";
}

TEST(Voronoi, RefusesWhatCannotBe) {
    const Polyhedron region = sample_box({0, 0, 0}, {1, 1, 1});
    EXPECT_FALSE(voronoi_blocks(region, {.block_count = 0}));
    EXPECT_FALSE(voronoi_blocks(region, {.block_count = 1'000'000'000}));
    EXPECT_FALSE(voronoi_blocks(region, {.block_count = 10, .gap = -1.0}));
    EXPECT_FALSE(voronoi_blocks(region, {.block_count = 100, .gap = 0.5})) << "nothing would be left of the blocks";
    EXPECT_FALSE(voronoi_blocks({}, {.block_count = 10}));
    const std::vector<Vec3> twice{{0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}}, outside{{0.5, 0.5, 1.5}};
    EXPECT_FALSE(voronoi_cells(region, twice, 0.0));
    EXPECT_FALSE(voronoi_cells(region, outside, 0.0));
}

}  // namespace
}  // namespace riprap::geometry
