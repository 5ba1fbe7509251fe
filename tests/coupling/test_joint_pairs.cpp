// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/joints/joint_pairs.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "riprap/core/mat3.hpp"

namespace riprap::coupling {
namespace {

/// Samples of three bodies strewn through each other, the third of them still.
struct Strewn {
    SampleSet samples;
    body::Motion motion;
    fluid::BoundaryParticles walls;
    fluid::ParticleSettings settings;
    std::vector<std::uint8_t> is_still{0, 0, 1}, is_loose{1, 1, 0};

    explicit Strewn(bool is_periodic) {
        settings.spacing = 1;
        settings.domain = {{0, 0, 0}, {12, 12, 12}, {is_periodic, false, false}, 3};
        motion.pose.resize(3);
        for (std::vector<Vec3>* rates :
             {&motion.velocity, &motion.angular_velocity, &motion.acceleration, &motion.angular_acceleration}) {
            rates->resize(3);
        }
        std::mt19937_64 random(3);
        std::uniform_real_distribution<double> place(0, 12), unit(-1, 1);
        for (std::int32_t body = 0; body < 3; ++body) {
            for (int k = 0; k < 101; ++k) {  // fours reach over from one body to the next
                samples.body.push_back(BodyId{body});
                samples.anchor.push_back({place(random), place(random), place(random)});
                samples.normal.push_back(normalized(Vec3{unit(random), unit(random), unit(random)}));
                samples.depth.push_back(0.5);
                samples.volume.push_back(1);
                samples.is_slippery.push_back(0);
            }
        }
        place_samples(samples, motion, walls);
    }
    void update(JointPairs& pairs) const { pairs.update(samples, {is_still, is_loose}, motion, walls, settings); }

    using Pair = std::pair<std::size_t, std::size_t>;
    template <class Near>
    static void insert(const JointPairs& pairs, std::size_t i, std::size_t four, const Near& near,
                       std::set<Pair>& found) {
        for (std::size_t lane = 0; lane < four_size; ++lane) {
            if ((bits_of(near.is_there) >> lane & 1U) != 0) {
                found.insert({i, at(pairs.fours()[four].member[lane])});
            }
        }
    }
    static std::set<Pair> met(const JointPairs& pairs) {
        std::set<Pair> found;
        for (std::size_t i = 0; i < pairs.members().size(); ++i) {
            pairs.for_each_met(i,
                               [&](std::size_t four, const JointFour& near) { insert(pairs, i, four, near, found); });
        }
        return found;
    }
    static std::set<Pair> joined(const JointPairs& pairs) {
        std::set<Pair> found;
        for (std::size_t i = 0; i < pairs.members().size(); ++i) {
            pairs.for_each_joined(i, pairs.self(i), [&](std::size_t four, const JointFour& near) {
                insert(pairs, i, four, near, found);
            });
        }
        return found;
    }
    /// Pairs by a look at all.
    std::set<Pair> all_within(const JointPairs& pairs, bool only_joined) const {
        const fluid::NearestImage nearest(settings.domain);
        std::set<Pair> found;
        for (std::size_t i = 0; i < pairs.members().size(); ++i) {
            for (std::size_t j = 0; j < pairs.members().size(); ++j) {
                const JointSelf a = pairs.self(i), b = pairs.self(j);
                const double apart = norm(nearest(a.place - b.place));
                const bool is_joined = apart < settings.support_radius() || dot(a.normal, b.normal) < -0.5;
                if (pairs.members()[i].solid != pairs.members()[j].solid && apart < JointKernel::reach(settings) &&
                    (is_joined || !only_joined)) {
                    found.insert({i, j});
                }
            }
        }
        return found;
    }
};

TEST(JointPairs, are_those_that_a_look_at_all_samples_finds) {
    for (const bool is_periodic : {false, true}) {
        const Strewn scene(is_periodic);
        JointPairs pairs;
        scene.update(pairs);
        EXPECT_EQ(pairs.members().size(), 303U);
        EXPECT_EQ(scene.met(pairs), scene.all_within(pairs, false));
        EXPECT_EQ(scene.joined(pairs), scene.all_within(pairs, true));
        EXPECT_GT(scene.joined(pairs).size(), 1000U);
    }
}

TEST(JointPairs, are_up_to_date_while_their_list_is_kept) {
    Strewn scene(false);
    JointPairs pairs;
    scene.update(pairs);
    scene.motion.pose[0].position = {0.2, 0, 0};  // less than the skin
    scene.motion.pose[1].orientation = normalized(Quat{1, 0, 0.005, 0});
    place_samples(scene.samples, scene.motion, scene.walls);
    scene.update(pairs);
    EXPECT_EQ(scene.met(pairs), scene.all_within(pairs, false));
    EXPECT_EQ(scene.joined(pairs), scene.all_within(pairs, true));
}

}  // namespace
}  // namespace riprap::coupling
