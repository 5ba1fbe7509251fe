// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "contact/broadphase_scenes.hpp"
#include "riprap/contact/broadphase/brute_force.hpp"
#include "riprap/contact/broadphase/multilevel_grid.hpp"
#include "riprap/contact/broadphase/single_grid.hpp"
#include "riprap/core/parallel.hpp"

namespace riprap::contact {
namespace {

using ::testing::ElementsAre;
using testing::graded_cloud;
using ::testing::IsEmpty;
using testing::Random;
using testing::Spheres;

std::vector<PartPair> multilevel(const Spheres& spheres, double skin, double factor = 2) {
    MultilevelGrid grid;
    std::vector<PartPair> pairs;
    grid.find_pairs(spheres.bounds(), {}, skin, factor, pairs);
    return pairs;
}

/// Every search gives the brute-force pairs at 1 to 4 threads.
void expect_same_as_brute_force(const Spheres& spheres, double skin, double factor = 2) {
    const std::vector<PartPair> expected = find_pairs_brute_force(spheres.bounds(), {}, skin);
    for (int threads = 1; threads <= 4; ++threads) {
        parallel::set_thread_count(threads);
        const std::vector<PartPair> found = multilevel(spheres, skin, factor);
        EXPECT_TRUE(found == expected) << found.size() << " pairs instead of " << expected.size() << " at " << threads
                                       << " threads";
    }
    parallel::set_thread_count(1);
    std::vector<PartPair> single;
    SingleGrid().find_pairs(spheres.bounds(), skin, single);
    EXPECT_TRUE(single == expected) << single.size() << " instead of " << expected.size();
}

TEST(Broadphase, TenThousandPartsOfSizeRatioHundredGiveTheBruteForcePairs) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const Spheres spheres = graded_cloud(10'000, 0.01, 100, 6, seed);
        ASSERT_GT(find_pairs_brute_force(spheres.bounds(), {}, 0.002).size(), 20'000U);
        expect_same_as_brute_force(spheres, 0.002);
    }
}

TEST(Broadphase, AnyRatioOfSizeClassesGivesTheSamePairs) {
    const Spheres spheres = graded_cloud(2000, 0.01, 100, 4, 11);
    for (const double factor : {1.05, 1.5, 2.0, 3.0, 10.0, 1e9, std::numeric_limits<double>::infinity()}) {
        expect_same_as_brute_force(spheres, 0.01, factor);
    }
}

TEST(Broadphase, ClustersFarApartGiveTheBruteForcePairs) {
    Random random(5);
    Spheres spheres;
    for (int cluster = 0; cluster < 6; ++cluster) {
        const Vec3 middle = random.in_cube(1e4);
        for (int i = 0; i < 300; ++i) {
            spheres.add(middle + random.in_cube(1), random.uniform(0.02, 0.2));
        }
    }
    expect_same_as_brute_force(spheres, 0.01);
}

TEST(Broadphase, CollinearAndCoplanarPartsGiveTheBruteForcePairs) {
    for (const Vec3 along : {Vec3{1, 0, 0}, Vec3{0, -1, 0}, Vec3{0, 0, 1}, Vec3{1, 1, 1}, Vec3{-1, 2, 0}}) {
        Spheres spheres;
        for (int i = 0; i < 1500; ++i) {
            spheres.add(0.7 * i * along, i % 7 == 0 ? 1.5 : 0.4);
        }
        expect_same_as_brute_force(spheres, 0.05);
    }
    Random random(9);
    Spheres sheet;
    for (int i = 0; i < 2000; ++i) {
        sheet.add({random.uniform(-20, 20), 3, random.uniform(-20, 20)}, random.uniform(0.1, 0.8));
    }
    expect_same_as_brute_force(sheet, 0.05);
}

TEST(Broadphase, PartsOnOnePointAllPair) {
    Spheres spheres;
    for (int i = 0; i < 60; ++i) {
        spheres.add({1, 2, 3}, i % 2 == 0 ? 1.0 : 0.1);
    }
    EXPECT_EQ(multilevel(spheres, 0).size(), 60U * 59 / 2);
    expect_same_as_brute_force(spheres, 0);
}

TEST(Broadphase, EqualPartsGiveTheBruteForcePairs) {
    Random random(4);
    Spheres spheres;
    for (int i = 0; i < 4000; ++i) {
        spheres.add(random.in_cube(10), 0.5);
    }
    expect_same_as_brute_force(spheres, 0.1);
}

TEST(Broadphase, ALatticeAtExactlyTheReachHasNoPairsAndJustBelowItHasAll) {
    // Centres on cell borders, distances equal to the reach: where an index rounds the wrong way first.
    for (const double pitch : {1.0, 1.0 - 1e-12}) {
        Spheres spheres;
        for (int k = 0; k < 12; ++k) {
            for (int j = 0; j < 12; ++j) {
                for (int i = 0; i < 12; ++i) {
                    spheres.add({pitch * i - 5, pitch * j + 1e3, pitch * k}, 0.5);
                }
            }
        }
        expect_same_as_brute_force(spheres, 0);
        EXPECT_EQ(multilevel(spheres, 0).size(), pitch == 1.0 ? 0U : 3U * 12 * 12 * 11);
    }
}

TEST(Broadphase, HugeAndNegativeCoordinatesLoseNoPair) {
    for (const Vec3 middle : {Vec3{1e9, -1e9, 1e9}, Vec3{-1e9, 0, 1e-9}, Vec3{-3e12, 2e12, -1e12}}) {
        Spheres spheres = graded_cloud(1500, 0.05, 20, 4, 21);
        for (Vec3& center : spheres.center) {
            center += middle;
        }
        expect_same_as_brute_force(spheres, 0.01);
    }
}

TEST(Broadphase, RunawayPartsLoseNoPair) {
    Spheres spheres = graded_cloud(1500, 0.001, 20, 0.1, 22);
    const double far[] = {1e6, -1e9, 1e15, -1e100, 1e300, std::numeric_limits<double>::max()};
    for (const double x : far) {
        spheres.add({x, 0, 0}, 0.01);
        spheres.add({x, 0.01, 0}, 0.01);
        spheres.add({0, x, -x}, 0.002);
    }
    expect_same_as_brute_force(spheres, 0.0001);
}

TEST(Broadphase, ANonFiniteCentrePairsWithNothingAndLosesNoOther) {
    Spheres spheres = graded_cloud(500, 0.05, 10, 2, 23);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    const auto expected = find_pairs_brute_force(spheres.bounds(), {}, 0.01);
    spheres.add({nan, 0, 0}, 0.1);
    spheres.add({0, nan, nan}, 0.5);
    spheres.add({infinity, 0, -infinity}, 0.5);
    EXPECT_TRUE(multilevel(spheres, 0.01) == expected);
}

TEST(Broadphase, NoPartsOrOnePartMakeNoPair) {
    Spheres spheres;
    EXPECT_THAT(multilevel(spheres, 0.1), IsEmpty());
    spheres.add({1, 2, 3}, 1);
    EXPECT_THAT(multilevel(spheres, 0.1), IsEmpty());
    expect_same_as_brute_force(spheres, 0.1);
}

TEST(Broadphase, PointsWithoutASkinMakeNoPair) {
    Spheres spheres;
    for (int i = 0; i < 50; ++i) {
        spheres.add({0.1 * i, 0, 0}, 0);
    }
    EXPECT_THAT(multilevel(spheres, 0), IsEmpty());
    EXPECT_EQ(multilevel(spheres, 0.11).size(), 49U);
}

TEST(Broadphase, ImmobilePartsMeetMobilePartsOnly) {
    Spheres spheres = graded_cloud(1000, 0.1, 10, 3, 31);
    std::ranges::fill(spheres.is_mobile, std::uint8_t{0});
    EXPECT_THAT(multilevel(spheres, 0.1), IsEmpty());
    for (std::size_t i = 0; i < spheres.is_mobile.size(); i += 3) {
        spheres.is_mobile[i] = 1;
    }
    expect_same_as_brute_force(spheres, 0.1);
    for (const PartPair& pair : multilevel(spheres, 0.1)) {
        ASSERT_TRUE(pair.a % 3 == 0 || pair.b % 3 == 0);
    }
}

TEST(Broadphase, PartsOfOneBodyNeverMeet) {
    Spheres spheres = graded_cloud(1200, 0.1, 10, 3, 32);
    for (std::size_t i = 0; i < spheres.body.size(); ++i) {
        spheres.body[i] = static_cast<std::int32_t>(i / 4);
        spheres.is_mobile[i] = i / 4 % 5 != 0 ? 1 : 0;
    }
    expect_same_as_brute_force(spheres, 0.1);
    for (const PartPair& pair : multilevel(spheres, 0.1)) {
        ASSERT_NE(pair.a / 4, pair.b / 4);
    }
}

TEST(Broadphase, BuffersOfAnEarlierSceneDoNotLeakIntoTheNext) {
    MultilevelGrid grid;
    std::vector<PartPair> pairs;
    for (const int count : {3000, 10, 0, 500, 3000}) {
        const Spheres spheres = graded_cloud(count, 0.02, count == 500 ? 1 : 60, 2, static_cast<std::uint64_t>(count));
        grid.find_pairs(spheres.bounds(), {}, 0.01, 2, pairs);
        EXPECT_TRUE(pairs == find_pairs_brute_force(spheres.bounds(), {}, 0.01)) << count;
    }
}

// The published grid takes the circumradius l as its cell and looks one cell around: index = 1 + int(x/l + 0.5).
// Centres at 0.49 and 2.45 with l = 1 are 1.96 < 2 l apart and may touch, but fall into cells 1 and 3.
TEST(Broadphase, ContactsThatACellOfOneRadiusMissesAreFound) {
    const auto published_index = [](double x) { return 1 + static_cast<int>(x + 0.5); };
    ASSERT_EQ(published_index(2.45) - published_index(0.49), 2);
    Spheres spheres;
    spheres.add({0.49, 0, 0}, 1);
    spheres.add({2.45, 0, 0}, 1);
    EXPECT_THAT(multilevel(spheres, 0), ElementsAre(PartPair{0, 1}));
    // Wherever the two lie in the grid, and with a third part to fix its origin elsewhere.
    for (int shift = 0; shift < 200; ++shift) {
        spheres.center = {{0.49 + 0.01 * shift, 0, 0}, {2.45 + 0.01 * shift, 0, 0}, {40, 0, 0}};
        spheres.radius = {1, 1, 1};
        spheres.body = {0, 1, 2};
        spheres.is_mobile = {1, 1, 1};
        ASSERT_THAT(multilevel(spheres, 0), ElementsAre(PartPair{0, 1}));
    }
}

}  // namespace
}  // namespace riprap::contact
