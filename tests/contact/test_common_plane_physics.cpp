// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "riprap/contact/common_plane_physics.hpp"
#include "riprap/geometry/polyhedra/shapes.hpp"

namespace riprap::contact {
namespace {

/// Unit cubes and a half-space under them.
class CommonPlanePhysicsTest : public ::testing::Test {
 protected:
    CommonPlanePhysicsTest() {
        materials_.materials.push_back({.name = "rock", .density = 2000, .normal_stiffness = 1e7, .friction = 0.5});
        mix_pairs(materials_, material::Mixing::mean, material::Mixing::mean);
        cube_ = shapes_.add_convex(geometry::cube(1), false, nullptr);
        ground_ = shapes_.add_half_space({0, 0, 1}, -0.5);
        add({}, ground_, body::Drive::fixed);
    }
    void add(const Vec3& place, ShapeId shape, body::Drive drive = body::Drive::free) {
        body::NewBody block;
        block.name = "block";
        block.material = MaterialId{0};
        block.density = 2000;
        block.drive = drive;
        block.pose = {place, {}};
        block.parts = {{BodyId{}, shape, Pose{}}};
        add_body(bodies_, state_, shapes_, block);
    }
    double find(PlaneLaw law) {
        topologies_ = hull_topologies(shapes_);
        body::update_kinematics(bodies_, state_, 0, kinematics_);
        pipeline_.place_parts(scene_, state_);
        pipeline_.find_pairs();
        return pipeline_.find_contacts(CommonPlanePhysics{topologies_, bodies_, friction_, law}, scene_, state_,
                                       kinematics_, 1e-3, history_);
    }
    Vec3 force_on(std::int32_t body) {
        auto loads = gathered();
        return loads.force[static_cast<std::size_t>(body)];
    }
    body::Loads gathered() {
        body::Loads loads;
        pipeline_.gather_loads(scene_, state_, loads);
        return loads;
    }

    geometry::ShapeSet shapes_;
    material::MaterialSet materials_;
    body::BodySet bodies_;
    body::BodyState state_;
    body::BodyKinematics kinematics_;
    std::vector<HullTopology> topologies_;
    Frictions friction_;
    ShapeId cube_, ground_;
    ContactScene scene_{shapes_, materials_, bodies_, 2, 0.1};
    ContactPipeline pipeline_;
    ContactHistory history_;
};

TEST_F(CommonPlanePhysicsTest, a_flat_soft_contact_is_as_stiff_as_its_area_says) {
    add({0, 0, 0}, cube_);
    add({0.25, 0, 0.99}, cube_);
    state_.position[1].z = 10;
    state_.position[2].z = 10.99;
    find(PlaneLaw::soft);
    EXPECT_EQ(pipeline_.rows().size(), 4U);
    // k = 2 x 1e7/0.5 Pa/m on 0.75 m^2, and a hundredth of r^2 for each of the four points.
    EXPECT_NEAR(force_on(2).z, 4e7 * (0.75 + 4 * 0.01 * 0.25) * 0.01, 1e-6);
    EXPECT_NEAR(force_on(1).z, -force_on(2).z, 1e-9);
}

TEST_F(CommonPlanePhysicsTest, a_cube_stands_on_a_half_space_by_four_corners_without_a_moment) {
    add({0, 0, -0.01}, cube_);
    find(PlaneLaw::penalty);
    EXPECT_EQ(pipeline_.rows().size(), 4U);
    EXPECT_NEAR(force_on(1).z, 4 * 2e7 * 0.25 * 0.01, 1e-6);
    EXPECT_NEAR(norm(gathered().torque[1]), 0, 1e-9);
}

TEST_F(CommonPlanePhysicsTest, friction_holds_against_spin_as_a_disc_of_each_points_area_under_even_pressure) {
    materials_.materials[0].has_torsion = true;
    mix_pairs(materials_, material::Mixing::mean, material::Mixing::mean);
    add({0, 0, -0.01}, cube_);
    state_.angular_momentum[1] = angular_momentum_of(bodies_, BodyId{1}, {}, {0, 0, 1e4});  // far beyond its limit
    find(PlaneLaw::penalty);
    ASSERT_EQ(pipeline_.rows().size(), 4U);
    const double disc = std::sqrt(0.25 / M_PI);
    double couple = 0;  // integral of mu p r over the disc by rings, F = 1
    constexpr int rings = 1000;
    for (int k = 0; k < rings; ++k) {
        const double r = (k + 0.5) * disc / rings;
        couple += 0.5 * r * 2 * r / (disc * rings);
    }
    for (const ContactRow& row : pipeline_.rows()) {
        EXPECT_NEAR(std::abs(row.moment.z), couple * 2e7 * 0.25 * 0.01, 1e-5 * 5e4);
    }
}

/// Two unit cubes that cross edge on edge, the edges along y and x, so deep in each other.
TEST_F(CommonPlanePhysicsTest, a_soft_contact_of_two_edges_is_as_stiff_as_the_section_that_they_share) {
    add({0, 0, 10}, cube_);
    add({0, 0, 0}, cube_);
    state_.orientation[1] = from_rotation_vector(Vec3{0, M_PI / 4, 0});
    state_.orientation[2] = from_rotation_vector(Vec3{M_PI / 4, 0, 0});
    double work = 0, before = 0;
    constexpr int steps = 400;
    constexpr double deepest = 0.2;
    for (int k = 1; k <= steps; ++k) {
        const double depth = deepest * k / steps;
        state_.position[2].z = 10 + std::sqrt(2.0) - depth;
        history_ = {};
        find(PlaneLaw::soft);
        ASSERT_EQ(pipeline_.rows().size(), 1U) << depth;
        const double force = force_on(2).z;
        // Half of the depth below its edge each cube is as wide as the depth; a hundredth of r^2 is always there.
        ASSERT_NEAR(force, 4e7 * (depth * depth + 0.01 * 0.25) * depth, 1e-7 * force) << depth;
        work += 0.5 * (force + before) * deepest / steps;
        before = force;
    }
    EXPECT_NEAR(pipeline_.rows()[0].elastic_energy, work, 1e-4 * work);
}

TEST_F(CommonPlanePhysicsTest, a_pair_apart_has_no_contact_and_is_remembered_as_apart) {
    add({0, 0, 10}, cube_);
    add({0.1, 0, 11.01}, cube_);
    find(PlaneLaw::soft);
    EXPECT_EQ(pipeline_.rows().size(), 0U);
    state_.position[2].z = 10.99;
    find(PlaneLaw::soft);
    EXPECT_EQ(pipeline_.rows().size(), 4U);
}

}  // namespace
}  // namespace riprap::contact
