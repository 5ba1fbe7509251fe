// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/solid/affine/block_contacts.hpp"

// Contact points of a block with ground: a surface of triangles that stands or is driven (body/ground.hpp).
//
// Three kinds, as between any two polyhedra: a corner of the block on a triangle, a point of the ground on a face of
// the block, and two edges that cross. Ground takes part with what sticks out of it, so that the edges and points
// inside of a plane are not met at all and a block slides over triangles as over a half-space. A corner is met by the
// triangle in whose cell it lies (geometry::SurfaceFeatures); the depth has no jump where it comes to the next cell,
// and the spring goes on with it. A point or an edge is met where its direction lies between those of the faces around
// it, to `geometry::steep_turn`.

namespace riprap::solid::affine {

struct Ground;

/// One block and one ground where they are now.
struct OnGround {
    const Ground* ground;
    Vec3 position;              ///< of the ground's frame [m]
    Mat3 turn;                  ///< ground frame -> world
    contact::PlacedHull block;  ///< in world axes
    contact::PartPair pair;     ///< numbers of the two
    bool is_ground_first;       ///< the ground is pair.a
    bool needs_areas;           ///< cohesion or tension of a bond counts by the area of a point
};

/// Appends the contact points with a gap up to `reach`, sorted by feature, with their rows of the history: rows begin
/// to end are those of the pair.
void find_on_ground(const OnGround& scene, const BlockContactHistory& history, std::size_t begin, std::size_t end,
                    double reach, NearGround& near, std::vector<BlockContact>& found);

}  // namespace riprap::solid::affine
