// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/solid/affine/block_contacts.hpp"
#include "riprap/solid/affine/round_blocks.hpp"

// Contact points of a block with ground: a surface of triangles, fixed or driven (body/ground.hpp).
//
// Three kinds, as between any two polyhedra: a corner of the block on a triangle, a point of the ground on a face of
// the block, and two edges that cross. Only convex edges and points of the ground take part, none inside of a plane, so
// a block slides over triangles as over a half-space. A corner meets the triangle in whose cell it lies
// (geometry::SurfaceFeatures); where the corner comes to the next cell, the depth has no jump and the spring is kept. A
// point or an edge is met where its direction lies between the directions of the faces around it, to
// `geometry::steep_turn`. Balls and discs of planar scenes meet the places of the surface that are nearest to their
// centres among those around (ground_round.cpp).

namespace riprap::solid::affine {

struct Ground;

/// One block and one ground at their present places.
struct OnGround {
    const Ground* ground;
    Vec3 position;              ///< of the ground's frame [m]
    Mat3 turn;                  ///< ground frame -> world
    contact::PlacedHull block;  ///< in world axes
    contact::PartPair pair;     ///< numbers of both bodies
    bool is_ground_first;       ///< the ground is pair.a
    bool needs_areas;           ///< a bond has cohesion or tensile strength per area
    RoundSide round{};          ///< the block where it is a ball or a disc
    double half{0};             ///< of the thickness of a disc; 0 = none [m]
};

/// Appends the contact points with a gap up to `reach`, sorted by feature, with their rows of the history. Rows begin
/// to end belong to the pair.
void find_on_ground(const OnGround& scene, const BlockContactHistory& history, std::size_t begin, std::size_t end,
                    double reach, NearGround& near, std::vector<BlockContact>& found);

}  // namespace riprap::solid::affine
