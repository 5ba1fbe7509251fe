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
// it sums what its targets do to them in a buffer of its own; the buffers are then added up in the order of patches.

#include <cstring>

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

/// Numbers that a sum over targets takes in a buffer: three are summed as four.
constexpr std::size_t padded(std::size_t sums) { return sums % 4 == 3 ? sums + 1 : sums; }

/// Adds the sums over targets of all numbers to a buffer: [number][candidate].
template <std::size_t Sums, std::size_t First = 0>
inline void add_sums_of_targets(const std::array<Lanes, Sums>& sum, float* buffer) {
    if constexpr (Sums == 0) {
        return;
    } else if constexpr (Sums - First >= 3) {
        const Lanes last = First + 3 < Sums ? sum[First + 3 < Sums ? First + 3 : 0] : Lanes(0);
        add_to(buffer + First * cluster_size, sums_of_targets(sum[First], sum[First + 1], sum[First + 2], last));
        if constexpr (First + 4 < Sums) {
            add_sums_of_targets<Sums, First + 4>(sum, buffer);
        }
    } else if constexpr (Sums - First == 2) {
        add_to(buffer + First * cluster_size, sums_of_targets(sum[First], sum[First + 1]));
    } else if constexpr (Sums - First == 1) {
        add_to(buffer + First * cluster_size, sums_of_targets(sum[First]));
    }
}

/// How a sweep uses its pair physics: what candidates do to targets,
template <class Pair>
struct OneWay {
    static constexpr std::size_t back_sums = 0;
    template <int Dim>
    static void act(const Pair& pair, const Lanes* a, const Lanes* b, const Lanes* d, Lanes r2, Lanes r, Lanes* sum,
                    Lanes*) {
        pair.template operator()<Dim, Lanes>(a, b, d, r2, r, sum);
    }
};
/// and what both do to each other.
template <class Pair>
struct BothWays {
    static constexpr auto back_sums = static_cast<std::size_t>(Pair::back_sums);
    template <int Dim>
    static void act(const Pair& pair, const Lanes* a, const Lanes* b, const Lanes* d, Lanes r2, Lanes r, Lanes* sum,
                    Lanes* back) {
        pair.template exchange<Dim, Lanes>(a, b, d, r2, r, sum, back);
    }
};

/// One patch in a sweep, with everything that its inner loop needs.
template <int Dim, class Pair, class Way>
struct PatchSweep {
    static constexpr auto target_fields = static_cast<std::size_t>(Pair::target_fields);
    static constexpr auto candidate_fields = static_cast<std::size_t>(Pair::candidate_fields);
    static constexpr auto sum_count = static_cast<std::size_t>(Pair::sums);
    static constexpr std::size_t back_sums = Way::back_sums;
    static constexpr std::size_t record = (Dim + candidate_fields) * cluster_size;  ///< floats per candidate cluster
    static constexpr std::size_t back_record = padded(back_sums) * cluster_size;

    struct Target {
        std::array<IntVector, Dim> place;
        Lanes apart;  ///< added to squares of distances: not zero, where square roots need care; far for absent members
        std::array<Lanes, target_fields + 1> fields{};
    };
    using Sums = std::array<Lanes, sum_count>;

    Pair pair;
    std::array<Lanes, Dim> quantum;
    const float* records;
    float* back;           ///< sums of candidates: [place][number][member]
    std::int32_t partial;  ///< entry of the candidate cluster that is not full, or -1
    float reach_squared;   ///< [m^2], and a little
    Lanes beyond;          ///< what puts its absent members out of reach [m^2]

    /// Where a cluster of candidates is, seen from the targets.
    struct Separation {
        std::array<Lanes, Dim> d;
        Lanes r2, r;
    };

