// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/sphere_dem/sphere_dem.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "riprap/geometry/polyhedra/shapes.hpp"

namespace riprap::solid {
namespace {

/// A cube of 0.2 m on the ground, as a case file describes it.
struct Scene {
    geometry::ShapeSet shapes;
    material::MaterialSet materials;
    body::BodySet bodies;
    body::BodyState state;
    body::Gravity gravity{.value = {0, 0, -9.81}};
    contact::ContactHistory contacts;
    double previous_dt{0};
    SphereDemSettings settings;
    SphereDem::Fields fields;
    SphereDem::Scratch scratch;

    explicit Scene(double drop) {
        materials.materials.push_back({.name = "ice", .density = 900, .normal_stiffness = 1e7, .friction = 0.3});
        mix_pairs(materials, material::Mixing::mean, material::Mixing::mean);
        body::NewBody ground;
        ground.name = "ground";
        ground.material = MaterialId{0};
        ground.drive = body::Drive::fixed;
        ground.parts.push_back({{}, shapes.add_half_space({0, 0, 1}, 0), {}});
        add_body(bodies, state, shapes, ground);
        body::NewBody cube;
        cube.name = "cube";
        cube.material = MaterialId{0};
        cube.density = 900;
        cube.pose.position.z = 0.1 + drop;
        cube.parts.push_back({{}, shapes.add_convex(geometry::cube(0.2)), {}});
        add_body(bodies, state, shapes, cube);
    }
    /// Runs to `end`; returns the last report.
    SolidReport run(double end, double& time) {
        SolidReport report;
        const SolidScene scene{shapes, materials, bodies, gravity, {}};
        while (time < end) {
            SphereDem solids(scene, settings, {state, contacts, previous_dt}, fields, scratch);
            const TimeSpan span{time, 0.15 * solids.limit().longest};
            report = {};
            const Outcome outcome = solids.advance(span, {}, Measure::energy, report);
            EXPECT_EQ(outcome.problem, "");
            time += span.dt;
        }
        return report;
    }
};

TEST(SphereDem, ACubeOfACaseIsSampledFlushAndComesToRestOnItsFace) {
    Scene scene(0.01);
    double time = 0;
    const SolidReport report = scene.run(1.0, time);
    EXPECT_EQ(scene.scratch.spheres.size(), 6 * 2 * 2 + 12 * 2 + 8);  // faces, edges, corners
    EXPECT_EQ(scene.fields.walls.size(), 16U);                        // four of the face, twelve of its outline
    EXPECT_EQ(report.contact_count, 1);                               // one pair of bodies
    // A spring of 1/30 m for each of nine cells carries the weight: F = 4/3 E* sqrt(R) d^(3/2).
    const double modulus = 1e7 / (2 * (1 - 0.09)), each = 900 * 0.008 * 9.81 / 9;
    const double depth = std::pow(each / (4.0 / 3 * modulus * std::sqrt(0.1 / 3)), 2.0 / 3);
    EXPECT_NEAR(scene.state.position[1].z, 0.1 - depth, 1e-6);
    EXPECT_LT(norm(scene.state.velocity[1]), 1e-4);
    EXPECT_NEAR(SphereDem::contact_loads(scene.scratch).force[1].z, 900 * 0.008 * 9.81, 1e-3 * 70);
}

TEST(SphereDem, OneSphereOfABodyHasItsVolume) {
    Scene scene(0.05);
    scene.settings.sampling = SphereSampling::one;
    double time = 0;
    scene.run(1.0, time);
    const double radius = std::cbrt(0.75 * 0.008 / M_PI);
    ASSERT_EQ(scene.scratch.spheres.size(), 1);
    EXPECT_NEAR(scene.scratch.spheres.radius[0], radius, 1e-12);
    EXPECT_NEAR(scene.state.position[1].z, radius, 1e-3);
}

TEST(SphereDem, ARunThatIsInterruptedHasTheBitsOfOneThatIsNot) {
    Scene whole(0.01), broken(0.01);
    double time_whole = 0, time_broken = 0;
    whole.run(0.2, time_whole);
    broken.run(0.1, time_broken);
    broken.scratch = {};
    broken.run(0.2, time_broken);
    EXPECT_EQ(hash_fields(whole.state), hash_fields(broken.state));
    EXPECT_EQ(hash_fields(whole.fields), hash_fields(broken.fields));
}

}  // namespace
}  // namespace riprap::solid
