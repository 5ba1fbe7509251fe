// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

#include "riprap/contact/law/joint_laws.hpp"
#include "riprap/solid/affine/elasticity.hpp"

namespace riprap {
template <class S>
struct MethodKeys;  // core/key.hpp
}

namespace riprap::solid::explicit_dda {

/// Which equations move a block.
enum class Form : std::uint8_t {
    pseudo_rigid,    ///< finite strain: large turns and stretches, energy and angular momentum kept
    twelve_unknowns  ///< small strain per step, the linear displacement function of DDA, turned exactly after each step
};

struct Settings {
    Form form{Form::pseudo_rigid};
    double mass_damping{0};  ///< c: v <- v/(1 + c dt), for quasi-static answers [1/s]
    double max_stretch{10};  ///< det F outside [1/max, max] ends the run [-]
    double safety{0.6};      ///< share of the stable step that is used [-]
    contact::JointLaws joint_law{};
};

struct State;  // state.hpp

}  // namespace riprap::solid::explicit_dda

namespace riprap::solid {

class ExplicitDda;

/// Keys of `solid.method = "explicit_dda"`.
struct ExplicitDdaSettings {
    using Method = ExplicitDda;
    using Fields = explicit_dda::State;
    static constexpr std::string_view method_name = "explicit_dda";
    static MethodKeys<ExplicitDdaSettings> keys();
    explicit_dda::Settings engine;
    affine::Elasticity elasticity;
};

}  // namespace riprap::solid
