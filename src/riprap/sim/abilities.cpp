// SPDX-License-Identifier: Apache-2.0
#include "riprap/sim/abilities.hpp"

#include <algorithm>
#include <array>

#include "riprap/sim/method_traits.hpp"
#include "riprap/sim/methods.hpp"
#include "riprap/sim/model.hpp"

namespace riprap::sim {

namespace {

using material::Property;

constexpr std::array all{
    Ability{"moving_water", "water at rest", "water that moves and takes time to be moved: waves, drag, added mass"},
    Ability{"restitution", "no restitution", "a loss at impact that the materials set"},
    Ability{"bonds", "no bonds", "faces that cohesion and tensile strength hold together"}};

/// Tells whether a fluid moves: then its step bounds that of the run.
template <class Fluid>
constexpr bool moves() {
    return Fluid::traits.is_there && Fluid::traits.leads;
}

std::vector<Property> properties_of(std::string_view word) {
    return word == "restitution" ? std::vector{Property::restitution, Property::damping_ratio}
                                 : std::vector{Property::tensile_strength};
}

}  // namespace

std::span<const Ability> abilities() { return all; }

bool has_ability(const Model& model, std::string_view word) {
    if (word == "moving_water") {
        return Fluids::visit(model.fluid,
                             []<class Fluid>(const typename Fluid::Settings& /*settings*/) { return moves<Fluid>(); });
    }
    return std::ranges::any_of(properties_of(word), [&](Property property) { return reads_property(model, property); });
}

std::vector<std::string_view> methods_with(std::string_view word) {
    std::vector<std::string_view> words;
    if (word == "moving_water") {
        const auto add = [&words]<class... Schemes>(const std::variant<Schemes...>* /*schemes*/) {
            (words.push_back(Schemes::method_name), ...);
        };
        Fluids::for_each([&]<class Fluid>() {
            if constexpr (moves<Fluid>() && requires { typename Fluid::Settings::Choices; }) {
                add(static_cast<const typename Fluid::Settings::Choices*>(nullptr));
            } else if constexpr (moves<Fluid>()) {
                words.push_back(Fluid::Settings::method_name);
            }
        });
        return words;
    }
    for (const Property property : properties_of(word)) {
        for (const std::string_view method : solids_that_read(property)) {
            if (std::ranges::find(words, method) == words.end()) {
                words.push_back(method);
            }
        }
    }
    return words;
}

}  // namespace riprap::sim
