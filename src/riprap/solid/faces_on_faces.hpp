// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "riprap/contact/narrowphase/hull.hpp"
#include "riprap/contact/pipeline.hpp"
#include "riprap/core/step.hpp"
#include "riprap/solid/dem_settings.hpp"
#include "riprap/solid/pair_physics.hpp"

namespace riprap::solid {

/// Rigid bodies that meet by their faces, by the physics that DemSettings::pair_contact chooses; bound to Model, State
/// and Scratch for one step.
class FacesOnFaces {
 public:
    static constexpr PairOfKinds kinds{BodyKind::faces, BodyKind::faces};
    static std::vector<material::PropertyUse> reads(const DemSettings& settings);
    struct Scratch {
        contact::ContactPipeline pipeline;
        std::vector<contact::HullTopology> topologies;  ///< by shape, for the common plane: a function of Model
        std::vector<std::uint8_t> left_out;             ///< per body: it meets others by another kind; empty: none does
        body::Loads loads;                              ///< of the last contacts
        SolidTimes times;
        std::optional<StepLimit> limit;  ///< a function of Model; set when it is first asked for
        std::size_t bytes() const { return pipeline.bytes() + loads.bytes(); }
    };

    FacesOnFaces(const SolidScene& scene, const DemSettings& settings, const SolidState& state, Scratch& scratch)
        : scene_(&scene), settings_(&settings), state_(state), scratch_(&scratch) {}

    /// Returns 2/omega_max of bodies covered by neighbours all around (time_step_bound).
    StepLimit limit() const;
    /// Updates the candidate pairs at the poses of the State. @returns true when they were searched afresh
    bool find();
    /// Answers the candidates that touch: contacts of the State, loads of the Scratch.
    /// @param sliding_time  since the last kick [s]
    void respond(const body::BodyKinematics& kinematics, double sliding_time, bool with_energy);
    const body::Loads& loads() const { return scratch_->loads; }
    /// Adds the contacts to a report, after the kick. @returns why an overlap ends the run
    /// @param kinematics  before the kick
    Outcome book(const body::BodyKinematics& kinematics, double dt, SolidReport& report) const;

 private:
    contact::ContactScene contact_scene() const;

    const SolidScene* scene_;
    const DemSettings* settings_;
    SolidState state_;
    Scratch* scratch_;
    double lost_{0};  ///< by friction, of springs whose contact was lost [J]
};

}  // namespace riprap::solid
