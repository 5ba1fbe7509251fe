// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/contact/contact_set.hpp"
#include "riprap/contact/narrowphase/facing_faces.hpp"

namespace riprap::contact {

/// Contact of a ball, or of a disc of a planar scene, as what it is, not as the polyhedron that stands for it: whose
/// facets would be hit one after the other as it rolls, and whose corners lie outside of it. Its push follows from the
/// depth d of its surface in the other body, at the point of that body nearest to its centre, as on an elastic
/// half-space:
///
///     ball (Hertz):  E = 8/15 k sqrt(R) d^(5/2),  F = 4/3 k sqrt(R) d^(3/2)
///     disc:          E = pi/8 k b d^2,            F = pi/4 k b d
///
/// with k = k_A + k_B [Pa], as of corners and edges (SharpPush); R = r, between two round bodies r_A r_B/(r_A + r_B);
/// b the thickness of the scene. The field of the potential, k pi d^2 under a ball, is softer than that of a punch of
/// its size by sqrt(d/r). Force and moment are the gradient of E. Valid while d is small beside r. Not beside parts
/// with cuts through a body, whose nearest points may lie on a cut: those keep the potential.
class RoundPush {
 public:
    /// @param stiffness_a, stiffness_b  k_n [Pa]
    RoundPush(const PlacedShape& a, double stiffness_a, const PlacedShape& b, double stiffness_b);

    /// At least one of both is round, and the other one has no cut.
    bool is_round() const { return is_round_; }
    /// Depth and normal from A to B. @returns false where they do not overlap
    bool overlaps(NormalContact& contact, Vec3& normal) const;
    /// @returns false where they do not overlap; `contact` is then undefined
    bool push(NormalContact& contact, Vec3& normal) const;

 private:
    const PlacedShape &a_, &b_;
    double modulus_;  ///< k [Pa]
    double radius_a_, radius_b_;
    bool is_round_;
};

}  // namespace riprap::contact
