// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "riprap/contact/find_contacts.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/geometry/polyhedra/shapes.hpp"

namespace riprap::contact {
namespace {

constexpr std::uint64_t left = feature_key(1, 7), right = feature_key(2, 3);

/// Cubes pushed apart vertically by 1 N at each of two corners, whatever the gap; a contact's spring counts the steps
/// that it has lived. Reports the right corner first, which is not the order of the keys.
struct TwoCorners {
    bool has_right{true};

    void meet(const Candidate& pair, SeparatingCache&, FoundContacts& found) const {
        if (has_right) {
            push(pair, found.add(right), 0.5);
        }
        push(pair, found.add(left), -0.5);
    }
    static void push(const Candidate& pair, FoundContact& contact, double x) {
        contact.springs.torsion += 1;
        contact.springs.shear_energy += 10;
        contact.row.point = 0.5 * (pair.a.center + pair.b.center) + Vec3{x, 0, 0};
        contact.row.force = {0, 0, pair.a.center.z > pair.b.center.z ? 1.0 : -1.0};
    }
};

/// A stack of unit cubes.
class ContactPhysicsTest : public ::testing::Test {
 protected:
    explicit ContactPhysicsTest(int cubes = 3) {
        materials_.materials.push_back({.name = "rock", .density = 2000, .normal_stiffness = 1e7});
        mix_pairs(materials_, material::Mixing::mean, material::Mixing::mean);
        const ShapeId cube = shapes_.add_convex(geometry::cube(1), false, nullptr);
        for (int i = 0; i < cubes; ++i) {
            body::NewBody block;
            block.name = "block";
            block.material = MaterialId{0};
            block.density = 2000;
            block.pose = {{0, 0, static_cast<double>(i)}, {}};
            block.parts = {{BodyId{}, cube, Pose{}}};
            add_body(bodies_, state_, shapes_, block);
        }
    }
    double find(const TwoCorners& physics) {
        body::update_kinematics(bodies_, state_, 0, kinematics_);
        pipeline_.place_parts(scene_, state_);
        pipeline_.find_pairs();
        return pipeline_.find_contacts(physics, scene_, state_, kinematics_, 1e-3, history_);
    }
    /// Bodies 1 and 2 away from 0 and, where asked, from each other.
    void lift(double z1, double z2) {
        state_.position[1].z = z1;
        state_.position[2].z = z2;
    }

    geometry::ShapeSet shapes_;
    material::MaterialSet materials_;
    body::BodySet bodies_;
    body::BodyState state_;
    body::BodyKinematics kinematics_;
    ContactScene scene_{shapes_, materials_, bodies_, 2, 0.1};
    ContactPipeline pipeline_;
    ContactHistory history_;
};

TEST_F(ContactPhysicsTest, TwoContactsOfAPairStandInTheOrderOfTheirKeys) {
    find(TwoCorners{});
    EXPECT_EQ(history_.pair,
              (std::vector<std::uint64_t>{pair_key({0, 1}), pair_key({0, 1}), pair_key({1, 2}), pair_key({1, 2})}));
    EXPECT_EQ(history_.feature, (std::vector<std::uint64_t>{left, right, left, right}));
    ASSERT_EQ(pipeline_.rows().size(), 4U);
    EXPECT_EQ(pipeline_.rows()[0].point.x, -0.5);
    EXPECT_EQ(pipeline_.rows()[1].point.x, 0.5);
}

TEST_F(ContactPhysicsTest, EveryContactOfAPairLoadsBothBodies) {
    find(TwoCorners{});
    body::Loads loads;
    pipeline_.gather_loads(scene_, state_, loads);
    EXPECT_EQ(loads.force[0].z, -2);
    EXPECT_EQ(loads.force[1].z, 0);
    EXPECT_EQ(loads.force[2].z, 2);
    find(TwoCorners{.has_right = false});
    pipeline_.gather_loads(scene_, state_, loads);
    EXPECT_EQ(loads.force[2].z, 1);
    EXPECT_EQ(loads.torque[2].y, 0.5);  // 1 N upwards at x = -0.5 m: (-0.5, 0, z) x (0, 0, 1)
}

TEST_F(ContactPhysicsTest, SpringsFollowTheirFeatureFromStepToStep) {
    find(TwoCorners{});
    find(TwoCorners{.has_right = false});
    find(TwoCorners{});
    // The left corner has lived three steps; the right one began anew.
    EXPECT_EQ(history_.torsion, (std::vector<double>{3, 1, 3, 1}));
}

TEST_F(ContactPhysicsTest, TheEnergyOfALostFeatureIsReportedOnce) {
    EXPECT_EQ(find(TwoCorners{}), 0);
    EXPECT_EQ(find(TwoCorners{.has_right = false}), 20);
    EXPECT_EQ(find(TwoCorners{.has_right = false}), 0);
}

TEST_F(ContactPhysicsTest, SpringsSurviveNewCandidatesAndANewPipeline) {
    find(TwoCorners{});
    lift(1, 20);  // the pairs are searched anew: (1, 2) is none any more
    EXPECT_EQ(find(TwoCorners{}), 20);
    EXPECT_EQ(history_.torsion, (std::vector<double>{2, 2}));
    lift(1, 2);
    find(TwoCorners{});
    EXPECT_EQ(history_.torsion, (std::vector<double>{3, 3, 1, 1}));
    pipeline_ = {};  // as after a restart
    find(TwoCorners{});
    EXPECT_EQ(history_.torsion, (std::vector<double>{4, 4, 2, 2}));
}

TEST_F(ContactPhysicsTest, SpringsAreThoseOfTheHistoryGivenAndNotOfTheLastStep) {
    find(TwoCorners{});
    lift(1, 20);
    find(TwoCorners{});
    const ContactHistory lower_two = history_;  // of pair (0, 1), second step
    state_.position[0].z = -20;
    lift(1, 2);
    find(TwoCorners{});
    ASSERT_EQ(history_.size(), lower_two.size());  // of pair (1, 2), first step
    state_.position[0].z = 0;
    history_ = lower_two;  // as after a step that is taken back
    find(TwoCorners{});
    EXPECT_EQ(history_.torsion, (std::vector<double>{3, 3, 1, 1}));
    history_ = {};
    find(TwoCorners{});
    EXPECT_EQ(history_.torsion, (std::vector<double>{1, 1, 1, 1}));
}

/// Enough cubes for many chunks.
class LongStackTest : public ContactPhysicsTest {
 protected:
    LongStackTest() : ContactPhysicsTest(3000) {}
};

TEST_F(LongStackTest, ContactsKeepTheirOrderAndSpringsAcrossChunksAtAnyNumberOfThreads) {
    const int before = parallel::thread_count();
    parallel::set_thread_count(4);
    find(TwoCorners{});
    parallel::set_thread_count(3);
    find(TwoCorners{});
    parallel::set_thread_count(before);
    ASSERT_EQ(history_.size(), 2U * 2999U);
    for (std::size_t i = 0; i < history_.size(); ++i) {
        const auto a = static_cast<std::int32_t>(i / 2);
        ASSERT_EQ(history_.pair[i], pair_key({a, a + 1}));
        ASSERT_EQ(history_.feature[i], i % 2 == 0 ? left : right);
        ASSERT_EQ(history_.torsion[i], 2);
    }
}

}  // namespace
}  // namespace riprap::contact
