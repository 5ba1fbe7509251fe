// SPDX-License-Identifier: Apache-2.0
#include "riprap/sim/method_traits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "riprap/sim/methods.hpp"
#include "riprap/sim/model.hpp"
#include "riprap/sim/state.hpp"

namespace riprap::sim {

bool books_every_step(const Model& model) {
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

double grain(const Model& model) {
    return Fluids::visit(model.fluid, []<class Fluid>(const typename Fluid::Settings& settings) {
        if constexpr (requires { Fluid::grain(settings); }) {
            return Fluid::grain(settings);
        }
        return 0.0;
    });
}

double fluid_spacing(const Model& model) {
    return Fluids::visit(model.fluid, []<class Fluid>(const typename Fluid::Settings& settings) {
        if constexpr (requires { settings.settings().spacing; }) {
            return settings.settings().spacing;
        } else if constexpr (Fluid::leads) {
            return settings.spacing;
        } else {
            return 0.0;
        }
    });
}

bool fluid_leads(const Model& model) {
    return Fluids::visit(model.fluid,
                         []<class Fluid>(const typename Fluid::Settings& /*settings*/) { return Fluid::leads; });
}

bool meets_by_shapes(const Model& model) {
    return Solids::visit(model.solid, []<class Solid>(const typename Solid::Settings& settings) {
        if constexpr (requires { Solid::meets_by_shapes(settings); }) {
            return Solid::meets_by_shapes(settings);
        }
        return true;
    });
}

double smallest_stand_in(const Model& model) {
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

bool tells_depth(const Model& model) {
    return Solids::visit(model.solid, []<class Solid>(const typename Solid::Settings& /*settings*/) {
        return requires { requires Solid::tells_depth; };
    });
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

std::vector<std::string_view> solid_words() {
    std::vector<std::string_view> words;
    Solids::for_each([&]<class Solid>() { words.push_back(Solid::Settings::method_name); });
    return words;
}

std::vector<std::string_view> solids_that_tip_about_edges(const Model& model) {
    std::vector<std::string_view> words;
    Solids::for_each([&]<class Solid>() {
        using Settings = typename Solid::Settings;
        const bool tells = requires { requires Solid::tells_depth; };
        bool is_of_shapes = true;
        if constexpr (requires { Solid::smallest_stand_in(model.bodies, model.shapes, Settings{}); }) {
            is_of_shapes = std::isinf(Solid::smallest_stand_in(model.bodies, model.shapes, Settings{}));
        }
        const bool is_of_plane = requires(Settings settings) { settings.plane; };
        if (!tells && is_of_shapes && (model.bodies.is_planar || !is_of_plane)) {
            words.push_back(Settings::method_name);
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
        return solid::lacking_properties(scene, solid::kinds_of<Solid>(scene, settings),
                                         solid::reads_of<Solid>(settings));
    });
}

std::vector<solid::SceneProblem> solid_problems(const Model& model, const body::BodyState& bodies) {
    return Solids::visit(
        model.solid, [&]<class Solid>(const typename Solid::Settings& settings) -> std::vector<solid::SceneProblem> {
            if constexpr (requires { Solid::problems_of(solid_scene(model), settings, bodies); }) {
                return Solid::problems_of(solid_scene(model), settings, bodies);
            }
            return {};
        });
}

std::vector<solid::UnansweredBody> unanswered_bodies(const Model& model) {
    return Solids::visit(model.solid, [&]<class Solid>(const typename Solid::Settings& settings) {
        return solid::unanswered_bodies(model.bodies, solid::kinds_of<Solid>(solid_scene(model), settings),
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
        const auto* fields = Solids::find<Solid>(state.solid_fields);
        if constexpr (requires { Solid::misfit(solid_scene(model), settings, state.bodies, *fields); }) {
            return fields == nullptr ? "its fields are missing"
                                     : Solid::misfit(solid_scene(model), settings, state.bodies, *fields);
        }
        return {};
    });
}

std::string let_go_text(const Model& model, const State& state) {
    return Fluids::visit(model.fluid, [&]<class Fluid>(const typename Fluid::Settings& settings) -> std::string {
        if constexpr (requires(typename Fluid::Fields fields) { Fluid::let_go_text(settings, fields); }) {
            return Fluid::let_go_text(settings, std::get<typename Fluid::Fields>(state.fluid_fields));
        }
        return {};
    });
}

bool reads_gauge(const Model& model, const fluid::GaugeKind& kind) {
    return Fluids::visit(model.fluid, [&kind]<class Fluid>(const typename Fluid::Settings& /*settings*/) {
        return (kind.needs & ~Fluid::offers) == 0;
    });
}

std::vector<std::string_view> fluids_that_read(const fluid::GaugeKind& kind) {
    std::vector<std::string_view> words;
    const auto add = [&words]<class... Schemes>(const std::variant<Schemes...>* /*schemes*/) {
        (words.push_back(Schemes::method_name), ...);
    };
    Fluids::for_each([&]<class Fluid>() {
        if ((kind.needs & ~Fluid::offers) != 0) {
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

namespace {

/// Does a solid method say that it has an ability?
template <class Solid>
bool states(SolidAbility asks) {
    switch (asks) {
        case SolidAbility::locks:
            return requires { requires Solid::has_locks; };
        case SolidAbility::fixed_points:
            return requires { requires Solid::has_fixed_points; };
        case SolidAbility::bolts:
            return requires { requires Solid::has_bolts; };
    }
    return false;
}

}  // namespace

bool does(const Model& model, SolidAbility asks) {
    return Solids::visit(
        model.solid, [asks]<class Solid>(const typename Solid::Settings& /*settings*/) { return states<Solid>(asks); });
}

std::vector<std::string_view> solids_that(SolidAbility asks) {
    std::vector<std::string_view> words;
    Solids::for_each([&]<class Solid>() {
        if (states<Solid>(asks)) {
            words.push_back(Solid::Settings::method_name);
        }
    });
    return words;
}

}  // namespace riprap::sim
