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
#include "riprap/fluid/mps_operators/mps_weight.hpp"
#include "riprap/fluid/particle/boundary_particles.hpp"
#include "riprap/fluid/particle/sweep/sweep.hpp"

namespace riprap::fluid {

/// Of |n|^2: above that of faces, 1, and below that in vertices, 4.
constexpr double longest_of_faces = 1.5;

/// The water about a wall particle, with d = x_w - x_j, the matrix N = n n^T of its normal, which is 1 where normals
/// are not known and where |n| is length_in_vertex, and T = 1 - N:
///
///     sums[0] = sum x_j (v_w.N d - v_j.d) W/r^2,    sums[1] = sum W,
///     sums[2..4] = sum v_j W,    sums[5..7] = sum x_j T d W/r^2
struct MpsWallOpening {
    struct Wall {
        enum : int { velocity, normal = velocity + 3, count = normal + 3 };
    };
    struct Water {
        enum : int { velocity, concentration = velocity + 3, count };
    };
    static constexpr int target_fields = Wall::count, candidate_fields = Water::count;
    // Places of the sums.
    static constexpr int at_opening = 0, at_weight = 1, at_velocity = 2, at_along = 5;
    static constexpr int sums = 8;
    MpsWeight weight;
    bool knows_normals;

    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real* wall, const Real* water, const Real* d, Real r2, Real, Real* sum) const {
        const Real w = weight.value(r2), over_square = water[Water::concentration] * weight.over_square(r2, w);
        Real across(0), opening(0), square(0);
        for (int axis = 0; axis < Dim; ++axis) {
            const Real n = wall[Wall::normal + axis];
            across = across + n * d[axis];
            square = square + n * n;
        }
        for (int axis = 0; axis < Dim; ++axis) {
            const Real of_face = across * wall[Wall::normal + axis];
            const Real led = knows_normals ? select(square > Real(longest_of_faces), d[axis], of_face) : d[axis];
            opening = opening + wall[Wall::velocity + axis] * led - water[Water::velocity + axis] * d[axis];
            sum[at_velocity + axis] = sum[at_velocity + axis] + water[Water::velocity + axis] * w;
            sum[at_along + axis] = sum[at_along + axis] + (d[axis] - led) * over_square;
        }
        sum[at_opening] = sum[at_opening] + opening * over_square;
        sum[at_weight] = sum[at_weight] + w;
    }
};

/// The walls about it, s = |n|^2, and none in vertices:
///
///     sums[0] = -sum b v.(s - N) d W/r^2,    sums[1..3] = sum b (s - N) d W/r^2
struct MpsWallsAlong {
    struct Own {
        enum : int { normal, count = normal + 3 };
    };
    struct Other {
        enum : int { velocity, share = velocity + 3, count };
    };
    static constexpr int target_fields = Own::count, candidate_fields = Other::count;
    // Places of the sums.
    static constexpr int at_opening = 0, at_along = 1;
    static constexpr int sums = 4;
    MpsWeight weight;

    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real* own, const Real* other, const Real* d, Real r2, Real, Real* sum) const {
        const Real over_square = other[Other::share] * weight.over_square(r2, weight.value(r2));
        Real across(0), square(0);
        for (int axis = 0; axis < Dim; ++axis) {
            const Real n = own[Own::normal + axis];
            across = across + n * d[axis];
            square = square + n * n;
        }
        for (int axis = 0; axis < Dim; ++axis) {
            const Real of_faces = (square * d[axis] - across * own[Own::normal + axis]) * over_square;
            const Real along = select(square > Real(longest_of_faces), Real(0), of_faces);
            sum[at_opening] = sum[at_opening] - other[Other::velocity + axis] * along;
            sum[at_along + axis] = sum[at_along + axis] + along;
        }
    }
};

/// Openings of the water about walls: Scratch, made anew in every step.
struct MpsWallOpenings {
    std::vector<double> share;   ///< g of NumberContinuityAtWalls: the opening over sum W [1/s]
    std::vector<double> around;  ///< sum W [-]
    std::vector<double> slip;    ///< g': by how much g is more than that of the forces' conjugate, sum x_j (v_w -
                                 ///< v_j).d W/r^2 over sum W [1/s]
    std::vector<Vec3> mean;      ///< sum v_j W
    std::vector<Vec3> along;     ///< of the water and of the walls

    std::size_t bytes() const { return bytes_of(share, around, slip, mean, along); }
};

/// Sets of particles of find_wall_openings, as they move.
struct MpsOpeningSides {
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
/// two bodies share, the share 1 - |n|^2, both faces let it slide, and only u - v_j counts. Where solids meet whose
/// faces have no way along all of them, as in the vertices of a tank, T = 0: along one of these faces water comes up
/// against the others, and of the one or two particles that are about a vertex u is all but v_j.
///
/// @param has_mean  of a wall particle by its number: has the mean pressure of the water about it, else g = 0
/// @param sum       add_pair_sums of the scheme, between walls and water, and among walls where its last argument says
/// so
template <class HasMean, class Sum>
void find_wall_openings(const MpsWeight& weight, const MpsOpeningSides& sides, const HasMean& has_mean, const Sum& sum,
                        MpsWallOpenings& found) {
    const std::size_t count = sides.walls.size();
    const bool knows_normals = sides.normal.size() == count;
    for (std::vector<double>* values : {&found.share, &found.around, &found.slip}) {
        values->assign(count, 0);
    }
    found.mean.assign(count, {});
    found.along.assign(count, {});
    const std::span<const Vec3> normals = knows_normals ? sides.normal : sides.wall_velocity;
    sum(MpsWallOpening{weight, knows_normals}, side(sides.walls, sides.wall_velocity, normals),
        side(sides.water, sides.velocity, sides.concentration),
        sinks(found.share, found.around, found.mean, found.along), false);
    const auto each = [&](const auto& work) {
        parallel::for_each(static_cast<std::int64_t>(count),
                           [&](std::int64_t w) { work(static_cast<std::size_t>(w)); });
    };
    if (knows_normals) {
        each([&](std::size_t w) { found.slip[w] = -found.share[w] - dot(sides.wall_velocity[w], found.along[w]); });
        sum(MpsWallsAlong{weight}, side(sides.walls, normals), side(sides.walls, sides.wall_velocity, sides.wall_share),
            sinks(found.share, found.along), true);
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

}  // namespace riprap::fluid
