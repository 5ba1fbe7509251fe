// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/particle/sweep/list_search.hpp"

#include <algorithm>
#include <bit>

namespace riprap::fluid {

namespace {

/// The places of a target cluster in lanes.
struct TargetPlaces {
    std::array<IntLanes, 3> places;
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
        return bits_below(square, Lanes(within * within)) != 0;
    }
};

}  // namespace

ListSearch::ListSearch(const Question& question)
    : question_(question),
      box_distance_(question.distance + question.target_boxes.slack() + question.candidate_boxes.slack()) {
    const auto blocks = static_cast<std::size_t>(question.candidates.block_count());
    named_.assign(blocks, 0);
    place_of_block_.assign(blocks, 0);
}

void ListSearch::fill(std::int64_t first_block, std::int64_t block_count, Patch& patch) {
    entries_.clear();
    start_.assign(1, 0);
    patch.watched.resize(static_cast<std::size_t>(block_count));
    for (std::int64_t b = first_block; b < first_block + block_count; ++b) {
        find_around(b);
        patch.watched[static_cast<std::size_t>(b - first_block)].assign(blocks_.begin(), blocks_.end());
        const std::int64_t end = std::min((b + 1) * BoxTree::branches, question_.targets.cluster_count());
        for (std::int64_t target = b * BoxTree::branches; target < end; ++target) {
            find(target, entries_);
            start_.push_back(static_cast<std::int32_t>(entries_.size()));
        }
    }
    patch.start.assign(start_);
    patch.blocks.clear();
    if (question_.is_each_once) {
        for (std::int64_t b = first_block; b < first_block + block_count; ++b) {
            patch.blocks.push_back(static_cast<std::int32_t>(b));  // its own come first, all of them, named or not
            const std::int64_t own =
                std::min<std::int64_t>(BoxTree::branches, question_.targets.cluster_count() - b * BoxTree::branches);
            named_[static_cast<std::size_t>(b)] = static_cast<std::uint16_t>((1U << static_cast<unsigned>(own)) - 1);
        }
    }
    number_clusters(patch);
}

/// Blocks that a block of targets may meet, with their boxes side by side.
void ListSearch::find_around(std::int64_t target_block) {
    const BoxTree& candidates = question_.candidate_boxes;
    blocks_.clear();
    candidates.find_blocks(question_.target_boxes.box_of_block(target_block), box_distance_ + question_.watched,
                           blocks_);
    if (question_.is_each_once) {
        blocks_.erase(blocks_.begin(), std::lower_bound(blocks_.begin(), blocks_.end(), target_block));
    }
    block_boxes_.assign((blocks_.size() + BoxTree::branches - 1) / BoxTree::branches, {});
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
        const BoxTree::Box box = candidates.box_of_block(blocks_[b]);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const int lane = static_cast<int>(b % BoxTree::branches);
            block_boxes_[b / BoxTree::branches].centre[axis].set(lane, box.centre[axis]);
            block_boxes_[b / BoxTree::branches].half[axis].set(lane, box.half[axis]);
        }
    }
    near_blocks_.resize(blocks_.size() + BoxTree::branches);
    near_clusters_.resize((blocks_.size() + 1) * BoxTree::branches);
}

void ListSearch::find(std::int64_t target, std::vector<std::int32_t>& found) {
    const BoxTree& candidates = question_.candidate_boxes;
    const BoxTree::Box box = question_.target_boxes.box_of_cluster(target);
    int block_count = 0;
    for (std::size_t k = 0; k < block_boxes_.size(); ++k) {
        const std::size_t here = k * BoxTree::branches;
        const std::size_t rest = std::min<std::size_t>(BoxTree::branches, blocks_.size() - here);
        const std::uint32_t hits = candidates.near(block_boxes_[k], box, box_distance_) & ((1U << rest) - 1U);
        for (std::uint32_t left = hits; left != 0; left &= left - 1) {
            near_blocks_[static_cast<std::size_t>(block_count++)] =
                blocks_[here + static_cast<std::size_t>(__builtin_ctz(left))];
        }
    }
    int cluster_count = 0;
    for (int k = 0; k < block_count; ++k) {
        const std::int32_t block = near_blocks_[static_cast<std::size_t>(k)];
        cluster_count +=
            write_selected(candidates.near(candidates.clusters_of(block), box, box_distance_),
                           block * BoxTree::branches, &near_clusters_[static_cast<std::size_t>(cluster_count)]);
    }
    int first = 0;
    if (question_.is_each_once) {
        while (first < cluster_count && near_clusters_[static_cast<std::size_t>(first)] < target) {
            ++first;
        }
    }
    const TargetPlaces here(question_.targets.cluster(target), question_.fixed, question_.dimension);
    std::size_t size = found.size();
    found.resize(size + static_cast<std::size_t>(cluster_count - first));
    for (int k = first; k < cluster_count; ++k) {
        const std::int32_t c = near_clusters_[static_cast<std::size_t>(k)];
        found[size] = c;
        size += here.has_pair_within(question_.candidates.cluster(c), question_.distance) ? 1 : 0;
    }
    found.resize(size);
}

/// Lists the clusters that the entries name, block by block, and makes entries places in that list.
void ListSearch::number_clusters(Patch& patch) {
    for (const std::int32_t cluster : entries_) {
        std::uint16_t& named = named_[static_cast<std::size_t>(cluster / BoxTree::branches)];
        if (named == 0) {
            patch.blocks.push_back(cluster / BoxTree::branches);
        }
        named = static_cast<std::uint16_t>(named | 1U << static_cast<unsigned>(cluster % BoxTree::branches));
    }
    std::sort(patch.blocks.begin(), patch.blocks.end());
    patch.clusters.clear();
    patch.cluster_count = 0;
    for (const std::int32_t block : patch.blocks) {
        place_of_block_[static_cast<std::size_t>(block)] = static_cast<std::int32_t>(patch.clusters.size());
        patch.clusters.push_back({patch.cluster_count, named_[static_cast<std::size_t>(block)]});
        patch.cluster_count += std::popcount(named_[static_cast<std::size_t>(block)]);
        named_[static_cast<std::size_t>(block)] = 0;
    }
    for (std::int32_t& entry : entries_) {
        const auto block = static_cast<std::size_t>(entry / BoxTree::branches);
        entry = patch.clusters[static_cast<std::size_t>(place_of_block_[block])].place(entry % BoxTree::branches);
    }
    patch.entries.assign(entries_);
}

}  // namespace riprap::fluid
