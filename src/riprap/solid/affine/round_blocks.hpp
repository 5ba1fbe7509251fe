// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "riprap/contact/broadphase/pair_cache.hpp"
#include "riprap/solid/affine/block_contacts.hpp"

// Balls. A sphere of a scene is a polyhedron of 320 triangles, whose corners lie outside of the sphere and whose faces
// lie inside. It would stand on a corner, press into the plane that it touches, and hop from edge to edge. Its contact
// is that of the sphere itself, or of the ellipsoid that a strained block makes of it. So it is with discs of planar
// scenes, which are prisms of 64 sides.

namespace riprap::solid::affine {

/// One side of a pair: a ball, a disc of a planar scene, or a convex body or half-space.
struct RoundSide {
    contact::PlacedHull hull;
    Mat3 deformation;       ///< F of the block
    double ball_radius{0};  ///< of a ball or a disc; 0 = neither [m]
};

/// Way from the centre of a ball or a disc to its point that lies farthest along n [m].
Vec3 farthest_along(const RoundSide& ball, const Vec3& n);

/// Finds the contact point of a pair of which at least one side is a ball, or a disc: the point of the ellipsoid
/// x_c + F X, |X| = r, that lies farthest towards the nearest point of the other body.
/// @returns nothing where they are farther apart than `reach` [m]
std::optional<BlockContact> find_at_ball(const contact::PartPair& pair, const RoundSide& a, const RoundSide& b,
                                         double reach);

/// Returns the contact of a disc at one end of its thickness: prisms of planar scenes meet in points at both ends.
BlockContact at_end_of_disc(const BlockContact& middle, double half, bool is_far);

}  // namespace riprap::solid::affine
