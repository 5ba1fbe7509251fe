// SPDX-License-Identifier: Apache-2.0
#pragma once

// The classes of the methods that sim/settings.hpp lists: for the sources of this folder that ask them.

#include <concepts>
#include <cstddef>
#include <type_traits>
#include <variant>

#include "riprap/contact/shown_contact.hpp"
#include "riprap/coupling/grid_fluid/grid_fluid.hpp"
#include "riprap/coupling/hydrostatic/hydrostatic.hpp"
#include "riprap/coupling/no_fluid.hpp"
#include "riprap/coupling/particle_walls/particle_method.hpp"
#include "riprap/sim/settings.hpp"
#include "riprap/solid/explicit_dda/explicit_dda.hpp"
#include "riprap/solid/implicit_dda/implicit_dda.hpp"
#include "riprap/solid/planar_dda/planar_dda.hpp"
#include "riprap/solid/polyhedral_dem/polyhedral_dem.hpp"
#include "riprap/solid/sphere_dem/sphere_dem.hpp"

namespace riprap::sim {

/// Lists what the class of a solid method has beside the verbs of solid::SolidMethod: it is made for one step, and
/// answers for its own fields and buffers.
template <class M>
concept RegisteredSolid = std::derived_from<M, solid::SolidMethod> &&
    std::default_initializable<typename M::Settings> && std::default_initializable<typename M::Fields> &&
    std::default_initializable<typename M::Scratch> &&
    std::constructible_from<M, const solid::SolidScene&, const typename M::Settings&, const solid::SolidState&,
                            typename M::Fields&, typename M::Scratch&> &&
    std::same_as<decltype(M::traits), const solid::SolidTraits<typename M::Settings>> &&
    requires(const typename M::Scratch& scratch, const solid::SolidScene& scene, const typename M::Settings& settings,
             const typename M::Fields& fields) {
    requires std::same_as<typename M::Fields, NoFields> || M::traits.misfit != nullptr;
    { M::Physics::kinds.size() } -> std::same_as<std::size_t>;
    { M::contact_loads(scratch) } -> std::same_as<const body::Loads&>;
    { M::times(scratch) } -> std::same_as<const solid::SolidTimes&>;
    { M::contacts(scene, settings, fields, scratch) } -> std::same_as<std::vector<contact::ShownContact>>;
};

/// What the class of a fluid has beside the verbs of coupling::FluidMethod.
template <class M>
concept RegisteredFluid = std::derived_from<M, coupling::FluidMethod> &&
    std::constructible_from<M, const coupling::FluidScene&, const typename M::Settings&, const coupling::FluidState&,
                            typename M::Fields&, typename M::Scratch&> &&
    std::same_as<decltype(M::traits), const coupling::FluidTraits<typename M::Settings>> &&
    requires(const coupling::GaugeQuery<M>& query) {
    { M::read(query) } -> std::same_as<fluid::GaugeReading>;
};

/// A list of methods, and the buffers that are made of it for the Scratch.
template <class... Methods>
struct MethodList {
    using Scratch = std::variant<typename Methods::Scratch...>;

    /// Returns the alternative of Fields or Scratch that goes with these settings, made anew where another one stands.
    template <class Method, class Settings, class Variant>
    static auto& matching(const Settings& settings, Variant& variant) {
        constexpr std::size_t index = index_of<Method, 0, Methods...>();
        if (variant.index() != settings.index()) {
            variant.template emplace<index>();
        }
        return std::get<index>(variant);
    }

    /// Returns the alternative of Fields or Scratch of a method, which must be the one that stands there.
    template <class Method, class Variant>
    static const auto& entry(const Variant& variant) {
        return std::get<index_of<Method, 0, Methods...>()>(variant);
    }

    /// Returns it, or nullptr where another one stands: before the first step.
    template <class Method, class Variant>
    static const auto* find(const Variant& variant) {
        return std::get_if<index_of<Method, 0, Methods...>()>(&variant);
    }

    /// Calls work.template operator()<Method>(entry) with the entry of a Settings, Fields or Scratch and its method.
    template <class Variant, class Work>
    static decltype(auto) visit(const Variant& entries, const Work& work) {
        return visit_from<0, Variant, Work, Methods...>(entries, work);
    }
    /// Calls work.template operator()<Method>() for every method.
    template <class Work>
    static void for_each(const Work& work) {
        (work.template operator()<Methods>(), ...);
    }

 private:
    template <class Method, std::size_t index, class First, class... Rest>
    static constexpr std::size_t index_of() {
        if constexpr (std::is_same_v<Method, First>) {
            return index;
        } else {
            return index_of<Method, index + 1, Rest...>();
        }
    }
    template <std::size_t index, class Variant, class Work, class First, class... Rest>
    static decltype(auto) visit_from(const Variant& entries, const Work& work) {
        if constexpr (sizeof...(Rest) > 0) {
            if (entries.index() != index) {
                return visit_from<index + 1, Variant, Work, Rest...>(entries, work);
            }
        }
        return work.template operator()<First>(std::get<index>(entries));
    }
};

namespace detail {
template <class Settings>
struct MethodsOf;
template <class... Settings>
struct MethodsOf<std::variant<Settings...>> {
    using List = MethodList<typename Settings::Method...>;
};
}  // namespace detail

using Solids = detail::MethodsOf<SolidSettings>::List;
using Fluids = detail::MethodsOf<FluidSettings>::List;

namespace detail {
template <RegisteredSolid... Methods>
constexpr bool are_solids(const MethodList<Methods...>* /*list*/) {
    return true;
}
template <RegisteredFluid... Methods>
constexpr bool are_fluids(const MethodList<Methods...>* /*list*/) {
    return true;
}
// A method that lacks a function is named here, by the concept that it does not meet.
static_assert(are_solids(static_cast<const Solids*>(nullptr)) && are_fluids(static_cast<const Fluids*>(nullptr)));
}  // namespace detail

}  // namespace riprap::sim