    Separation separation(const Target& target, const std::array<Lanes, Dim>& unit, const float* four,
                          Lanes apart) const {
        Separation s;
        s.r2 = apart;
        for (std::size_t axis = 0; axis < Dim; ++axis) {
            const IntVector there =
                candidates_in_lanes(reinterpret_cast<const std::int32_t*>(four) + axis * cluster_size);
            s.d[axis] = difference(target.place[axis], there) * unit[axis];
            s.r2 += s.d[axis] * s.d[axis];
        }
        s.r = distance(s.r2);
        return s;
    }

    template <class ThisWay>
    [[gnu::always_inline]] std::array<Lanes, ThisWay::back_sums> act(const Pair& physics, const Target& target,
                                                                     const float* four, const Separation& s,
                                                                     Sums& sum) const {
        std::array<Lanes, candidate_fields + 1> candidate{};
        for (std::size_t k = 0; k < candidate_fields; ++k) {
            candidate[k] = candidates_in_lanes(four + (Dim + k) * cluster_size);
        }
        std::array<Lanes, ThisWay::back_sums> other;
        other.fill(Lanes(0));
        ThisWay::template act<Dim>(physics, target.fields.data(), candidate.data(), s.d.data(), s.r2, s.r, sum.data(),
                                   other.data());
        return other;
    }

