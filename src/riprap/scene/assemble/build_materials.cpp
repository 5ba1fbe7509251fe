// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>

#include "riprap/core/index.hpp"
#include "riprap/material/property_keys.hpp"
#include "riprap/scene/assemble/build_case.hpp"
#include "riprap/scene/keys/bound_keys.hpp"
#include "riprap/scene/keys/check_value.hpp"
#include "riprap/scene/keys/words.hpp"
#include "riprap/scene/text/suggest.hpp"
#include "riprap/sim/method_traits.hpp"

namespace riprap::scene {

using material::Material;
using material::Mixing;
using material::PairProperties;
using material::Property;

namespace {

/// Fills the properties of the keys that `table` has.
template <class To>
void read_properties(const Value& table, const std::vector<material::PropertyKey<To>>& keys, To& to) {
    for (const material::PropertyKey<To>& key : keys) {
        if (const Value* given = table.find(key.key.row.name)) {
            key.key.set(to, key_value(*given, key.key.row.kind));
        }
    }
}

/// Does anything read a property? Of the dashpots of faces, which spheres have as restitution instead, that depends on
/// what the bodies meet by; stiffnesses of both stand side by side in cases for several methods.
bool is_read(const CaseBuild& build, Property property) {
    const bool is_of_faces_alone = property == Property::damping_ratio && build.has_all_bodies;
    return sim::reads_property(build.model, property) &&
           (!is_of_faces_alone || sim::reads_among_bodies(build.model, property));
}

/// Places of keys with a value that the solid method does not read.
struct Unread {
    SourcePlace place;  ///< of the first
    std::string where;  ///< "material 'rock'"
    std::size_t count{0};
};

/// Notes the keys of a table that give another value than their default to a property that nothing reads.
template <class To>
void find_unread(const CaseBuild& build, const Value& table, const std::vector<material::PropertyKey<To>>& keys,
                 const std::string& where, std::map<std::string_view, Unread>& found) {
    const To defaults{};
    for (const material::PropertyKey<To>& key : keys) {
        const Value* given = table.find(key.key.row.name);
        if (given == nullptr || is_read(build, key.property) ||
            key_value(*given, key.key.row.kind) == key.key.get(defaults)) {
            continue;
        }
        Unread& unread = found[key.key.row.name];
        if (unread.count++ == 0) {
            unread = {given->place, where, 1};
        }
    }
}

/// Names the key that a method reads in the place of the stiffness of materials, which is a pressure; empty where it
/// has none.
std::string own_stiffness(const CaseBuild& build, material::Property property) {
    const bool has_own = sim::elasticity_of(build.model.solid) != nullptr;
    return has_own && property == material::Property::normal_stiffness
               ? "; its contacts have solid.contact_stiffness, of a contact point, in N/m"
               : "";
}

/// Warns of a key without effect: the solid method does not read it (the warning names those that do), or its
/// settings leave it out.
void warn_of_unread(CaseBuild& build, std::string_view key, material::Property property, const Unread& unread) {
    const auto quoted = [](std::string_view word) { return fmt::format("\"{}\"", word); };
    const std::string method = quoted(get_text(get(build.root, "solid"), "method"));
    std::string readers;
    bool is_read = false;
    for (const std::string_view word : sim::solids_that_read(property)) {
        is_read = is_read || quoted(word) == method;
        readers += fmt::format("{}{}", readers.empty() ? "" : ", ", quoted(word));
    }
    const bool is_of_kinds = sim::reads_property(build.model, property);
    const SourcePlace& chosen = get(get(build.root, "solid"), "method").place;
    if (chosen.line == 0 && !chosen.file.empty() && (!is_read || is_of_kinds) && !readers.empty()) {
        return;  // the method was chosen over that of the file, which stands there for several
    }
    const std::string others =
        unread.count > 1 ? fmt::format(" and {} other{}", unread.count - 1, unread.count > 2 ? "s" : "") : "";
    if (is_of_kinds) {
        build.warnings.push_back(to_string(Diagnostic{
            unread.place,
            fmt::format("'{}' of {}{} does nothing here: solid.method {} reads it of bodies that meet by their faces, "
                        "and these meet by spheres",
                        key, unread.where, others, method),
            "leave it out, or 'restitution', which spheres read"}));
        return;
    }
    build.warnings.push_back(to_string(
        Diagnostic{unread.place,
                   fmt::format("'{}' of {}{} does nothing here: solid.method {} does not read it{}", key, unread.where,
                               others, method, is_read ? " with these settings" : ""),
                   is_read ? "leave it out"
                           : ("leave it out, or solid.method = " + readers).append(own_stiffness(build, property))}));
}

/// The mixing rule that the case gives. Where the materials in use differ in `value`, and the solid method reads it,
/// the case must give one.
/// @param value  of a material, what the rule mixes
template <class Of>
Mixing mixing_rule(CaseBuild& build, const Value& contact, std::string_view key, const Of& value,
                   material::Property property, Mixing if_alike = Mixing::minimum) {
    const bool is_read = sim::reads_property(build.model, property);
    if (const Value* given = contact.find(key)) {
        const Mixing rule = get_word(contact, key, mixing_rules());
        if (!is_read && rule != if_alike) {
            warn_of_unread(build, key, property, {given->place, "[contact]", 1});
        }
        return rule;
    }
    if (!is_read) {
        return if_alike;
    }
    const Material* first = nullptr;
    for (const std::int32_t id : build.used_materials) {
        const Material& other = build.model.materials[MaterialId{id}];
        if (first == nullptr) {
            first = &other;
        } else if (std::invoke(value, *first) != std::invoke(value, other)) {
            build.problem(
                contact.place,
                fmt::format("materials '{}' and '{}' differ, and [contact] lacks '{}'", first->name, other.name, key),
                "one of \"minimum\", \"maximum\", \"mean\", \"geometric\", \"harmonic\"");
            break;
        }
    }
    return if_alike;
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
    read_properties(pair, material::pair_keys(), properties);
    set.pairs[a * size + b] = properties;
    set.pairs[b * size + a] = properties;
}

}  // namespace

void build_materials(CaseBuild& build) {
    for (const Entry& entry : get(build.root, "material").entries) {
        Material material;
        material.name = entry.key;
        material.density = get_number(entry.value, "density");
        read_properties(entry.value, material::material_keys(), material);
        build.materials[entry.key] = MaterialId{build.model.materials.size()};
        build.model.materials.materials.push_back(std::move(material));
    }
}

void build_contact(CaseBuild& build) {
    const Value& contact = get(build.root, "contact");
    const bool has_share = sim::reads_property(build.model, Property::kinetic_share);
    const auto sliding = [has_share](const Material& material) {
        return std::pair(material.friction, has_share ? material.kinetic_share : std::nullopt);
    };
    const Mixing friction = mixing_rule(build, contact, "friction_mixing", sliding, Property::friction);
    const Mixing cohesion = mixing_rule(build, contact, "cohesion_mixing", &Material::cohesion, Property::cohesion);
    build.model.materials.restitution_mixing =
        mixing_rule(build, contact, "restitution_mixing", &Material::restitution, Property::restitution, Mixing::mean);
    build.model.materials.friction_mixing = friction;
    build.model.materials.rolling_mixing = mixing_rule(build, contact, "rolling_mixing", &Material::rolling_friction,
                                                       Property::rolling_friction, Mixing::mean);
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

void check_materials(CaseBuild& build) {
    std::map<std::string_view, Unread> unread;
    const auto material_keys = material::material_keys();
    const auto pair_keys = material::pair_keys();
    const Value& contact = get(build.root, "contact");
    for (const Entry& entry : get(build.root, "material").entries) {
        if (build.used_materials.contains(build.materials[entry.key].value)) {
            find_unread(build, entry.value, material_keys, fmt::format("material '{}'", entry.key), unread);
        }
    }
    for (const Value& pair : get(contact, "pair").items) {
        find_unread(build, pair, pair_keys, "[[contact.pair]]", unread);
    }
    const auto warn_of = [&](std::string_view key, Property property) {
        if (const auto found = unread.find(key); found != unread.end()) {
            warn_of_unread(build, found->first, property, found->second);
            unread.erase(found);
        }
    };
    for (const auto& key : material_keys) {
        warn_of(key.key.row.name, key.property);
    }
    for (const auto& key : pair_keys) {
        warn_of(key.key.row.name, key.property);
    }
    if (!build.has_all_bodies) {
        return;  // which bodies meet by their faces is not known
    }
    const sim::Model& model = build.model;
    const std::vector<solid::LackingProperty> lacking = sim::lacking_properties(model);
    for (const solid::LackingProperty& lack : lacking) {
        const std::string& material = model.materials[model.bodies.material[at(lack.body.value)]].name;
        const auto key = std::ranges::find(material_keys, lack.property, &material::PropertyKey<Material>::property);
        build.problem(
            get(get(build.root, "material"), material).place,
            fmt::format("material '{}' lacks '{}', which solid.method = \"{}\" needs of '{}'", material,
                        key->key.row.name, get_text(get(build.root, "solid"), "method"), model.bodies.name(lack.body)),
            fmt::format("{}: {}", describe_form(key_of(key->key.row, {}).forms.front()), key->key.row.help));
    }
}

}  // namespace riprap::scene
