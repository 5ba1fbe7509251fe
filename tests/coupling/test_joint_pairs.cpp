// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/joints/joint_sums.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "riprap/core/index.hpp"
#include "riprap/core/mat3.hpp"
#include "riprap/fluid/particle/sweep/cell_grid.hpp"

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

    using Pair = std::pair<std::size_t, std::size_t>;  ///< samples, the one of the lower solid last
    double apart(const Pair& pair) const {
        const fluid::NearestImage nearest(settings.domain);
        return norm(nearest(walls.position[pair.first] - walls.position[pair.second]));
    }
    Vec3 normal(std::size_t sample) const {
        return rotate(motion.pose[at(samples.body[sample].value)].orientation, samples.normal[sample]);
    }
    bool is_joined(const Pair& pair) const {
        return apart(pair) < settings.support_radius() || dot(normal(pair.first), normal(pair.second)) < -0.5;
    }
    /// Pairs of the lists that are within reach.
    std::set<Pair> listed(const JointPairs& pairs, bool only_joined) const {
        std::set<Pair> found;
        for (std::size_t u = 0; u < pairs.units().size(); ++u) {
            const JointUnit& unit = pairs.units()[u];
            std::set<std::uint32_t> before;
            for (const JointEntry entry : only_joined ? pairs.joined(u) : pairs.met(u)) {
                EXPECT_TRUE(before.insert(entry.both).second);
                const JointSlot &own = pairs.slots()[at(unit.first_slot) + entry.own()],
                                &other = pairs.slots()[at(unit.first_slot + unit.own_count) + entry.other()];
                for (std::size_t pair = 0; pair < four_size * four_size; ++pair) {
                    const std::size_t i = pair / four_size, j = pair % four_size;
                    if ((own.lanes >> i & 1U) != 0 && (other.lanes >> j & 1U) != 0) {
                        const Pair samples_there{pairs.fours()[at(own.four)].sample(i),
                                                 pairs.fours()[at(other.four)].sample(j)};
                        if (apart(samples_there) < JointKernelLimits(settings).reach &&
                            (!only_joined || is_joined(samples_there))) {
                            EXPECT_TRUE(found.insert(samples_there).second);
                        }
                    }
                }
            }
        }
        return found;
    }
    /// Pairs by a look at all.
    std::set<Pair> all_within(bool only_joined) const {
        const auto solid = [&](std::size_t i) {
            const std::int32_t body = samples.body[i].value;
            return is_still[at(body)] != 0 ? still_solid : body;
        };
        std::set<Pair> found;
        for (std::size_t i = 0; i < walls.position.size(); ++i) {
            for (std::size_t j = 0; j < walls.position.size(); ++j) {
                if (solid(i) > solid(j) && apart({i, j}) < JointKernelLimits(settings).reach &&
                    (!only_joined || is_joined({i, j}))) {
                    found.insert({i, j});
                }
            }
        }
        return found;
    }
};

TEST(JointPairs, are_those_that_a_look_at_all_samples_finds_each_once) {
    for (const bool is_periodic : {false, true}) {
        const Strewn scene(is_periodic);
        JointPairs pairs;
        scene.update(pairs);
        EXPECT_EQ(scene.listed(pairs, false), scene.all_within(false));
        EXPECT_EQ(scene.listed(pairs, true), scene.all_within(true));
        EXPECT_GT(scene.listed(pairs, true).size(), 500U);
    }
}

TEST(JointPairs, are_up_to_date_while_their_list_is_kept) {
    Strewn scene(false);
    JointPairs pairs;
    scene.update(pairs);
    scene.motion.pose[0].position = {0.04, 0, 0};  // less than half of the least skin
    scene.motion.pose[1].orientation = normalized(Quat{1, 0, 0.001, 0});
    place_samples(scene.samples, scene.motion, scene.walls);
    scene.update(pairs);
    EXPECT_EQ(scene.listed(pairs, false), scene.all_within(false));
    EXPECT_EQ(scene.listed(pairs, true), scene.all_within(true));
}

TEST(JointPairs, of_a_joint_are_all_fours_that_its_units_name) {
    const Strewn scene(false);
    JointPairs pairs;
    scene.update(pairs);
    ASSERT_EQ(pairs.joints().size(), 3U);  // each with each
    for (const JointUnit& unit : pairs.units()) {
        const Joint& joint = pairs.joints()[at(unit.joint)];
        EXPECT_EQ(joint.high, unit.own_solid);
        EXPECT_EQ(joint.low, unit.other_solid);
        for (std::int32_t k = 0; k < unit.own_count + unit.other_count; ++k) {
            const JointSlot& slot = pairs.slots()[at(unit.first_slot + k)];
            EXPECT_EQ(pairs.sides()[at(slot.side)].joint, unit.joint);
            EXPECT_EQ(pairs.sides()[at(slot.side)].four, slot.four);
        }
    }
}

/// One sum over fours that lie about each other at random, in both precisions.
TEST(JointPairs, sums_in_float_are_those_in_double_and_opposite_for_both_sides) {
    const Strewn scene(true);
    JointPairs pairs;
    scene.update(pairs);
    std::vector<PlacedFour<double>> placed;
    place_fours<double>(pairs.fours(), scene.samples, scene.motion, scene.walls, pairs.fixed(), placed);
    const JointSums<float> fast(pairs, pairs.placed(), scene.settings, {0, 0, -9.81});
    const JointSums<double> plain(pairs, placed, scene.settings, {0, 0, -9.81});
    std::vector<SideFour<float>> of_fast(pairs.sides().size());
    std::vector<SideFour<double>> of_plain(pairs.sides().size());
    for (std::size_t k = 0; k < of_fast.size(); ++k) {
        for (std::size_t lane = 0; lane < four_size; ++lane) {
            of_plain[k].pressure[lane] = 1000 + static_cast<double>((7 * k + lane) % 13);
            of_plain[k].left_to_do[lane] = 0.25 * static_cast<double>((k + 3 * lane) % 5);
            of_fast[k].pressure[lane] = static_cast<float>(of_plain[k].pressure[lane]);
            of_fast[k].left_to_do[lane] = static_cast<float>(of_plain[k].left_to_do[lane]);
        }
    }
    for (std::size_t u = 0; u < pairs.units().size(); ++u) {
        const JointUnit& unit = pairs.units()[u];
        const std::size_t count = at(unit.own_count + unit.other_count);
        std::vector<ForceSlot<float>> a(count);
        std::vector<ForceSlot<double>> b(count);
        std::vector<std::uint8_t> marks(count, SlotMark::meets);
        fast.push(u, of_fast, a, marks);
        plain.push(u, of_plain, b, marks);
        double largest = 0, total = 0;
        for (std::size_t k = 0; k < count; ++k) {
            for (std::size_t lane = 0; lane < four_size; ++lane) {
                total += b[k][0][lane];  // all volumes are 1
                largest = std::max(largest, std::abs(b[k][0][lane]));
                EXPECT_NEAR(double{a[k][0][lane]}, b[k][0][lane], 1e-3) << "of some thousands";
            }
        }
        EXPECT_GT(largest, 100);
        EXPECT_NEAR(total, 0, 1e-12 * largest);
    }
}

}  // namespace
}  // namespace riprap::coupling