    /// Adds what the candidates do to the target, and back.
    /// @param is_first_itself  the first candidates are the targets, of which every pair is there both ways
    void add(const Target& target, std::span<const std::int32_t> near, bool is_first_itself, Sums& sums_out) const {
        // Distances come first, for many clusters at once, and are kept: pairs of clusters that do not meet, which the
        // skin brings along, then cost a third, and two short chains of dependent instructions overlap better with
        // those of the next pairs than one long one does.
        constexpr std::size_t batch = 64;
        std::array<Separation, batch> separations;
        std::array<std::int32_t, batch> met;
        const Pair physics = pair;
        const std::array<Lanes, Dim> unit = quantum;
        const float* const all_records = records;
        float* const all_back = back;
        const auto record_of = [&](std::int32_t entry) {
            return all_records + static_cast<std::size_t>(entry) * record;
        };
        Sums sum = sums_out;
        std::size_t done = 0;
        if (is_first_itself) {
            const float* const four = record_of(near[0]);
            const Lanes apart = near[0] == partial ? target.apart + beyond : target.apart;
            act<OneWay<Pair>>(physics, target, four, separation(target, unit, four, apart), sum);
            done = 1;
        }
        while (done < near.size()) {
            const std::size_t count = std::min(batch, near.size() - done);
            const std::int32_t* const entries = near.data() + done;
            std::size_t met_count = 0;
            for (std::size_t n = 0; n < count; ++n) {
                const Separation s = separation(target, unit, record_of(entries[n]), target.apart);
                separations[met_count] = s;
                met[met_count] = entries[n];
                met_count += bits_below(s.r2, reach_squared) != 0 ? 1 : 0;
            }
            if (met_count > 0 && met[met_count - 1] == partial) [[unlikely]] {
                separations[met_count - 1] = separation(target, unit, record_of(partial), target.apart + beyond);
            }
            for (std::size_t n = 0; n < met_count; ++n) {
                const auto other = act<Way>(physics, target, record_of(met[n]), separations[n], sum);
                add_sums_of_targets(other, all_back + static_cast<std::size_t>(met[n]) * back_record);
            }
            done += count;
        }
        sums_out = sum;
    }
};

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
    float far;  ///< square of a distance without effect [m^2]

    void sweep_patch(std::int64_t p) const {
        const ClusterList& list = scratch.list;
        const Patch& patch = list.patches()[static_cast<std::size_t>(p)];
        std::unique_ptr<BufferPool::Buffer> records = scratch.records.take();
        copy_records(patch, *records);
        Patches work{pair, {}, records->data(), nullptr, -1, far * 0.0625F * 1.00001F, Lanes(0)};
        const std::int64_t members = list.candidates().size() % cluster_size,
                           last = list.candidates().cluster_count() - 1;
        if (members != 0 && !patch.blocks.empty() && patch.blocks.back() == last / BoxTree::branches) {
            work.partial = static_cast<std::int32_t>(
                (static_cast<std::int64_t>(patch.blocks.size()) - 1) * BoxTree::branches + last % BoxTree::branches);
            for (int lane = 0; lane < lane_count; ++lane) {
                work.beyond.v[lane] = lane % cluster_size < members ? 0.0F : far;
            }
        }
        for (std::size_t axis = 0; axis < Dim; ++axis) {
            work.quantum[axis] = Lanes(list.fixed().quantum()[static_cast<int>(axis)]);
        }
        if constexpr (Way::back_sums > 0) {
            std::vector<float>& back = scratch.patch_sums[static_cast<std::size_t>(p)];
            back.assign(patch.blocks.size() * BoxTree::branches * Patches::back_record, 0.0F);
            work.back = back.data();
        }
        const std::int64_t first = list.first_cluster(p), end = list.first_cluster(p + 1);
        for (std::int64_t t = first; t < end; ++t) {
            std::span<const std::int32_t> near = patch.near(t - first);
            if (!near.empty()) {
                sweep_cluster(t, t - first, near, work);
            }
        }
        scratch.records.give(std::move(records));
    }

    void sweep_cluster(std::int64_t t, std::int64_t local, std::span<const std::int32_t> near,
                       const Patches& work) const {
        const ClusterList& list = scratch.list;
        const std::int64_t count = std::min<std::int64_t>(cluster_size, list.targets().size() - t * cluster_size);
        const typename Patches::Target target =
            is_each_once ? target_in(work.records + static_cast<std::size_t>(local) * Patches::record, count)
                         : target_of(t, count);
        typename Patches::Sums sum;
        sum.fill(Lanes(0));
        work.add(target, near, is_each_once && near.front() == local, sum);
        if (is_each_once) {
            for (std::size_t k = 0; k < sum_count; ++k) {
                add_to(work.back + static_cast<std::size_t>(local) * Patches::back_record + k * cluster_size,
                       sum_of_candidates(sum[k]));
            }
            return;
        }
        for (std::size_t k = 0; k < sum_count; ++k) {
            const FloatFour total = sum_of_candidates(sum[k]);
            for (int member = 0; member < count; ++member) {
                sums[k][t * cluster_size + member] += static_cast<double>(total[member]);
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
                square.v[lane] = lane / cluster_size < count ? 1e-30F : far;
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
            for (std::int64_t member = 0; member < cluster_size; ++member) {
                four[static_cast<std::size_t>(member)] =
                    static_cast<float>(targets[k][t * cluster_size + std::min(member, count - 1)]);
            }
            target.fields[k] = targets_in_lanes(four.data());
        }
        return target;
    }

    /// Places and fields of the patch's candidates, cluster by cluster.
    void copy_records(const Patch& patch, std::vector<float>& records) const {
        const ClusterPlaces& places = scratch.list.candidates();
        records.resize(patch.blocks.size() * BoxTree::branches * Patches::record);
        float* out = records.data();
        for (const std::int32_t block : patch.blocks) {
            const std::int64_t first = std::int64_t{block} * BoxTree::branches;
            const std::int64_t end = std::min(places.cluster_count(), first + BoxTree::branches);
            for (std::int64_t c = first; c < end; ++c, out += Patches::record) {
                std::memcpy(out, places.cluster(c), Dim * cluster_size * sizeof(float));
                std::memcpy(out + Dim * cluster_size,
                            scratch.fields.data() + static_cast<std::size_t>(c) * candidate_fields * cluster_size,
                            candidate_fields * cluster_size * sizeof(float));
            }
        }
    }
};

