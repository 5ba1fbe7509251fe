// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "riprap/contact/broadphase/pair_cache.hpp"
#include "riprap/solid/affine/block_contacts.hpp"

// Balls. A sphere of a scene is a polyhedron of 320 triangles, whose corners lie outside of the sphere and whose faces
// lie inside. It would stand on a corner, press into the plane that it touches, and hop from edge to edge. Its contact
// is that of the sphere itself, or of the ellipsoid that a strained block makes of it.

namespace riprap::solid::affine {

/// Radius of the sphere that a shape stands for, of the same volume; 0 = it stands for none [m].
double ball_radius(const Shape& shape);

/// One side of a pair: a ball, or a convex body or half-space.
struct RoundSide {
    contact::PlacedHull hull;
    Mat3 deformation;       ///< F of the block
    double ball_radius{0};  ///< 0 = no ball [m]
};

/// Finds the contact point of a pair of which at least one side is a ball: the point of the ellipsoid x_c + F X,
/// |X| = r, that lies farthest towards the nearest point of the other body.
/// @returns nothing where they are farther apart than `reach` [m]
std::optional<BlockContact> find_at_ball(const contact::PartPair& pair, const RoundSide& a, const RoundSide& b,
                                         double reach);

}  // namespace riprap::solid::affine
