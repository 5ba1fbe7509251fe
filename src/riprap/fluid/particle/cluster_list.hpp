// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "riprap/fluid/particle/box_tree.hpp"
#include "riprap/fluid/particle/cluster_places.hpp"

namespace riprap::fluid {

/// Some blocks of clusters of targets that follow each other, which one thread sweeps in one go, with everything around
/// them that may act on them. Where its data are cut depends on the number of targets alone.
struct Patch {
    /// 2048 particles: a cube of 13 spacings, with about twice as many around it; their records fit into the cache of
    /// one core.
    static constexpr std::int64_t size = 32;  ///< blocks of targets

    std::vector<std::int32_t> blocks;  ///< of candidates that lists name, ascending
    std::vector<std::int32_t>
        entries;                      ///< lists: place of a cluster in `blocks`, times BoxTree::branches, plus its own
    std::vector<std::int32_t> start;  ///< of the list of each target cluster, one more at the end
    std::vector<std::vector<std::int32_t>> watched;  ///< per target block: blocks around, farther than the lists reach

    std::span<const std::int32_t> near(std::int64_t target) const {
        const std::int32_t first = start[static_cast<std::size_t>(target)];
        return {entries.data() + first, static_cast<std::size_t>(start[static_cast<std::size_t>(target) + 1] - first)};
    }
};

/// For every cluster of targets the clusters of candidates that may act on it, ascending. Complete as long as targets
/// and candidates together have come no further than the skin.
class ClusterList {
 public:
    /// Brings places and lists up to date with the positions.
    /// @param is_each_once  only candidates that are no earlier cluster than the target; both are the same particles
    void update(const SweepReach& reach, std::span<const Vec3> targets, std::span<const Vec3> candidates,
                bool is_each_once);

    const ClusterPlaces& targets() const { return targets_; }
    const ClusterPlaces& candidates() const { return is_same_ ? targets_ : candidates_; }
    const FixedPoint& fixed() const { return fixed_; }

    const std::vector<Patch>& patches() const { return patches_; }
    /// The first cluster of targets of a patch, or behind the last one.
    std::int64_t first_cluster(std::int64_t patch) const {
        return std::min(targets_.cluster_count(), patch * Patch::size * BoxTree::branches);
    }
    /// Patches in which lists name a block of candidates, ascending.
    struct Mention {
        std::int32_t patch;
        std::int32_t place;  ///< in Patch::blocks
    };
    /// Patches from `first_patch` up to `end_patch` that name a block.
    std::span<const Mention> mentions_in(std::int64_t candidate_block, std::int64_t first_patch,
                                         std::int64_t end_patch) const;

    /// Tells whether any list names a block of candidates.
    bool is_mentioned(std::int64_t candidate_block) const {
        const auto block = static_cast<std::size_t>(candidate_block);
        return mention_start_[block] != mention_start_[block + 1];
    }

    /// For the record: how often lists were made, how many pairs of clusters they hold.
    std::int64_t builds() const { return builds_; }
    std::int64_t cluster_pairs() const;
    std::size_t bytes() const;

 private:
    class Search;

    void build(const SweepReach& reach, std::span<const Vec3> targets, std::span<const Vec3> candidates);
    void collect_mentions();
    float closer_in_lists() const;
    float closer_anywhere() const;
    void choose_skin(double support_radius, double closer);

    ClusterPlaces targets_, candidates_;
    BoxTree target_boxes_, candidate_boxes_;
    FixedPoint fixed_;
    std::vector<Patch> patches_;
    std::vector<std::int32_t> mention_start_;
    std::vector<Mention> mentions_;
    double skin_{0};                      ///< [m]
    std::int64_t sweeps_{0}, builds_{0};  ///< sweeps since the last build; builds
    bool is_same_{false}, is_each_once_{false}, is_complete_{false};
};

}  // namespace riprap::fluid
