// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "riprap/contact/shown_contact.hpp"
#include "riprap/core/account.hpp"
#include "riprap/core/step.hpp"
#include "riprap/solid/faces_on_faces.hpp"
#include "riprap/solid/solid_method.hpp"
#include "riprap/solid/solid_scene.hpp"
#include "riprap/solid/solid_traits.hpp"
#include "riprap/solid/sphere_dem/look_ahead.hpp"
#include "riprap/solid/sphere_dem/sphere_dem_settings.hpp"
#include "riprap/solid/sphere_dem/sphere_model.hpp"
#include "riprap/solid/sphere_dem/sphere_physics.hpp"
#include "riprap/solid/sphere_dem/sphere_scratch.hpp"
#include "riprap/solid/sphere_dem/sphere_state.hpp"

namespace riprap::solid {

/// Bodies that meet by spheres and, where no spheres stand for them, by their faces; moved by drift, kick and drift,
/// bound to Model, State and Scratch for one step: SolidMethod (docs/theory/spheres.md).
class SphereDem final : public SolidMethod {
 public:
    using Settings = SphereDemSettings;
    using Fields = sphere_dem::SphereState;
    using Physics = sphere_dem::SpherePhysics;
    struct Scratch {
        sphere_dem::SphereSet spheres;  ///< a function of Model; made when they are first asked for
        sphere_dem::TriangleSet triangles;
        contact::ContactTable table;
        double strength_divisor{1};    ///< of both tables, see SolidScene [-]
        std::vector<double> cohesion;  ///< of pairs of materials, row after row [Pa]; empty where no pair has any
        sphere_dem::SphereScratch buffers;
        sphere_dem::LookAhead ahead;
        FacesOnFaces::Scratch faces;
        bool do_faces_meet{false};  ///< a body without spheres may move
        body::PointLoadSum point_loads;
        bool is_built{false};
        std::size_t bytes() const;
    };

    /// A sphere of the volume of a body reaches beyond its shape.
    static bool meets_by_shapes(const Settings& settings) { return settings.sampling != SphereSampling::one; }

    /// Returns the radius of the samples of surfaces [m].
    static double smallest_stand_in(const body::BodySet& bodies, const geometry::ShapeSet& shapes,
                                    const Settings& settings);

    /// Returns what every body meets others by (solid/pair_physics.hpp).
    static std::vector<BodyKind> kinds_of(const SolidScene& scene, const Settings& settings);
    /// Returns the settings with stiffnesses in place of those that the case leaves open (default_stiffness.hpp).
    /// @param speed  of the hardest impact to come [m/s]
    static Settings completed(const SolidScene& scene, const Settings& settings, const body::BodyState& state,
                              double speed);
    /// Refuses moduli that make the run take more steps than anybody waits for.
    static std::vector<SceneProblem> problems_of(const SolidScene& scene, const Settings& settings,
                                                 const body::BodyState& state);

    SphereDem(const SolidScene& scene, const Settings& settings, const SolidState& state, Fields& fields,
              Scratch& scratch);

    /// Returns a 7.5th of the shortest impact: with the default share of 0.15, an impact takes 50 steps. That is enough
    /// for whatever touches later.
    StepLimit lasting_limit() const override;
    /// Returns the same for the step that comes: longer where the contacts of sampled bodies allow it (look_ahead.hpp).
    StepLimit limit() const override;
    /// Moves the bodies over a piece of a step under loads that are held over it.
    Outcome advance(const TimeSpan& span, const body::LoadView& loads, Measure measure, SolidReport& report) override;

    static std::span<const Account> accounts();
    /// Seconds spent per stage so far.
    static const SolidTimes& times(const Scratch& scratch) { return scratch.buffers.times; }
    /// Sum of the contact forces and of their moments on every body in the last piece.
    static const body::Loads& contact_loads(const Scratch& scratch) { return scratch.buffers.loads; }
    /// Says why fields that were read from a file are not of this scene; empty where they are.
    static std::string misfit(const SolidScene& scene, const Settings& settings, const body::BodyState& bodies,
                              const Fields& fields);
    static constexpr SolidTraits<Settings> traits{
        .has_locks = true,
        .max_speed = [](const Settings& settings) { return settings.laws.max_speed; },
        .meets_by_shapes = &meets_by_shapes,
        .smallest_stand_in = &smallest_stand_in,
        .kinds_of = &kinds_of,
        .completed = &completed,
        .problems_of = &problems_of,
        .misfit = &misfit,
        .accounts = &accounts};
    /// Returns the contacts of the last piece, for output: those between spheres only where it measured everything.
    static std::vector<contact::ShownContact> contacts(const SolidScene& scene, const Settings& settings,
                                                       const Fields& fields, const Scratch& scratch);

 private:
    sphere_dem::SphereModel model() const;
    /// Returns the shorter one of the step of the spheres and that of bodies that meet by their faces.
    StepLimit shorter_of(const StepLimit& of_spheres) const;
    FacesOnFaces faces() const { return {*scene_, faces_settings_, state_, scratch_->faces}; }

    const SolidScene* scene_;
    const Settings* settings_;
    DemSettings faces_settings_;  ///< of bodies without spheres, and of the motion of all
    SolidState state_;
    Fields* fields_;
    Scratch* scratch_;
};

}  // namespace riprap::solid
