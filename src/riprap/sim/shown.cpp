// SPDX-License-Identifier: Apache-2.0
#include "riprap/sim/shown.hpp"

#include <algorithm>
#include <limits>

#include "riprap/sim/method_scratch.hpp"

namespace riprap::sim {

namespace {

template <class Method>
inline constexpr bool shows = requires {
    Method::shown();
};

template <class Fluid>
inline constexpr bool draws_water = requires(coupling::FluidScene scene, typename Fluid::Settings settings,
                                             typename Fluid::Fields fields) {
    Fluid::shown(scene, settings, fields);
};

template <class Method>
std::span<const ShownField> shown_by() {
    if constexpr (shows<Method>) {
        return Method::shown();
    } else {
        return {};
    }
}

double value_of(const Model& model, const State& state, std::size_t field, std::size_t body) {
    return Solids::visit(model.solid, [&]<class Solid>(const typename Solid::Settings&) {
        if constexpr (shows<Solid>) {
            return Solid::show(state.bodies, Solids::entry<Solid>(state.solid_fields), body, field);
        } else {
            return std::numeric_limits<double>::quiet_NaN();
        }
    });
}

}  // namespace

std::span<const ShownField> shown_fields(const Model& model) {
    return Solids::visit(model.solid, []<class Solid>(const typename Solid::Settings&) { return shown_by<Solid>(); });
}

const std::vector<ShownField>& all_shown_fields() {
    static const std::vector<ShownField> all = [] {
        std::vector<ShownField> fields;
        Solids::for_each([&fields]<class Solid>() {
            for (const ShownField& field : shown_by<Solid>()) {
                const auto is_same = [&field](const ShownField& other) { return other.name == field.name; };
                if (std::none_of(fields.begin(), fields.end(), is_same)) {
                    fields.push_back(field);
                }
            }
        });
        return fields;
    }();
    return all;
}

std::vector<double> shown_values(const Model& model, const State& state, std::size_t field) {
    std::vector<double> values(state.bodies.position.size());
    for (std::size_t b = 0; b < values.size(); ++b) {
        values[b] = value_of(model, state, field, b);
    }
    return values;
}

double shown_value(const Model& model, const State& state, std::string_view name, BodyId body) {
    const std::span<const ShownField> fields = shown_fields(model);
    const auto is_it = [name](const ShownField& field) { return field.name == name; };
    const auto found = std::find_if(fields.begin(), fields.end(), is_it);
    return found == fields.end() ? std::numeric_limits<double>::quiet_NaN()
                                 : value_of(model, state, static_cast<std::size_t>(found - fields.begin()),
                                            static_cast<std::size_t>(body.value));
}

std::vector<contact::ShownContact> shown_contacts(const Model& model, const State& state, const Scratch& scratch) {
    const solid::SolidScene scene = solid_scene(model);
    return Solids::visit(model.solid, [&]<class Solid>(const typename Solid::Settings& settings) {
        const typename Solid::Fields* fields = Solids::find<Solid>(state.solid_fields);
        const typename Solid::Scratch* own = Solids::find<Solid>(scratch.data().methods->solid);
        return fields != nullptr && own != nullptr ? Solid::contacts(scene, settings, *fields, *own)
                                                   : std::vector<contact::ShownContact>();
    });
}

bool shows_water(const Model& model) {
    return Fluids::visit(model.fluid,
                         []<class Fluid>(const typename Fluid::Settings& /*settings*/) { return draws_water<Fluid>; });
}

std::optional<fluid::grid::ShownWater> show_water(const Model& model, const State& state) {
    return Fluids::visit(
        model.fluid,
        [&]<class Fluid>(const typename Fluid::Settings& settings) -> std::optional<fluid::grid::ShownWater> {
            const coupling::FluidScene scene{model.shapes, model.bodies, model.gravity};
            if constexpr (draws_water<Fluid>) {
                return Fluid::shown(scene, settings, std::get<typename Fluid::Fields>(state.fluid_fields));
            } else {
                return std::nullopt;
            }
        });
}

}  // namespace riprap::sim
