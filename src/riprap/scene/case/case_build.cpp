// SPDX-License-Identifier: Apache-2.0
// Names of a case, and what they stand for.
#include <fmt/format.h>

#include "riprap/scene/case/body_names.hpp"
#include "riprap/scene/case/case_build.hpp"
#include "riprap/scene/text/suggest.hpp"
#include "riprap/sim/quantity.hpp"

namespace riprap::scene {

Vec3 CaseBuild::up() const {
    const Vec3 gravity = model.gravity.value;
    return norm(gravity) > 0 ? -1.0 * normalized(gravity) : is_planar ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
}

void CaseBuild::claim_name(const Value& table) {
    const Value* name = table.find("name");
    if (name != nullptr && !names.emplace(name->text, name->place).second) {
        problem(name->place, fmt::format("the name '{}' is taken", name->text),
                "names of [[body]], [[pack]], [[rock_mass]] and [[section]] are unique");
    }
}

BodyId CaseBuild::body_named(const Value& name) {
    const BodyId body = sim::find_body(model.bodies, name.text);
    if (!body.is_valid() && (!is_claimed(name.text) || problems.empty())) {  // else the body itself has a problem
        const NameAnswer answer = answer_to_name(model.bodies, name.text);
        problem(name.place, answer.message, answer.allowed);
    }
    return body;
}

void CaseBuild::material_problem(const Value& name) {
    constexpr std::size_t most = 6;
    std::vector<std::string> known;
    std::string list;
    for (const auto& [material, id] : materials) {
        if (known.size() < most) {
            list += fmt::format("{}'{}'", known.empty() ? "" : ", ", material);
        }
        known.push_back(material);
    }
    const std::string meant = nearest(name.text, known);
    problem(name.place, fmt::format("there is no material '{}'", name.text),
            known.empty() ? fmt::format("a table [material.{}] with a density", name.text)
            : !meant.empty()
                ? fmt::format("did you mean '{}'?", meant)
                : fmt::format("a name of [material.NAME]: {}{}", list, known.size() > most ? ", ..." : ""));
}

MaterialId CaseBuild::material_of(const Value& table) {
    const Value& name = get(table, "material");
    const auto found = materials.find(name.text);
    if (found == materials.end()) {
        material_problem(name);
        return {};
    }
    used_materials.insert(found->second.value);
    return found->second;
}

}  // namespace riprap::scene
