// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "riprap/core/vec3.hpp"
#include "riprap/fluid/particle/sweep/domain.hpp"
#include "riprap/fluid/particle/sweep/lanes.hpp"

namespace riprap::fluid {

/// Boxes around clusters, around blocks of sixteen of those, and so on: a tree that needs no pointers, since clusters
/// that follow each other lie near each other. Boxes are in float, relative to the corner of the domain.
class BoxTree {
 public:
    static constexpr int branches = lane_count;

    struct Box {
        std::array<float, 3> centre, half;  ///< [m]
    };
    /// Sixteen boxes side by side, per axis.
    struct Block {
        std::array<Lanes, 3> centre, half;
    };

    void build(std::span<const Vec3> position, const Domain& domain);

    /// Appends to `found`, ascending, the blocks of clusters that may come within `distance` [m] of the box.
    void find_blocks(const Box& box, float distance, std::vector<std::int32_t>& found) const;
    /// Bit b is set where box b of the block may come within `distance` of the box.
    std::uint32_t near(const Block& block, const Box& box, float distance) const;

    const Block& clusters_of(std::int64_t block) const { return levels_[0][static_cast<std::size_t>(block)]; }
    Box box_of_cluster(std::int64_t cluster) const { return box(0, cluster); }
    /// Box around a block of clusters.
    Box box_of_block(std::int64_t block) const;
    /// Bound of what rounding to float can do to a distance between boxes [m].
    float slack() const { return slack_; }
    std::size_t bytes() const;

 private:
    Box box(std::size_t level, std::int64_t entry) const;
    void visit(std::size_t level, std::int64_t block, const Box& box, float distance,
               std::vector<std::int32_t>& found) const;

    std::vector<std::vector<Block>> levels_;  ///< from the clusters up to one block
    std::array<float, 3> period_{};
    float slack_{0};
};

}  // namespace riprap::fluid
