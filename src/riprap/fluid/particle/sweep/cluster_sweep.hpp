// SPDX-License-Identifier: Apache-2.0
#pragma once

// A sweep over one patch of targets after the other. For sweep_kernel.hpp.

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <vector>

#include "riprap/core/parallel.hpp"
#include "riprap/fluid/particle/sweep/patch_sweep.hpp"
#include "riprap/fluid/particle/sweep/sweep_scratch.hpp"

namespace riprap::fluid::detail {

/// Makes sums zero that are to take the place of what is there.
template <std::size_t SumCount>
void clear_fresh(const std::array<FieldSink, SumCount>& sums, std::int64_t first, std::int64_t end) {
    for (const FieldSink& sum : sums) {
        for (std::int64_t i = first; sum.is_fresh && i < end; ++i) {
            sum.set(i, 0);
        }
    }
}

/// Lists the blocks of candidates that some patches name, and numbers them in that order.
inline void number_blocks(const ClusterList& list, std::int64_t first_patch, std::int64_t end_patch,
                          PackedFields& packed) {
    for (const std::int32_t block : packed.blocks) {
        packed.place[static_cast<std::size_t>(block)] = -1;
    }
    packed.blocks.clear();
    packed.place.resize(static_cast<std::size_t>(list.candidates().block_count()), -1);
    for (std::int64_t p = first_patch; p < end_patch; ++p) {
        for (const std::int32_t block : list.patches()[static_cast<std::size_t>(p)].blocks) {
            std::int32_t& place = packed.place[static_cast<std::size_t>(block)];
            if (place < 0) {
                place = static_cast<std::int32_t>(packed.blocks.size());
                packed.blocks.push_back(block);
            }
        }
    }
}

/// Packs fields as floats: [cluster][field][member], zero where the last cluster is not full; of the candidates that
/// some patches name.
template <std::size_t FieldCount>
void pack_fields(const std::array<FieldView, FieldCount>& fields, const ClusterList& list, std::int64_t first_patch,
                 std::int64_t end_patch, PackedFields& packed) {
    constexpr std::size_t block_record = FieldCount * cluster_size * BoxTree::branches;
    number_blocks(list, first_patch, end_patch, packed);
    const std::int64_t size = list.candidates().size(), clusters = list.candidates().cluster_count();
    make_room(packed.fields, packed.blocks.size() * block_record);
    parallel::for_each_uneven(static_cast<std::int64_t>(packed.blocks.size()), 16, [&](std::int64_t place) {
        const std::int64_t block = packed.blocks[static_cast<std::size_t>(place)];
        const std::int64_t first = block * BoxTree::branches, end = std::min(clusters, first + BoxTree::branches);
        float* four = packed.fields.data() + static_cast<std::size_t>(place) * block_record;
        for (std::int64_t c = first; c < end; ++c) {
            const std::int64_t members = std::min<std::int64_t>(cluster_size, size - c * cluster_size);
            for (std::size_t k = 0; k < FieldCount; ++k, four += cluster_size) {
                if (members == cluster_size) {
                    fields[k].copy_four(c * cluster_size, four);
                    continue;
                }
                for (std::int64_t member = 0; member < cluster_size; ++member) {
                    four[member] = member < members ? static_cast<float>(fields[k][c * cluster_size + member]) : 0.0F;
                }
            }
        }
    });
}

/// A sweep over all patches.
template <int Dim, class Pair, class Way>
struct ClusterSweep {
    using Patches = PatchSweep<Dim, Pair, Way>;
    static constexpr std::size_t target_fields = Patches::target_fields;
    static constexpr std::size_t candidate_fields = Patches::candidate_fields;
    static constexpr std::size_t sum_count = Patches::sum_count;

    Pair pair;
    const std::array<FieldView, target_fields>& targets;
    const std::array<FieldSink, sum_count>& sums;
    SweepScratchData& scratch;
    bool is_each_once;
    float far;                    ///< square of a distance without effect [m^2]
    std::int64_t first_patch{0};  ///< that of the first of the buffers

    void sweep_patch(std::int64_t p) const {
        const ClusterList& list = scratch.list;
        const Patch& patch = list.patches()[static_cast<std::size_t>(p)];
        std::unique_ptr<BufferPool::Buffer> records = scratch.buffers->records.take();
        copy_records(patch, *records);
        Patches work{pair, {}, records->data(), nullptr, -1, far * 0.0625F * 1.00001F, Lanes(0)};
        const std::int64_t members = list.candidates().size() % cluster_size,
                           last = list.candidates().cluster_count() - 1;
        if (members != 0 && !patch.blocks.empty() && patch.blocks.back() == last / BoxTree::branches &&
            patch.clusters.back().has(last % BoxTree::branches)) {
            work.partial = patch.clusters.back().place(last % BoxTree::branches);
            for (int lane = 0; lane < lane_count; ++lane) {
                work.beyond.set(lane, lane % cluster_size < members ? 0.0F : far);
            }
        }
        for (std::size_t axis = 0; axis < Dim; ++axis) {
            work.quantum[axis] = Lanes(list.fixed().quantum()[static_cast<int>(axis)]);
        }
        if constexpr (Way::back_sums > 0) {
            work.back = scratch.buffers->patch_sums.data() +
                        scratch.buffers->patch_begin[static_cast<std::size_t>(p - first_patch)];
            std::fill_n(work.back, static_cast<std::size_t>(patch.cluster_count) * Patches::back_record, 0.0F);
        }
        const std::int64_t first = list.first_cluster(p), end = list.first_cluster(p + 1);
        for (std::int64_t t = first; t < end; ++t) {
            const NearClusters near = patch.near(t - first);
            if (near.size() > 0) {
                sweep_cluster(t, t - first, near, work);
            } else if (!is_each_once) {
                clear_fresh(sums, t * cluster_size, std::min(list.targets().size(), (t + 1) * cluster_size));
            }
        }
        scratch.buffers->records.give(std::move(records));
    }

