// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace riprap::material {

/// Properties of materials that physics of contact read. The density is no such property: every method reads it.
enum class Property : std::uint8_t {
    normal_stiffness,
    shear_stiffness,  ///< as a ratio or literally
    friction,
    cohesion,
    tensile_strength,
    damping_ratio,
    torsion,
    youngs_modulus,
    poisson_ratio,
    restitution,
    kinetic_share,
    rolling_friction,
    contact_ratio,
    spring_stiffness,
    spring_shear_ratio
};

/// A property that a physics reads.
struct PropertyUse {
    Property property;
    bool is_required{false};  ///< every material of bodies that the physics acts on has to give it
    bool acts{true};          ///< false where the settings choose a law that does not read it
};

/// Adds a use to a list with one entry a property: where several physics read it, one that needs it or lets it act
/// decides.
void add_use(std::vector<PropertyUse>& uses, const PropertyUse& use);

}  // namespace riprap::material
