// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/contact/broadphase/pair_cache.hpp"
#include "riprap/contact/narrowphase/common_plane_contacts.hpp"
#include "riprap/solid/affine/blocks.hpp"

namespace riprap::solid::affine {

/// One contact point between blocks a < b, as the common plane or ground gives it: Scratch.
struct BlockContact {
    std::int32_t a, b;
    std::uint64_t feature;  ///< which contact point of the pair
    std::uint64_t plane;    ///< feature that fixes the common plane, packed
    Vec3 normal;            ///< from a to b [-]
    Vec3 on_a, on_b;        ///< [m]
    double gap;             ///< n . (on_b - on_a) [m]
    double area;            ///< [m^2]
    std::int64_t old{-1};   ///< row of the history, -1 = new
};

/// Turns a vector with a contact plane that turns from old_normal to normal: the shortest rotation between them.
Vec3 turn_with_plane(const Vec3& v, const Vec3& old_normal, const Vec3& normal);

/// Triangles, ridges and sharp points of ground near one block, in the frame of the ground: Scratch. They stay while
/// the block stays within the ball in which they were looked for.
struct NearGround {
    Vec3 centre{};
    double radius{-1};  ///< of the ball [m]; < 0 = not looked for yet
    std::vector<std::int32_t> triangles, edges, points;
};

/// Finds the contact points of all blocks: Scratch. Pairs from the grid of bounding spheres, kept with a skin; half-
/// spaces and ground against every free block; common planes from the feature of the history. The same bits at any
/// thread count, and from a fresh finder.
class ContactFinder {
 public:
    /// All contact points with gap up to `reach`, sorted by (pair, feature). [m]
    const std::vector<BlockContact>& find(const BlockSystem& system, const BlockState& state,
                                          const PlacedBlocks& placed, const BlockContactHistory& history, double reach);
    /// The answer of the last find().
    const std::vector<BlockContact>& found() const { return contacts_; }
    std::int64_t pair_count() const { return static_cast<std::int64_t>(pairs_.size()); }

 private:
    void find_pairs(const BlockSystem& system, const BlockState& state, const PlacedBlocks& placed, double reach);
    void add_unbounded(const BlockSystem& system);

    contact::PairCache cache_;
    std::vector<double> radius_;
    std::vector<std::int32_t> body_;
    std::vector<std::uint8_t> is_mobile_;
    std::vector<contact::PartPair> pairs_;
    std::vector<Vec3> separating_;            ///< per pair: a direction that kept it apart
    std::vector<std::int32_t> near_of_pair_;  ///< places in near_; -1 = a pair without ground
    std::vector<NearGround> near_;
    std::vector<std::vector<BlockContact>> chunks_;
    std::vector<BlockContact> contacts_;
};

}  // namespace riprap::solid::affine
