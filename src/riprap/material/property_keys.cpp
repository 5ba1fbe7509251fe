// SPDX-License-Identifier: Apache-2.0
#include "riprap/material/property_keys.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace riprap::material {

namespace {

using namespace key;

constexpr Range steepness{.low = 0, .high = 1.5707, .is_high_open = true};  // below a right angle

/// Makes a key optional whose value has no default: 0 means that the key is not given.
template <class To>
BoundKey<To> without_default(BoundKey<To> key) {
    key.get = [get = key.get](const To& to) {
        const KeyValue value = get(to);
        return std::get<double>(value) > 0 ? value : KeyValue();
    };
    return key;
}

/// Makes a key of a pair of materials optional: a value that is not given is mixed from both materials.
template <class To>
BoundKey<To> mixed(BoundKey<To> key) {
    if constexpr (std::is_same_v<To, PairProperties>) {
        key.get = [](const To&) { return KeyValue(); };
    }
    return key;
}

/// Keys that a material and a pair of materials share.
template <class To>
std::vector<PropertyKey<To>> surface_keys() {
    BoundKey<To> ratio = number(&To::shear_ratio, "shear_ratio", dimension::plain, non_negative(),
                                "Tangential over normal stiffness of a contact.");
    ratio.set = [set = ratio.set](To& to, const KeyValue& value) {
        set(to, value);
        to.shear_stiffness = 0;
    };
    BoundKey<To> angle = number(&To::friction, "friction_angle", dimension::angle, steepness,
                                "Friction angle; the coefficient is its tangent.");
    angle.get = [](const To&) { return KeyValue(); };
    angle.set = [](To& to, const KeyValue& value) { to.friction = std::tan(std::get<double>(value)); };
    return {
        {Property::shear_stiffness, mixed(ratio)},
        {Property::shear_stiffness,
         without_default(number(&To::shear_stiffness, "shear_stiffness", dimension::stiffness, positive(),
                                "Tangential stiffness of every contact, whatever its area."))},
        {Property::friction, mixed(number(&To::friction, "friction_coefficient", dimension::plain, non_negative(),
                                          "Coulomb coefficient."))},
        {Property::friction, angle},
        {Property::cohesion,
         mixed(number(&To::cohesion, "cohesion", dimension::pressure, non_negative(),
                      "Added to the shear strength, per contact area, as in limit equilibrium: corners of a face that "
                      "reach their strength first slide and keep their cohesion, so that the whole face bears the "
                      "load. A bond of DDA that has slid, or without tensile strength opened, by 1e-4 of the smaller "
                      "of its two blocks is broken, and its cohesion is lost for good."))},
        {Property::tensile_strength,
         mixed(number(&To::tensile_strength, "tensile_strength", dimension::pressure, non_negative(),
                      "Tensile strength: with cohesion it bonds faces that touch at the start. A bond that is torn, or "
                      "has slid as `cohesion` says, is gone for good. Two materials mix it as cohesion."))},
        {Property::damping_ratio, mixed(number(&To::damping_ratio, "damping_ratio", dimension::plain, between(0, 1),
                                               "Share of critical damping of a contact's dashpot."))},
        {Property::restitution, number(&To::restitution, "restitution", dimension::plain, above(0, 1),
                                       "Coefficient of restitution; that of [solid] when not given. In DDA it comes "
                                       "before damping_ratio where both materials, or their pair, have it.")},
        {Property::kinetic_share,
         number(&To::kinetic_share, "kinetic_share", dimension::plain, above(0, 1),
                "Kinetic over static friction of spheres; that of [solid] when not given. Two materials mix it as "
                "friction.")},
        {Property::rolling_friction,
         number(&To::rolling_friction, "rolling_friction", dimension::plain, non_negative(),
                "Coefficient of rolling friction of spheres; that of [solid] when not given.")},
        {Property::torsion, mixed(boolean(&To::has_torsion, "torsion",
                                          "Resist spinning about the contact normal, where both materials ask for "
                                          "it."))}};
}

}  // namespace

void add_use(std::vector<PropertyUse>& uses, const PropertyUse& use) {
    const auto same =
        std::ranges::find_if(uses, [&use](const PropertyUse& other) { return other.property == use.property; });
    if (same == uses.end()) {
        uses.push_back(use);
        return;
    }
    same->is_required = same->is_required || use.is_required;
    same->acts = same->acts || use.acts;
}

std::vector<PropertyKey<Material>> material_keys() {
    using M = Material;
    std::vector<PropertyKey<M>> keys{
        {Property::normal_stiffness,
         without_default(number(&M::normal_stiffness, "normal_stiffness", dimension::pressure, positive(),
                                "Factor k_n of the distance potential, a pressure: two flat faces of area S press with "
                                "k_n S (1/r_a + 1/r_b) per unit of overlap, r the inscribed radii. Required of bodies "
                                "that meet others by their faces. The DDA methods have contact_stiffness of [solid] "
                                "instead, in N/m."))}};
    for (PropertyKey<M>& key : surface_keys<M>()) {
        keys.push_back(std::move(key));
    }
    keys.push_back({Property::youngs_modulus, number(&M::youngs_modulus, "youngs_modulus", dimension::pressure,
                                                     positive(), "Young's modulus; that of [solid] when not given.")});
    keys.push_back(
        {Property::poisson_ratio, number(&M::poisson_ratio, "poisson_ratio", dimension::plain, between(0, 0.5),
                                         "Poisson's ratio; that of [solid] when not given.")});
    return keys;
}

std::vector<PropertyKey<PairProperties>> pair_keys() {
    using P = PairProperties;
    std::vector<PropertyKey<P>> keys = surface_keys<P>();
    keys.push_back(
        {Property::contact_ratio,
         number(
             &P::contact_ratio, "contact_ratio", dimension::plain, non_negative(),
             "Contact ratio of the dashpot: epsilon of Hertz, xi of a linear spring; from the restitution or that of "
             "[solid] when not given.")});
    keys.push_back({Property::spring_stiffness,
                    number(&P::spring_stiffness, "spring_stiffness", dimension::stiffness, positive(),
                           "Normal stiffness of linear springs of spheres; that of [solid] when not given.")});
    keys.push_back({Property::spring_shear_ratio,
                    number(&P::spring_shear_ratio, "spring_shear_ratio", dimension::plain, positive(),
                           "Tangential over normal stiffness of linear springs of spheres; `shear_ratio` of [solid] "
                           "when not given.")});
    return keys;
}

bool is_given(const Material& material, Property property) {
    return std::ranges::any_of(material_keys(), [&](const PropertyKey<Material>& key) {
        return key.property == property && !std::holds_alternative<std::monostate>(key.key.get(material));
    });
}

}  // namespace riprap::material
