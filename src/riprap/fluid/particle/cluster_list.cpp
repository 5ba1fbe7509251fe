// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/particle/cluster_list.hpp"

#include <algorithm>
#include <cmath>

#include "riprap/core/parallel.hpp"
#include "riprap/fluid/particle/cell_grid.hpp"

namespace riprap::fluid {

namespace {

/// The places of a target cluster in lanes.
struct TargetPlaces {
    std::array<IntVector, 3> places;
    std::array<Lanes, 3> quantum;
    int dimension;

    TargetPlaces(const std::int32_t* four, const FixedPoint& fixed, int dim) : dimension(dim) {
        for (int axis = 0; axis < dimension; ++axis) {
            const auto k = static_cast<std::size_t>(axis);
            places[k] = targets_in_lanes(four + static_cast<std::ptrdiff_t>(axis) * cluster_size);
            quantum[k] = Lanes(fixed.quantum()[axis]);
        }
    }
    bool has_pair_within(const std::int32_t* candidates, float within) const {
        Lanes square(0);
        for (int axis = 0; axis < dimension; ++axis) {
            const auto k = static_cast<std::size_t>(axis);
            const Lanes d = difference(places[k], candidates_in_lanes(candidates + static_cast<std::ptrdiff_t>(axis) *
                                                                                       cluster_size)) *
                            quantum[k];
            square += d * d;
        }
        return bits_below(square, within * within) != 0;
    }
};

}  // namespace

namespace {
/// Blocks whose motion is watched lie so many skins farther away than lists reach. What lies beyond them cannot have
/// come within reach as long as nothing anywhere has come closer than by these skins and one more.
constexpr double watched_skins = 4;
}  // namespace

/// Finds what is near clusters of targets, sixteen clusters of targets at a time. No branch depends on a single box:
/// the finds are written one behind the other, and the misses overwritten.
class ClusterList::Search {
 public:
    Search(const ClusterList& list, const BoxTree& targets, int dimension, float distance, float watched)
        : list_(list),
          targets_(targets),
          candidates_(list.candidate_boxes_),
          dimension_(dimension),
          distance_(distance),
          watched_(watched),
          box_distance_(distance + targets.slack() + candidates_.slack()) {}

    void fill(std::int64_t target_block, Chunk& chunk) {
        blocks_.clear();
        candidates_.find_blocks(targets_.box_of_block(target_block), box_distance_ + watched_, blocks_);
        chunk.blocks.assign(blocks_.begin(), blocks_.end());
        block_boxes_.assign((blocks_.size() + BoxTree::branches - 1) / BoxTree::branches, {});
        for (std::size_t b = 0; b < blocks_.size(); ++b) {
            const BoxTree::Box box = candidates_.box_of_block(blocks_[b]);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                block_boxes_[b / BoxTree::branches].centre[axis][static_cast<int>(b % BoxTree::branches)] =
                    box.centre[axis];
                block_boxes_[b / BoxTree::branches].half[axis][static_cast<int>(b % BoxTree::branches)] =
                    box.half[axis];
            }
        }
        near_blocks_.resize(blocks_.size() + BoxTree::branches);
        near_clusters_.resize((blocks_.size() + 1) * BoxTree::branches);
        chunk.candidates.clear();
        chunk.start.fill(0);
        const std::int64_t first = target_block * chunk_size;
        const std::int64_t count = std::min(chunk_size, list_.targets_.cluster_count() - first);
        for (std::int64_t local = 0; local < chunk_size; ++local) {
            if (local < count) {
                find(first + local, chunk.candidates);
            }
            chunk.start[static_cast<std::size_t>(local) + 1] = static_cast<std::int32_t>(chunk.candidates.size());
        }
        chunk.candidates.shrink_to_fit();
    }

 private:
    void find(std::int64_t target, std::vector<std::int32_t>& found) {
        const BoxTree::Box box = targets_.box_of_cluster(target);
        IntVector steps;
        for (int lane = 0; lane < lane_count; ++lane) {
            steps[lane] = lane;
        }
        int block_count = 0;
        for (std::size_t k = 0; k < block_boxes_.size(); ++k) {
            const std::size_t here = k * BoxTree::branches;
            const std::size_t rest = std::min<std::size_t>(BoxTree::branches, blocks_.size() - here);
            const std::uint32_t hits = candidates_.near(block_boxes_[k], box, box_distance_) & ((1U << rest) - 1U);
            for (std::uint32_t left = hits; left != 0; left &= left - 1) {
                near_blocks_[static_cast<std::size_t>(block_count++)] =
                    blocks_[here + static_cast<std::size_t>(__builtin_ctz(left))];
            }
        }
        int cluster_count = 0;
        for (int k = 0; k < block_count; ++k) {
            const std::int32_t block = near_blocks_[static_cast<std::size_t>(k)];
            cluster_count += write_selected(candidates_.near(candidates_.clusters_of(block), box, box_distance_),
                                            steps + block * BoxTree::branches,
                                            &near_clusters_[static_cast<std::size_t>(cluster_count)]);
        }
        const TargetPlaces here(list_.targets_.cluster(target), list_.fixed_, dimension_);
        std::size_t size = found.size();
        found.resize(size + static_cast<std::size_t>(cluster_count));
        for (int k = 0; k < cluster_count; ++k) {
            const std::int32_t c = near_clusters_[static_cast<std::size_t>(k)];
            found[size] = c;
            size += here.has_pair_within(list_.candidates().cluster(c), distance_) ? 1 : 0;
        }
        found.resize(size);
    }

