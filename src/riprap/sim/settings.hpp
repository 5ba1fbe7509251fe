// SPDX-License-Identifier: Apache-2.0
#pragma once

// The methods that a case can choose from, by their settings: one line registers a method. Each settings struct names
// the class that moves the scene and the fields that this one keeps, neither of which is included here: who reads a
// scene knows no method (sim/methods.hpp does).

#include <type_traits>
#include <variant>

#include "riprap/coupling/grid_fluid/settings.hpp"
#include "riprap/coupling/hydrostatic/settings.hpp"
#include "riprap/coupling/no_fluid_settings.hpp"
#include "riprap/coupling/particle_walls/particle_fluid.hpp"
#include "riprap/solid/dem_settings.hpp"
#include "riprap/solid/explicit_dda/settings.hpp"
#include "riprap/solid/implicit_dda/settings.hpp"
#include "riprap/solid/planar_dda/settings.hpp"
#include "riprap/solid/sphere_dem/sphere_dem_settings.hpp"

namespace riprap::sim {

using SolidSettings = std::variant<  //
    solid::DemSettings,              //
    solid::SphereDemSettings,        //
    solid::ExplicitDdaSettings,      //
    solid::ImplicitDdaSettings,      //
    solid::PlanarDdaSettings         //
    >;
using FluidSettings = std::variant<  //
    coupling::NoFluidSettings,       //
    coupling::ParticleFluid,         //
    coupling::HydrostaticSettings,   //
    coupling::GridFluidSettings      //
    >;

namespace detail {
template <class... Settings>
struct Choices {
    using Variant = std::variant<Settings...>;
    template <class Next>
    static Choices<Settings..., Next> with(const Next*);
    template <class... Schemes>
    static Choices<Settings..., Schemes...> with(const std::variant<Schemes...>*);
};
template <class Found>
Found choices_of(Found);
template <class Found, class First, class... Rest>
auto choices_of(Found, const First*, const Rest*... rest) {
    if constexpr (std::is_same_v<First, coupling::NoFluidSettings>) {
        return choices_of(Found{}, rest...);
    } else if constexpr (requires { typename First::Choices; }) {
        return choices_of(decltype(Found::with(static_cast<const typename First::Choices*>(nullptr))){}, rest...);
    } else {
        return choices_of(decltype(Found::with(static_cast<const First*>(nullptr))){}, rest...);
    }
}
template <class Settings>
struct ChoicesOf;
template <class... Settings>
struct ChoicesOf<std::variant<Settings...>> {
    using Variant = typename decltype(choices_of(Choices<>{}, static_cast<const Settings*>(nullptr)...))::Variant;
};
}  // namespace detail

/// Settings that `fluid.method` chooses from: those of every fluid, or its `Choices` where it stands for a family (of
/// particles those of every scheme).
using FluidChoices = detail::ChoicesOf<FluidSettings>::Variant;

}  // namespace riprap::sim
