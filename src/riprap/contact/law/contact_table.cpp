// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/law/contact_table.hpp"

#include <algorithm>

#include "riprap/contact/law/hertz.hpp"
#include "riprap/contact/law/linear_spring.hpp"

namespace riprap::contact {

namespace {

double ratio_of(const ContactMaterial& a, const ContactMaterial& b, double restitution, NormalLaw law,
                bool allows_pull) {
    if (a.contact_ratio >= 0 && b.contact_ratio >= 0) {
        return 0.5 * (a.contact_ratio + b.contact_ratio);
    }
    if (a.contact_ratio >= 0 || b.contact_ratio >= 0) {
        return std::max(a.contact_ratio, b.contact_ratio);
    }
    if (law == NormalLaw::linear) {
        return allows_pull ? linear_damping_ratio(restitution) : linear_damping_ratio_without_pull(restitution);
    }
    return allows_pull ? contact_ratio(restitution) : contact_ratio_without_pull(restitution);
}

}  // namespace

ContactPair mixed_pair(const ContactMaterial& a, const ContactMaterial& b, NormalLaw law, const ContactMixing& mixing,
                       bool allows_pull) {
    const auto kinetic = [](const ContactMaterial& m) {
        return m.kinetic_friction < 0 ? m.static_friction : m.kinetic_friction;
    };
    const Elasticity of_a{a.youngs_modulus, a.poisson_ratio}, of_b{b.youngs_modulus, b.poisson_ratio};
    ContactPair pair;
    pair.modulus = effective_modulus(of_a, of_b);
    pair.shear_modulus = effective_shear_modulus(of_a, of_b);
    pair.restitution = material::mix(mixing.restitution, a.restitution, b.restitution);
    pair.ratio = ratio_of(a, b, pair.restitution, law, allows_pull);
    pair.static_friction = material::mix(mixing.friction, a.static_friction, b.static_friction);
    pair.kinetic_friction = std::min(pair.static_friction, material::mix(mixing.friction, kinetic(a), kinetic(b)));
    pair.rolling_friction = material::mix(mixing.rolling, a.rolling_friction, b.rolling_friction);
    pair.normal_stiffness = material::mix(material::Mixing::harmonic, a.normal_stiffness, b.normal_stiffness);
    pair.shear_ratio = 0.5 * (a.shear_ratio + b.shear_ratio);
    return pair;
}

ContactTable::ContactTable(const std::vector<ContactMaterial>& materials, NormalLaw law, const ContactMixing& mixing,
                           bool allows_pull)
    : count_(static_cast<int>(materials.size())) {
    for (const ContactMaterial& a : materials) {
        for (const ContactMaterial& b : materials) {
            pairs_.push_back(mixed_pair(a, b, law, mixing, allows_pull));
        }
    }
}

void ContactTable::set_pair(MaterialId a, MaterialId b, const ContactPair& pair) {
    const auto place = [this](MaterialId i, MaterialId j) {
        return static_cast<std::size_t>(i.value) * static_cast<std::size_t>(count_) + static_cast<std::size_t>(j.value);
    };
    pairs_[place(a, b)] = pair;
    pairs_[place(b, a)] = pair;
}

}  // namespace riprap::contact