/// Adds up what patches have done to candidates.
template <std::size_t SumCount>
void add_patch_sums(const SweepScratchData& scratch, const std::array<FieldSink, SumCount>& sums) {
    constexpr std::size_t stride = padded(SumCount) * cluster_size;
    const std::int64_t size = scratch.list.candidates().size();
    parallel::for_each_uneven(scratch.list.candidates().block_count(), 16, [&](std::int64_t block) {
        const auto mentions = scratch.list.mentions(block);
        const std::int64_t first = block * BoxTree::branches;
        const std::int64_t end = std::min(scratch.list.candidates().cluster_count(), first + BoxTree::branches);
        for (std::int64_t c = first; c < end; ++c) {
            std::array<DoubleFour, SumCount> total{};
            for (const ClusterList::Mention& mention : mentions) {
                const float* const part = &scratch.patch_sums[static_cast<std::size_t>(
                    mention.patch)][static_cast<std::size_t>(mention.place * BoxTree::branches + c - first) * stride];
                for (std::size_t k = 0; k < SumCount; ++k) {
                    FloatFour four;
                    __builtin_memcpy(&four, part + k * cluster_size, sizeof four);
                    total[k] += __builtin_convertvector(four, DoubleFour);
                }
            }
            const std::int64_t count = std::min<std::int64_t>(cluster_size, size - c * cluster_size);
            for (std::size_t k = 0; k < SumCount; ++k) {
                for (int member = 0; member < count; ++member) {
                    sums[k][c * cluster_size + member] += total[k][member];
                }
            }
        }
    });
}

template <int Dim, template <class> class Way, class Pair>
void sweep_patches(const Pair& pair, const SweepReach& reach, const SweepSide<Pair::target_fields>& targets,
                   const SweepSide<Pair::candidate_fields>& candidates,
                   const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>& sums, bool is_each_once,
                   SweepScratchData& scratch) {
    scratch.list.update(reach, targets.position, candidates.position, is_each_once);
    pack_fields(candidates.fields, static_cast<std::int64_t>(candidates.position.size()), scratch.fields);
    const auto patches = static_cast<std::int64_t>(scratch.list.patches().size());
    scratch.patch_sums.resize(static_cast<std::size_t>(patches));
    const auto far = static_cast<float>(16 * reach.support_radius * reach.support_radius);
    const ClusterSweep<Dim, Pair, Way<Pair>> sweep{pair, targets.fields, sums, scratch, is_each_once, far};
    parallel::for_each_uneven(patches, 1, [&](std::int64_t p) { sweep.sweep_patch(p); });
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
        detail::sweep_patches<2, detail::OneWay>(pair, reach, targets, candidates, sums, false, scratch.data());
    } else {
        detail::sweep_patches<3, detail::OneWay>(pair, reach, targets, candidates, sums, false, scratch.data());
    }
}

template <MutualPhysics Pair>
void exchange(const Pair& pair, const SweepReach& reach, const SweepSide<Pair::target_fields>& a,
              const SweepSide<Pair::candidate_fields>& b,
              const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>& sums_a,
              const std::array<FieldSink, static_cast<std::size_t>(Pair::back_sums)>& sums_b, SweepScratch& scratch) {
    if (a.position.empty() || b.position.empty()) {
        return;
    }
    if (reach.domain.dimension == 2) {
        detail::sweep_patches<2, detail::BothWays>(pair, reach, a, b, sums_a, false, scratch.data());
    } else {
        detail::sweep_patches<3, detail::BothWays>(pair, reach, a, b, sums_a, false, scratch.data());
    }
    detail::add_patch_sums(scratch.data(), sums_b);
}

template <MutualPhysics Pair>
void exchange_within(const Pair& pair, const SweepReach& reach, const SweepSide<Pair::target_fields>& particles,
                     const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>& sums, SweepScratch& scratch) {
    static_assert(Pair::target_fields == Pair::candidate_fields && Pair::sums == Pair::back_sums);
    if (particles.position.empty()) {
        return;
    }
    if (reach.domain.dimension == 2) {
        detail::sweep_patches<2, detail::BothWays>(pair, reach, particles, particles, sums, true, scratch.data());
    } else {
        detail::sweep_patches<3, detail::BothWays>(pair, reach, particles, particles, sums, true, scratch.data());
    }
    detail::add_patch_sums(scratch.data(), sums);
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
