// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "riprap/scene/assemble/build_case.hpp"

namespace riprap::scene {

namespace {

/// Tells whether any pair of materials has a strength that is divided.
bool divides_anything(const material::MaterialSet& materials, const material::StrengthReduction& strength) {
    return std::ranges::any_of(materials.pairs, [&strength](const material::PairProperties& pair) {
        return (strength.has_friction && pair.friction > 0) || (strength.has_cohesion && pair.cohesion > 0) ||
               (strength.has_tension && pair.tensile_strength > 0);
    });
}

}  // namespace

void build_strength(CaseBuild& build) {
    const Value* table = build.root.find("strength");
    if (table == nullptr) {
        return;
    }
    material::StrengthReduction& strength = build.model.strength;
    strength.to = get_number(*table, "reduction");
    strength.from = get_number(*table, "initial");
    strength.begins = get_number(*table, "begins");
    strength.over = get_number(*table, "over");
    if (const Value* reduces = table->find("reduces")) {
        const auto is_named = [reduces](std::string_view word) {
            return std::ranges::any_of(reduces->items, [word](const Value& item) { return item.text == word; });
        };
        strength.has_friction = is_named("friction");
        strength.has_cohesion = is_named("cohesion");
        strength.has_tension = is_named("tension");
    }
    if (build.has_all_bodies && !divides_anything(build.model.materials, strength)) {
        build.problem(table->place, "'strength' divides nothing: the materials have no such strength",
                      "materials with friction, cohesion or tensile strength that 'reduces' names");
    }
    if (strength.begins + strength.over > build.model.time.end) {
        build.warnings.push_back(
            to_string(Diagnostic{table->place,
                                 fmt::format("the run ends at {:.6g} s, before strength has changed at {:.6g} s",
                                             build.model.time.end, strength.begins + strength.over),
                                 "a later end"}));
    }
}

}  // namespace riprap::scene
