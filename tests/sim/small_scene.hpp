// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "riprap/geometry/polyhedra/shapes.hpp"
#include "riprap/sim/advance.hpp"

namespace riprap::sim {

/// A scene built by hand: the smallest thing `advance` accepts.
struct SmallScene {
    Model model;
    State state;

    SmallScene() {
        model.materials.materials.push_back({.name = "rock", .density = 2000, .normal_stiffness = 1e7});
        mix();
        model.time.end = 1;
    }
    material::Material& rock() { return model.materials.materials[0]; }
    void mix() { mix_pairs(model.materials, material::Mixing::mean, material::Mixing::mean); }

    ShapeId add_shape(const geometry::Polyhedron& polyhedron) {
        return model.shapes.add_convex(polyhedron, model.bodies.is_planar, nullptr);
    }
    BodyId add(const std::string& name, ShapeId shape, const Pose& pose, body::Drive drive = body::Drive::free,
               const Vec3& velocity = {}, const Vec3& angular_velocity = {}) {
        body::NewBody body;
        body.name = name;
        body.material = MaterialId{0};
        body.density = rock().density;
        body.drive = drive;
        body.pose = pose;
        body.velocity = velocity;
        body.angular_velocity = angular_velocity;
        body.parts = {{BodyId{}, shape, Pose{}}};
        return add_body(model.bodies, state.bodies, model.shapes, body);
    }
    /// Runs `steps` steps and returns the last report; stops early when a step is not accepted.
    StepReport run(std::int64_t steps, double dt) {
        if (state.step == 0) {
            initialise(model, state);
        }
        Scratch scratch;
        StepReport report;
        for (std::int64_t i = 0; i < steps && report.status.ok(); ++i) {
            report = advance(model, state, scratch, dt, i + 1 < steps ? Measure::flow : Measure::energy);
        }
        return report;
    }
    double automatic_step() const { return largest_time_step(model, time_step_bound(model)); }
};

}  // namespace riprap::sim
