// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/affine/dda_keys.hpp"

#include "riprap/core/key.hpp"

namespace riprap::solid::affine {

using namespace key;

KeyList<Elasticity> elastic_keys() {
    return {number(&Elasticity::youngs_modulus, "youngs_modulus", dimension::pressure, positive(),
                   "Young's modulus of all blocks."),
            number(&Elasticity::poisson_ratio, "poisson_ratio", dimension::plain, between(0, 0.49),
                   "Poisson's ratio of all blocks."),
            number(&Elasticity::contact_stiffness, "contact_stiffness", dimension::stiffness, positive(),
                   "Normal stiffness of a contact point; the shear ratio of the materials gives the tangential one.")};
}

KeyList<Elasticity> elastic_keys_in_space() {
    constexpr Dimension stiffness_per_area{-2, 1, -2, 0};
    return elastic_keys() +
           KeyList<Elasticity>{
               number(&Elasticity::stiffness_per_area, "contact_stiffness_per_area", stiffness_per_area, positive(),
                      "Normal stiffness over the area that a contact point stands for, instead of "
                      "contact_stiffness; corners and edges count for a hundredth of the squared radius of "
                      "the smallest block.")};
}

std::vector<KeyProblem> problems_of(const Elasticity& elasticity) {
    if (!elasticity.stiffness_per_area || elasticity.contact_stiffness == Elasticity{}.contact_stiffness) {
        return {};
    }
    return {{"contact_stiffness_per_area", "contacts have a stiffness of a point and one per area", "one of them"}};
}

std::vector<material::PropertyUse> contact_uses(bool has_dashpots) {
    using material::Property;
    std::vector<material::PropertyUse> uses{
        {Property::shear_stiffness}, {Property::friction}, {Property::cohesion}, {Property::tensile_strength}};
    if (has_dashpots) {
        uses.push_back({Property::damping_ratio});
        uses.push_back({Property::restitution});
    }
    return uses;
}

}  // namespace riprap::solid::affine
