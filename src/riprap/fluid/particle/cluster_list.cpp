// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/particle/cluster_list.hpp"

#include <algorithm>
#include <cmath>

#include "riprap/core/bytes.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/fluid/particle/cell_grid.hpp"
#include "riprap/fluid/particle/list_search.hpp"

namespace riprap::fluid {

namespace {

/// Blocks whose motion is watched lie so many skins farther away than lists reach. What lies beyond them cannot have
/// come within reach as long as nothing anywhere has come closer than by these skins and one more.
constexpr double watched_skins = 4;

Motion join_all(const std::vector<Motion>& motions) {
    Motion all = no_motion();
    for (const Motion& motion : motions) {
        all = join(all, motion);
    }
    return all;
}

}  // namespace

void ClusterList::update(const SweepReach& reach, std::span<const Vec3> targets, std::span<const Vec3> candidates,
                         bool is_each_once) {
    check_periods(reach.domain, reach.support_radius);
    const bool is_same = targets.data() == candidates.data() && targets.size() == candidates.size();
    const bool is_alike = is_complete_ && is_same_ == is_same && is_each_once_ == is_each_once;
    is_same_ = is_same;
    is_each_once_ = is_each_once;
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
    const bool is_known = is_alike && targets_.is_motion_known() && this->candidates().is_motion_known();
    const double in_lists = is_known ? closer_in_lists() : 0, anywhere = is_known ? closer_anywhere() : 0;
    if (is_known && in_lists <= skin_ && anywhere <= (1 + watched_skins) * skin_) {
        return;
    }
    choose_skin(reach.support_radius, is_known ? std::max(in_lists, anywhere / (1 + watched_skins)) : -1);
    build(reach, targets, candidates);
}

float ClusterList::closer_in_lists() const {
    const auto closer = [&](std::int64_t block) {
        const std::vector<std::int32_t>& watched = patches_[static_cast<std::size_t>(block / Patch::size)]
                                                       .watched[static_cast<std::size_t>(block % Patch::size)];
        Motion around = no_motion();
        for (const std::int32_t other : watched) {
            around = join(around, candidates().motions()[static_cast<std::size_t>(other)]);
        }
        return watched.empty() ? 0.0F : approach(targets_.motions()[static_cast<std::size_t>(block)], around);
    };
    return parallel::reduce(
        targets_.block_count(), 0.0F, closer, [](float a, float b) { return std::max(a, b); }, 64);
}

float ClusterList::closer_anywhere() const {
    return approach(join_all(targets_.motions()), join_all(candidates().motions()));
}

/// @param closer  by which particles came closer since the last build [m]; negative: not known
void ClusterList::choose_skin(double support_radius, double closer) {
    // A skin s makes a sweep dearer by 3 s/(2 h) of the third of it that finds distances, and lets it last s/u sweeps
    // at a motion of u per sweep until the lists, which cost about 0.7 sweeps, are made anew: least in sum at
    // s^2 = 0.7 u (2 h).
    constexpr double least = 0.01, most = 0.2;
    const double per_sweep =
        closer >= 0 ? closer / static_cast<double>(std::max<std::int64_t>(1, sweeps_)) : 0.005 * support_radius;
    skin_ = std::clamp(std::sqrt(0.7 * per_sweep * support_radius), least * support_radius, most * support_radius);
}

void ClusterList::build(const SweepReach& reach, std::span<const Vec3> targets, std::span<const Vec3> candidates) {
    candidate_boxes_.build(candidates, reach.domain);
    if (!is_same_) {
        target_boxes_.build(targets, reach.domain);
    }
    const double fixed_slack = 4 * std::max({fixed_.quantum().x, fixed_.quantum().y, fixed_.quantum().z});
    const auto distance = static_cast<float>((reach.support_radius + skin_) * (1 + 1e-5) + fixed_slack);
    const ListSearch::Question question{targets_,
                                        this->candidates(),
                                        is_same_ ? candidate_boxes_ : target_boxes_,
                                        candidate_boxes_,
                                        fixed_,
                                        reach.domain.dimension,
                                        is_each_once_,
                                        distance,
                                        static_cast<float>(watched_skins * skin_)};
    const std::int64_t block_count = targets_.block_count();
    patches_.resize(static_cast<std::size_t>((block_count + Patch::size - 1) / Patch::size));
    parallel::for_ranges(static_cast<std::int64_t>(patches_.size()), 1, [&](std::int64_t begin, std::int64_t end) {
        ListSearch search(question);
        for (std::int64_t p = begin; p < end; ++p) {
            const std::int64_t first = p * Patch::size;
            search.fill(first, std::min(Patch::size, block_count - first), patches_[static_cast<std::size_t>(p)]);
        }
    });
    collect_mentions();
    targets_.remember();
    if (!is_same_) {
        candidates_.remember();
    }
    is_complete_ = true;
    sweeps_ = 0;
    ++builds_;
}

void ClusterList::collect_mentions() {
    mention_start_.assign(static_cast<std::size_t>(candidates().block_count()) + 2, 0);
    for (const Patch& patch : patches_) {
        for (const std::int32_t block : patch.blocks) {
            ++mention_start_[static_cast<std::size_t>(block) + 2];
        }
    }
    for (std::size_t b = 2; b < mention_start_.size(); ++b) {
        mention_start_[b] += mention_start_[b - 1];
    }
    mentions_.resize(static_cast<std::size_t>(mention_start_.back()));
    for (std::size_t p = 0; p < patches_.size(); ++p) {
        const std::vector<std::int32_t>& blocks = patches_[p].blocks;
        for (std::size_t place = 0; place < blocks.size(); ++place) {
            std::int32_t& next = mention_start_[static_cast<std::size_t>(blocks[place]) + 1];
            mentions_[static_cast<std::size_t>(next++)] = {static_cast<std::int32_t>(p),
                                                           static_cast<std::int32_t>(place)};
        }
    }
}

std::span<const ClusterList::Mention> ClusterList::mentions_in(std::int64_t candidate_block, std::int64_t first_patch,
                                                               std::int64_t end_patch) const {
    const auto block = static_cast<std::size_t>(candidate_block);
    const auto begin = mentions_.begin() + mention_start_[block], end = mentions_.begin() + mention_start_[block + 1];
    const auto is_before = [](const Mention& mention, std::int64_t patch) { return mention.patch < patch; };
    const auto first = std::lower_bound(begin, end, first_patch, is_before);
    return {first, std::lower_bound(first, end, end_patch, is_before)};
}

std::int64_t ClusterList::cluster_pairs() const {
    std::int64_t pairs = 0;
    for (const Patch& patch : patches_) {
        pairs += static_cast<std::int64_t>(patch.entries.size());
    }
    return pairs;
}

std::size_t ClusterList::bytes() const {
    std::size_t bytes = targets_.bytes() + candidates_.bytes() + target_boxes_.bytes() + candidate_boxes_.bytes() +
                        bytes_of(patches_, mention_start_, mentions_);
    for (const Patch& patch : patches_) {
        bytes += bytes_of(patch.blocks, patch.entries, patch.start, patch.watched);
    }
    return bytes;
}

}  // namespace riprap::fluid
