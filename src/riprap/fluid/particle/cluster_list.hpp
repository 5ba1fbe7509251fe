// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "riprap/fluid/particle/box_tree.hpp"
#include "riprap/fluid/particle/cluster_places.hpp"

namespace riprap::fluid {

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
