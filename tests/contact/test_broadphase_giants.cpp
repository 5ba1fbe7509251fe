// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "contact/broadphase_scenes.hpp"
#include "riprap/contact/broadphase/brute_force.hpp"
#include "riprap/contact/broadphase/giants.hpp"
#include "riprap/contact/broadphase/multilevel_grid.hpp"
#include "riprap/core/parallel.hpp"

namespace riprap::contact {
namespace {

using ::testing::ElementsAre;
using testing::graded_cloud;
using ::testing::IsEmpty;
using testing::PlaneShape;
using testing::Random;
using testing::Spheres;

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(ChooseGiants, APlatformAmongBlocksIsOne) {
    std::vector<double> radius(100'000, 0.5);
    radius[77'777] = 30;
    EXPECT_THAT(choose_giants(radius), ElementsAre(77'777));
    EXPECT_THAT(choose_giants(std::vector<double>{0.5, 30}), ElementsAre(1));
}

TEST(ChooseGiants, AContainerOfSixWallsAndItsGroundAreGiants) {
    std::vector<double> radius(735, 0.87);
    for (const double wall : {9.2, 9.2, 9.2, 11.0, 9.2, 12.0, infinity}) {
        radius.push_back(wall);
    }
    EXPECT_THAT(choose_giants(radius), ElementsAre(735, 736, 737, 738, 739, 740, 741));
}

TEST(ChooseGiants, EqualBodiesAndContinuousGradingsHaveNone) {
    EXPECT_THAT(choose_giants(std::vector<double>(1000, 2.0)), IsEmpty());
    EXPECT_THAT(choose_giants(graded_cloud(10'000, 0.01, 100, 1, 3).radius), IsEmpty());
    EXPECT_THAT(choose_giants({}), IsEmpty());
    EXPECT_THAT(choose_giants(std::vector<double>{1.0}), IsEmpty());
    EXPECT_THAT(choose_giants(std::vector<double>(5, 0.0)), IsEmpty());
}

TEST(ChooseGiants, ManyLargeBodiesAreASizeClassNotGiants) {
    std::vector<double> radius(1000, 0.1);
    std::fill(radius.begin(), radius.begin() + 100, 1.0);
    EXPECT_THAT(choose_giants(radius), IsEmpty());
}

TEST(ChooseGiants, HalfSpacesAreGiantsHoweverMany) {
    EXPECT_EQ(choose_giants(std::vector<double>(40, infinity)).size(), 40U);
}

/// A tilted platform, a ground and a wall with blocks of many sizes about them.
struct Slope {
    PlaneShape platform = PlaneShape::box({6, 6, 0.5});
    PlaneShape ground = PlaneShape::half_space({0, 0, 1}, -2);
    PlaneShape wall = PlaneShape::half_space({-1, 0, 0}, 7);
    Spheres spheres = graded_cloud(3000, 0.02, 20, 8, 41);
    std::vector<Giant> giants;

    explicit Slope(const Quat& tilt, bool is_platform_mobile = false) {
        const std::int32_t first = spheres.size();
        const Pose pose{{0.3, -0.2, 0.1}, tilt};
        spheres.add(pose.position, platform.radius(), is_platform_mobile);
        spheres.add({0, 0, 0}, infinity, false);
        spheres.add({5, 5, 5}, infinity, false);
        giants = {{first, platform.view(), to_frame(pose)},
                  {first + 1, ground.view(), to_frame({})},
                  {first + 2, wall.view(), to_frame({{0, 1, 0}, from_rotation_vector({0, 0.2, 0})})}};
    }
};

TEST(Giants, ATiltedPlatformAndHalfSpacesGiveTheBruteForcePairs) {
    for (const bool is_platform_mobile : {false, true}) {
        const Slope slope(from_rotation_vector({0.3, -0.5, 0.2}), is_platform_mobile);
        const auto expected = find_pairs_brute_force(slope.spheres.bounds(), slope.giants, 0.01);
        for (int threads = 1; threads <= 4; ++threads) {
            parallel::set_thread_count(threads);
            MultilevelGrid grid;
            std::vector<PartPair> pairs;
            grid.find_pairs(slope.spheres.bounds(), slope.giants, 0.01, 2, pairs);
            EXPECT_TRUE(pairs == expected) << pairs.size() << " instead of " << expected.size();
        }
        parallel::set_thread_count(1);
        const bool platform_meets_ground =
            std::ranges::binary_search(expected, PartPair{slope.giants[0].part, slope.giants[1].part});
        EXPECT_EQ(platform_meets_ground, is_platform_mobile);
    }
}

TEST(Giants, APlatformPairsWithWhatLiesOnItAndNotWithWhatItsSphereHolds) {
    // A 12 m platform turned by 30 degrees about y; blocks of radius 0.3 on, above, under and beside it.
    const PlaneShape platform = PlaneShape::box({6, 6, 0.5});
    const Frame frame = to_frame({{1, 2, 3}, from_rotation_vector({0, M_PI / 6, 0})});
    const auto at = [&frame](const Vec3& local) { return frame.origin + frame.axes * local; };
    Spheres spheres;
    spheres.add(frame.origin, platform.radius(), false);
    spheres.add(at({2, 1, 0.79}), 0.3);   // 1: sunk by 1 cm
    spheres.add(at({2, 1, 0.805}), 0.3);  // 2: 5 mm above, within the skin of 1 cm
    spheres.add(at({2, 1, 0.82}), 0.3);   // 3: 2 cm above
    spheres.add(at({-6.29, 0, 0}), 0.3);  // 4: at the edge
    spheres.add(at({-6.35, 0, 0}), 0.3);  // 5: past the edge
    spheres.add(at({0, 0, -0.79}), 0.3);  // 6: below
    spheres.add(at({0, 0, 4}), 0.3);      // 7: far above, but inside the platform's sphere
    const std::vector<Giant> giants{{0, platform.view(), frame}};
    std::vector<PartPair> with_platform;
    for (const PartPair& pair : find_pairs_brute_force(spheres.bounds(), giants, 0.01)) {
        if (pair.a == 0) {
            with_platform.push_back(pair);
        }
    }
    EXPECT_THAT(with_platform, ElementsAre(PartPair{0, 1}, PartPair{0, 2}, PartPair{0, 4}, PartPair{0, 6}));
}

TEST(Giants, AHalfSpacePairsWithWhatReachesItsPlane) {
    const PlaneShape ground = PlaneShape::half_space({0, 0, 1}, 1);
    Spheres spheres;
    spheres.add({0, 0, 0}, infinity, false);
    spheres.add({1e6, 0, 1.99}, 1);
    spheres.add({0, 50, 2.2}, 1);
    spheres.add({0, -7, -1e5}, 1);
    const std::vector<Giant> giants{{0, ground.view(), to_frame({})}};
    EXPECT_THAT(find_pairs_brute_force(spheres.bounds(), giants, 0.1), ElementsAre(PartPair{0, 1}, PartPair{0, 3}));
}

TEST(Giants, TheDisplacementBoundCoversEveryPointOfTheRegion) {
    // D >= |h'_j(x) - h_j(x)| for all planes j and points x of the ball, for random small and large motions.
    Random random(71);
    const PlaneShape box = PlaneShape::box({3, 2, 0.5});
    for (int trial = 0; trial < 200; ++trial) {
        const Vec3 middle = random.in_cube(5);
        const double rho = random.uniform(0.1, 6);
        const Pose first{random.in_cube(3), from_rotation_vector(3.0 * random.direction())};
        const double size = std::pow(10, random.uniform(-4, 0));
        const Pose second{first.position + size * random.direction(),
                          from_rotation_vector(size * random.direction()) * first.orientation};
        const auto planes_at = [&](const Pose& pose) {
            Spheres spheres;
            spheres.add(pose.position, infinity, false);  // infinite: the bound over the given ball alone
            GiantPlanes planes;
            planes.assign(spheres.bounds(), std::vector<Giant>{{0, box.view(), to_frame(pose)}});
            return planes;
        };
        const double bound = planes_at(second).displacement_since(planes_at(first), 0, middle, rho, 0);
        double largest = 0;
        for (int sample = 0; sample < 300; ++sample) {
            const Vec3 x = middle + rho * random.direction();
            for (int j = 0; j < 6; ++j) {
                const auto h = [&](const Pose& pose) {
                    return box.view().offset[j] - dot(box.view().normal(j), to_body(pose, x));
                };
                largest = std::max(largest, std::abs(h(second) - h(first)));
            }
        }
        ASSERT_LE(largest, bound * (1 + 1e-12));
        ASSERT_GT(largest, 0.3 * bound) << "the bound is needlessly wide";
    }
}

}  // namespace
}  // namespace riprap::contact
