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

std::vector<material::PropertyUse> contact_uses(bool has_dashpots) {
    using material::Property;
    std::vector<material::PropertyUse> uses{
        {Property::shear_stiffness}, {Property::friction}, {Property::cohesion}, {Property::tensile_strength}};
    if (has_dashpots) {
        uses.push_back({Property::damping_ratio});
    }
    return uses;
}

}  // namespace riprap::solid::affine
