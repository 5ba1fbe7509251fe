// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/solid/planar_dda/contacts.hpp"

// Discs. A sphere of a planar scene is a polygon of 64 corners, which lie outside of its circle, and of edges, which
// lie inside. It would stand on a corner, and hop from edge to edge as it rolls. Its contact is that of the circle
// itself: one at every place of another outline that is nearer to its centre than the places about it. Of a strained
// block it is that of the ellipse x_c + R U X, |X| = r, that the strain makes of the circle, whose point of contact is
// taken to lie farthest towards that nearest place: right to the first order of the strain, also for the force by
// which a contact strains its disc.

namespace riprap::solid::planar_dda {

struct Scene;  // contact_scene.hpp

/// A contact of a disc is named by the first corner of its block and by an edge of the other one, from whose line or
/// begin it is nearest; by the first corner of the other block where that is a disc too.
inline bool is_round(const Model& model, std::int32_t corner) {
    return model.round_radius[static_cast<std::size_t>(model.corner_block[static_cast<std::size_t>(corner)])] > 0;
}

/// A place where a disc may touch another block.
struct RoundTouch {
    double gap{0};            ///< negative where they overlap [m]
    double foot{0};           ///< along the edge, 0 at its end, 1 at its begin; beyond these the corner is nearest [-]
    Vec2 normal{};            ///< from the other block to the disc [-]
    Vec2 on_disc{}, other{};  ///< the two points that touch [m]
};

/// Finds how a disc stands to the edge or the disc that names a contact. The normal at a corner or a disc turns while
/// a step moves the disc by w against the other block, and the gap changes by n . w + w^2/2r: exactly by the normal
/// that it has half way.
/// @param ahead  w/2 [m]
RoundTouch touch_round(const Model& model, const State& state, const std::vector<Vec2>& corners, std::int32_t disc,
                       std::int32_t edge, const Vec2& ahead = {});

/// Finds the contacts of all discs among the pairs of the search, by their names, as `wanted`. Two blocks that lie
/// flush, or with a joint between them that counts as closed, are one face: a corner that does not stand above the face
/// which a disc touches beside it, by more than the overlap there, is none.
void find_round(const Scene& scene, ContactSearch& search);

/// Makes a contact of its name. It goes on with what the state knows of it, or with what it knows of another one that
/// the disc has left for this one on its way: along an outline, around a corner, over a seam. Its slip is the way in
/// which the two points of contact of each step have moved against each other, so a disc that rolls winds up nothing.
/// It is not bonded, as a line of contact has no area.
Contact make_round_contact(const Scene& scene, const ContactSearch& search, std::int32_t disc, std::int32_t edge);

}  // namespace riprap::solid::planar_dda
