// SPDX-License-Identifier: Apache-2.0
#pragma once

// Properties that methods state of themselves beyond what a step needs. A method that does not say it has the default.

#include <algorithm>
#include <limits>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "riprap/sim/model.hpp"
#include "riprap/solid/pair_physics.hpp"

namespace riprap::sim {

/// Does the ledger close from the first step on? A solid method says so by `books_every_step`, a fluid by
/// `books_every_step(settings)`; else what it dissipates is known over some steps only.
inline bool books_every_step(const Model& model) {
    const bool of_solids = Solids::visit(model.solid, []<class Solid>(const typename Solid::Settings& /*settings*/) {
        return requires { requires Solid::books_every_step; };
    });
    return of_solids && Fluids::visit(model.fluid, []<class Fluid>(const typename Fluid::Settings& settings) {
               if constexpr (requires { Fluid::books_every_step(settings); }) {
                   return Fluid::books_every_step(settings);
               }
               return false;
           });
}

/// Height by which a fluid may settle when it is let go, `grain(settings)` of its method: the spacing of particles; by
/// default none [m].
inline double grain(const Model& model) {
    return Fluids::visit(model.fluid, []<class Fluid>(const typename Fluid::Settings& settings) {
        if constexpr (requires { Fluid::grain(settings); }) {
            return Fluid::grain(settings);
        }
        return 0.0;
    });
}

/// Do bodies meet by their shapes? A solid method for which something else may stand for a body says so by
/// `meets_by_shapes(settings)`; by default they do.
inline bool meets_by_shapes(const Model& model) {
    return Solids::visit(model.solid, []<class Solid>(const typename Solid::Settings& settings) {
        if constexpr (requires { Solid::meets_by_shapes(settings); }) {
            return Solid::meets_by_shapes(settings);
        }
        return true;
    });
}

/// Smallest radius of what a solid method lets stand for the shapes of bodies, its `smallest_stand_in(bodies, shapes,
/// settings)`; infinity by default [m].
inline double smallest_stand_in(const Model& model) {
    double least = Solids::visit(model.solid, [&]<class Solid>(const typename Solid::Settings& settings) {
        if constexpr (requires { Solid::smallest_stand_in(model.bodies, model.shapes, settings); }) {
            return Solid::smallest_stand_in(model.bodies, model.shapes, settings);
        }
        return std::numeric_limits<double>::infinity();
    });
    for (const body::GivenSpheres& given : model.spheres) {
        for (const body::ShapeSphere& sphere : given.spheres) {
            least = std::min(least, sphere.radius);
        }
    }
    return least;
}

/// Does every contact tell how deep it is (ContactRow::potential), one a pair of parts? A solid method says so by
/// `tells_depth`.
inline bool tells_depth(const Model& model) {
    return Solids::visit(model.solid, []<class Solid>(const typename Solid::Settings& /*settings*/) {
        return requires { requires Solid::tells_depth; };
    });
}

/// Returns the properties of materials that the solid method reads, whatever bodies the scene has.
inline std::vector<material::PropertyUse> property_uses(const Model& model) {
    return Solids::visit(model.solid, []<class Solid>(const typename Solid::Settings& settings) {
        return solid::joined(solid::reads_of<Solid>(settings));
    });
}

/// Does the solid method, with the settings of the case, read a property?
inline bool reads_property(const Model& model, material::Property property) {
    return std::ranges::any_of(property_uses(model), [property](const material::PropertyUse& use) {
        return use.property == property && use.acts;
    });
}

/// Returns the words of the solid methods that can read a property of materials.
inline std::vector<std::string_view> solids_that_read(material::Property property) {
    std::vector<std::string_view> words;
    Solids::for_each([&]<class Solid>() {
        for (const material::PropertyUse& use : solid::joined(solid::reads_of<Solid>(typename Solid::Settings{}))) {
            if (use.property == property) {
                words.push_back(Solid::Settings::method_name);
            }
        }
    });
    return words;
}

/// Does the fluid read gauges of a kind? It says so by `reads(kind)`.
inline bool reads_gauge(const Model& model, fluid::GaugeKind kind) {
    return Fluids::visit(
        model.fluid, [kind]<class Fluid>(const typename Fluid::Settings& /*settings*/) { return Fluid::reads(kind); });
}

// Abilities of a solid method besides moving bodies, each stated by a member of this name.
inline constexpr auto has_locks = []<class Solid>() {
    return requires { requires Solid::has_locks; };
};
inline constexpr auto has_fixed_points = []<class Solid>() {
    return requires { requires Solid::has_fixed_points; };
};
inline constexpr auto has_bolts = []<class Solid>() {
    return requires { requires Solid::has_bolts; };
};

/// Does the solid method do what is asked for, one of those above?
template <class Asks>
bool does(const Model& model, const Asks& asks) {
    return Solids::visit(model.solid, [&asks]<class Solid>(const typename Solid::Settings& /*settings*/) {
        return asks.template operator()<Solid>();
    });
}

/// Returns the words of the solid methods that do.
template <class Asks>
std::vector<std::string_view> solids_that(const Asks& asks) {
    std::vector<std::string_view> words;
    Solids::for_each([&]<class Solid>() {
        if (asks.template operator()<Solid>()) {
            words.push_back(Solid::Settings::method_name);
        }
    });
    return words;
}

/// Returns the words of the fluids that read gauges of a kind.
inline std::vector<std::string_view> fluids_that_read(fluid::GaugeKind kind) {
    std::vector<std::string_view> words;
    const auto add = [&words]<class... Schemes>(const std::variant<Schemes...>* /*schemes*/) {
        (words.push_back(Schemes::method_name), ...);
    };
    Fluids::for_each([&]<class Fluid>() {
        if (!Fluid::reads(kind)) {
            return;
        }
        if constexpr (requires { typename Fluid::Settings::Choices; }) {
            add(static_cast<const typename Fluid::Settings::Choices*>(nullptr));
        } else if constexpr (Fluid::is_there) {
            words.push_back(Fluid::Settings::method_name);
        }
    });
    return words;
}

}  // namespace riprap::sim
