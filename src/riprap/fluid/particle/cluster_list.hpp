// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "riprap/fluid/particle/fixed_point.hpp"
#include "riprap/fluid/particle/lanes.hpp"

namespace riprap::fluid {

/// Particles in clusters of four that follow each other in the State. Entry [cluster][axis][member]; the last cluster
/// is filled up with copies of the last particle.
class ClusterPlaces {
 public:
    /// Clusters whose motion is kept together: a block of BoxTree.
    static constexpr std::int64_t block_size = lane_count;
    /// Box around the ways of some particles [m]: least x, y, z, nothing, and the greatest with their signs turned.
    using Motion = FloatEight;

    void update(std::span<const Vec3> position, const FixedPoint& fixed, int dimension);
    /// Whether there was something to compare with.
    bool is_motion_known() const { return is_motion_known_; }
    /// Ways since remember(), one box per block.
    const std::vector<Motion>& motions() const { return motions_; }
    void remember();

    std::int64_t size() const { return size_; }
    std::int64_t cluster_count() const { return (size_ + cluster_size - 1) / cluster_size; }
    /// Four places along each axis in turn.
    const std::int32_t* cluster(std::int64_t c) const { return &places_[static_cast<std::size_t>(c * stride_)]; }

 private:
    template <int Dim>
    Motion place_block(std::span<const Vec3> position, std::int64_t block, bool is_comparable);

    std::vector<Motion> motions_;
    bool is_motion_known_{false};
    std::vector<std::int32_t> places_, remembered_;
    std::int64_t size_{0}, stride_{0};
    FixedPoint fixed_, remembered_fixed_;
};

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
        std::array<FloatVector, 3> centre, half;
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

 private:
    Box box(std::size_t level, std::int64_t entry) const;
    void visit(std::size_t level, std::int64_t block, const Box& box, float distance,
               std::vector<std::int32_t>& found) const;

    std::vector<std::vector<Block>> levels_;  ///< from the clusters up to one block
    std::array<float, 3> period_{};
    float slack_{0};
};

/// For every cluster of targets the clusters of candidates that may act on it, ascending. Complete as long as targets
/// and candidates together have come no further than the skin.
class ClusterList {
 public:
    /// Target clusters of which the lists are kept together, and which one thread sweeps in one go.
    static constexpr std::int64_t chunk_size = BoxTree::branches;

    /// Brings places and lists up to date with the positions.
    void update(const SweepReach& reach, std::span<const Vec3> targets, std::span<const Vec3> candidates);

    const ClusterPlaces& targets() const { return targets_; }
    const ClusterPlaces& candidates() const { return is_same_ ? targets_ : candidates_; }
    const FixedPoint& fixed() const { return fixed_; }
    std::int64_t chunk_count() const { return (targets_.cluster_count() + chunk_size - 1) / chunk_size; }
    std::span<const std::int32_t> near(std::int64_t target_cluster) const {
        const Chunk& chunk = chunks_[static_cast<std::size_t>(target_cluster / chunk_size)];
        const auto local = static_cast<std::size_t>(target_cluster % chunk_size);
        return std::span(chunk.candidates)
            .subspan(static_cast<std::size_t>(chunk.start[local]),
                     static_cast<std::size_t>(chunk.start[local + 1] - chunk.start[local]));
    }

    /// For the record: how often lists were made, how many pairs of clusters they hold.
    std::int64_t builds() const { return builds_; }
    std::int64_t cluster_pairs() const;

 private:
    struct Chunk {
        std::vector<std::int32_t> candidates;
        std::array<std::int32_t, chunk_size + 1> start;
        std::vector<std::int32_t> blocks;  ///< of candidates around, farther than the lists reach
    };
    class Search;

    void build(const SweepReach& reach, std::span<const Vec3> targets, std::span<const Vec3> candidates);
    float closer_in_lists() const;
    float closer_anywhere() const;
    void choose_skin(double support_radius, double closer);

    ClusterPlaces targets_, candidates_;
    BoxTree target_boxes_, candidate_boxes_;
    FixedPoint fixed_;
    std::vector<Chunk> chunks_;
    double skin_{0};                      ///< [m]
    std::int64_t sweeps_{0}, builds_{0};  ///< sweeps since the last build; builds
    bool is_same_{false}, is_complete_{false};
};

}  // namespace riprap::fluid