    const ClusterList& list_;
    const BoxTree& targets_;
    const BoxTree& candidates_;
    int dimension_;
    float distance_, watched_, box_distance_;
    std::vector<std::int32_t> blocks_, near_blocks_, near_clusters_;
    std::vector<BoxTree::Block> block_boxes_;
};

void ClusterList::update(const SweepReach& reach, std::span<const Vec3> targets, std::span<const Vec3> candidates) {
    check_periods(reach.domain, reach.support_radius);
    const bool was_same = is_same_;
    is_same_ = targets.data() == candidates.data() && targets.size() == candidates.size();
    riprap::fluid::Box box = box_of(targets);
    if (!is_same_) {
        const riprap::fluid::Box other = box_of(candidates);
        box = {min(box.low, other.low), max(box.high, other.high)};
    }
    fixed_ = FixedPoint(reach, max(box.high - box.low, Vec3{}));
    const int dimension = reach.domain.dimension;
    targets_.update(targets, fixed_, dimension);
    if (!is_same_) {
        candidates_.update(candidates, fixed_, dimension);
    }
    ++sweeps_;
    const bool is_known =
        is_complete_ && was_same == is_same_ && targets_.is_motion_known() && this->candidates().is_motion_known();
    const double in_lists = is_known ? closer_in_lists() : 0, anywhere = is_known ? closer_anywhere() : 0;
    if (is_known && in_lists <= skin_ && anywhere <= (1 + watched_skins) * skin_) {
        return;
    }
    choose_skin(reach.support_radius, is_known ? std::max(in_lists, anywhere / (1 + watched_skins)) : -1);
    build(reach, targets, candidates);
}

float ClusterList::closer_in_lists() const {
    const auto closer = [&](std::int64_t k) {
        const Chunk& chunk = chunks_[static_cast<std::size_t>(k)];
        Motion around = no_motion();
        for (const std::int32_t block : chunk.blocks) {
            around = join(around, candidates().motions()[static_cast<std::size_t>(block)]);
        }
        return chunk.blocks.empty() ? 0.0F : approach(targets_.motions()[static_cast<std::size_t>(k)], around);
    };
    return parallel::reduce(
        chunk_count(), 0.0F, closer, [](float a, float b) { return std::max(a, b); }, 64);
}

float ClusterList::closer_anywhere() const {
    Motion of_targets = no_motion(), of_candidates = no_motion();
    for (const Motion& motion : targets_.motions()) {
        of_targets = join(of_targets, motion);
    }
    for (const Motion& motion : candidates().motions()) {
        of_candidates = join(of_candidates, motion);
    }
    return approach(of_targets, of_candidates);
}

/// @param closer  by which particles came closer since the last build [m]; negative: not known
void ClusterList::choose_skin(double support_radius, double closer) {
    // A skin s makes a sweep dearer by 3 s/(2 h + 1) of it and lets it last s/u sweeps at a motion of u per sweep until
    // the lists, which cost about half a sweep, are made anew: least in sum at s^2 = u (2 h)/6.
    constexpr double least = 0.01, most = 0.12;
    const double per_sweep =
        closer >= 0 ? closer / static_cast<double>(std::max<std::int64_t>(1, sweeps_)) : 0.005 * support_radius;
    skin_ = std::clamp(std::sqrt(per_sweep * support_radius / 6), least * support_radius, most * support_radius);
}

void ClusterList::build(const SweepReach& reach, std::span<const Vec3> targets, std::span<const Vec3> candidates) {
    const int dimension = reach.domain.dimension;
    candidate_boxes_.build(candidates, reach.domain);
    if (!is_same_) {
        target_boxes_.build(targets, reach.domain);
    }
    const BoxTree& boxes = is_same_ ? candidate_boxes_ : target_boxes_;
    const double fixed_slack = 4 * std::max({fixed_.quantum().x, fixed_.quantum().y, fixed_.quantum().z});
    const auto distance = static_cast<float>((reach.support_radius + skin_) * (1 + 1e-5) + fixed_slack);
    chunks_.resize(static_cast<std::size_t>(chunk_count()));
    parallel::for_ranges(chunk_count(), 16, [&](std::int64_t begin, std::int64_t end) {
        Search search(*this, boxes, dimension, distance, static_cast<float>(watched_skins * skin_));
        for (std::int64_t k = begin; k < end; ++k) {
            search.fill(k, chunks_[static_cast<std::size_t>(k)]);
        }
    });
    targets_.remember();
    if (!is_same_) {
        candidates_.remember();
    }
    is_complete_ = true;
    sweeps_ = 0;
    ++builds_;
}

std::int64_t ClusterList::cluster_pairs() const {
    std::int64_t pairs = 0;
    for (const Chunk& chunk : chunks_) {
        pairs += static_cast<std::int64_t>(chunk.candidates.size());
    }
    return pairs;
}

}  // namespace riprap::fluid
