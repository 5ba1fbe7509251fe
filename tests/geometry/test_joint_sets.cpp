// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/polyhedra/joint_sets.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "geometry/sample_surfaces.hpp"
#include "riprap/geometry/polyhedra/clip.hpp"

namespace riprap::geometry {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

TEST(JointSets, NormalAndSteepestLineFollowTheCompass) {
    const Vec3 east = joint_normal(30.0 * degree, 90.0 * degree);  // dips 30 degrees towards east, +x
    EXPECT_NEAR(east.x, 0.5, 1e-15);
    EXPECT_NEAR(east.y, 0.0, 1e-15);
    EXPECT_NEAR(east.z, std::sqrt(0.75), 1e-15);
    EXPECT_NEAR(dot(east, Vec3{std::cos(30.0 * degree), 0.0, -std::sin(30.0 * degree)}), 0.0, 1e-15);
    const Vec3 north = joint_normal(90.0 * degree, 0.0);  // a vertical joint that strikes east-west
    EXPECT_NEAR(north.y, 1.0, 1e-15);
    const Vec3 flat = joint_normal(0.0, 77.0 * degree);
    EXPECT_EQ(flat.z, 1.0);
}

TEST(JointSets, ThreeOrthogonalSetsCutABoxIntoBricks) {
    const std::vector<JointSet> sets{{.normal = {1, 0, 0}, .spacing = 0.5, .offset = 0.25},
                                     {.normal = {0, 1, 0}, .spacing = 1.0},
                                     {.normal = {0, 0, 1}, .spacing = 0.25}};
    const auto rock = cut_by_joint_sets(sample_box({0, 0, 0}, {1, 2, 1}), sets, {});
    ASSERT_TRUE(rock);
    EXPECT_EQ(rock.value().blocks.size(), 3u * 2u * 4u) << "joints in the faces of the region cut nothing";
    EXPECT_EQ(rock.value().joint_count, 2 + 1 + 3);
    EXPECT_NEAR(rock.value().smallest_volume, 0.25 * 1.0 * 0.25, 1e-15);
    EXPECT_NEAR(total_volume(rock.value().blocks), 2.0, 2e-14);
}

TEST(JointSets, ObliqueSetsWithScatterConserveTheVolume) {
    Polyhedron slope = sample_box({0, 0, 0}, {10, 4, 6});
    slope = clip_convex(slope, {joint_normal(60.0 * degree, 270.0 * degree), 0.5});
    const double volume = mass_properties(slope).volume;
    const std::vector<JointSet> sets{
        {.normal = joint_normal(35.0 * degree, 100.0 * degree), .spacing = 0.7, .spacing_scatter = 0.4},
        {.normal = joint_normal(80.0 * degree, 280.0 * degree),
         .spacing = 0.9,
         .spacing_scatter = 0.2,
         .persistence = 0.7},
        {.normal = joint_normal(88.0 * degree, 5.0 * degree), .spacing = 1.1}};
    const auto rock = cut_by_joint_sets(slope, sets, {.seed = 11});
    ASSERT_TRUE(rock);
    EXPECT_GT(rock.value().blocks.size(), 200u);
    EXPECT_NEAR(total_volume(rock.value().blocks), volume, volume * 1e-12);
}

TEST(JointSets, ScatteredSpacingsStayWithinTheirRangeAndKeepTheMean) {
    const std::vector<JointSet> sets{{.normal = {1, 0, 0}, .spacing = 0.1, .spacing_scatter = 0.5, .offset = 500.0}};
    const auto rock = cut_by_joint_sets(sample_box({0, 0, 0}, {1000, 1, 1}), sets, {.seed = 3});
    ASSERT_TRUE(rock);
    const auto& blocks = rock.value().blocks;
    EXPECT_NEAR(static_cast<double>(blocks.size()), 10000.0, 150.0);  // 5 standard deviations of the count
    for (std::size_t i = 1; i + 1 < blocks.size(); ++i) {
        const Range range = range_along(blocks[i], {1, 0, 0});
        ASSERT_GE(range.high - range.low, 0.05 - 1e-9);
        ASSERT_LE(range.high - range.low, 0.15 + 1e-9);
    }
}

TEST(JointSets, PersistenceIsTheShareOfBlocksThatAJointCuts) {
    // 10000 bricks in a plate, then one horizontal joint that meets all of them.
    std::vector<JointSet> sets{{.normal = {1, 0, 0}, .spacing = 1.0},
                               {.normal = {0, 1, 0}, .spacing = 1.0},
                               {.normal = {0, 0, 1}, .spacing = 1.0, .offset = 0.5, .persistence = 0.3}};
    const auto rock = cut_by_joint_sets(sample_box({0, 0, 0}, {100, 100, 1}), sets, {.seed = 9});
    ASSERT_TRUE(rock);
    EXPECT_NEAR(static_cast<double>(rock.value().blocks.size()) - 10000.0, 3000.0, 230.0);  // 5 standard deviations
    sets[2].persistence = 0.0;
    EXPECT_EQ(cut_by_joint_sets(sample_box({0, 0, 0}, {100, 100, 1}), sets, {}).value().blocks.size(), 10000u);
}

TEST(JointSets, ADecisionInOneSetSaysNothingAboutTheNext) {
    // Four equal joints in two sets: if the draws were tied, the blocks left whole by one set would be left by both.
    const JointSet half{.normal = {0, 0, 1}, .spacing = 100.0, .offset = 0.5, .persistence = 0.5};
    std::vector<JointSet> sets{
        {.normal = {1, 0, 0}, .spacing = 1.0}, {.normal = {0, 1, 0}, .spacing = 1.0}, half, half};
    sets[3].offset = 0.25;
    const auto rock = cut_by_joint_sets(sample_box({0, 0, 0}, {100, 100, 1}), sets, {.seed = 4});
    std::size_t whole = 0;
    for (const Polyhedron& block : rock.value().blocks) {
        const Range range = range_along(block, {0, 0, 1});
        whole += range.high - range.low > 0.99 ? 1 : 0;
    }
    EXPECT_NEAR(static_cast<double>(whole), 2500.0, 220.0);  // 5 standard deviations about 10000 / 4
}

TEST(JointSets, TheSameSeedGivesTheSameRock) {
    const std::vector<JointSet> sets{{.normal = {1, 0, 0}, .spacing = 0.3, .spacing_scatter = 0.5, .persistence = 0.5},
                                     {.normal = {0, 1, 0}, .spacing = 0.3, .spacing_scatter = 0.5, .persistence = 0.5}};
    const Polyhedron region = sample_box({-2, -2, 0}, {2, 2, 1});
    const auto first = cut_by_joint_sets(region, sets, {.seed = 1}),
               again = cut_by_joint_sets(region, sets, {.seed = 1});
    ASSERT_EQ(first.value().blocks.size(), again.value().blocks.size());
    for (std::size_t i = 0; i < first.value().blocks.size(); ++i) {
        EXPECT_EQ(first.value().blocks[i].vertices, again.value().blocks[i].vertices);
    }
    const auto other = cut_by_joint_sets(region, sets, {.seed = 2});
    EXPECT_NE(first.value().smallest_volume, other.value().smallest_volume);
}

TEST(JointSets, NoBlockIsSmallerThanTheMinimumVolumeAndNoVolumeIsLost) {
    const std::vector<JointSet> sets{{.normal = normalized(Vec3{1, 1, 0}), .spacing = 0.3},
                                     {.normal = normalized(Vec3{1, -1, 0.5}), .spacing = 0.35}};
    const Polyhedron region = sample_box({0, 0, 0}, {2, 2, 1});
    const auto all = cut_by_joint_sets(region, sets, {});
    const auto kept = cut_by_joint_sets(region, sets, {.minimum_volume = 0.01});
    ASSERT_TRUE(all && kept);
    EXPECT_LT(all.value().smallest_volume, 0.01);
    EXPECT_GE(kept.value().smallest_volume, 0.01);
    EXPECT_GT(kept.value().skipped_cuts, 0);
    EXPECT_NEAR(total_volume(kept.value().blocks), 4.0, 4e-13);
}

TEST(JointSets, RefusesMoreBlocksThanAllowedBeforeMakingThem) {
    const Polyhedron region = sample_box({0, 0, 0}, {1, 1, 1});
    std::vector<JointSet> sets{{.normal = {1, 0, 0}, .spacing = 1e-9}};
    const auto rock = cut_by_joint_sets(region, sets, {});
    ASSERT_FALSE(rock);
    EXPECT_NE(rock.problems()[0].allowed.find("1000000 blocks"), std::string::npos);
    sets = {{.normal = {1, 0, 0}, .spacing = 0.01}, {.normal = {0, 1, 0}, .spacing = 0.01}};
    EXPECT_FALSE(cut_by_joint_sets(region, sets, {.maximum_blocks = 9999}));
    EXPECT_TRUE(cut_by_joint_sets(region, sets, {.maximum_blocks = 10000}));
}

TEST(JointSets, AllProblemsAreReportedAtOnce) {
    const std::vector<JointSet> sets{{.normal = {1, 0, 0}, .spacing = -1.0, .spacing_scatter = 1.0, .persistence = 1.5},
                                     {.normal = {0, 0, 2}, .spacing = std::nan(""), .offset = INFINITY}};
    const auto rock = cut_by_joint_sets(sample_box({0, 0, 0}, {1, 1, 1}), sets, {.minimum_volume = -1.0});
    ASSERT_FALSE(rock);
    EXPECT_EQ(rock.problems().size(), 7u);
}

}  // namespace
}  // namespace riprap::geometry
