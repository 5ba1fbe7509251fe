// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "riprap/core/bits.hpp"
#include "riprap/fluid/particle/sweep/cell_pairs.hpp"
#include "riprap/fluid/particle/sweep/sweep.hpp"

namespace riprap::fluid {

/// Room for the fields of one candidate, in steps of the four floats that a device reads at once.
template <int Fields>
inline constexpr int packed_fields = (Fields + 3) / 4 * 4;

/// Writes the fields of candidates as floats in the order of their cells.
template <int Fields>
struct PackFields {
    std::array<FieldView, static_cast<std::size_t>(Fields)> fields;
    const std::uint32_t* order;  ///< particles, cell by cell
    float* packed;               ///< [place in the order][packed_fields]

    RIPRAP_HD void operator()(std::int64_t place) const {
        const auto j = static_cast<std::int64_t>(order[place]);
        for (std::size_t k = 0; k < fields.size(); ++k) {
            packed[packed_fields<Fields> * place + static_cast<std::int64_t>(k)] = static_cast<float>(fields[k][j]);
        }
    }
};

/// The sums of one target in float, as a functor for a device or the host: one thread per target, candidates in the
/// order of their cells. Threads that follow each other have targets of the same cell, which meet the same candidates.
/// Places are those of FixedPoint, so differences are as exact as in the host's lanes.
template <int Dim, PairPhysics Pair>
struct CellSweep {
    Pair pair;
    std::array<FieldView, static_cast<std::size_t>(Pair::target_fields)> target_fields;
    std::array<FieldSink, static_cast<std::size_t>(Pair::sums)> sums;
    const std::uint32_t* target_order;   ///< targets, cell by cell
    const Vec3* target_position;         ///< of every target [m]
    const PackedPlace* target_place;     ///< [place in target_order]
    CellGridView grid;                   ///< of the candidates
    const PackedPlace* candidate_place;  ///< [place in the grid's order]
    const float* candidate_fields;       ///< [place in the grid's order][packed_fields]
    float quantum[3];                    ///< length of a place's unit [m]
    float reach_squared;                 ///< [m^2]

    RIPRAP_HD void operator()(std::int64_t thread) const {
        const auto i = static_cast<std::int64_t>(target_order[thread]);
        const PackedPlace here = target_place[thread];
        float target[Pair::target_fields + 1], sum[Pair::sums] = {};
        for (std::size_t k = 0; k < target_fields.size(); ++k) {
            target[k] = static_cast<float>(target_fields[k][i]);
        }
        grid.for_each_run_near(target_position[i], [&](std::int32_t begin, std::int32_t end) {
            for (std::int32_t first = begin; first < end; first += at_once) {
                meet(target, here, first, end - first < at_once ? end - first : at_once, sum);
            }
        });
        for (std::size_t k = 0; k < Pair::sums; ++k) {
            const auto found = static_cast<double>(sum[k]);
            sums[k].set(i, sums[k].is_fresh ? found : sums[k].get(i) + found);
        }
    }

 private:
    /// Candidates that are looked at before any is met. Of those near a target about a quarter is in reach, and threads
    /// that go side by side wait for each other: they meet the first in reach of each at once, then the second, and so
    /// on, in the order that each target would have had alone.
    static constexpr std::int32_t at_once = 32;

    /// Fills in x_i - x_j [m]. @returns its square
    RIPRAP_HD float difference(const PackedPlace& here, std::int32_t candidate, float* d) const {
        const PackedPlace there = candidate_place[candidate];
        float r2 = 0;
        for (int axis = 0; axis < Dim; ++axis) {
            const auto whole = static_cast<std::int32_t>(static_cast<std::uint32_t>(here.along[axis]) -
                                                         static_cast<std::uint32_t>(there.along[axis]));
            d[axis] = static_cast<float>(whole) * quantum[axis];  // modulo 2^32: the nearest image
            r2 += d[axis] * d[axis];
        }
        return r2;
    }
    RIPRAP_HD void meet(const float* target, const PackedPlace& here, std::int32_t first, std::int32_t count,
                        float* sum) const {
        constexpr int stride = packed_fields<Pair::candidate_fields>;
        float d[3] = {};
        std::uint32_t in_reach = 0;
        for (std::int32_t k = 0; k < count; ++k) {
            in_reach |= static_cast<std::uint32_t>(difference(here, first + k, d) < reach_squared) << k;
        }
        for (; in_reach != 0; in_reach &= in_reach - 1) {
            const std::int32_t candidate = first + lowest_bit(in_reach);
            const float r2 = difference(here, candidate, d);
            act_one_way<Dim, Pair, float>(pair, target, candidate_fields + std::int64_t{stride} * candidate, d, r2,
                                          distance(r2), sum);
        }
    }
};

/// Computes the sums of sweep() by CellSweep. Views and sinks are in memory of `Where`, and CellLists::place has been
/// told where the particles are.
template <class Where, PairPhysics Pair>
void cell_sweep(const Pair& pair, const SweepReach& reach, const SweepSide<Pair::target_fields>& targets,
                const SweepSide<Pair::candidate_fields>& candidates,
                const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>& sums, CellPairs<Where>& pairs) {
    constexpr int fields = Pair::candidate_fields;
    const auto target_count = static_cast<std::int64_t>(targets.position.size());
    const auto candidate_count = static_cast<std::int64_t>(candidates.position.size());
    pairs.packed->resize(static_cast<std::size_t>(packed_fields<fields>) * candidates.position.size());
    Where::for_each(candidate_count,
                    PackFields<fields>{candidates.fields, pairs.candidates->order(), pairs.packed->data()});
    const auto sweep_in = [&]<int Dim>() {
        CellSweep<Dim, Pair> sweep{pair,
                                   targets.fields,
                                   sums,
                                   pairs.targets->order(),
                                   targets.position.data(),
                                   pairs.targets->places(),
                                   pairs.candidates->view(),
                                   pairs.candidates->places(),
                                   pairs.packed->data(),
                                   {},
                                   static_cast<float>(reach.support_radius * reach.support_radius)};
        for (int axis = 0; axis < 3; ++axis) {
            sweep.quantum[axis] = static_cast<float>(pairs.candidates->fixed().quantum()[axis]);
        }
        Where::for_each_uneven(target_count, sweep);
    };
    if (reach.domain.dimension == 2) {
        sweep_in.template operator()<2>();
    } else {
        sweep_in.template operator()<3>();
    }
}

}  // namespace riprap::fluid
