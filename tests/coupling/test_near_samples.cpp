// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/samples/near_samples.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

namespace riprap::coupling::testing {
namespace {

/// A wall of samples all over a box, half of them on a body that never moves, and a few drops of water.
struct Wall {
    SampleSet samples;
    body::Motion motion;
    std::vector<std::uint8_t> is_still{1, 0};
    std::vector<Vec3> water;
    fluid::Domain domain;

    explicit Wall(int dimension, bool is_periodic) {
        domain = {{-1, -1, -1}, {1, 2, 3}, {is_periodic, false, false}, dimension};
        motion.pose = {{{0.3, -0.2, 0}, {}}, {{}, {}}};
        std::mt19937_64 random(5);
        const auto point = [&] {
            std::uniform_real_distribution<double> x(-1, 1), y(-1, 2), z(-1, 3);
            return Vec3{x(random), y(random), dimension == 3 ? z(random) : 0};
        };
        for (int i = 0; i < 4000; ++i) {
            samples.body.push_back(BodyId{i < 2000 ? 0 : 1});
            samples.anchor.push_back(point() - (i < 2000 ? motion.pose[0].position : Vec3{}));
        }
        samples.normal.resize(4000);
        samples.depth.resize(4000);
        samples.volume.resize(4000);
        samples.is_slippery.resize(4000);
        for (int i = 0; i < 12; ++i) {
            water.push_back(point());
        }
    }
    double distance_to_water(std::size_t sample) const {
        const Vec3 x =
            motion.pose[static_cast<std::size_t>(samples.body[sample].value)].position + samples.anchor[sample];
        double least = 1e9;
        for (const Vec3& drop : water) {
            Vec3 d = drop - x;
            d.x -= domain.is_periodic[0] ? 2 * std::round(d.x / 2) : 0;
            least = std::min(least, norm(d));
        }
        return least;
    }
};

TEST(NearSamples, leave_out_none_within_reach_of_water_and_none_of_a_body_that_can_move) {
    constexpr double reach = 0.15;
    for (const int dimension : {2, 3}) {
        for (const bool is_periodic : {false, true}) {
            const Wall wall(dimension, is_periodic);
            const auto found =
                near_samples(wall.samples, wall.motion, wall.is_still, wall.water, {}, wall.domain, reach);
            EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
            std::size_t still = 0, within = 0;
            for (std::int32_t i = 0; i < 4000; ++i) {
                const bool is_found = std::binary_search(found.begin(), found.end(), i);
                if (i >= 2000) {
                    ASSERT_TRUE(is_found) << i;
                    continue;
                }
                const double distance = wall.distance_to_water(static_cast<std::size_t>(i));
                ASSERT_TRUE(is_found || distance > reach) << i;
                // three cells of half a reach along every axis at most, for one of a four
                double nearest = 1e9;
                for (std::int32_t k = i - i % 4; k < i - i % 4 + 4; ++k) {
                    nearest = std::min(nearest, wall.distance_to_water(static_cast<std::size_t>(k)));
                }
                ASSERT_TRUE(!is_found || nearest < 3 * reach) << i;
                still += is_found ? 1 : 0;
                within += distance <= reach ? 1 : 0;
            }
            EXPECT_GT(within, 0U);
            EXPECT_LT(still, 2000U);
        }
    }
}

TEST(NearSamples, bear_water_that_is_lost_and_water_that_is_not_there) {
    Wall wall(3, false);
    const auto all = near_samples(wall.samples, wall.motion, wall.is_still, wall.water, {}, wall.domain, 0.15);
    wall.water.push_back({std::nan(""), 0, 0});
    EXPECT_EQ(near_samples(wall.samples, wall.motion, wall.is_still, wall.water, {}, wall.domain, 0.15), all);
    // A drop far away may move the edges of cells, and so change which farther ones are among them.
    const auto leaves_out_none = [](const Wall& scene) {
        const auto found =
            near_samples(scene.samples, scene.motion, scene.is_still, scene.water, {}, scene.domain, 0.15);
        for (std::int32_t i = 0; i < 4000; ++i) {
            if (scene.distance_to_water(static_cast<std::size_t>(i)) <= 0.15 &&
                !std::binary_search(found.begin(), found.end(), i)) {
                return false;
            }
        }
        return true;
    };
    for (const double far : {1e12, 1.7e308, -1.7e308}) {  // outside the domain: no cells for it
        wall.water.push_back({far, 0, 0});
        EXPECT_TRUE(leaves_out_none(wall));
    }
    wall.domain = {{-1e9, -1e9, -1e9}, {1e9, 1e9, 1e9}, {}, 3};  // cells grow instead of their number
    wall.water.push_back({1e9, 1e9, 1e9});
    EXPECT_TRUE(leaves_out_none(wall));
    const auto none = near_samples(wall.samples, wall.motion, wall.is_still, {}, {}, wall.domain, 0.15);
    EXPECT_EQ(none.size(), 2000U);
}

TEST(NearSamples, faces_of_joints_call_for_samples_as_water_does) {
    const Wall wall(3, false);
    const auto wet = near_samples(wall.samples, wall.motion, wall.is_still, wall.water, {}, wall.domain, 0.15);
    EXPECT_EQ(near_samples(wall.samples, wall.motion, wall.is_still, {}, wall.water, wall.domain, 0.15), wet);
    const std::span water(wall.water);
    EXPECT_EQ(
        near_samples(wall.samples, wall.motion, wall.is_still, water.first(1), water.subspan(1), wall.domain, 0.15),
        wet);
}

TEST(NearSamples, a_body_that_is_told_to_be_far_has_none) {
    const Wall wall(3, false);
    const std::vector<std::uint8_t> is_far{0, 1};
    const auto all = near_samples(wall.samples, wall.motion, wall.is_still, wall.water, {}, wall.domain, 0.15);
    const auto found =
        near_samples(wall.samples, wall.motion, wall.is_still, wall.water, {}, wall.domain, 0.15, is_far);
    ASSERT_EQ(found.size() + 2000, all.size());
    EXPECT_TRUE(std::equal(found.begin(), found.end(), all.begin()));
}

TEST(NearSamples, a_body_is_near_once_one_of_its_samples_is) {
    for (const bool is_periodic : {false, true}) {
        Wall wall(3, is_periodic);
        wall.samples.body.clear();
        for (int i = 0; i < 4000; ++i) {
            wall.samples.body.push_back(BodyId{i / 40});
        }
        wall.motion.pose.assign(100, {});
        std::vector<std::uint8_t> asked(100, 1);
        asked[7] = 0;
        const auto near = near_bodies(wall.samples, wall.motion, asked, wall.water, {}, wall.domain, 0.15);
        const auto by_others = near_bodies(wall.samples, wall.motion, asked, {}, wall.water, wall.domain, 0.15);
        EXPECT_EQ(near, by_others);
        int count = 0;
        for (std::size_t b = 0; b < 100; ++b) {
            double least = 1e9;
            for (std::size_t i = 40 * b; i < 40 * (b + 1); ++i) {
                least = std::min(least, wall.distance_to_water(i));
            }
            EXPECT_TRUE(b == 7 || near[b] == 1 || least > 0.15) << b;
            EXPECT_TRUE(near[b] == 0 || least < 0.45) << b;
            count += near[b];
        }
        EXPECT_EQ(near[7], 0);
        EXPECT_GT(count, 0);
    }
}

TEST(NearSamples, a_view_shows_what_each_sample_is) {
    Wall wall(3, false);
    SampleSet& set = wall.samples;
    set.normal.set(17, {0, 0, 1});
    set.depth.set(17, 0.25);
    set.volume.set(17, 0.5);
    set.is_slippery.set(17, 1);
    const std::vector<std::int32_t> numbers{3, 17, 2500};
    const SampleView some(set, numbers), all = set;
    ASSERT_EQ(some.size(), 3);
    ASSERT_EQ(all.size(), set.size());
    for (const auto& [view, entry] : {std::pair(&some, std::size_t{1}), std::pair(&all, std::size_t{17})}) {
        EXPECT_EQ(view->number(entry), 17U);
        EXPECT_EQ(view->body(entry), set.body[17]);
        EXPECT_EQ(view->anchor(entry), set.anchor[17]);
        EXPECT_EQ(view->normal(entry), set.normal[17]);
        EXPECT_EQ(view->depth(entry), 0.25);
        EXPECT_EQ(view->volume(entry), 0.5);
        EXPECT_EQ(view->is_slippery(entry), 1);
    }
    EXPECT_EQ(some.body(2), BodyId{1});
    EXPECT_EQ(SampleView().size(), 0);
}

TEST(NearSamples, a_view_finds_where_each_body_begins) {
    SampleSet samples;
    for (const int body : {0, 0, 2, 2, 2, 5}) {
        samples.body.push_back(BodyId{body});
        samples.anchor.push_back({});
    }
    const std::vector<std::int32_t> numbers{1, 2, 4, 5};  // of bodies 0, 2, 2, 5
    const SampleView all = samples, some(samples, numbers);
    const std::array<std::size_t, 7> begin_in_all{0, 2, 2, 5, 5, 5, 6}, begin_in_some{0, 1, 1, 3, 3, 3, 4};
    for (int body = 0; body < 7; ++body) {
        EXPECT_EQ(all.begin_of(BodyId{body}), begin_in_all[at(body)]) << body;
        EXPECT_EQ(some.begin_of(BodyId{body}), begin_in_some[at(body)]) << body;
    }
    EXPECT_EQ(SampleView(samples, {}).begin_of(BodyId{3}), 0U);
}

}  // namespace
}  // namespace riprap::coupling::testing
