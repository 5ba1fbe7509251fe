// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "riprap/contact/broadphase/pair_cache.hpp"
#include "riprap/contact/narrowphase/common_plane_contacts.hpp"
#include "riprap/solid/affine/blocks.hpp"

// Seams: places where the face that a block stands on is continued by the next block. The common plane of two blocks
// alone cannot tell what is hidden there: a block that stands on a slab is in by the overlap of its springs, so the
// side of the next slab has the larger gap and would stop it, although the first slab covers that side.

namespace riprap::solid::affine {

/// A step up to this share of the narrower block's breadth is no step [-].
constexpr double step_share = 5e-4;
/// Nor is one up to twice the overlap of the block, as far as that is up to this share [-].
constexpr double soft_step_share = 1e-2;
/// A joint up to this share wide is closed: what lies beyond continues the face [-].
constexpr double joint_share = 2.5e-2;

/// Finds what third blocks hide: Scratch of one search.
class Seams {
 public:
    Seams(const BlockSystem& system, const BlockState& state, const PlacedBlocks& placed,
          std::span<const contact::PartPair> pairs, double reach);

    /// Looks at contact points of a pair across `plane`. Where all of them lie on a side that a third block covers, on
    /// which one of the two blocks stands, `plane` becomes that of the face which continues the face stood on.
    /// @returns whether it has
    bool open_plane(const contact::PartPair& pair, const contact::PlaneContacts& points,
                    contact::CommonPlane& plane) const;

 private:
    /// Two blocks that meet, one of which may stand on a third that the other continues.
    struct Meeting {
        std::int32_t stander, other;
        contact::PlacedHull standing, next;
        Vec3 normal;                                  ///< of the plane between them, from `other` to `stander` [-]
        std::vector<std::pair<Vec3, double>> points;  ///< on `other`, and the gap there [m]
        double breadth;                               ///< of the narrower block [m]
        bool is_stander_first;                        ///< of the pair
    };
    bool is_hidden(const Meeting& meeting, std::int32_t third, contact::CommonPlane& plane) const;
    bool covers(const Meeting& meeting, const contact::PlacedHull& third, const Vec3& up, double overlap, double step,
                double joint, double& set_back) const;
    bool may_bridge(const Meeting& meeting, const contact::PlacedHull& third) const;
    bool has_dipped(const Meeting& meeting, const contact::PlacedHull& third, const contact::CommonPlane& under,
                    double least) const;
    bool turn(const Meeting& meeting, const Vec3& up, double deepest, contact::CommonPlane& plane) const;
    bool slides_along(const Meeting& meeting, const Vec3& normal) const;

    const BlockSystem& system_;
    const BlockState& state_;
    const PlacedBlocks& placed_;
    double reach_;
    std::vector<std::int32_t> begin_, neighbour_;
};

}  // namespace riprap::solid::affine
