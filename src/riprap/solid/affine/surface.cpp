// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/affine/surface.hpp"

#include "riprap/solid/affine/restitution.hpp"

namespace riprap::solid::affine {

namespace {

Surface surface_of(const material::MaterialSet& materials, MaterialId a, MaterialId b, const Elasticity& elasticity,
                   double least_area) {
    const material::PairProperties& pair = materials.pair(a, b);
    const double normal = elasticity.stiffness_per_area.value_or(elasticity.contact_stiffness);
    const double shear = pair.shear_stiffness > 0 ? pair.shear_stiffness : pair.shear_ratio * normal;
    return {normal,
            shear,
            elasticity.stiffness_per_area.has_value(),
            pair.friction,
            pair.cohesion,
            pair.tensile_strength,
            damping_ratio_of(materials, a, b),
            least_area};
}

}  // namespace

Surfaces make_surfaces(const material::MaterialSet& materials, const Elasticity& elasticity, double least_area) {
    Surfaces surfaces{{}, materials.size()};
    for (int a = 0; a < materials.size(); ++a) {
        for (int b = 0; b < materials.size(); ++b) {
            surfaces.pairs.push_back(surface_of(materials, MaterialId{a}, MaterialId{b}, elasticity, least_area));
        }
    }
    return surfaces;
}

void renew_strengths(const material::MaterialSet& materials, double divisor, Surfaces& surfaces) {
    if (divisor == surfaces.divisor) {
        return;
    }
    for (std::size_t i = 0; i < surfaces.pairs.size(); ++i) {
        const material::PairProperties& pair = materials.pairs[i];
        surfaces.pairs[i].friction = pair.friction;
        surfaces.pairs[i].cohesion = pair.cohesion;
        surfaces.pairs[i].tension = pair.tensile_strength;
    }
    surfaces.divisor = divisor;
}

}  // namespace riprap::solid::affine
