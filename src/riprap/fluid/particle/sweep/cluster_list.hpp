// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "riprap/fluid/particle/sweep/placed_particles.hpp"
#include "riprap/fluid/particle/sweep/small_numbers.hpp"

namespace riprap::fluid {

/// A part of the entries of a Patch.
struct NearClusters {
    const SmallNumbers& entries;
    std::size_t first, count;

    std::size_t size() const { return count; }
    std::int32_t operator[](std::size_t n) const { return entries[first + n]; }
    void copy(std::size_t from, std::size_t number, std::int32_t* out) const {
        entries.copy(first + from, number, out);
    }
};

/// Some of the clusters of a block of candidates, and their places in a list of such clusters that follow each other.
struct NamedClusters {
    std::int32_t first;   ///< place of the first of them
    std::uint16_t named;  ///< bit c: cluster c of the block is one

    bool has(std::int64_t member) const { return (named >> member & 1) != 0; }
    /// Place of the cluster, if it is one of them.
    std::int32_t place(std::int64_t member) const {
        return first + std::popcount(named & ((1U << static_cast<unsigned>(member)) - 1));
    }
};
static_assert(BoxTree::branches == 16, "a bit for each cluster of a block");

/// Some blocks of clusters of targets that follow each other, which one thread sweeps in one go, with everything around
/// them that may act on them. Where its data are cut depends on the number of targets alone.
struct Patch {
    /// 2048 particles: a cube of 13 spacings, with about twice as many around it; their records fit into the cache of
    /// one core.
    static constexpr std::int64_t size = 32;  ///< blocks of targets
    static_assert(size * ClusterPlaces::block_size * cluster_size == parallel::reduce_block,
                  "a patch is a block of the order of particles");

    std::vector<std::int32_t> blocks;                ///< of candidates with clusters that lists name, ascending
    std::vector<NamedClusters> clusters;             ///< of each of them, those that lists name
    std::int32_t cluster_count{0};                   ///< in all
    SmallNumbers entries;                            ///< lists: places of clusters
    SmallNumbers start;                              ///< of the list of each target cluster, one more at the end
    std::vector<std::vector<std::int32_t>> watched;  ///< per target block: blocks around, farther than the lists reach

    /// List of a cluster of targets.
    NearClusters near(std::int64_t target) const {
        const std::int32_t first = start[static_cast<std::size_t>(target)];
        return {entries, static_cast<std::size_t>(first),
                static_cast<std::size_t>(start[static_cast<std::size_t>(target) + 1] - first)};
    }
    std::size_t bytes() const { return entries.bytes() + start.bytes() + bytes_of(blocks, clusters, watched); }
};

/// For every cluster of targets the clusters of candidates that may act on it, ascending. Complete as long as targets
/// and candidates together have come no further than the skin.
class ClusterList {
 public:
    ClusterList() : ClusterList(nullptr, nullptr) {}
    /// Lists between sets whose places somebody else keeps up to date, with the same FixedPoint; nullptr: it does so
    /// itself.
    ClusterList(std::shared_ptr<PlacedParticles> targets, std::shared_ptr<PlacedParticles> candidates);

    /// Brings places and lists up to date with the positions.
    /// @param is_each_once  only candidates that are no earlier cluster than the target; both are the same particles
    void update(const SweepReach& reach, std::span<const Vec3> targets, std::span<const Vec3> candidates,
                bool is_each_once);

    const ClusterPlaces& targets() const { return targets_->places(); }
    const ClusterPlaces& candidates() const { return placed_candidates().places(); }
    const FixedPoint& fixed() const { return targets().fixed(); }

    const std::vector<Patch>& patches() const { return patches_; }
    /// Numbers of patches in the order of all targets.
    const PatchOrder& order() const { return targets_->order(); }
    /// The first cluster of targets of a patch, or behind the last one.
    std::int64_t first_cluster(std::int64_t patch) const {
        return std::min(targets().cluster_count(), patch * Patch::size * BoxTree::branches);
    }
    /// Patches in which lists name a block of candidates, ascending.
    struct Mention {
        std::int32_t patch;
        NamedClusters clusters;
    };
    /// Patches from `first_patch` up to `end_patch` that name clusters of a block.
    std::span<const Mention> mentions_in(std::int64_t candidate_block, std::int64_t first_patch,
                                         std::int64_t end_patch) const;

    /// For the record: how often lists were made, how many pairs of clusters they hold.
    std::int64_t builds() const { return builds_; }
    std::int64_t cluster_pairs() const;
    std::size_t bytes() const;

 private:
    /// State of a set when the lists were made, and the motion of its blocks since.
    struct Since {
        std::int64_t known_since{0}, checked{0};
        std::vector<Travel> then;
        std::vector<Motion> motions;

        void remember(const ClusterPlaces& places);
        /// Returns whether nothing was placed since the last call of either.
        bool is_checked(const ClusterPlaces& places) const {
            return known_since == places.known_since() && checked == places.updates();
        }
        /// Returns whether motions are known.
        bool update(const ClusterPlaces& places);
    };

    PlacedParticles& placed_candidates() const { return is_same_ ? *targets_ : *candidates_; }
    const std::vector<Motion>& candidate_motions() const {
        return is_same_ ? since_targets_.motions : since_candidates_.motions;
    }
    void place(const SweepReach& reach, std::span<const Vec3> targets, std::span<const Vec3> candidates);
    void build(const SweepReach& reach, std::span<const Vec3> targets, std::span<const Vec3> candidates);
    void collect_mentions();
    float closer_in_lists() const;
    float closer_anywhere() const;
    void choose_skin(double support_radius, double closer);

    std::shared_ptr<PlacedParticles> targets_, candidates_;
    Since since_targets_, since_candidates_;
    std::vector<Patch> patches_;
    std::vector<std::int32_t> mention_start_;
    std::vector<Mention> mentions_;
    double skin_{0};                      ///< [m]
    std::int64_t sweeps_{0}, builds_{0};  ///< sweeps since the last build; builds
    bool is_same_{false}, is_each_once_{false}, is_complete_{false}, places_itself_{true};
};

}  // namespace riprap::fluid
