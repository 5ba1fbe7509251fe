// SPDX-License-Identifier: Apache-2.0
#include "riprap/validation/scene_builder.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "riprap/core/error.hpp"
#include "riprap/sim/quantity.hpp"

namespace riprap::validation {

SceneBuilder::SceneBuilder(bool is_planar) { model.bodies.is_planar = is_planar; }

MaterialId SceneBuilder::add_material(const material::Material& material) {
    model.materials.materials.push_back(material);
    material::mix_pairs(model.materials, material::Mixing::mean, material::Mixing::mean);
    return MaterialId{model.materials.size() - 1};
}

ShapeId SceneBuilder::add_shape(const geometry::Polyhedron& polyhedron) {
    Vec3 centroid{};
    const ShapeId shape = model.shapes.add_convex(polyhedron, model.bodies.is_planar, &centroid);
    centroids_.push_back(centroid);
    return shape;
}

ShapeId SceneBuilder::add_shape(const geometry::Outcome<geometry::Polyhedron>& outcome) {
    if (!outcome) {
        std::vector<Diagnostic> problems;
        for (const geometry::GeometryProblem& problem : outcome.problems()) {
            problems.push_back({SourcePlace{}, problem.message, problem.allowed});
        }
        throw CaseError(std::move(problems));
    }
    return add_shape(outcome.value());
}

ShapeId SceneBuilder::add_half_space(const Vec3& normal, double offset) {
    centroids_.emplace_back();
    return model.shapes.add_half_space(normal, offset);
}

BodyId SceneBuilder::add_body(const BodySpec& spec) {
    body::NewBody body;
    body.name = spec.name;
    body.material = spec.material;
    body.density = model.materials[spec.material].density;
    body.drive = spec.drive;
    body.pose = spec.pose;
    body.velocity = spec.velocity;
    body.angular_velocity = spec.angular_velocity;
    if (spec.drive == body::Drive::driven) {
        body.motion = static_cast<std::int32_t>(model.bodies.motions.size());
        model.bodies.motions.push_back(spec.motion);
    }
    body.parts = {{BodyId{}, spec.shape, Pose{centroid_of(spec.shape), Quat{}}}};
    return body::add_body(model.bodies, state.bodies, model.shapes, body);
}

Trial::Trial(sim::Model model, sim::State state) : model_(std::move(model)), state_(std::move(state)) {
    dt_ = sim::largest_time_step(model_, sim::time_step_bound(model_, state_));
    sim::initialise(model_, state_);
}

const sim::StepReport& Trial::step() {
    if (model_.particles() != nullptr) {
        dt_ = sim::choose_time_step(model_, state_, scratch_).dt;
    }
    report_ = sim::advance(model_, state_, scratch_, dt_, measure_);
    if (!report_.status.ok()) {
        throw std::runtime_error(report_.status.text);
    }
    if (after_step_) {
        after_step_(state_.time, model_.time.end);
    }
    return report_;
}

BodyId Trial::body(const std::string& name) const {
    const BodyId found = sim::find_body(model_.bodies, name);
    if (!found.is_valid()) {
        throw std::runtime_error(fmt::format("the scene has no body called {}", name));
    }
    return found;
}

Quat turn(const Vec3& axis, double angle) { return from_rotation_vector(angle * normalized(axis)); }

}  // namespace riprap::validation
