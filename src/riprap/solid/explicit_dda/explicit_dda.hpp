// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "riprap/contact/shown_contact.hpp"
#include "riprap/core/account.hpp"
#include "riprap/material/property.hpp"
#include "riprap/solid/affine/body_bridge.hpp"
#include "riprap/solid/affine/shown_blocks.hpp"
#include "riprap/solid/explicit_dda/advance.hpp"
#include "riprap/solid/explicit_dda/settings.hpp"
#include "riprap/solid/solid_method.hpp"
#include "riprap/solid/solid_traits.hpp"

namespace riprap::solid {

/// Deformable convex blocks moved by explicit DDA, bound to Model, State and Scratch for one step: SolidMethod.
class ExplicitDda final : public SolidMethod {
 public:
    using Settings = ExplicitDdaSettings;
    using Fields = explicit_dda::State;
    struct Scratch : affine::SceneBlocks {
        explicit_dda::Scratch engine;
        std::size_t bytes() const;
    };

    using Physics = PairPhysics<OwnFaces<ExplicitDda>>;

    ExplicitDda(const SolidScene& scene, const Settings& settings, const SolidState& state, Fields& fields,
                Scratch& scratch);

    /// Returns the properties of materials that contacts have.
    static std::vector<material::PropertyUse> reads(const Settings& settings);
    /// Returns why the method cannot move the scene: bodies of several parts.
    static std::vector<SceneProblem> problems_of(const SolidScene& scene, const Settings& settings,
                                                 const body::BodyState& bodies);
    /// Returns the step that strain modes and eight contact points a block allow (explicit_dda::stable_step).
    StepLimit limit() const override;
    bool takes_back() const override { return true; }
    /// Moves the blocks over a piece of a step under loads that are held over it.
    Outcome advance(const TimeSpan& span, const body::LoadView& loads, Measure measure, SolidReport& report) override;
    static std::span<const Account> accounts();
    static std::span<const ShownField> shown() { return affine::shown_of_blocks(); }
    static double show(const body::BodyState& /*bodies*/, const Fields& fields, std::size_t body, std::size_t field) {
        return affine::show_block(fields.blocks, body, field);
    }
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

    static constexpr SolidTraits<Settings> traits{
        .elasticity = &Settings::elasticity,
        .max_stretch = [](const Settings& settings) { return settings.engine.max_stretch; },
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
