// SPDX-License-Identifier: Apache-2.0
#pragma once

// What a solid method says of itself beyond what a step needs.

#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "riprap/core/account.hpp"
#include "riprap/core/fields.hpp"
#include "riprap/core/shown.hpp"
#include "riprap/solid/pair_physics.hpp"
#include "riprap/solid/solid_scene.hpp"

namespace riprap::solid {

namespace affine {
struct Elasticity;
}

/// Traits of a solid method, which its class declares as `static constexpr SolidTraits<Settings> traits{...}`. What it
/// leaves out has the default; a name that is none of these does not compile.
template <class Settings>
struct SolidTraits {
    using Fields = typename Settings::Fields;

    bool books_every_step{false};  ///< its ledger closes from the first step on; else what it dissipates is known late
    bool tells_depth{false};       ///< every contact tells how deep it is (ContactRow::potential), one a pair of parts
    bool has_locks{false};         ///< bodies may be locked along axes
    bool has_fixed_points{false}, has_bolts{false};
    bool is_of_plane{false};  ///< it moves planar scenes alone

    /// Settings that several methods have: the step that it wants, the elasticity of blocks; null: none.
    double Settings::*step{nullptr};
    affine::Elasticity Settings::*elasticity{nullptr};

    /// What ends a run: the speed of a body [m/s] and the determinant of its deformation [-]; 0: nothing of the kind.
    double (*max_speed)(const Settings&) = [](const Settings&) { return 0.0; };
    double (*max_stretch)(const Settings&) = [](const Settings&) { return 0.0; };
    /// Most rounds of an open-close iteration; 0: it has none.
    int (*open_close)(const Settings&) = [](const Settings&) { return 0; };
    /// Do bodies meet by their shapes? False where something that reaches beyond may stand for one.
    bool (*meets_by_shapes)(const Settings&) = [](const Settings&) { return true; };
    /// Smallest radius of what the method lets stand for the shapes of bodies [m].
    double (*smallest_stand_in)(const body::BodySet&, const geometry::ShapeSet&, const Settings&) =
        [](const body::BodySet&, const geometry::ShapeSet&, const Settings&) {
            return std::numeric_limits<double>::infinity();
        };
    /// Kind of every body.
    std::vector<BodyKind> (*kinds_of)(const SolidScene&, const Settings&) =
        [](const SolidScene& scene, const Settings&) { return kinds_by_lists(scene); };
    /// The settings with what they leave to the scene. @param speed  of the hardest impact to come [m/s]
    Settings (*completed)(const SolidScene&, const Settings&, const body::BodyState&, double speed) =
        [](const SolidScene&, const Settings& settings, const body::BodyState&, double) { return settings; };
    /// Says why the method cannot move the scene.
    std::vector<SceneProblem> (*problems_of)(const SolidScene&, const Settings&, const body::BodyState&) =
        [](const SolidScene&, const Settings&, const body::BodyState&) { return std::vector<SceneProblem>(); };
    /// Says why fields that were read from a file are not of this scene. A method with fields has to have it.
    std::string (*misfit)(const SolidScene&, const Settings&, const body::BodyState&, const Fields&){nullptr};
    /// Accounts of energy that the method has besides those of all solids.
    std::span<const Account> (*accounts)() = [] { return std::span<const Account>(); };
    /// Fields that it shows of its bodies, and the value of one of them; null: none.
    std::span<const ShownField> (*shown)() = [] { return std::span<const ShownField>(); };
    double (*show)(const body::BodyState&, const Fields&, std::size_t body, std::size_t field){nullptr};
};

}  // namespace riprap::solid
