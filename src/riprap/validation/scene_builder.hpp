// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>

#include "riprap/geometry/shapes.hpp"
#include "riprap/sim/shown.hpp"
#include "riprap/validation/after_step.hpp"

namespace riprap::validation {

/// One body of a scene that a validation case builds by hand.
struct BodySpec {
    std::string name{};
    ShapeId shape{};
    MaterialId material{0};
    Pose pose{};  ///< of the shape as it was given, not of its centre of mass
    body::Drive drive{body::Drive::free};
    Vec3 velocity{};                  ///< of the centre of mass [m/s]
    Vec3 angular_velocity{};          ///< world axes [rad/s]
    body::PrescribedMotion motion{};  ///< of a driven body
};

/// Builds Model and State where a case file is not natural: analytic problems that sweep their own parameters.
/// Keeps the rules of scene/: materials are mixed by the mean, shapes are audited by their builders.
class SceneBuilder {
 public:
    explicit SceneBuilder(bool is_planar = false);

    MaterialId add_material(const material::Material& material);
    ShapeId add_shape(const geometry::Polyhedron& polyhedron);
    /// A shape from a builder that may refuse. @throws CaseError with its problem
    ShapeId add_shape(const geometry::Outcome<geometry::Polyhedron>& outcome);
    /// { x : normal . x <= offset }
    ShapeId add_half_space(const Vec3& normal, double offset);
    BodyId add_body(const BodySpec& spec);

    sim::Model model;
    sim::State state;

 private:
    Vec3 centroid_of(ShapeId shape) const { return centroids_[static_cast<std::size_t>(shape.value)]; }
    std::vector<Vec3> centroids_;  ///< of every shape in the frame it was given in [m]
};

/// A scene being advanced. Steps are those of largest_time_step with the default factor, or with water those of
/// choose_time_step, so no case tunes its own.
class Trial {
 public:
    explicit Trial(sim::Model model, sim::State state);
    explicit Trial(SceneBuilder scene) : Trial(std::move(scene.model), std::move(scene.state)) {}

    /// One step. @throws std::runtime_error with the reason when the step is not acceptable.
    const sim::StepReport& step();
    /// Steps until State's time reaches `time` (to half a step); look(*this) after every one.
    template <class Look>
    void run_until(double time, Look look) {
        while (state().time < time - 0.5 * dt_) {
            step();
            look(*this);
        }
    }
    void run_until(double time) {
        run_until(time, [](const Trial&) {});
    }

    /// Who is told after every step from now on; nobody where empty.
    void tell(AfterStep after_step) { after_step_ = std::move(after_step); }

    /// Cases that do not read energies save the time to work them out.
    void follow_energy(bool wanted) { measure_ = wanted ? sim::Measure::energy : sim::Measure::flow; }

    double dt() const { return dt_; }
    void set_dt(double dt) { dt_ = dt; }
    double time() const { return state_.time; }
    const sim::Model& model() const { return model_; }
    sim::Model& model() { return model_; }
    const sim::State& state() const { return state_; }
    sim::State& state() { return state_; }
    const sim::StepReport& report() const { return report_; }
    const sim::Scratch& scratch() const { return scratch_; }
    std::vector<contact::ShownContact> contacts() const { return shown_contacts(model_, state_, scratch_); }
    const Vec3& position(BodyId body) const { return state_.bodies.position[index(body)]; }
    const Vec3& velocity(BodyId body) const { return state_.bodies.velocity[index(body)]; }
    const Quat& orientation(BodyId body) const { return state_.bodies.orientation[index(body)]; }
    Vec3 angular_velocity(BodyId body) const { return body::angular_velocity(model_.bodies, state_.bodies, body); }
    /// By name; throws where there is none.
    BodyId body(const std::string& name) const;

 private:
    static std::size_t index(BodyId body) { return static_cast<std::size_t>(body.value); }

    sim::Model model_;
    sim::State state_;
    sim::Scratch scratch_;
    sim::StepReport report_;
    double dt_;
    sim::Measure measure_{sim::Measure::energy};
    AfterStep after_step_;
};

/// Unit vectors and a rotation, for short: the turn by `angle` about `axis` (any length).
Quat turn(const Vec3& axis, double angle);

}  // namespace riprap::validation
