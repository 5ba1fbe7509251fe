// SPDX-License-Identifier: Apache-2.0
#pragma once

// The inner loop of a sweep: one cluster of targets against the clusters that its list names. For sweep_kernel.hpp.

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "riprap/fluid/particle/sweep/cluster_list.hpp"
#include "riprap/fluid/particle/sweep/lanes.hpp"
#include "riprap/fluid/particle/sweep/pair_physics.hpp"

namespace riprap::fluid::detail {

/// Numbers that a sum over targets takes in a buffer: three are summed as four.
constexpr std::size_t padded(std::size_t sums) { return sums % 4 == 3 ? sums + 1 : sums; }

/// Adds the sums over targets of all numbers to a buffer: [number][candidate].
template <std::size_t Sums, std::size_t First = 0>
inline void add_sums_of_targets(const std::array<LanePart, Sums>& sum, float* buffer) {
    if constexpr (Sums == 0) {
        return;
    } else if constexpr (Sums - First >= 3) {
        const LanePart last = First + 3 < Sums ? sum[First + 3 < Sums ? First + 3 : 0] : LanePart(0);
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

/// Use of the pair physics by a sweep: what candidates do to targets,
template <class Pair>
struct OneWay {
    static constexpr std::size_t back_sums = 0;
    template <int Dim>
    static void act(const Pair& pair, const LanePart* a, const LanePart* b, const LanePart* d, LanePart r2, LanePart r,
                    LanePart* sum, LanePart*) {
        act_one_way<Dim>(pair, a, b, d, r2, r, sum);
    }
};
/// and what both do to each other.
template <class Pair>
struct BothWays {
    static constexpr auto back_sums = static_cast<std::size_t>(Pair::back_sums);
    template <int Dim>
    static void act(const Pair& pair, const LanePart* a, const LanePart* b, const LanePart* d, LanePart r2, LanePart r,
                    LanePart* sum, LanePart* back) {
        pair.template exchange<Dim, LanePart>(a, b, d, r2, r, sum, back);
    }
};

/// Pair physics of few particles: field `mark`, which is never negative, is zero in most, and a pair adds nothing where
/// it is zero in both or, with `needs_both_marks`, in one of them.
template <class Pair>
concept MarkedPairs = requires {
    Pair::mark;
    Pair::needs_both_marks;
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
        std::array<IntLanes, Dim> place;
        Lanes apart;  ///< added to squares of distances: not zero, where square roots need care; far for absent members
        std::array<Lanes, target_fields + 1> fields{};
    };
    using Sums = std::array<std::array<LanePart, sum_count>, Lanes::part_count>;

    /// Number k of each target.
    static Wide<float, 4> sum_of(const Sums& sums, std::size_t k) {
        return sum_of_candidates(Lanes::each([&](std::size_t p) { return sums[p][k].part[0]; }));
    }

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

    /// Writes vector by vector: GCC copies a Separation as a whole by a call of memcpy.
    [[gnu::always_inline]] void separate(const Target& target, const std::array<Lanes, Dim>& unit, const float* four,
                                         const Lanes& apart, Separation& out) const {
        std::array<IntLanes, Dim> there;
        for (std::size_t axis = 0; axis < Dim; ++axis) {
            there[axis] = candidates_in_lanes(reinterpret_cast<const std::int32_t*>(four) + axis * cluster_size);
        }
        for (std::size_t k = 0; k < Lanes::part_count; ++k) {
            LanePart r2 = part_of(apart, k);
            for (std::size_t axis = 0; axis < Dim; ++axis) {
                const LanePart d = part_of(difference(target.place[axis], there[axis]) * unit[axis], k);
                r2 += d * d;
                out.d[axis].part[k] = d.part[0];
            }
            out.r2.part[k] = r2.part[0];
            out.r.part[k] = distance(r2).part[0];
        }
    }

    template <class ThisWay>
    [[gnu::always_inline]] std::array<LanePart, ThisWay::back_sums> act(const Pair& physics, const Target& target,
                                                                        const float* four, const Separation& s,
                                                                        Sums& sum) const {
        std::array<LanePart, ThisWay::back_sums> other;
        other.fill(LanePart(0));
        [&]<std::size_t... K>(std::index_sequence<K...>) {
            (act_in_part<ThisWay, K>(physics, target, four, s, sum[K], other), ...);
        }
        (Lanes::Parts{});
        return other;
    }
    template <class ThisWay, std::size_t K>
    [[gnu::always_inline]] void act_in_part(const Pair& physics, const Target& target, const float* four,
                                            const Separation& s, std::array<LanePart, sum_count>& sum,
                                            std::array<LanePart, ThisWay::back_sums>& other) const {
        std::array<LanePart, target_fields + 1> own{};
        std::array<LanePart, candidate_fields + 1> candidate{};
        std::array<LanePart, Dim> d;
        for (std::size_t field = 0; field < target_fields; ++field) {
            own[field] = part_of(target.fields[field], K);
        }
        for (std::size_t field = 0; field < candidate_fields; ++field) {
            candidate[field] = part_of(candidates_in_lanes(four + (Dim + field) * cluster_size), K);
        }
        for (std::size_t axis = 0; axis < Dim; ++axis) {
            d[axis] = part_of(s.d[axis], K);
        }
        ThisWay::template act<Dim>(physics, own.data(), candidate.data(), d.data(), part_of(s.r2, K), part_of(s.r, K),
                                   sum.data(), other.data());
    }

    /// Adds what the candidates do to the target, and back.
    /// @param is_first_itself  the first candidates are the targets, of which every pair is there both ways
    [[gnu::flatten]]  // GCC leaves parts of the pair physics as calls, and their sums go through memory
    void
    add(const Target& target, const NearClusters& near, bool is_first_itself, Sums& sums_out) const {
        // Distances come first, for many clusters at once, and are kept: pairs of clusters that do not meet, which the
        // skin brings along, then cost a third, and two short chains of dependent instructions overlap better with
        // those of the next pairs than one long one does.
        constexpr std::size_t batch = 64;
        std::array<Separation, batch> separations;
        std::array<std::int32_t, batch> entries, met;
        const Pair physics = pair;
        const std::array<Lanes, Dim> unit = quantum;
        const float* const all_records = records;
        float* const all_back = back;
        const auto record_of = [&](std::int32_t entry) {
            return all_records + static_cast<std::size_t>(entry) * record;
        };
        bool is_marked = true, skips_unmarked = false;
        if constexpr (MarkedPairs<Pair>) {
            is_marked = bits_below(Lanes(0), target.fields[Pair::mark]) != 0;
            skips_unmarked = Pair::needs_both_marks || !is_marked;
            if (Pair::needs_both_marks && !is_marked) {
                return;
            }
        }
        Sums sum = sums_out;
        std::size_t done = is_first_itself ? 1 : 0;
        if (is_first_itself && is_marked) {
            const float* const four = record_of(near[0]);
            const Lanes apart = near[0] == partial ? target.apart + beyond : target.apart;
            separate(target, unit, four, apart, separations[0]);
            act<OneWay<Pair>>(physics, target, four, separations[0], sum);
        }
        while (done < near.size()) {
            const std::size_t count = std::min(batch, near.size() - done);
            near.copy(done, count, entries.data());
            std::size_t met_count = 0;
            for (std::size_t n = 0; n < count; ++n) {
                if constexpr (MarkedPairs<Pair>) {
                    const float* const marks = record_of(entries[n]) + (Dim + Pair::mark) * cluster_size;
                    if (skips_unmarked && !(marks[0] + marks[1] + marks[2] + marks[3] > 0)) {
                        continue;
                    }
                }
                Separation& s = separations[met_count];
                separate(target, unit, record_of(entries[n]), target.apart, s);
                met[met_count] = entries[n];
                met_count += bits_below(s.r2, Lanes(reach_squared)) != 0 ? 1 : 0;
            }
            if (met_count > 0 && met[met_count - 1] == partial) [[unlikely]] {
                separate(target, unit, record_of(partial), target.apart + beyond, separations[met_count - 1]);
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

}  // namespace riprap::fluid::detail
