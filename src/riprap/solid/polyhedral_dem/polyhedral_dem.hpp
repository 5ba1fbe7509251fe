// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "riprap/contact/narrowphase/hull.hpp"
#include "riprap/contact/pipeline.hpp"
#include "riprap/core/fields.hpp"
#include "riprap/core/step.hpp"
#include "riprap/solid/solid_scene.hpp"
#include "riprap/solid/time_step.hpp"

namespace riprap::solid {

/// Rigid polyhedra that repel by the distance potential or across the common plane, moved by drift, kick and drift,
/// bound to Model, State and Scratch for one step: SolidMethod.
class PolyhedralDem {
 public:
    using Settings = DemSettings;
    using Fields = NoFields;
    struct Scratch {
        contact::ContactPipeline pipeline;
        std::vector<contact::HullTopology> topologies;  ///< by shape, for the common plane: a function of Model
        body::Loads loads;                              ///< of contacts, in the last piece
        body::BodyKinematics kinematics;
        body::PointLoadSum point_loads;
        SolidTimes times;
        std::optional<StepLimit> limit;  ///< a function of Model; set when it is first asked for
        std::size_t bytes() const;
    };

    static constexpr bool books_every_step = true;  ///< see sim/method_traits.hpp
    static constexpr bool tells_depth = true;       ///< see there

    PolyhedralDem(const SolidScene& scene, const Settings& settings, const SolidState& state, Fields& /*fields*/,
                  Scratch& scratch)
        : scene_(&scene), settings_(&settings), state_(state), scratch_(&scratch) {}

    /// Returns 2/omega_max of bodies covered by neighbours all around (time_step_bound).
    StepLimit limit() const;
    /// Moves the bodies over a piece of a step under loads that are held over it.
    Outcome advance(const TimeSpan& span, const body::LoadView& loads, Measure measure, SolidReport& report);

    /// Contacts of the last piece, for output; valid until the next.
    static contact::ContactRows contacts(const Scratch& scratch) { return scratch.pipeline.rows(); }
    /// Sum of the contact forces and of their moments on every body in the last piece.
    static const body::Loads& contact_loads(const Scratch& scratch) { return scratch.loads; }

 private:
    const SolidScene* scene_;
    const DemSettings* settings_;
    SolidState state_;
    Scratch* scratch_;
};

}  // namespace riprap::solid
