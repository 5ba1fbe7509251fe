// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/affine/dda_keys.hpp"

#include <cmath>

#include "riprap/core/key.hpp"
#include "riprap/solid/affine/default_scales.hpp"

namespace riprap::solid::affine {

using namespace key;

namespace {

KeyList<Elasticity> modulus() {
    return {number(&Elasticity::youngs_modulus, "youngs_modulus", dimension::pressure, positive(),
                   "Young's modulus of all blocks.")};
}

KeyList<Elasticity> modulus_of_waves() {
    return {
        number_or_left(&Elasticity::youngs_modulus, "youngs_modulus", dimension::pressure,
                       "Young's modulus of all blocks. \"auto\": 400000 rho a R of the block for which that is most, "
                       "rho its density, a and R as of contact_stiffness, and 5e9 Pa at most: stiffer blocks take "
                       "shorter steps.")};
}

KeyList<Elasticity> ratio_and_stiffness() {
    return {
        number(&Elasticity::poisson_ratio, "poisson_ratio", dimension::plain, between(0, 0.49),
               "Poisson's ratio of all blocks."),
        number_or_left(&Elasticity::contact_stiffness, "contact_stiffness", dimension::stiffness,
                       "Normal stiffness of a contact point, not the pressure `normal_stiffness` of materials, which "
                       "DDA does not read; the shear ratio of the materials gives the tangential "
                       "one. \"auto\": 2000 F/R of the block for which that is most, R half its edge, F the "
                       "weight of the blocks that may stand on it, or what loads or its speed at the start give "
                       "it.")};
}

KeyList<Elasticity> stiffness_of_areas() {
    constexpr Dimension stiffness_per_area{-2, 1, -2, 0};
    return {number(&Elasticity::stiffness_per_area, "contact_stiffness_per_area", stiffness_per_area, positive(),
                   "Normal stiffness over the area that a contact point stands for, instead of "
                   "contact_stiffness; corners and edges count for a hundredth of the squared radius of "
                   "the smallest block.")};
}

}  // namespace

KeyList<Elasticity> elastic_keys() { return modulus() + ratio_and_stiffness(); }

KeyList<Elasticity> elastic_keys_in_space() { return elastic_keys() + stiffness_of_areas(); }

KeyList<Elasticity> elastic_keys_of_waves() {
    return modulus_of_waves() + ratio_and_stiffness() + stiffness_of_areas();
}

std::vector<KeyProblem> problems_of(const Elasticity& elasticity) {
    if (!elasticity.stiffness_per_area || std::isnan(elasticity.contact_stiffness)) {
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
