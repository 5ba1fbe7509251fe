// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "riprap/core/ids.hpp"
#include "riprap/material/material_set.hpp"

namespace riprap::contact {

/// Normal force of spheres.
enum class NormalLaw : std::uint8_t { hertz, linear };
/// Resistance against rolling.
enum class RollingLaw : std::uint8_t { none, constant, spring };
/// Simultaneous contacts of the spheres of one pair of bodies.
enum class Sharing : std::uint8_t {
    dashpots,  ///< springs count in full, dashpots by 1/sqrt(N), N = sum of overlaps/largest overlap
    sum,       ///< every contact counts in full: restitution falls with the number of spheres
    divide,    ///< springs and dashpots count by 1/N: as soft as one contact
    closest,   ///< the deepest contact of a pair of bodies counts alone
};
/// Contact normals of spheres of multispheres.
enum class SphereNormals : std::uint8_t {
    centres,  ///< along the centres
    faces,    ///< of the face that a sphere lies in, see closest_pair_normal
};

/// Surface of one material as spheres feel it.
struct ContactMaterial {
    double youngs_modulus{1e7};    ///< E [Pa]
    double poisson_ratio{0.3};     ///< nu [-]
    double restitution{1};         ///< e, 0 < e <= 1 [-]
    double static_friction{0};     ///< [-]
    double kinetic_friction{-1};   ///< [-]; negative = as static
    double rolling_friction{0};    ///< mu_r, couple over R* F_n [-]
    double contact_ratio{-1};      ///< epsilon of the dashpot [-]; negative = from the restitution
    double normal_stiffness{1e5};  ///< k of the linear spring [N/m]
    double shear_ratio{2.0 / 7};   ///< k_t/k_n of the linear spring [-]
};

/// One pair of materials, ready for the laws.
struct ContactPair {
    double modulus{0};           ///< E* [Pa]
    double shear_modulus{0};     ///< G* [Pa]
    double restitution{1};       ///< [-]
    double ratio{0};             ///< epsilon (hertz) or xi (linear) [-]
    double static_friction{0};   ///< [-]
    double kinetic_friction{0};  ///< [-]
    double rolling_friction{0};  ///< [-]
    double normal_stiffness{0};  ///< k (linear) [N/m]
    double shear_ratio{0};       ///< k_t/k_n (linear) [-]
};

/// Rules by which two materials become a pair. Codes differ silently here, so each is named.
struct ContactMixing {
    material::Mixing friction{material::Mixing::mean};
    material::Mixing restitution{material::Mixing::mean};
    material::Mixing rolling{material::Mixing::mean};
};

/// Returns what two materials are to each other. Stiffnesses of linear springs mix by the harmonic mean, as springs in
/// series, their shear ratios by the mean.
/// @param allows_pull  the force may pull at the end of an impact; else it is cut off at zero and the contact ratio is
///                     the one that keeps the restitution
ContactPair mixed_pair(const ContactMaterial& a, const ContactMaterial& b, NormalLaw law, const ContactMixing& mixing,
                       bool allows_pull);

/// All pairs of materials; symmetric.
class ContactTable {
 public:
    ContactTable() = default;
    /// Pairs without any value, to be set.
    explicit ContactTable(int count)
        : count_(count), pairs_(static_cast<std::size_t>(count) * static_cast<std::size_t>(count)) {}
    /// All pairs by mixed_pair.
    ContactTable(const std::vector<ContactMaterial>& materials, NormalLaw law, const ContactMixing& mixing,
                 bool allows_pull);
    /// Replaces one pair.
    void set_pair(MaterialId a, MaterialId b, const ContactPair& pair);
    const ContactPair& pair(MaterialId a, MaterialId b) const {
        return pairs_[static_cast<std::size_t>(a.value) * static_cast<std::size_t>(count_) +
                      static_cast<std::size_t>(b.value)];
    }
    int size() const { return count_; }

 private:
    int count_{0};
    std::vector<ContactPair> pairs_;
};

}  // namespace riprap::contact
