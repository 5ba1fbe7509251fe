// SPDX-License-Identifier: Apache-2.0
// Names of a case, and what they stand for.
#include <fmt/format.h>

#include "riprap/scene/build/build_case.hpp"
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
        const std::string meant = nearest(name.text, model.bodies.names);
        const bool is_of_many = meant == name.text;
        problem(name.place,
                is_of_many ? fmt::format("there are many bodies '{}'", name.text)
                           : fmt::format("there is no body '{}'", name.text),
                meant.empty() ? "a name of [[body]], or NAME[17]"
                : is_of_many  ? fmt::format("'{}[0]', or another number", meant)
                              : fmt::format("did you mean '{}'?", meant));
    }
    return body;
}

}  // namespace riprap::scene
