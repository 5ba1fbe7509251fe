// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

namespace riprap::solid::affine {

/// Properties of rock that a DDA needs besides the materials of the scene; one value for all blocks.
struct Elasticity {
    double youngs_modulus{5e9};     ///< E [Pa]
    double poisson_ratio{0.25};     ///< nu [-]
    double contact_stiffness{1e8};  ///< k_n of a contact point [N/m]; k_s by the shear ratio of the pair
    /// k_n over the area that a contact point stands for, instead of contact_stiffness [Pa/m]. Blocks in space only.
    std::optional<double> stiffness_per_area{};

    /// Lame's constants lambda = E nu/((1 + nu)(1 - 2 nu)) and mu = E/(2 (1 + nu)) [Pa].
    double lame() const { return youngs_modulus * poisson_ratio / ((1 + poisson_ratio) * (1 - 2 * poisson_ratio)); }
    double shear_modulus() const { return youngs_modulus / (2 * (1 + poisson_ratio)); }
};

}  // namespace riprap::solid::affine
