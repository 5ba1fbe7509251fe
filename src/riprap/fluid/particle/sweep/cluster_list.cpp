// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/particle/sweep/cluster_list.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "riprap/core/bytes.hpp"
#include "riprap/core/error.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/fluid/particle/sweep/cell_grid.hpp"
#include "riprap/fluid/particle/sweep/list_search.hpp"

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

ClusterList::ClusterList(std::shared_ptr<PlacedParticles> targets, std::shared_ptr<PlacedParticles> candidates)
    : targets_(std::move(targets)), candidates_(std::move(candidates)), places_itself_(targets_ == nullptr) {
    if (places_itself_) {
        targets_ = std::make_shared<PlacedParticles>();
        candidates_ = std::make_shared<PlacedParticles>();
    }
}

void ClusterList::Since::remember(const ClusterPlaces& places) {
    known_since = places.known_since();
    checked = places.updates();
    then = places.travels();
}

bool ClusterList::Since::update(const ClusterPlaces& places) {
    if (known_since != places.known_since()) {
        return false;
    }
    checked = places.updates();
    motions.resize(then.size());
    for (std::size_t block = 0; block < then.size(); ++block) {
        motions[block] = motion_between(then[block], places.travels()[block]);
    }
    return true;
}

/// Places both sets, or makes sure that they were placed where they are.
void ClusterList::place(const SweepReach& reach, std::span<const Vec3> targets, std::span<const Vec3> candidates) {
    if (places_itself_) {
        const riprap::fluid::Box box = is_same_ ? box_of(targets) : box_of(targets, candidates);
        const FixedPoint fixed(reach, max(box.high - box.low, Vec3{}));
        targets_->place(targets, fixed, reach.domain.dimension);
        if (!is_same_) {
            candidates_->place(candidates, fixed, reach.domain.dimension);
        }
        return;
    }
    RIPRAP_ASSERT(this->targets().is_at(targets) && this->candidates().is_at(candidates),
                  "particles are swept elsewhere than they were placed");
}

void ClusterList::update(const SweepReach& reach, std::span<const Vec3> targets, std::span<const Vec3> candidates,
                         bool is_each_once) {
    check_periods(reach.domain, reach.support_radius);
    const bool is_same = targets.data() == candidates.data() && targets.size() == candidates.size();
    const bool is_alike = is_complete_ && is_same_ == is_same && is_each_once_ == is_each_once;
    is_same_ = is_same;
    is_each_once_ = is_each_once;
    place(reach, targets, candidates);
    ++sweeps_;
    if (is_alike && since_targets_.is_checked(this->targets()) &&
        (is_same_ || since_candidates_.is_checked(this->candidates()))) {
        return;
    }
    const bool is_known = is_alike && since_targets_.update(this->targets()) &&
                          (is_same_ || since_candidates_.update(this->candidates()));
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
            around = join(around, candidate_motions()[static_cast<std::size_t>(other)]);
        }
        return watched.empty() ? 0.0F : approach(since_targets_.motions[static_cast<std::size_t>(block)], around);
    };
    return parallel::reduce(
        targets().block_count(), 0.0F, closer, [](float a, float b) { return std::max(a, b); }, 64);
}

float ClusterList::closer_anywhere() const {
    return approach(join_all(since_targets_.motions), join_all(candidate_motions()));
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
    const BoxTree& target_boxes = targets_->boxes(targets, reach.domain);
    const BoxTree& candidate_boxes = placed_candidates().boxes(candidates, reach.domain);
    const Vec3 quantum = fixed().quantum();
    const double fixed_slack = 4 * std::max({quantum.x, quantum.y, quantum.z});
    const auto distance = static_cast<float>((reach.support_radius + skin_) * (1 + 1e-5) + fixed_slack);
    const ListSearch::Question question{this->targets(),
                                        this->candidates(),
                                        target_boxes,
                                        candidate_boxes,
                                        fixed(),
                                        reach.domain.dimension,
                                        is_each_once_,
                                        distance,
                                        static_cast<float>(watched_skins * skin_)};
    const std::int64_t block_count = this->targets().block_count();
    patches_.resize(static_cast<std::size_t>((block_count + Patch::size - 1) / Patch::size));
    parallel::for_ranges(static_cast<std::int64_t>(patches_.size()), 1, [&](std::int64_t begin, std::int64_t end) {
        ListSearch search(question);
        for (std::int64_t p = begin; p < end; ++p) {
            const std::int64_t first = p * Patch::size;
            search.fill(first, std::min(Patch::size, block_count - first), patches_[static_cast<std::size_t>(p)]);
        }
    });
    collect_mentions();
    since_targets_.remember(this->targets());
    if (!is_same_) {
        since_candidates_.remember(this->candidates());
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
        const Patch& patch = patches_[p];
        for (std::size_t b = 0; b < patch.blocks.size(); ++b) {
            std::int32_t& next = mention_start_[static_cast<std::size_t>(patch.blocks[b]) + 1];
            mentions_[static_cast<std::size_t>(next++)] = {static_cast<std::int32_t>(p), patch.clusters[b]};
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
    std::size_t bytes = bytes_of(mention_start_, mentions_) + bytes_of(patches_);
    if (places_itself_) {
        bytes += targets_->bytes() + candidates_->bytes();
    }
    for (const Since* since : {&since_targets_, &since_candidates_}) {
        bytes += bytes_of(since->then, since->motions);
    }
    for (const Patch& patch : patches_) {
        bytes += patch.bytes();
    }
    return bytes;
}

}  // namespace riprap::fluid
