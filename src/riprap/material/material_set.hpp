// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "riprap/core/ids.hpp"

namespace riprap::material {

/// Material of a solid and behaviour of its surface in contact.
struct Material {
    std::string name;
    double density{0};           ///< rho [kg/m^3]
    double normal_stiffness{0};  ///< k_n, factor of the potential, a pressure [Pa]
    /// k_s/k_n: tangential over normal stiffness of a contact [-]; ignored where shear_stiffness > 0.
    double shear_ratio{0.8};
    double shear_stiffness{0};   ///< K_s taken literally [N/m]; 0 = use shear_ratio
    double friction{0};          ///< Coulomb coefficient mu = tan(friction angle) [-]
    double cohesion{0};          ///< c, added to the shear strength per contact area [Pa]
    double tensile_strength{0};  ///< of faces that touch at the start, per contact area [Pa]
    double damping_ratio{0};     ///< xi, fraction of critical contact damping [-]
    bool has_torsion{false};     ///< resist spinning about the contact normal
    // Of bodies made of spheres; empty = those of the method's own keys.
    std::optional<double> youngs_modulus{};    ///< E [Pa]
    std::optional<double> poisson_ratio{};     ///< nu [-]
    std::optional<double> restitution{};       ///< e [-]
    std::optional<double> kinetic_share{};     ///< kinetic over static friction [-]
    std::optional<double> rolling_friction{};  ///< mu_r, couple over R* F_n [-]
};

/// Rule by which the values of two materials become one. Codes differ silently here, so it is a key of the case.
enum class Mixing { minimum, maximum, mean, geometric, harmonic };

/// Surface properties of one pair of materials. k_n stays with each body (its own field).
struct PairProperties {
    double shear_ratio{0};
    double shear_stiffness{0};
    double friction{0};
    double cohesion{0};
    double tensile_strength{0};
    double damping_ratio{0};
    bool has_torsion{false};
    // Of spheres; empty = mixed from the materials, or that of the method's own keys where materials have none.
    std::optional<double> restitution{};         ///< e [-]
    std::optional<double> kinetic_share{};       ///< kinetic over static friction [-]
    std::optional<double> rolling_friction{};    ///< mu_r, couple over R* F_n [-]
    std::optional<double> contact_ratio{};       ///< epsilon of Hertz' dashpot [-]
    std::optional<double> spring_stiffness{};    ///< of the linear normal spring [N/m]
    std::optional<double> spring_shear_ratio{};  ///< tangential over normal stiffness of linear springs [-]
};

/// Materials by id and the resolved table of all pairs.
struct MaterialSet {
    std::vector<Material> materials;
    std::vector<PairProperties> pairs;     ///< symmetric, row-major size() x size()
    Mixing friction_mixing{Mixing::mean};  ///< of kinetic shares; mix_pairs applies its own to friction
    Mixing restitution_mixing{Mixing::mean};
    Mixing rolling_mixing{Mixing::mean};

    int size() const { return static_cast<int>(materials.size()); }
    const Material& operator[](MaterialId id) const { return materials[static_cast<std::size_t>(id.value)]; }
    const PairProperties& pair(MaterialId a, MaterialId b) const {
        return pairs[static_cast<std::size_t>(a.value) * materials.size() + static_cast<std::size_t>(b.value)];
    }
};

double mix(Mixing rule, double a, double b);

/// Fills `pairs` from the materials: friction and cohesion by their own rules, tensile strength by that of cohesion,
/// stiffness ratio and damping by the mean, torsion where both ask for it. Entries given explicitly afterwards replace
/// these.
void mix_pairs(MaterialSet& set, Mixing friction_rule, Mixing cohesion_rule);

}  // namespace riprap::material
