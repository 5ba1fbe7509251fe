// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/contact/shown_contact.hpp"
#include "riprap/core/fields.hpp"
#include "riprap/core/step.hpp"
#include "riprap/solid/faces_on_faces.hpp"
#include "riprap/solid/solid_method.hpp"
#include "riprap/solid/solid_scene.hpp"
#include "riprap/solid/solid_traits.hpp"

namespace riprap::solid {

/// Rigid polyhedra that repel by the distance potential or across the common plane, moved by drift, kick and drift,
/// bound to Model, State and Scratch for one step: SolidMethod.
class PolyhedralDem final : public SolidMethod {
 public:
    using Settings = DemSettings;
    using Fields = NoFields;
    using Physics = PairPhysics<FacesOnFaces>;
    struct Scratch {
        FacesOnFaces::Scratch faces;
        body::BodyKinematics kinematics;
        body::PointLoadSum point_loads;
        std::size_t bytes() const;
    };

    static constexpr SolidTraits<Settings> traits{
        .books_every_step = true, .tells_depth = true, .has_locks = true, .max_speed = [](const Settings& settings) {
            return settings.max_speed;
        }};

    PolyhedralDem(const SolidScene& scene, const Settings& settings, const SolidState& state, Fields& /*fields*/,
                  Scratch& scratch)
        : scene_(&scene), settings_(&settings), state_(state), scratch_(&scratch) {}

    /// Returns 2/omega_max of bodies covered by neighbours all around (time_step_bound).
    StepLimit limit() const override { return faces().limit(); }
    /// Moves the bodies over a piece of a step under loads that are held over it.
    Outcome advance(const TimeSpan& span, const body::LoadView& loads, Measure measure, SolidReport& report) override;

    /// Returns the contacts of the last piece, for output.
    static std::vector<contact::ShownContact> contacts(const SolidScene& scene, const Settings& settings,
                                                       const Fields& fields, const Scratch& scratch);
    /// Seconds spent per stage so far.
    static const SolidTimes& times(const Scratch& scratch) { return scratch.faces.times; }
    /// Sum of the contact forces and of their moments on every body in the last piece.
    static const body::Loads& contact_loads(const Scratch& scratch) { return scratch.faces.loads; }

 private:
    FacesOnFaces faces() const { return {*scene_, *settings_, state_, scratch_->faces}; }

    const SolidScene* scene_;
    const DemSettings* settings_;
    SolidState state_;
    Scratch* scratch_;
};

}  // namespace riprap::solid
