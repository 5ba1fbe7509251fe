// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/core/parallel.hpp"
#include "riprap/fluid/particle/sweep/cell_grid.hpp"
#include "riprap/fluid/particle/sweep/sweep.hpp"

namespace riprap::fluid {

/// Computes the sums of sweep(), one pair at a time in double: the oracle that fast sweeps are tested against.
template <int Dim, PairPhysics Pair>
void sweep_plain_in(const Pair& pair, const SweepReach& reach, const SweepSide<Pair::target_fields>& targets,
                    const SweepSide<Pair::candidate_fields>& candidates,
                    const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>& sums) {
    CellGrid grid;
    grid.build(candidates.position, reach.domain, reach.support_radius);
    const NearestImage nearest(reach.domain);
    const double reach_squared = reach.support_radius * reach.support_radius;
    const auto add_one = [&](std::int64_t i) {
        std::array<double, Pair::target_fields + 1> target{};  // never of size 0
        std::array<double, Pair::candidate_fields + 1> candidate{};
        std::array<double, Pair::sums> sum{};
        for (std::size_t k = 0; k < targets.fields.size(); ++k) {
            target[k] = targets.fields[k][i];
        }
        const Vec3 place = targets.position[static_cast<std::size_t>(i)];
        grid.for_each_near(place, [&](std::int64_t j) {
            const Vec3 difference = nearest(place - candidates.position[static_cast<std::size_t>(j)]);
            const std::array<double, 3> d{difference.x, difference.y, difference.z};
            double r2 = 0;
            for (std::size_t axis = 0; axis < Dim; ++axis) {
                r2 += d[axis] * d[axis];
            }
            if (r2 < reach_squared) {
                for (std::size_t k = 0; k < candidates.fields.size(); ++k) {
                    candidate[k] = candidates.fields[k][j];
                }
                act_one_way<Dim>(pair, target.data(), candidate.data(), d.data(), r2, distance(r2), sum.data());
            }
        });
        for (std::size_t k = 0; k < sums.size(); ++k) {
            sums[k].set(i, sums[k].is_fresh ? sum[k] : sums[k].get(i) + sum[k]);
        }
    };
    parallel::for_each_uneven(static_cast<std::int64_t>(targets.position.size()), 256, add_one);
}

template <PairPhysics Pair>
void sweep_plain(const Pair& pair, const SweepReach& reach, const SweepSide<Pair::target_fields>& targets,
                 const SweepSide<Pair::candidate_fields>& candidates,
                 const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>& sums) {
    if (reach.domain.dimension == 2) {
        sweep_plain_in<2>(pair, reach, targets, candidates, sums);
    } else {
        sweep_plain_in<3>(pair, reach, targets, candidates, sums);
    }
}

}  // namespace riprap::fluid
