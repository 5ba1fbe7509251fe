// SPDX-License-Identifier: Apache-2.0
#include "riprap/sim/method_traits.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "riprap/sim/methods.hpp"
#include "riprap/sim/model.hpp"
#include "riprap/sim/state.hpp"

namespace riprap::sim {

namespace {

/// Calls ask(traits, settings) with those of the method of the case.
template <class Ask>
auto of_solid(const SolidSettings& solid, const Ask& ask) {
    return Solids::visit(
        solid, [&ask]<class Solid>(const typename Solid::Settings& settings) { return ask(Solid::traits, settings); });
}
template <class Ask>
auto of_fluid(const Model& model, const Ask& ask) {
    return Fluids::visit(model.fluid, [&ask]<class Fluid>(const typename Fluid::Settings& settings) {
        return ask(Fluid::traits, settings);
    });
}

}  // namespace

bool books_every_step(const Model& model) {
    return of_solid(model.solid, [](const auto& traits, const auto&) { return traits.books_every_step; }) &&
           of_fluid(model, [](const auto& traits, const auto& settings) { return traits.books_every_step(settings); });
}

double grain(const Model& model) {
    return of_fluid(model, [](const auto& traits, const auto& settings) { return traits.grain(settings); });
}

double grain_mass(const Model& model) {
    return of_fluid(model, [](const auto& traits, const auto& settings) { return traits.grain_mass(settings); });
}

const fluid::Domain* fluid_domain(const Model& model) {
    return of_fluid(model, [](const auto& traits, const auto& settings) { return traits.domain(settings); });
}

double fluid_spacing(const Model& model) {
    return of_fluid(model, [](const auto& traits, const auto& settings) { return traits.spacing(settings); });
}

double cell_width(const Model& model) {
    return of_fluid(model, [](const auto& traits, const auto& settings) { return traits.cell_width(settings); });
}

double courant(const Model& model) {
    return of_fluid(model, [](const auto& traits, const auto& settings) { return traits.courant(settings); });
}

std::size_t fluid_bytes(const Model& model) {
    return of_fluid(model, [](const auto& traits, const auto& settings) { return traits.bytes(settings); });
}

std::string cells_text(const Model& model) {
    return of_fluid(model, [](const auto& traits, const auto& settings) { return traits.cells_text(settings); });
}

std::vector<std::string> absorbed_ranges(const Model& model) {
    return of_fluid(model, [](const auto& traits, const auto& settings) { return traits.absorbed_ranges(settings); });
}

bool starts_slowly(const Model& model) {
    return of_fluid(model, [](const auto& traits, const auto& settings) { return traits.starts_slowly(settings); });
}

bool makes_up(const Model& model) {
    return of_fluid(model, [](const auto& traits, const auto&) { return traits.makes_up; });
}

bool fluid_leads(const Model& model) {
    return of_fluid(model, [](const auto& traits, const auto&) { return traits.leads; });
}

bool meets_by_shapes(const Model& model) {
    return of_solid(model.solid,
                    [](const auto& traits, const auto& settings) { return traits.meets_by_shapes(settings); });
}

double smallest_stand_in(const Model& model) {
    double least = of_solid(model.solid, [&](const auto& traits, const auto& settings) {
        return traits.smallest_stand_in(model.bodies, model.shapes, settings);
    });
    for (const body::GivenSpheres& given : model.spheres) {
        for (const body::ShapeSphere& sphere : given.spheres) {
            least = std::min(least, sphere.radius);
        }
    }
    return least;
}

bool tells_depth(const Model& model) {
    return of_solid(model.solid, [](const auto& traits, const auto&) { return traits.tells_depth; });
}

const double* step_of(const SolidSettings& solid) {
    return Solids::visit(solid, []<class Solid>(const typename Solid::Settings& settings) -> const double* {
        return Solid::traits.step == nullptr ? nullptr : &(settings.*Solid::traits.step);
    });
}
double* step_of(SolidSettings& solid) { return const_cast<double*>(step_of(std::as_const(solid))); }

const solid::affine::Elasticity* elasticity_of(const SolidSettings& solid) {
    using Elasticity = solid::affine::Elasticity;
    return Solids::visit(solid, []<class Solid>(const typename Solid::Settings& settings) -> const Elasticity* {
        return Solid::traits.elasticity == nullptr ? nullptr : &(settings.*Solid::traits.elasticity);
    });
}
solid::affine::Elasticity* elasticity_of(SolidSettings& solid) {
    return const_cast<solid::affine::Elasticity*>(elasticity_of(std::as_const(solid)));
}

double max_speed(const Model& model) {
    return of_solid(model.solid, [](const auto& traits, const auto& settings) { return traits.max_speed(settings); });
}

double max_stretch(const Model& model) {
    return of_solid(model.solid, [](const auto& traits, const auto& settings) { return traits.max_stretch(settings); });
}

int open_close(const Model& model) {
    return of_solid(model.solid, [](const auto& traits, const auto& settings) { return traits.open_close(settings); });
}

bool is_of_plane(const Model& model) {
    return of_solid(model.solid, [](const auto& traits, const auto&) { return traits.is_of_plane; });
}

std::vector<material::PropertyUse> property_uses(const Model& model) {
    return Solids::visit(model.solid, []<class Solid>(const typename Solid::Settings& settings) {
        return solid::joined(solid::reads_of<Solid>(settings));
    });
}

bool reads_property(const Model& model, material::Property property) {
    return std::ranges::any_of(property_uses(model), [property](const material::PropertyUse& use) {
        return use.property == property && use.acts;
    });
}

bool reads_among_bodies(const Model& model, material::Property property) {
    const solid::SolidScene scene = solid_scene(model);
    const std::optional<bool> is_read =
        Solids::visit(model.solid, [&]<class Solid>(const typename Solid::Settings& settings) {
            return solid::is_read_in_scene(scene, Solid::traits.kinds_of(scene, settings),
                                           solid::reads_of<Solid>(settings), property);
        });
    return is_read.value_or(reads_property(model, property));
}

std::vector<std::string_view> solid_words() {
    std::vector<std::string_view> words;
    Solids::for_each([&]<class Solid>() { words.push_back(Solid::Settings::method_name); });
    return words;
}

std::vector<std::string_view> solids_that_tip_about_edges(const Model& model) {
    std::vector<std::string_view> words;
    Solids::for_each([&]<class Solid>() {
        const auto& traits = Solid::traits;
        const bool is_of_shapes =
            std::isinf(traits.smallest_stand_in(model.bodies, model.shapes, typename Solid::Settings{}));
        if (!traits.tells_depth && is_of_shapes && (model.bodies.is_planar || !traits.is_of_plane)) {
            words.push_back(Solid::Settings::method_name);
        }
    });
    return words;
}

std::vector<material::PropertyUse> property_uses(std::string_view solid_word) {
    std::vector<material::PropertyUse> uses;
    Solids::for_each([&]<class Solid>() {
        if (Solid::Settings::method_name == solid_word) {
            uses = solid::joined(solid::reads_of<Solid>(typename Solid::Settings{}));
        }
    });
    return uses;
}

std::vector<std::string_view> solids_that_read(material::Property property) {
    std::vector<std::string_view> words;
    for (const std::string_view word : solid_words()) {
        const std::vector<material::PropertyUse> uses = property_uses(word);
        if (std::ranges::find(uses, property, &material::PropertyUse::property) != uses.end()) {
            words.push_back(word);
        }
    }
    return words;
}

std::vector<solid::LackingProperty> lacking_properties(const Model& model) {
    const solid::SolidScene scene = solid_scene(model);
    return Solids::visit(model.solid, [&]<class Solid>(const typename Solid::Settings& settings) {
        return solid::lacking_properties(scene, Solid::traits.kinds_of(scene, settings),
                                         solid::reads_of<Solid>(settings));
    });
}

std::vector<solid::SceneProblem> solid_problems(const Model& model, const body::BodyState& bodies) {
    return of_solid(model.solid, [&](const auto& traits, const auto& settings) {
        return traits.problems_of(solid_scene(model), settings, bodies);
    });
}

std::vector<solid::UnansweredBody> unanswered_bodies(const Model& model) {
    return Solids::visit(model.solid, [&]<class Solid>(const typename Solid::Settings& settings) {
        return solid::unanswered_bodies(model.bodies, Solid::traits.kinds_of(solid_scene(model), settings),
                                        solid::pairs_of<Solid>());
    });
}

std::vector<std::string_view> solids_that_answer(const solid::UnansweredBody& unanswered) {
    std::vector<std::string_view> words;
    Solids::for_each([&]<class Solid>() {
        if (std::ranges::all_of(unanswered.others, [&](solid::BodyKind other) {
                return solid::answers(solid::pairs_of<Solid>(), unanswered.kind, other);
            })) {
            words.push_back(Solid::Settings::method_name);
        }
    });
    return words;
}

std::string misfit_of_fields(const Model& model, const State& state) {
    return Solids::visit(model.solid, [&]<class Solid>(const typename Solid::Settings& settings) -> std::string {
        if (Solid::traits.misfit == nullptr) {
            return {};
        }
        const auto* fields = Solids::find<Solid>(state.solid_fields);
        return fields == nullptr ? "its fields are missing"
                                 : Solid::traits.misfit(solid_scene(model), settings, state.bodies, *fields);
    });
}

std::string let_go_text(const Model& model, const State& state) {
    return Fluids::visit(model.fluid, [&]<class Fluid>(const typename Fluid::Settings& settings) {
        const auto* fields = Fluids::find<Fluid>(state.fluid_fields);
        return fields == nullptr ? std::string() : Fluid::traits.let_go_text(settings, *fields);
    });
}

bool reads_gauge(const Model& model, const fluid::GaugeKind& kind) {
    return of_fluid(model, [&kind](const auto& traits, const auto&) { return (kind.needs & ~traits.offers) == 0; });
}

std::vector<std::string_view> fluids_that_read(const fluid::GaugeKind& kind) {
    std::vector<std::string_view> words;
    const auto add = [&words]<class... Schemes>(const std::variant<Schemes...>* /*schemes*/) {
        (words.push_back(Schemes::method_name), ...);
    };
    Fluids::for_each([&]<class Fluid>() {
        if ((kind.needs & ~Fluid::traits.offers) != 0) {
            return;
        }
        if constexpr (requires { typename Fluid::Settings::Choices; }) {
            add(static_cast<const typename Fluid::Settings::Choices*>(nullptr));
        } else if constexpr (Fluid::traits.is_there) {
            words.push_back(Fluid::Settings::method_name);
        }
    });
    return words;
}

namespace {

/// Does a solid method say that it has an ability?
bool states(const auto& traits, SolidAbility asks) {
    switch (asks) {
        case SolidAbility::locks:
            return traits.has_locks;
        case SolidAbility::fixed_points:
            return traits.has_fixed_points;
        case SolidAbility::bolts:
            return traits.has_bolts;
    }
    return false;
}

}  // namespace

bool does(const Model& model, SolidAbility asks) {
    return of_solid(model.solid, [asks](const auto& traits, const auto&) { return states(traits, asks); });
}

std::vector<std::string_view> solids_that(SolidAbility asks) {
    std::vector<std::string_view> words;
    Solids::for_each([&]<class Solid>() {
        if (states(Solid::traits, asks)) {
            words.push_back(Solid::Settings::method_name);
        }
    });
    return words;
}

}  // namespace riprap::sim
