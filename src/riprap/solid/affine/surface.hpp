// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "riprap/material/material_set.hpp"
#include "riprap/solid/affine/elasticity.hpp"

// What blocks of all three methods of discontinuous deformation analysis meet with.

namespace riprap::solid::affine {

/// Springs between two surfaces and what they stand.
struct Surface {
    double normal_stiffness{0};  ///< k_n: of a contact point [N/m], or per area of contact [Pa/m]
    double shear_stiffness{0};   ///< k_s, likewise
    bool is_per_area{false};     ///< stiffness times the area that a contact point stands for (soft contact)
    double friction{0};          ///< tan phi [-]
    double cohesion{0};          ///< c of a bond, per area; see bonds.hpp [Pa]
    double tension{0};           ///< strength of a bond across the contact, likewise [Pa]
    double damping_ratio{0};     ///< share of critical damping; not of implicit DDA in space [-]
    double least_area{0};        ///< that a point counts for at least where stiffness is per area [m^2]

    /// Returns by what a contact point multiplies the stiffnesses.
    double factor(double area) const { return is_per_area ? std::max(area, least_area) : 1; }
    /// Tells whether faces that touch at the start are bonded.
    bool has_bond() const { return cohesion > 0 || tension > 0; }
};

/// The surfaces of all pairs of materials.
struct Surfaces {
    std::vector<Surface> pairs;  ///< symmetric table of materials x materials
    std::int32_t material_count{0};
    double divisor{1};  ///< by which strengths are divided, see SolidScene::strength_divisor [-]

    const Surface& of(std::int32_t material_a, std::int32_t material_b) const {
        return pairs[static_cast<std::size_t>(material_a * material_count + material_b)];
    }
    bool have_bonds() const { return std::ranges::any_of(pairs, &Surface::has_bond); }
    bool are_damped() const {
        return std::ranges::any_of(pairs, [](const Surface& surface) { return surface.damping_ratio > 0; });
    }
};

/// Takes friction, strength, damping and the stiffness in shear from the pairs of materials, the normal one from the
/// settings of the method.
/// @param least_area  see Surface
Surfaces make_surfaces(const material::MaterialSet& materials, const Elasticity& elasticity, double least_area);
/// Takes the strengths anew from the materials where they are divided by another divisor than before.
void renew_strengths(const material::MaterialSet& materials, double divisor, Surfaces& surfaces);

}  // namespace riprap::solid::affine
