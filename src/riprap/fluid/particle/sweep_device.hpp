// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "riprap/fluid/particle/cell_grid.hpp"
#include "riprap/fluid/particle/pair_physics.hpp"

namespace riprap::fluid {

/// The sums of one target in float, as a functor for parallel::for_each on a device or on the host: one thread per
/// target, candidates in the order of the cells. Places are those of FixedPoint, so differences are as exact as in the
/// host's lanes. All pointers are to memory of where it runs.
template <int Dim, PairPhysics Pair>
struct TargetSweep {
    Pair pair;
    CellGridView grid;                    ///< of the candidates
    const Vec3* target_position;          ///< [m]
    const std::int32_t* target_place;     ///< [target][3]
    const std::int32_t* candidate_place;  ///< [candidate][3]
    const float* target_fields;           ///< [target][Pair::target_fields]
    const float* candidate_fields;        ///< [candidate][Pair::candidate_fields]
    float quantum[3];                     ///< length of a place's unit [m]
    float reach_squared;                  ///< [m^2]
    float* sums;                          ///< [target][Pair::sums], overwritten

    RIPRAP_HD void operator()(std::int64_t i) const {
        const float* const target = target_fields + i * Pair::target_fields;
        float sum[Pair::sums] = {};
        grid.for_each_near(target_position[i], [&](std::int64_t j) {
            float d[3] = {};
            float r2 = 0;
            for (int axis = 0; axis < Dim; ++axis) {
                const auto whole = static_cast<std::int32_t>(static_cast<std::uint32_t>(target_place[3 * i + axis]) -
                                                             static_cast<std::uint32_t>(candidate_place[3 * j + axis]));
                d[axis] = static_cast<float>(whole) * quantum[axis];
                r2 += d[axis] * d[axis];
            }
            if (r2 < reach_squared) {
                pair.template operator()<Dim, float>(target, candidate_fields + j * Pair::candidate_fields, d, r2,
                                                     distance(r2), sum);
            }
        });
        for (int k = 0; k < Pair::sums; ++k) {
            sums[i * Pair::sums + k] = sum[k];
        }
    }
};

}  // namespace riprap::fluid
