// SPDX-License-Identifier: Apache-2.0
#pragma once

// The definitions of sweep() and exchange(). For files of kernels only, see sweep.hpp.
//
// Particles are taken in clusters of four that follow each other in the State. One evaluation of the pair physics works
// on 16 lanes: four targets times four candidates. A list, made with a skin and kept for several sweeps, names the
// clusters of candidates for each cluster of targets, ascending. A candidate out of reach adds exactly zero to its
// lane, so what else is in a list changes no bit.
//
// Work is cut into patches of targets. A patch copies its candidates next to each other, and where pairs act both ways
// it sums what its targets do to them in a buffer of its own; the buffers are then added up in the order of patches,
// some patches at a time, so that few buffers are enough and are still in the cache.

#include <algorithm>

#include "riprap/fluid/particle/sweep/cluster_sweep.hpp"

namespace riprap::fluid {

namespace detail {

/// `count` sums from `first` on, filled up with zeros.
inline DoubleFour four_of(const FieldSink& sums, std::int64_t first, std::int64_t count) {
    if (count == cluster_size) {
        return DoubleFour{sums.get(first), sums.get(first + 1), sums.get(first + 2), sums.get(first + 3)};
    }
    DoubleFour four{};
    for (std::int64_t member = 0; member < count; ++member) {
        four[member] = sums.get(first + member);
    }
    return four;
}

/// Adds what patches from `first_patch` up to `end_patch` have done to candidates to their sums, one patch after the
/// other. Sums that are kept as floats are rounded once for every call that adds to them.
template <std::size_t SumCount>
void add_patch_sums(const SweepScratchData& scratch, std::int64_t first_patch, std::int64_t end_patch,
                    const std::array<FieldSink, SumCount>& sums) {
    constexpr std::size_t stride = padded(SumCount) * cluster_size;
    const std::int64_t size = scratch.list.candidates().size();
    parallel::for_each_uneven(scratch.list.candidates().block_count(), 16, [&](std::int64_t block) {
        const auto mentions = scratch.list.mentions_in(block, first_patch, end_patch);
        const bool is_first = first_patch == 0;
        if (mentions.empty()) {
            constexpr std::int64_t particles = BoxTree::branches * cluster_size;
            if (is_first) {
                clear_fresh(sums, block * particles, std::min(size, (block + 1) * particles));
            }
            return;
        }
        const std::int64_t first = block * BoxTree::branches;
        const std::int64_t end = std::min(scratch.list.candidates().cluster_count(), first + BoxTree::branches);
        for (std::int64_t c = first; c < end; ++c) {
            const std::int64_t count = std::min<std::int64_t>(cluster_size, size - c * cluster_size);
            std::array<DoubleFour, SumCount> total;
            for (std::size_t k = 0; k < SumCount; ++k) {
                total[k] = is_first && sums[k].is_fresh ? DoubleFour{} : four_of(sums[k], c * cluster_size, count);
            }
            for (const ClusterList::Mention& mention : mentions) {
                if (!mention.clusters.has(c - first)) {
                    continue;
                }
                const std::size_t begin =
                    scratch.buffers->patch_begin[static_cast<std::size_t>(mention.patch - first_patch)];
                const auto cluster = static_cast<std::size_t>(mention.clusters.place(c - first));
                const float* const part = &scratch.buffers->patch_sums[begin + cluster * stride];
                for (std::size_t k = 0; k < SumCount; ++k) {
                    FloatFour four;
                    __builtin_memcpy(&four, part + k * cluster_size, sizeof four);
                    total[k] += __builtin_convertvector(four, DoubleFour);
                }
            }
            for (std::size_t k = 0; k < SumCount; ++k) {
                for (int member = 0; member < count; ++member) {
                    sums[k].set(c * cluster_size + member, total[k][member]);
                }
            }
        }
    });
}

/// Number of patches that are swept before their sums at candidates are added up: even shares of all, about a tenth of
/// them, so that their buffers, some 0.4 MB each, are a small part of what the particles take; as many as keep eight
/// threads at work, and no more than 32 do. It decides bits of sums that are kept as floats, so it depends on nothing
/// but the number of patches of all targets, and rounds go by the numbers of patches among them, whoever keeps some.
inline std::int64_t patches_at_a_time(std::int64_t patches) {
    const std::int64_t most = std::clamp<std::int64_t>(patches / 10, 8, 32);
    const std::int64_t rounds = std::max<std::int64_t>(1, (patches + most - 1) / most);
    return (patches + rounds - 1) / rounds;
}

/// The first patch that is kept of a later round than patch `first`, out of `patches` that are kept.
inline std::int64_t end_of_round(const PatchOrder& order, std::int64_t first, std::int64_t patches) {
    const std::int64_t step = patches_at_a_time(order.whole(patches)), round = order[first] / step;
    std::int64_t end = first + 1;
    while (end < patches && order[end] / step == round) {
        ++end;
    }
    return end;
}

/// Cuts the buffer of sums at candidates into those of patches from `first_patch` up to `end_patch`.
/// @param cluster_record  numbers that a cluster of candidates takes
inline void make_room_for_patches(SweepScratchData& scratch, std::int64_t first_patch, std::int64_t end_patch,
                                  std::size_t cluster_record) {
    std::vector<std::size_t>& begin = scratch.buffers->patch_begin;
    begin.clear();
    std::size_t room = 0;
    for (std::int64_t p = first_patch; p < end_patch; ++p) {
        begin.push_back(room);
        room += static_cast<std::size_t>(scratch.list.patches()[static_cast<std::size_t>(p)].cluster_count) *
                cluster_record;
    }
    make_room(scratch.buffers->patch_sums, room);
}

/// Brings lists up to date and sweeps all patches, some at a time; `add(first, end)` is called after each round.
template <int Dim, class Way, class Pair, class Add>
void sweep_in_rounds(const Pair& pair, const SweepReach& reach, const SweepSide<Pair::target_fields>& targets,
                     const SweepSide<Pair::candidate_fields>& candidates,
                     const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>& sums, bool is_each_once,
                     SweepScratchData& scratch, const Add& add) {
    scratch.list.update(reach, targets.position, candidates.position, is_each_once);
    const auto far = static_cast<float>(16 * reach.support_radius * reach.support_radius);
    ClusterSweep<Dim, Pair, Way> sweep{pair, targets.fields, sums, scratch, is_each_once, far};
    const auto patches = static_cast<std::int64_t>(scratch.list.patches().size());
    for (std::int64_t first = 0, end = 0; first < patches; first = end) {
        end = end_of_round(scratch.list.order(), first, patches);
        sweep.first_patch = first;
        if constexpr (Way::back_sums > 0) {
            make_room_for_patches(scratch, first, end, decltype(sweep)::Patches::back_record);
        }
        pack_fields(candidates.fields, scratch.list, first, end, scratch.buffers->packed);
        parallel::for_each_uneven(end - first, 1, [&](std::int64_t p) { sweep.sweep_patch(first + p); });
        add(first, end);
    }
}

template <int Dim, class Pair>
void sweep_one_way(const Pair& pair, const SweepReach& reach, const SweepSide<Pair::target_fields>& targets,
                   const SweepSide<Pair::candidate_fields>& candidates,
                   const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>& sums, SweepScratchData& scratch) {
    sweep_in_rounds<Dim, OneWay<Pair>>(pair, reach, targets, candidates, sums, false, scratch,
                                       [](std::int64_t, std::int64_t) {});
}

template <int Dim, class Pair>
void sweep_both_ways(const Pair& pair, const SweepReach& reach, const SweepSide<Pair::target_fields>& a,
                     const SweepSide<Pair::candidate_fields>& b,
                     const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>& sums_a,
                     const std::array<FieldSink, static_cast<std::size_t>(Pair::back_sums)>& sums_b, bool is_each_once,
                     SweepScratchData& scratch) {
    sweep_in_rounds<Dim, BothWays<Pair>>(
        pair, reach, a, b, sums_a, is_each_once, scratch,
        [&](std::int64_t first, std::int64_t end) { add_patch_sums(scratch, first, end, sums_b); });
}

}  // namespace detail

template <PairPhysics Pair>
void sweep(const Pair& pair, const SweepReach& reach, const SweepSide<Pair::target_fields>& targets,
           const SweepSide<Pair::candidate_fields>& candidates,
           const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>& sums, SweepScratch& scratch) {
    if (targets.position.empty() || candidates.position.empty()) {
        detail::clear_fresh(sums, 0, static_cast<std::int64_t>(targets.position.size()));
        return;
    }
    if (reach.domain.dimension == 2) {
        detail::sweep_one_way<2>(pair, reach, targets, candidates, sums, scratch.data());
    } else {
        detail::sweep_one_way<3>(pair, reach, targets, candidates, sums, scratch.data());
    }
}

template <MutualPhysics Pair>
void exchange(const Pair& pair, const SweepReach& reach, const SweepSide<Pair::target_fields>& a,
              const SweepSide<Pair::candidate_fields>& b,
              const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>& sums_a,
              const std::array<FieldSink, static_cast<std::size_t>(Pair::back_sums)>& sums_b, SweepScratch& scratch) {
    if (a.position.empty() || b.position.empty()) {
        detail::clear_fresh(sums_a, 0, static_cast<std::int64_t>(a.position.size()));
        detail::clear_fresh(sums_b, 0, static_cast<std::int64_t>(b.position.size()));
        return;
    }
    if (reach.domain.dimension == 2) {
        detail::sweep_both_ways<2>(pair, reach, a, b, sums_a, sums_b, false, scratch.data());
    } else {
        detail::sweep_both_ways<3>(pair, reach, a, b, sums_a, sums_b, false, scratch.data());
    }
}

template <MutualPhysics Pair>
void exchange_within(const Pair& pair, const SweepReach& reach, const SweepSide<Pair::target_fields>& particles,
                     const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>& sums, SweepScratch& scratch) {
    static_assert(Pair::target_fields == Pair::candidate_fields && Pair::sums == Pair::back_sums);
    if (particles.position.empty()) {
        return;
    }
    if (reach.domain.dimension == 2) {
        detail::sweep_both_ways<2>(pair, reach, particles, particles, sums, sums, true, scratch.data());
    } else {
        detail::sweep_both_ways<3>(pair, reach, particles, particles, sums, sums, true, scratch.data());
    }
}

}  // namespace riprap::fluid

/// Define the sweeps of one type of pair physics here; at namespace scope of riprap::fluid.
#define RIPRAP_INSTANTIATE_SWEEP(Pair)                                                               \
    template void sweep<Pair>(const Pair&, const SweepReach&, const SweepSide<Pair::target_fields>&, \
                              const SweepSide<Pair::candidate_fields>&,                              \
                              const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>&, SweepScratch&)
#define RIPRAP_INSTANTIATE_EXCHANGE(Pair)                                                                             \
    template void exchange<Pair>(                                                                                     \
        const Pair&, const SweepReach&, const SweepSide<Pair::target_fields>&,                                        \
        const SweepSide<Pair::candidate_fields>&, const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>&, \
        const std::array<FieldSink, static_cast<std::size_t>(Pair::back_sums)>&, SweepScratch&)
#define RIPRAP_INSTANTIATE_EXCHANGE_WITHIN(Pair)                                                               \
    template void exchange_within<Pair>(const Pair&, const SweepReach&, const SweepSide<Pair::target_fields>&, \
                                        const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>&,    \
                                        SweepScratch&)
