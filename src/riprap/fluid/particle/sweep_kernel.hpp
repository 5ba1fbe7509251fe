// SPDX-License-Identifier: Apache-2.0
#pragma once

// The definition of sweep(). For files of kernels only, see sweep.hpp.
//
// Particles are taken in clusters of four that follow each other in the State. One evaluation of the pair physics works
// on 16 lanes: four targets times four candidates. A list, made with a skin and kept for several sweeps, names the
// clusters of candidates for each cluster of targets, ascending. A candidate out of reach adds exactly zero to its
// lane, so what else is in a list changes no bit.

#include "riprap/core/parallel.hpp"
#include "riprap/fluid/particle/sweep_scratch.hpp"

namespace riprap::fluid {

namespace detail {

/// Fields as floats: [cluster][field][member], zero where the last cluster is not full.
template <std::size_t FieldCount>
void pack_fields(const std::array<FieldView, FieldCount>& fields, std::int64_t size, std::vector<float>& packed) {
    const std::int64_t clusters = (size + cluster_size - 1) / cluster_size;
    packed.resize(static_cast<std::size_t>(clusters * cluster_size) * FieldCount);
    parallel::for_each(clusters, [&](std::int64_t c) {
        for (std::size_t k = 0; k < FieldCount; ++k) {
            float* four = &packed[(static_cast<std::size_t>(c) * FieldCount + k) * cluster_size];
            for (std::int64_t member = 0; member < cluster_size; ++member) {
                const std::int64_t i = c * cluster_size + member;
                four[member] = i < size ? static_cast<float>(fields[k][i]) : 0.0F;
            }
        }
    });
}

/// One sweep, with everything that its inner loop needs.
template <int Dim, class Pair>
struct ClusterSweep {
    static constexpr auto target_fields = static_cast<std::size_t>(Pair::target_fields);
    static constexpr auto candidate_fields = static_cast<std::size_t>(Pair::candidate_fields);
    static constexpr auto sum_count = static_cast<std::size_t>(Pair::sums);

    Pair pair;
    const ClusterList& list;
    const std::array<FieldView, target_fields>& targets;
    const float* fields;  ///< of the candidates, packed
    const std::array<FieldSink, sum_count>& sums;
    float far;  ///< square of a distance without effect [m^2]

    void operator()(std::int64_t begin_chunk, std::int64_t end_chunk) const {
        const std::int64_t end = std::min(list.targets().cluster_count(), end_chunk * ClusterList::chunk_size);
        for (std::int64_t t = begin_chunk * ClusterList::chunk_size; t < end; ++t) {
            if (!list.near(t).empty()) {
                sweep_cluster(t);
            }
        }
    }

    void sweep_cluster(std::int64_t t) const {
        const std::int64_t count = std::min<std::int64_t>(cluster_size, list.targets().size() - t * cluster_size);
        std::array<IntVector, Dim> place;
        std::array<Lanes, Dim> quantum;
        for (std::size_t axis = 0; axis < Dim; ++axis) {
            place[axis] = targets_in_lanes(list.targets().cluster(t) + axis * cluster_size);
            quantum[axis] = Lanes(list.fixed().quantum()[static_cast<int>(axis)]);
        }
        std::array<Lanes, target_fields + 1> target{};
        for (std::size_t k = 0; k < target_fields; ++k) {
            std::array<float, cluster_size> four;
            for (std::int64_t member = 0; member < cluster_size; ++member) {
                four[static_cast<std::size_t>(member)] =
                    static_cast<float>(targets[k][t * cluster_size + std::min(member, count - 1)]);
            }
            target[k] = targets_in_lanes(four.data());
        }
        std::array<Lanes, sum_count> sum;
        sum.fill(Lanes(0));
        add_candidates(place, quantum, target, list.near(t), sum);
        for (std::size_t k = 0; k < sum_count; ++k) {
            const FloatFour total = sum_of_candidates(sum[k]);
            for (int member = 0; member < count; ++member) {
                sums[k][t * cluster_size + member] += static_cast<double>(total[member]);
            }
        }
    }

