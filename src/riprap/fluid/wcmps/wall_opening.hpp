// SPDX-License-Identifier: Apache-2.0
#pragma once

// Finds how the water about walls opens, whose mean pressure they have: what its conjugate, the continuity of that
// water, shares out (docs/theory/wcmps.md, 5). For both schemes of the MPS family.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "riprap/core/bytes.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/core/vec3.hpp"
#include "riprap/fluid/particle/boundary_particles.hpp"
#include "riprap/fluid/particle/mps_weight.hpp"
#include "riprap/fluid/particle/sweep.hpp"

namespace riprap::fluid::wcmps {

/// The water about a wall particle, with d = x_w - x_j, the matrix N = n n^T of its normal, which is 1 where normals
/// are not known, and T = 1 - N:
///
///     sums[0] = sum x_j (v_w.N d - v_j.d) W/r^2,    sums[1] = sum W,
///     sums[2..4] = sum v_j W,    sums[5..7] = sum x_j T d W/r^2
struct WallOpening {
    static constexpr int target_fields = 6;     ///< v_w, n
    static constexpr int candidate_fields = 4;  ///< v, x
    // Places of the sums.
    static constexpr int at_opening = 0, at_weight = 1, at_velocity = 2, at_along = 5;
    static constexpr int sums = 8;
    MpsWeight weight;
    bool knows_normals;

    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real* target, const Real* candidate, const Real* d, Real r2, Real,
                              Real* sum) const {
        const Real w = weight.value(r2), over_square = candidate[3] * weight.over_square(r2, w);
        Real across(0), opening(0);
        for (int axis = 0; axis < Dim; ++axis) {
            across = across + target[3 + axis] * d[axis];
        }
        for (int axis = 0; axis < Dim; ++axis) {
            const Real led = knows_normals ? across * target[3 + axis] : d[axis];
            opening = opening + target[axis] * led - candidate[axis] * d[axis];
            sum[at_velocity + axis] = sum[at_velocity + axis] + candidate[axis] * w;
            sum[at_along + axis] = sum[at_along + axis] + (d[axis] - led) * over_square;
        }
        sum[at_opening] = sum[at_opening] + opening * over_square;
        sum[at_weight] = sum[at_weight] + w;
    }
};

/// The walls about it, s = |n|^2:
///
///     sums[0] = -sum b v.(s - N) d W/r^2,    sums[1..3] = sum b (s - N) d W/r^2
struct WallsAlong {
    static constexpr int target_fields = 3;     ///< n
    static constexpr int candidate_fields = 4;  ///< v, b
    // Places of the sums.
    static constexpr int at_opening = 0, at_along = 1;
    static constexpr int sums = 4;
    MpsWeight weight;

    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real* target, const Real* candidate, const Real* d, Real r2, Real,
                              Real* sum) const {
        const Real over_square = candidate[3] * weight.over_square(r2, weight.value(r2));
        Real across(0), own(0);
        for (int axis = 0; axis < Dim; ++axis) {
            across = across + target[axis] * d[axis];
            own = own + target[axis] * target[axis];
        }
        for (int axis = 0; axis < Dim; ++axis) {
            const Real along = (own * d[axis] - across * target[axis]) * over_square;
            sum[at_opening] = sum[at_opening] - candidate[axis] * along;
            sum[at_along + axis] = sum[at_along + axis] + along;
        }
    }
};

/// Openings of the water about walls: Scratch, made anew in every step.
struct WallOpenings {
    std::vector<double> share;   ///< g of NumberContinuityAtWalls: the opening over sum W [1/s]
    std::vector<double> around;  ///< sum W [-]
    std::vector<double> slip;    ///< g': by how much g is more than that of the forces' conjugate, sum x_j (v_w -
                                 ///< v_j).d W/r^2 over sum W [1/s]
    std::vector<Vec3> mean;      ///< sum v_j W
    std::vector<Vec3> along;     ///< of the water and of the walls

    std::size_t bytes() const { return bytes_of(share, around, slip, mean, along); }
};

/// Sets of particles of find_openings, as they move.
struct OpeningSides {
    std::span<const Vec3> walls, wall_velocity, normal;  ///< the last: as BoundaryParticles say
    std::span<const double> wall_share;                  ///< b
    std::span<const Vec3> water, velocity;
    std::span<const double> concentration;  ///< x
};

/// Finds the openings, with u the mean velocity of the water about a wall particle and T = 1 - n n^T,
///
///     G = sum_j x_j ((v_w - v_j).n d.n + (u - v_j).T d) W/r^2 + sum_w' b' (u - v_w').T d W/r^2.
///
/// Along its face a wall lets water slide: only what all that stands about it does there counts, walls and water, so
/// that the edge of the water at its surface, or at a floor that a wall slides through, is no opening. In solid that
/// two bodies share, the share 1 - |n|^2, both faces let it slide, and only u - v_j counts.
///
/// @param has_mean  of a wall particle by its number: has the mean pressure of the water about it, else g = 0
/// @param sum       add_pair_sums of the scheme, between walls and water, and among walls where its last argument says
/// so
template <class HasMean, class Sum>
void find_openings(const MpsWeight& weight, const OpeningSides& sides, const HasMean& has_mean, const Sum& sum,
                   WallOpenings& found) {
    const std::size_t count = sides.walls.size();
    const bool knows_normals = sides.normal.size() == count;
    for (std::vector<double>* values : {&found.share, &found.around, &found.slip}) {
        values->assign(count, 0);
    }
    found.mean.assign(count, {});
    found.along.assign(count, {});
    const auto v = [&](int axis) { return component(sides.velocity, axis); };
    const auto v_w = [&](int axis) { return component(sides.wall_velocity, axis); };
    const std::span<const Vec3> normals = knows_normals ? sides.normal : sides.wall_velocity;
    const auto n = [&](int axis) { return component(normals, axis); };
    const auto at = [](std::vector<Vec3>& sums, int axis) { return sink_component(sums, axis); };
    sum(WallOpening{weight, knows_normals}, SweepSide<6>{sides.walls, {v_w(0), v_w(1), v_w(2), n(0), n(1), n(2)}},
        SweepSide<4>{sides.water, {v(0), v(1), v(2), field(sides.concentration)}},
        std::array<FieldSink, 8>{sink(found.share), sink(found.around), at(found.mean, 0), at(found.mean, 1),
                                 at(found.mean, 2), at(found.along, 0), at(found.along, 1), at(found.along, 2)},
        false);
    const auto each = [&](const auto& work) {
        parallel::for_each(static_cast<std::int64_t>(count),
                           [&](std::int64_t w) { work(static_cast<std::size_t>(w)); });
    };
    if (knows_normals) {
        each([&](std::size_t w) { found.slip[w] = -found.share[w] - dot(sides.wall_velocity[w], found.along[w]); });
        sum(WallsAlong{weight}, SweepSide<3>{sides.walls, {n(0), n(1), n(2)}},
            SweepSide<4>{sides.walls, {v_w(0), v_w(1), v_w(2), field(sides.wall_share)}},
            std::array<FieldSink, 4>{sink(found.share), at(found.along, 0), at(found.along, 1), at(found.along, 2)},
            true);
    }
    each([&](std::size_t w) {
        if (found.around[w] <= 0 || !has_mean(w)) {
            found.share[w] = found.slip[w] = 0;
            return;
        }
        found.share[w] += dot(found.mean[w] / found.around[w], found.along[w]);
        found.slip[w] = knows_normals ? (found.slip[w] + found.share[w]) / found.around[w] : 0;
        found.share[w] /= found.around[w];
    });
}

}  // namespace riprap::fluid::wcmps