    void sweep_cluster(std::int64_t t, std::int64_t local, const NearClusters& near, const Patches& work) const {
        const ClusterList& list = scratch.list;
        const std::int64_t count = std::min<std::int64_t>(cluster_size, list.targets().size() - t * cluster_size);
        const typename Patches::Target target =
            is_each_once ? target_in(work.records + static_cast<std::size_t>(local) * Patches::record, count)
                         : target_of(t, count);
        typename Patches::Sums sum;
        for (auto& part : sum) {
            part.fill(LanePart(0));
        }
        work.add(target, near, is_each_once && near[0] == local, sum);
        if (is_each_once) {
            for (std::size_t k = 0; k < sum_count; ++k) {
                add_to(work.back + static_cast<std::size_t>(local) * Patches::back_record + k * cluster_size,
                       Patches::sum_of(sum, k));
            }
            return;
        }
        for (std::size_t k = 0; k < sum_count; ++k) {
            const Wide<float, 4> total = Patches::sum_of(sum, k);
            for (int member = 0; member < count; ++member) {
                const std::int64_t i = t * cluster_size + member;
                sums[k].set(i, (sums[k].is_fresh ? 0 : sums[k].get(i)) + static_cast<double>(total[member]));
            }
        }
    }

    typename Patches::Target target_in(const float* four, std::int64_t count) const {
        typename Patches::Target target;
        target.apart = apart(count);
        for (std::size_t axis = 0; axis < Dim; ++axis) {
            target.place[axis] = targets_in_lanes(reinterpret_cast<const std::int32_t*>(four) + axis * cluster_size);
        }
        if constexpr (target_fields == candidate_fields) {
            for (std::size_t k = 0; k < target_fields; ++k) {
                target.fields[k] = targets_in_lanes(four + (Dim + k) * cluster_size);
            }
        }
        return target;
    }
    Lanes apart(std::int64_t count) const {
        Lanes square(1e-30F);
        if (count < cluster_size) {
            for (int lane = 0; lane < lane_count; ++lane) {
                square.set(lane, lane / cluster_size < count ? 1e-30F : far);
            }
        }
        return square;
    }
    typename Patches::Target target_of(std::int64_t t, std::int64_t count) const {
        typename Patches::Target target;
        target.apart = apart(count);
        for (std::size_t axis = 0; axis < Dim; ++axis) {
            target.place[axis] = targets_in_lanes(scratch.list.targets().cluster(t) + axis * cluster_size);
        }
        for (std::size_t k = 0; k < target_fields; ++k) {
            std::array<float, cluster_size> four;
            if (count == cluster_size) {
                targets[k].copy_four(t * cluster_size, four.data());
            } else {
                for (std::int64_t member = 0; member < cluster_size; ++member) {
                    four[static_cast<std::size_t>(member)] =
                        static_cast<float>(targets[k][t * cluster_size + std::min(member, count - 1)]);
                }
            }
            target.fields[k] = targets_in_lanes(four.data());
        }
        return target;
    }

    /// Places and fields of the clusters that the patch names, one behind the other.
    void copy_records(const Patch& patch, std::vector<float>& records) const {
        const ClusterPlaces& places = scratch.list.candidates();
        make_room(records, static_cast<std::size_t>(patch.cluster_count) * Patches::record);
        float* out = records.data();
        for (std::size_t b = 0; b < patch.blocks.size(); ++b) {
            const std::int64_t first = std::int64_t{patch.blocks[b]} * BoxTree::branches;
            const float* fields = nullptr;
            if constexpr (candidate_fields > 0) {
                const PackedFields& packed = scratch.buffers->packed;
                const auto place = static_cast<std::size_t>(packed.place[static_cast<std::size_t>(patch.blocks[b])]);
                fields = packed.fields.data() + place * candidate_fields * cluster_size * BoxTree::branches;
            }
            for (unsigned left = patch.clusters[b].named; left != 0; left &= left - 1, out += Patches::record) {
                const auto member = static_cast<std::size_t>(std::countr_zero(left));
                std::memcpy(out, places.cluster(first + static_cast<std::int64_t>(member)),
                            Dim * cluster_size * sizeof(float));
                if constexpr (candidate_fields > 0) {
                    std::memcpy(out + Dim * cluster_size, fields + member * candidate_fields * cluster_size,
                                candidate_fields * cluster_size * sizeof(float));
                }
            }
        }
    }
};

}  // namespace riprap::fluid::detail