    void add_candidates(const std::array<IntVector, Dim>& place, const std::array<Lanes, Dim>& quantum,
                        const std::array<Lanes, target_fields + 1>& target, std::span<const std::int32_t> near,
                        std::array<Lanes, sum_count>& sums_out) const {
        const Pair physics = pair;
        std::array<Lanes, sum_count> sum = sums_out;
        const std::int64_t size = list.candidates().size();
        const std::int64_t partial = size % cluster_size == 0 ? -1 : size / cluster_size;
        const std::int32_t* const places = list.candidates().cluster(0);
        const auto add = [&](std::int64_t c) __attribute__((always_inline)) {
            std::array<Lanes, Dim> d;
            Lanes r2(1e-30F);  // not zero, where square roots need care
            const std::int32_t* const four_places = places + c * Dim * cluster_size;
            for (std::size_t axis = 0; axis < Dim; ++axis) {
                d[axis] =
                    difference(place[axis], candidates_in_lanes(four_places + axis * cluster_size)) * quantum[axis];
                r2 += d[axis] * d[axis];
            }
            if (c == partial) [[unlikely]] {
                r2 += beyond(size % cluster_size);
            }
            std::array<Lanes, candidate_fields + 1> candidate{};
            const float* const four_fields = fields + c * Pair::candidate_fields * cluster_size;
            for (std::size_t k = 0; k < candidate_fields; ++k) {
                candidate[k] = candidates_in_lanes(four_fields + k * cluster_size);
            }
            physics.template operator()<Dim, Lanes>(target.data(), candidate.data(), d.data(), r2, sum.data());
        };
        // Two at a time, so that the compiler can mix their instructions: one alone is a long chain of dependences.
        std::size_t n = 0;
        for (; n + 1 < near.size(); n += 2) {
            add(near[n]);
            add(near[n + 1]);
        }
        if (n < near.size()) {
            add(near[n]);
        }
        sums_out = sum;
    }

    /// Out of reach for candidates from `first` on.
    Lanes beyond(std::int64_t first) const {
        Lanes r2(0);
        for (int lane = 0; lane < lane_count; ++lane) {
            r2.v[lane] = lane % cluster_size < first ? 0.0F : far;
        }
        return r2;
    }
};

template <int Dim, class Pair>
void sweep_clusters(const Pair& pair, const SweepReach& reach, const SweepSide<Pair::target_fields>& targets,
                    const SweepSide<Pair::candidate_fields>& candidates,
                    const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>& sums,
                    SweepScratchData& scratch) {
    scratch.list.update(reach, targets.position, candidates.position);
    pack_fields(candidates.fields, static_cast<std::int64_t>(candidates.position.size()), scratch.fields);
    const auto far = static_cast<float>(16 * reach.support_radius * reach.support_radius);
    parallel::for_ranges(scratch.list.chunk_count(), 8,
                         ClusterSweep<Dim, Pair>{pair, scratch.list, targets.fields, scratch.fields.data(), sums, far});
}

}  // namespace detail

template <PairPhysics Pair>
void sweep(const Pair& pair, const SweepReach& reach, const SweepSide<Pair::target_fields>& targets,
           const SweepSide<Pair::candidate_fields>& candidates,
           const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>& sums, SweepScratch& scratch) {
    if (targets.position.empty() || candidates.position.empty()) {
        return;
    }
    if (reach.domain.dimension == 2) {
        detail::sweep_clusters<2>(pair, reach, targets, candidates, sums, scratch.data());
    } else {
        detail::sweep_clusters<3>(pair, reach, targets, candidates, sums, scratch.data());
    }
}

}  // namespace riprap::fluid

/// Defines the sweep of one type of pair physics here; at namespace scope of riprap::fluid.
#define RIPRAP_INSTANTIATE_SWEEP(Pair)                                                               \
    template void sweep<Pair>(const Pair&, const SweepReach&, const SweepSide<Pair::target_fields>&, \
                              const SweepSide<Pair::candidate_fields>&,                              \
                              const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>&, SweepScratch&)
