// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "riprap/scene/build/build_case.hpp"
#include "riprap/scene/keys/words.hpp"
#include "riprap/scene/text/suggest.hpp"

namespace riprap::scene {

using material::Material;
using material::Mixing;
using material::PairProperties;

namespace {

/// The values that a material and a pair of materials share. Keys that are not given leave `to` alone.
template <class Target>
void read_surface(const Value& table, Target& to) {
    to.shear_ratio = get_number_or(table, "shear_ratio", to.shear_ratio);
    if (table.find("shear_ratio") != nullptr) {
        to.shear_stiffness = 0;
    }
    to.shear_stiffness = get_number_or(table, "shear_stiffness", to.shear_stiffness);
    to.friction = get_number_or(table, "friction_coefficient", to.friction);
    if (const Value* angle = table.find("friction_angle")) {
        to.friction = std::tan(angle->as_number());
    }
    to.cohesion = get_number_or(table, "cohesion", to.cohesion);
    to.tensile_strength = get_number_or(table, "tensile_strength", to.tensile_strength);
    to.damping_ratio = get_number_or(table, "damping_ratio", to.damping_ratio);
    if (const Value* torsion = table.find("torsion")) {
        to.has_torsion = torsion->boolean;
    }
}

/// The mixing rule that the case gives. Where the materials in use differ in `value` the case must give one.
template <class Number>
Mixing mixing_rule(CaseBuild& build, const Value& contact, std::string_view key, Number Material::*value,
                   Mixing if_alike = Mixing::minimum) {
    if (contact.find(key) != nullptr) {
        return get_word(contact, key, mixing_rules());
    }
    const Material* first = nullptr;
    for (const std::int32_t id : build.used_materials) {
        const Material& other = build.model.materials[MaterialId{id}];
        if (first == nullptr) {
            first = &other;
        } else if (first->*value != other.*value) {
            build.problem(
                contact.place,
                fmt::format("materials '{}' and '{}' differ, and [contact] lacks '{}'", first->name, other.name, key),
                "one of \"minimum\", \"maximum\", \"mean\", \"geometric\", \"harmonic\"");
            break;
        }
    }
    return if_alike;
}

void read_number(const Value& table, std::string_view key, std::optional<double>& to) {
    if (const Value* value = table.find(key)) {
        to = value->as_number();
    }
}

/// Warns of a restitution that nothing reads: what loses energy in contacts of other methods is a damping.
void warn_of_restitution(CaseBuild& build, const Value& table) {
    const Value* restitution = table.find("restitution");
    if (restitution != nullptr && !std::holds_alternative<solid::SphereDemSettings>(build.model.solid)) {
        build.warnings.push_back(to_string(
            Diagnostic{restitution->place, "'restitution' does nothing here: solid.method \"sphere_dem\" alone has it",
                       "'damping_ratio' for this method"}));
    }
}

void read_pair(CaseBuild& build, const Value& pair) {
    std::array<MaterialId, 2> ids;
    for (std::size_t i = 0; i < 2; ++i) {
        const Value& name = get(pair, "materials").items[i];
        const auto found = build.materials.find(name.text);
        if (found == build.materials.end()) {
            build.material_problem(name);
            return;
        }
        ids[i] = found->second;
    }
    material::MaterialSet& set = build.model.materials;
    const auto size = static_cast<std::size_t>(set.size());
    const auto a = static_cast<std::size_t>(ids[0].value), b = static_cast<std::size_t>(ids[1].value);
    PairProperties properties = set.pairs[a * size + b];
    read_surface(pair, properties);
    read_number(pair, "restitution", properties.restitution);
    warn_of_restitution(build, pair);
    set.pairs[a * size + b] = properties;
    set.pairs[b * size + a] = properties;
}

}  // namespace

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
            !meant.empty() ? fmt::format("did you mean '{}'?", meant)
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

void build_materials(CaseBuild& build) {
    for (const Entry& entry : get(build.root, "material").entries) {
        Material material;
        material.name = entry.key;
        material.density = get_number(entry.value, "density");
        material.normal_stiffness = get_number(entry.value, "normal_stiffness");
        read_surface(entry.value, material);
        read_number(entry.value, "youngs_modulus", material.youngs_modulus);
        read_number(entry.value, "poisson_ratio", material.poisson_ratio);
        read_number(entry.value, "restitution", material.restitution);
        warn_of_restitution(build, entry.value);
        build.materials[entry.key] = MaterialId{build.model.materials.size()};
        build.model.materials.materials.push_back(std::move(material));
    }
}

void build_contact(CaseBuild& build) {
    const Value& contact = get(build.root, "contact");
    const Mixing friction = mixing_rule(build, contact, "friction_mixing", &Material::friction);
    const Mixing cohesion = mixing_rule(build, contact, "cohesion_mixing", &Material::cohesion);
    build.model.materials.restitution_mixing =
        mixing_rule(build, contact, "restitution_mixing", &Material::restitution, Mixing::mean);
    material::mix_pairs(build.model.materials, friction, cohesion);
    for (const Value& pair : get(contact, "pair").items) {
        read_pair(build, pair);
    }
    for (const auto& [name, id] : build.materials) {
        if (!build.used_materials.contains(id.value)) {
            build.warnings.push_back(fmt::format("material '{}' is not used", name));
        }
    }
}

}  // namespace riprap::scene
