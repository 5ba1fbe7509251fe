// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/contact/contact_set.hpp"
#include "riprap/geometry/polyhedra/convex_view.hpp"

namespace riprap::contact {

/// Push of sharp parts where they meet by corners and edges. The distance potential gives way too much there: its
/// stiffness grows with the area of what overlaps, that of a punch on an elastic half-space with the size of it. A
/// function of its energy E_p takes its place,
///
///     E = E_p + E_0^(1-p) E_p^m (E_p + E_1)^(p-m),    E_0 = k l^3 (in space), k l^2 b (planar prisms, b = 1 m thick),
///
/// k = k_A + k_B [Pa], l = k/(k_A/r_A + k_B/r_B) a mean of the inscribed radii [m], m = 3, E_1 = 0.005^(1/(1-p)) E_0
/// [J]. With p = 3/4 a corner or two crossing edges, whose E_p grows with d^4, have E ~ k d^3, so a force ~ k d d, as
/// of a punch of width d. With p = 2/3 a corner in the plane, whose E_p grows with d^3, has E ~ k b d^2: a spring.
///
/// Shallower than about l/200 (E_p below E_1) a corner stays as the field has it. Else a block that slides over flush
/// faces would meet each next one as a step as high as its sinking in.
///
/// E is a function of E_p alone, so its force is the gradient of E_p times dE/dE_p: as conservative as the field, for
/// all shapes. Not for parts with cuts, whose energies add up to that of the body only where they are left as they are;
/// nor for round ones, whose facets are as soft as their area is small and would catch at stiff corners in rolling
/// (docs/decisions/0020-corner-springs-of-feet.md).
class SharpPush {
 public:
    /// @param modulus   k [Pa]
    /// @param per_area  k_A/r_A + k_B/r_B [N/m^3]
    SharpPush(double modulus, double per_area, bool is_planar);

    /// Replaces force, couple, energy and stiffness of a contact, its E_p known. The stiffness is that of the push at
    /// its depth, dE/dE_p K_n + d2E/dE_p^2 |F|^2, K_n and F of the potential.
    void stiffen(NormalContact& contact) const;

 private:
    double power_;   ///< p [-]
    double energy_;  ///< E_0 [J]
    double least_;   ///< E_1 [J]
};

}  // namespace riprap::contact
