// SPDX-License-Identifier: Apache-2.0
#include "riprap/sim/shown.hpp"

#include <algorithm>
#include <limits>

#include "riprap/sim/method_scratch.hpp"

namespace riprap::sim {

namespace {

double value_of(const Model& model, const State& state, std::size_t field, std::size_t body) {
    return Solids::visit(model.solid, [&]<class Solid>(const typename Solid::Settings&) {
        const auto show = Solid::traits.show;
        return show != nullptr ? show(state.bodies, Solids::entry<Solid>(state.solid_fields), body, field)
                               : std::numeric_limits<double>::quiet_NaN();
    });
}

}  // namespace

std::span<const ShownField> shown_fields(const Model& model) {
    return Solids::visit(model.solid,
                         []<class Solid>(const typename Solid::Settings&) { return Solid::traits.shown(); });
}

const std::vector<ShownField>& all_shown_fields() {
    static const std::vector<ShownField> all = [] {
        std::vector<ShownField> fields;
        Solids::for_each([&fields]<class Solid>() {
            for (const ShownField& field : Solid::traits.shown()) {
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

bool draws_fluid(const Model& model) {
    return Fluids::visit(model.fluid, []<class Fluid>(const typename Fluid::Settings& /*settings*/) {
        return Fluid::traits.shown != nullptr;
    });
}

std::optional<fluid::ShownWater> shown_fluid(const Model& model, const State& state) {
    const coupling::FluidScene scene{model.shapes, model.bodies, model.gravity};
    return Fluids::visit(
        model.fluid, [&]<class Fluid>(const typename Fluid::Settings& settings) -> std::optional<fluid::ShownWater> {
            if (Fluid::traits.shown == nullptr) {
                return std::nullopt;
            }
            return Fluid::traits.shown(scene, settings, Fluids::entry<Fluid>(state.fluid_fields));
        });
}

}  // namespace riprap::sim
