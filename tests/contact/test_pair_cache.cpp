// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "contact/broadphase_scenes.hpp"
#include "riprap/contact/broadphase/brute_force.hpp"
#include "riprap/contact/broadphase/pair_cache.hpp"
#include "riprap/core/parallel.hpp"

namespace riprap::contact {
namespace {

using ::testing::ElementsAre;
using testing::graded_cloud;
using testing::PlaneShape;
using testing::Random;
using testing::Spheres;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Every pair that touches now (skin 0) is among the candidates.
::testing::AssertionResult holds_all_touching(const PairCache& cache, const Spheres& spheres,
                                              std::span<const Giant> giants) {
    for (const PartPair& pair : find_pairs_brute_force(spheres.bounds(), giants, 0)) {
        if (!std::ranges::binary_search(cache.pairs(), pair)) {
            return ::testing::AssertionFailure() << "missed " << pair.a << ", " << pair.b;
        }
    }
    return ::testing::AssertionSuccess();
}

TEST(PairCache, NoPairIsMissedInTenThousandStepsOfARandomWalk) {
    Spheres spheres = graded_cloud(60, 0.1, 8, 1.6, 1);
    const std::vector<double> speed = [&] {
        Random random(2);
        std::vector<double> v;
        for (int i = 0; i < spheres.size(); ++i) {
            v.push_back(std::pow(10, random.uniform(-4, -2)));
        }
        return v;
    }();
    Random random(3);
    PairCache cache;
    for (int step = 0; step < 10'000; ++step) {
        for (std::size_t i = 0; i < spheres.center.size(); ++i) {
            spheres.center[i] += speed[i] * random.direction();
            spheres.center[i] *= 0.9999;
        }
        cache.update(spheres.bounds(), {}, {.skin = 0.05});
        ASSERT_TRUE(holds_all_touching(cache, spheres, {})) << "step " << step;
    }
    EXPECT_LT(cache.rebuild_count(), 5000);
    EXPECT_GT(cache.rebuild_count(), 50);
}

TEST(PairCache, NoPairIsMissedWhileAPlatformTiltsAndAGroundTurns) {
    const PlaneShape box = PlaneShape::box({3, 3, 0.2});
    const PlaneShape plane = PlaneShape::half_space({0, 0, 1}, -1.5);
    Spheres spheres = graded_cloud(80, 0.03, 6, 2.5, 5);
    const std::int32_t platform = spheres.size(), ground = platform + 1;
    spheres.add({}, box.radius(), false);
    spheres.add({0, 0, 0}, infinity, false);
    Random random(6);
    PairCache cache;
    for (int step = 0; step < 10'000; ++step) {
        const double t = 1e-3 * step;
        for (std::size_t i = 0; i < static_cast<std::size_t>(platform); ++i) {
            spheres.center[i] += 2e-4 * random.direction();
        }
        const Pose tilting{{0.2 * std::sin(t), 0, 0.3 * std::sin(3 * t)},
                           from_rotation_vector({0, 0.8 * std::sin(t), 0.1 * t})};
        // The ground turns about a far axis and slides along itself.
        const Pose turning{{5 * t, -40, 0}, from_rotation_vector({0.05 * std::sin(2 * t), 0, t})};
        spheres.center[static_cast<std::size_t>(platform)] = tilting.position;
        const std::vector<Giant> giants{{platform, box.view(), to_frame(tilting)},
                                        {ground, plane.view(), to_frame(turning)}};
        cache.update(spheres.bounds(), giants, {.skin = 0.05});
        ASSERT_TRUE(holds_all_touching(cache, spheres, giants)) << "step " << step;
    }
    EXPECT_LT(cache.rebuild_count(), 2500);
    EXPECT_GT(cache.rebuild_count(), 100);
}

TEST(PairCache, AGroundThatSlidesAlongItselfOrTurnsAboutItsNormalNeedsNoRebuild) {
    const PlaneShape plane = PlaneShape::half_space({0, 0, 1}, 0);
    Spheres spheres;
    spheres.add({0, 0, 0}, infinity, false);
    spheres.add({3, 1, 0.9}, 1);
    PairCache cache;
    for (int step = 0; step < 100; ++step) {
        const Pose pose{{1.0 * step, -2.0 * step, 0}, from_rotation_vector({0, 0, 0.02 * step})};
        cache.update(spheres.bounds(), std::vector<Giant>{{0, plane.view(), to_frame(pose)}}, {.skin = 0.01});
    }
    EXPECT_EQ(cache.rebuild_count(), 1);
    EXPECT_THAT(cache.pairs(), ElementsAre(PartPair{0, 1}));
}

TEST(PairCache, IsRebuiltWhenTheTwoLargestDisplacementsExceedTheSkin) {
    Spheres spheres;
    for (int i = 0; i < 3; ++i) {
        spheres.add({3.0 * i, 0, 0}, 1);
    }
    PairCache cache;
    EXPECT_TRUE(cache.update(spheres.bounds(), {}, {.skin = 0.1}));
    EXPECT_FALSE(cache.update(spheres.bounds(), {}, {.skin = 0.1}));
    spheres.center[0].x += 0.06;
    EXPECT_FALSE(cache.update(spheres.bounds(), {}, {.skin = 0.1}));
    spheres.center[2].y -= 0.03;
    EXPECT_FALSE(cache.update(spheres.bounds(), {}, {.skin = 0.1}));
    spheres.center[2].y -= 0.02;
    EXPECT_TRUE(cache.update(spheres.bounds(), {}, {.skin = 0.1}));
    EXPECT_EQ(cache.rebuild_count(), 2);
}

TEST(PairCache, TwoImmobilePartsDoNotAddTheirDisplacements) {
    // Two driven walls move by 0.08 each, the block by 0.01: no pair closed by more than 0.09.
    Spheres spheres;
    spheres.add({0, 0, 0}, 1, false);
    spheres.add({9, 0, 0}, 1, false);
    spheres.add({4, 0, 0}, 1);
    PairCache cache;
    cache.update(spheres.bounds(), {}, {.skin = 0.1});
    spheres.center[0].x += 0.08;
    spheres.center[1].x -= 0.08;
    spheres.center[2].x += 0.01;
    EXPECT_FALSE(cache.update(spheres.bounds(), {}, {.skin = 0.1}));
}

TEST(PairCache, IsRebuiltWhenABodyIsReleasedOrTheSceneChanges) {
    Spheres spheres;
    spheres.add({0, 0, 0}, 1, false);
    spheres.add({1.5, 0, 0}, 1, false);
    PairCache cache;
    cache.update(spheres.bounds(), {}, {.skin = 0.1});
    EXPECT_TRUE(cache.pairs().empty());
    spheres.is_mobile[1] = 1;
    EXPECT_TRUE(cache.update(spheres.bounds(), {}, {.skin = 0.1}));
    EXPECT_THAT(cache.pairs(), ElementsAre(PartPair{0, 1}));
    EXPECT_TRUE(cache.update(spheres.bounds(), {}, {.skin = 0.2}));
    spheres.add({0, 1.5, 0}, 1);
    EXPECT_TRUE(cache.update(spheres.bounds(), {}, {.skin = 0.2}));
    EXPECT_THAT(cache.pairs(), ElementsAre(PartPair{0, 1}, PartPair{0, 2}, PartPair{1, 2}));
}

TEST(PairCache, EachPartListsItsPairsInOrder) {
    const Spheres spheres = graded_cloud(500, 0.05, 20, 2, 8);
    PairCache cache;
    cache.update(spheres.bounds(), {}, {.skin = 0.02});
    std::size_t listed = 0;
    for (std::int32_t part = 0; part < spheres.size(); ++part) {
        std::vector<std::int32_t> expected;
        for (std::size_t k = 0; k < cache.pairs().size(); ++k) {
            if (cache.pairs()[k].a == part || cache.pairs()[k].b == part) {
                expected.push_back(static_cast<std::int32_t>(k));
            }
        }
        listed += expected.size();
        ASSERT_THAT(cache.pairs_of(part), ::testing::ElementsAreArray(expected));
    }
    EXPECT_EQ(listed, 2 * cache.pairs().size());
    EXPECT_EQ(cache.pairs_of(10, 13).size(),
              cache.pairs_of(10).size() + cache.pairs_of(11).size() + cache.pairs_of(12).size());
}

TEST(MedianRadius, IgnoresHalfSpaces) {
    EXPECT_EQ(median_radius(std::vector<double>{3, infinity, 1, 2, infinity}), 2);
    EXPECT_EQ(median_radius(std::vector<double>{infinity}), 0);
}

/// A cloud of mobile spheres above a floor of many small fixed ones, which reaches far beyond it.
Spheres cloud_over_wide_floor() {
    Spheres spheres = graded_cloud(40, 0.1, 3, 1, 7);
    for (int i = -30; i <= 30; ++i) {
        for (int j = -30; j <= 30; ++j) {
            spheres.add({0.2 * i, 0.2 * j, -0.8}, 0.12, false);
        }
    }
    return spheres;
}

TEST(PairCache, AFloorFarBeyondTheMobilePartsChangesNoPair) {
    const Spheres spheres = cloud_over_wide_floor();
    PairCache cache;
    cache.update(spheres.bounds(), {}, {.skin = 0.05});
    const std::vector<PartPair> all = find_pairs_brute_force(spheres.bounds(), {}, 0.05);
    EXPECT_TRUE(std::ranges::equal(cache.pairs(), all));
    EXPECT_GT(all.size(), 50U);
}

TEST(PairCache, AMobilePartThatIsNowhereHidesNoOther) {
    Spheres spheres = cloud_over_wide_floor();
    const std::vector<PartPair> all = find_pairs_brute_force(spheres.bounds(), {}, 0.05);
    spheres.add({std::nan(""), 0, 0}, 0.1);
    PairCache cache;
    cache.update(spheres.bounds(), {}, {.skin = 0.05});
    EXPECT_TRUE(std::ranges::equal(cache.pairs(), all));
}

TEST(PairCache, PartsThatRestNeedNotBeLookedAtWhileTheSceneIsTheSame) {
    Spheres spheres = cloud_over_wide_floor();
    std::vector<std::int32_t> restless(40);
    std::iota(restless.begin(), restless.end(), 0);
    const auto known = [&] {
        PartBounds bounds = spheres.bounds();
        bounds.scene = 5;
        bounds.restless = restless;
        return bounds;
    };
    Random random(8);
    PairCache quick, plain;
    for (int step = 0; step < 2000; ++step) {
        for (std::size_t i = 0; i < 40; ++i) {
            spheres.center[i] += 2e-3 * random.direction();
        }
        if (step == 1000) {  // a fixed part is moved from now on
            restless.push_back(100);
        }
        if (step >= 1000) {
            spheres.center[100] += Vec3{1e-3, 1e-3, 0};
        }
        EXPECT_EQ(quick.update(known(), {}, {.skin = 0.05}), plain.update(spheres.bounds(), {}, {.skin = 0.05}));
        ASSERT_TRUE(std::ranges::equal(quick.pairs(), plain.pairs())) << step;
    }
    EXPECT_GT(quick.rebuild_count(), 10);
    // Another scene of the same size: its radii are looked at.
    spheres.radius[3] *= 2;
    PartBounds other = known();
    other.scene = 6;
    EXPECT_TRUE(quick.update(other, {}, {.skin = 0.05}));
}

}  // namespace
}  // namespace riprap::contact
