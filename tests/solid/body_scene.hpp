// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <span>
#include <string>
#include <vector>

#include "riprap/geometry/polyhedra/shapes.hpp"
#include "riprap/solid/solid_scene.hpp"

// Scenes of bodies for tests of solid methods: what the reader of cases makes, without a case.

namespace riprap::solid {

/// Model and State of bodies of one material.
struct BodyScene {
    geometry::ShapeSet shapes;
    material::MaterialSet materials;
    body::BodySet bodies;
    body::BodyState state;
    body::Gravity gravity{{0, 0, -9.81}};
    std::vector<body::FixedPoint> fixed_points;
    std::vector<body::Bolt> bolts;
    contact::ContactHistory contacts;
    double previous_dt{0};

    void add_material(const material::Material& material) {
        materials.materials.push_back(material);
        mix_pairs(materials, material::Mixing::mean, material::Mixing::mean);
    }
    ShapeId add_prism(std::span<const geometry::Point2> corners, Vec3* centroid = nullptr) {
        return shapes.add_convex(geometry::planar_prism(corners).value(), true, centroid);
    }
    /// Adds a body of the last material. Its name is "block"; parts lie in the axes of `pose`.
    BodyId add(const Pose& pose, const std::vector<body::Part>& parts, body::Drive drive = body::Drive::free,
               double release = INFINITY, double density = 0) {
        body::NewBody block;
        block.name = "block";
        block.name_index = bodies.size();
        block.material = MaterialId{materials.size() - 1};
        block.density = density > 0 ? density : materials.materials.back().density;
        block.drive = drive;
        block.release_time = release;
        block.pose = pose;
        block.parts = parts;
        return add_body(bodies, state, shapes, block);
    }
    BodyId add(const Pose& pose, ShapeId shape, body::Drive drive = body::Drive::free, double release = INFINITY,
               double density = 0) {
        return add(pose, {{BodyId{}, shape, Pose{}}}, drive, release, density);
    }
    BodyId add_cube(const Pose& pose, body::Drive drive = body::Drive::free, double release = INFINITY) {
        return add(pose, shapes.add_convex(geometry::cube(1), false, nullptr), drive, release);
    }
    SolidScene scene() const { return {shapes, materials, bodies, gravity, {}, fixed_points, bolts}; }
};

/// Bodies that a method of deformable blocks moves as a step driver would: rock of 2000 kg/m^3 and 0.1 GPa.
template <class Method>
struct MovedScene : BodyScene {
    typename Method::Settings settings;
    typename Method::Fields fields{};
    typename Method::Scratch scratch;
    double time{0};

    explicit MovedScene(double damping_ratio = 0) {
        add_material({.name = "rock",
                      .density = 2000,
                      .normal_stiffness = 1e7,
                      .friction = 0.5,
                      .damping_ratio = damping_ratio});
        settings.elasticity = {1e8, 0.25, 1e7};
    }
    /// Advances over [time, time + dt], whatever comes of it.
    Outcome advance(double dt, SolidReport& report, const body::LoadView& loads = {}) {
        const SolidScene all = scene();
        Method method(all, settings, {state, contacts, previous_dt}, fields, scratch);
        return method.advance({time, dt}, loads, Measure::energy, report);
    }
    /// Takes a step, in halves where it is refused, as the driver does. @returns the report of the last of them
    SolidReport step(double dt, const body::LoadView& loads = {}) {
        SolidReport report;
        const Outcome outcome = advance(dt, report, loads);
        if (outcome.shorten > 0 && dt > 1e-6) {
            step(0.5 * dt, loads);
            return step(0.5 * dt, loads);
        }
        EXPECT_EQ(outcome.problem, "");
        time += dt;
        return report;
    }
};

/// A floor in the plane z = 0 and three cubes that fall on it, each a little to the side of the one below.
template <class Method>
struct FallingCubes : MovedScene<Method> {
    FallingCubes() {
        this->gravity = {{0.5, 0, -9.81}};
        this->add({}, this->shapes.add_half_space({0, 0, 1}, 0), body::Drive::fixed);
        const ShapeId cube = this->shapes.add_convex(geometry::cube(1), false, nullptr);
        for (int i = 0; i < 3; ++i) {
            this->add({{0.1 * i, 0, 0.501 + 1.001 * i}, {}}, cube);
        }
    }
};

/// Moves blocks over `dt` by step(length), which says what came of it, in shorter pieces where one is refused.
template <class Step>
Outcome in_pieces(double dt, const Step& step) {
    const Outcome outcome = step(dt);
    if (outcome.ok() || outcome.shorten == 0 || dt < 1e-9) {
        return outcome;
    }
    const Outcome first = in_pieces(0.5 * dt, step);
    return first.ok() ? in_pieces(0.5 * dt, step) : first;
}

}  // namespace riprap::solid
