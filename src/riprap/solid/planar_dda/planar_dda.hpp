// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "riprap/contact/shown_contact.hpp"
#include "riprap/core/account.hpp"
#include "riprap/core/shown.hpp"
#include "riprap/material/property.hpp"
#include "riprap/solid/planar_dda/make_blocks.hpp"
#include "riprap/solid/planar_dda/settings.hpp"
#include "riprap/solid/planar_dda/state.hpp"
#include "riprap/solid/planar_dda/step.hpp"
#include "riprap/solid/solid_method.hpp"
#include "riprap/solid/solid_traits.hpp"

namespace riprap::solid {

/// Deformable polygons moved by Shi's planar DDA, bound to Model, State and Scratch for one step: SolidMethod. The
/// whole step is that of planar_dda::advance; works and losses are those of planar_dda::Accounts.
class PlanarDda final : public SolidMethod {
 public:
    using Settings = PlanarDdaSettings;
    using Fields = PlanarDdaFields;
    struct Scratch {
        planar_dda::SceneBlocks scene;
        planar_dda::Settings settings;  ///< with the lengths of the scene
        bool is_made{false};
        planar_dda::Scratch engine;
        std::vector<planar_dda::Unknowns> driven, given;
        body::Loads loads;  ///< of contacts, in the last piece
        body::PointLoadSum point_loads;
        std::size_t bytes() const;
    };

    using Physics = PairPhysics<OwnFaces<PlanarDda>>;

    PlanarDda(const SolidScene& scene, const Settings& settings, const SolidState& state, Fields& fields,
              Scratch& scratch);

    /// Returns the properties of materials that contacts have.
    static std::vector<material::PropertyUse> reads(const Settings& settings);
    /// Returns why the method cannot move the scene: one that is not planar, outlines that are no polygon, stiffnesses
    /// out of range.
    static std::vector<SceneProblem> problems_of(const SolidScene& scene, const Settings& settings,
                                                 const body::BodyState& bodies);
    /// Returns the step of the settings, which the method wants for itself.
    StepLimit limit() const override { return {settings_->step, true, "step of planar DDA"}; }
    bool takes_back() const override { return true; }
    /// Moves the blocks over a piece of a step; a piece that does not settle is refused with nothing changed.
    Outcome advance(const TimeSpan& span, const body::LoadView& loads, Measure measure, SolidReport& report) override;
    /// Says why fields that were read from a file are not of this scene; empty where they are.
    static std::string misfit(const SolidScene& scene, const Settings& settings, const body::BodyState& bodies,
                              const Fields& fields);
    /// Returns the contacts of the last piece, for output.
    static std::vector<contact::ShownContact> contacts(const SolidScene& scene, const Settings& settings,
                                                       const Fields& fields, const Scratch& scratch);
    /// Seconds spent per stage so far.
    static const SolidTimes& times(const Scratch& scratch) { return scratch.engine.times; }
    /// Sum of the contact forces and of their moments on every body in the last piece.
    static const body::Loads& contact_loads(const Scratch& scratch) { return scratch.loads; }
    static std::span<const Account> accounts();
    /// Stress and strain in the plane, with von Mises' stress: as of blocks in space.
    static std::span<const ShownField> shown();
    static double show(const body::BodyState& bodies, const Fields& fields, std::size_t body, std::size_t field);

    static constexpr SolidTraits<Settings> traits{
        .has_fixed_points = true,
        .has_bolts = true,
        .is_of_plane = true,
        .step = &Settings::step,
        .elasticity = &Settings::elasticity,
        .open_close = [](const Settings& settings) { return settings.engine.max_iterations; },
        .problems_of = &problems_of,
        .misfit = &misfit,
        .accounts = &accounts,
        .shown = &shown,
        .show = &show};

 private:
    const SolidScene* scene_;
    const Settings* settings_;
    SolidState state_;
    Fields* fields_;
    Scratch* scratch_;
};

}  // namespace riprap::solid
