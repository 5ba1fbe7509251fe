// SPDX-License-Identifier: Apache-2.0
// Balls and polyhedra that move and touch in one scene: solid.spheres = "balls".
#include <gtest/gtest.h>

#include <cmath>

#include "riprap/core/index.hpp"
#include "riprap/geometry/polyhedra/shapes.hpp"
#include "riprap/solid/polyhedral_dem/polyhedral_dem.hpp"
#include "riprap/solid/sphere_dem/sphere_dem.hpp"

namespace riprap::solid {
namespace {

constexpr double side = 2, radius = 0.5;

struct Scene {
    geometry::ShapeSet shapes;
    material::MaterialSet materials;
    body::BodySet bodies;
    body::BodyState state;
    body::Gravity gravity{};
    SphereDemSettings settings;
    contact::ContactHistory contacts;
    double previous_dt{0};
    sphere_dem::SphereState fields;
    SphereDem::Scratch scratch;

    explicit Scene(double friction = 0) {
        materials.materials.push_back(
            {.name = "stone", .density = 1000, .normal_stiffness = 1e7, .friction = friction});
        mix_pairs(materials, material::Mixing::mean, material::Mixing::mean);
        settings.sampling = SphereSampling::balls;
        settings.restitution = 1;
    }
    BodyId add(const geometry::Polyhedron& shape, const Vec3& position, const Vec3& velocity = {}) {
        body::NewBody body;
        body.name = "body";
        body.material = MaterialId{0};
        body.density = 1000;
        body.pose.position = position;
        body.velocity = velocity;
        body.parts.push_back({{}, shapes.add_convex(shape), {}});
        return add_body(bodies, state, shapes, body);
    }
    BodyId add_cube(const Vec3& position, const Vec3& velocity = {}) {
        return add(geometry::cube(side), position, velocity);
    }
    BodyId add_ball(const Vec3& position, const Vec3& velocity = {}) {
        return add(geometry::sphere(radius), position, velocity);
    }
    SolidScene view() const { return {shapes, materials, bodies, gravity, {}}; }
    SolidReport step(double time, double dt) {
        const SolidScene scene = view();
        SphereDem solids(scene, settings, {state, contacts, previous_dt}, fields, scratch);
        SolidReport report;
        EXPECT_EQ(solids.advance({time, dt}, {}, Measure::energy, report).problem, "");
        return report;
    }
    double limit() {
        const SolidScene scene = view();
        return SphereDem(scene, settings, {state, contacts, previous_dt}, fields, scratch).limit().longest;
    }
    const body::Loads& loads() const { return SphereDem::contact_loads(scratch); }
};

void expect_near(const Vec3& a, const Vec3& b, double tolerance) {
    EXPECT_LT(norm(a - b), tolerance) << "(" << a.x << ", " << a.y << ", " << a.z << ") and (" << b.x << ", " << b.y
                                      << ", " << b.z << ")";
}

/// A ball 0.01 m deep in a free cube about the origin, beside the point `touched` of its surface, along `outward`.
void expect_push(const Vec3& touched, const Vec3& outward) {
    constexpr double depth = 0.01;
    Scene scene;
    const BodyId cube = scene.add_cube({});
    const BodyId ball = scene.add_ball(touched + (radius - depth) * outward);
    const double volume_radius =
        std::cbrt(0.75 * scene.bodies.mass[at(ball.value)] / 1000 / M_PI);  // of the ball as it stands in the search
    scene.step(0, 1e-6);
    // Hertz [Mellado2021, eq. 4.7] with 1/E* = 2 (1 - nu^2)/E.
    const double modulus = 1e7 / (2 * (1 - 0.09)), overlap = volume_radius - (radius - depth);
    const double force = 4.0 / 3 * modulus * std::sqrt(volume_radius * overlap) * overlap;
    ASSERT_GT(force, 0);
    expect_near(scene.loads().force[at(ball.value)], force * outward, 1e-9 * force);
    expect_near(scene.loads().force[at(cube.value)], -force * outward, 1e-9 * force);
    expect_near(scene.loads().torque[at(cube.value)], cross(touched, -force * outward), 1e-9 * force);
    expect_near(scene.loads().torque[at(ball.value)], {}, 1e-9 * force);
}

TEST(MixedShapes, a_ball_on_a_face_of_a_free_cube_is_pushed_along_the_normal_of_the_face) {
    expect_push({0.4, -0.3, 1}, {0, 0, 1});
    expect_push({-1, 0.2, 0.7}, {-1, 0, 0});
}

TEST(MixedShapes, a_ball_on_an_edge_is_pushed_away_from_the_nearest_point_of_the_edge) {
    const double half = std::sqrt(0.5);
    expect_push({1, 0.3, 1}, {half, 0, half});
    expect_push({1, 0.3, 1}, {0.6, 0, 0.8});  // any direction between those of the faces
}

TEST(MixedShapes, a_ball_on_a_corner_is_pushed_away_from_the_corner) {
    const double third = std::sqrt(1.0 / 3);
    expect_push({1, 1, 1}, {third, third, third});
    expect_push({-1, 1, -1}, {-2.0 / 7, 3.0 / 7, -6.0 / 7});
}

TEST(MixedShapes, polyhedra_push_each_other_as_they_do_without_balls) {
    Scene scene(0.4);
    scene.add_cube({0, 0, 0}, {0, 0.1, 0});
    scene.add_cube({0.1, 0.2, 1.95}, {0, 0, -0.2});
    scene.add_ball({10, 0, 0});
    Scene other(0.4);
    other.add_cube({0, 0, 0}, {0, 0.1, 0});
    other.add_cube({0.1, 0.2, 1.95}, {0, 0, -0.2});
    DemSettings settings;
    PolyhedralDem::Scratch scratch;
    NoFields none;
    for (int k = 0; k < 20; ++k) {
        const double dt = 1e-4;
        scene.step(k * dt, dt);
        const SolidScene view = other.view();
        SolidReport report;
        PolyhedralDem(view, settings, {other.state, other.contacts, other.previous_dt}, none, scratch)
            .advance({k * dt, dt}, {}, Measure::energy, report);
    }
    EXPECT_GT(norm(scene.loads().force[0]), 1e3);
    for (std::size_t b = 0; b < 2; ++b) {
        EXPECT_EQ(scene.loads().force[b], PolyhedralDem::contact_loads(scratch).force[b]);
        expect_near(scene.state.velocity[b], other.state.velocity[b], 1e-15);
    }
    EXPECT_EQ(scene.contacts, other.contacts);
}

TEST(MixedShapes, a_scene_without_balls_is_one_of_polyhedra) {
    Scene scene(0.4);
    scene.add_cube({0, 0, 0}, {0, 0.1, 0});
    scene.add_cube({0.1, 0.2, 1.95}, {0, 0, -0.2});
    const double before = scene.state.velocity[1].z;
    const SolidReport report = scene.step(0, 1e-4);
    EXPECT_EQ(report.contact_count, 1);
    EXPECT_GT(report.elastic, 0);
    EXPECT_GT(scene.state.velocity[1].z, before);
    EXPECT_LT(scene.limit(), 1e-2);
}

TEST(MixedShapes, a_row_of_cube_ball_and_cube_passes_momentum_on_and_keeps_the_energy) {
    Scene scene;
    scene.add_cube({-3, 0, 0}, {1, 0, 0});
    scene.add_ball({0, 0, 0});
    scene.add_cube({1.6, 0, 0});  // touched by the ball, later hit
    const double dt = 0.02 * scene.limit();
    double time = 0, stored = 0;
    SolidReport report;
    while (time < 2.5) {
        report = scene.step(time, dt);
        time += dt;
        stored = std::max(stored, report.elastic);
    }
    const double mass = scene.bodies.mass[0];
    EXPECT_GT(stored, 1);
    EXPECT_GT(scene.state.velocity[2].x, 0.1);
    EXPECT_NEAR(report.kick.momentum.x, mass, 1e-9 * mass);
    EXPECT_NEAR(report.kick.kinetic + report.elastic, 0.5 * mass, 2e-3 * mass);
}

}  // namespace
}  // namespace riprap::solid
