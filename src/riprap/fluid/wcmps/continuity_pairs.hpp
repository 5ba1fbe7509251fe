// SPDX-License-Identifier: Apache-2.0
#pragma once

// Pair physics of the density of weakly compressible MPS, with d = x_i - x_j, v = v_i - v_j, W the weight, x = n/n_0,
// and b = V/l_0^D of wall particles.

#include "riprap/fluid/mps_operators/even_count.hpp"
#include "riprap/fluid/mps_operators/mps_weight.hpp"

namespace riprap::fluid::wcmps {

/// Rates of the number density and how neighbours stand about a particle:
///
///     sums[0]    = sum x_j v.d W/r^2                    times -D/n_0: dx/dt [Mellado2021, eq. 5.16]
///     sums[1]    = sum (p_j - p_i + rho_0 g.d) W        diffusion
///     sums[2]    = sum W,   sums[3] = sum 1             concentration, number of neighbours
///     sums[4..6] = sum W d/r                            outward where one side is empty [Mellado2021, eq. 5.35]
///     sums[7]    = sum v^2 W                            n_0 u^2: how fast neighbours pass each other
///     sums[8]    = sum w                                of EvenCount
struct NumberContinuity {
    enum Field : int { velocity, pressure = velocity + 3, concentration, field_count };
    static constexpr int target_fields = field_count, candidate_fields = field_count;
    // Places of the sums.
    static constexpr int at_rate = 0, at_diffusion = 1, at_weight = 2, at_count = 3, at_outward = 4, at_stir = 7,
                         at_even = 8;
    static constexpr int sums = 9, back_sums = sums;
    MpsWeight weight;
    EvenCount even;
    double head[3];  ///< rho_0 g [N/m^3]; zero where all of n diffuses

    template <int Dim, class Real>
    RIPRAP_HD void exchange(const Real* a, const Real* b, const Real* d, Real r2, Real r, Real* sum, Real* back) const {
        const Real w = weight.value(r2), over_square = weight.over_square(r2, w);
        Real opening(0), uneven = b[pressure] - a[pressure], squares(0);
        for (int axis = 0; axis < Dim; ++axis) {
            const Real v = a[velocity + axis] - b[velocity + axis];
            opening = opening + v * d[axis];
            squares = squares + v * v;
            uneven = uneven + Real(head[axis]) * d[axis];
        }
        const Real rate = opening * over_square, flux = uneven * w, one = select(Real(0) < w, Real(1), Real(0));
        sum[at_rate] = sum[at_rate] + b[concentration] * rate;
        back[at_rate] = back[at_rate] + a[concentration] * rate;
        sum[at_diffusion] = sum[at_diffusion] + flux;
        back[at_diffusion] = back[at_diffusion] - flux;
        sum[at_weight] = sum[at_weight] + w;
        back[at_weight] = back[at_weight] + w;
        sum[at_count] = sum[at_count] + one;
        back[at_count] = back[at_count] + one;
        sum[at_stir] = sum[at_stir] + squares * w;
        back[at_stir] = back[at_stir] + squares * w;
        const Real counted = even.of_pair(r, w);
        sum[at_even] = sum[at_even] + counted;
        back[at_even] = back[at_even] + counted;
        const Real over_r = over_square * r;
        for (int axis = 0; axis < Dim; ++axis) {
            const Real away = over_r * d[axis];
            sum[at_outward + axis] = sum[at_outward + axis] + away;
            back[at_outward + axis] = back[at_outward + axis] - away;
        }
    }
};

/// The same of walls; no diffusion into them: sums[1..5] are sums 2, 3 and 4 to 6 above, times b, and
///
///     sums[0] = sum b ((1 + m) v.d W/r^2 + x_i g W),    sums[6] = sum b W over walls that stand still,
///     sums[7] = sum b x_i g' W,    g' the part of g that the forces have no conjugate of,    sums[8] = sum b w
///
/// Where m = 1, a wall particle moves as the mirror image of the neighbouring fluid particle. Where it has the mean
/// pressure of the water about it, m = 0, and g is the opening of that water over its sum of W: its particles share
/// that as they share in the mean.
struct NumberContinuityAtWalls {
    struct Water {
        enum : int { velocity, concentration = velocity + 3, count };
    };
    struct Wall {
        enum : int {
            velocity,
            share = velocity + 3,  ///< b
            mirrors,               ///< m
            opening,               ///< g
            stands_still,          ///< 1 where nothing moves it, else 0
            slip,                  ///< g'
            count,
        };
    };
    static constexpr int target_fields = Water::count, candidate_fields = Wall::count;
    // Places of the sums.
    static constexpr int at_rate = 0, at_weight = 1, at_count = 2, at_outward = 3, at_still = 6, at_slip = 7,
                         at_even = 8;
    static constexpr int sums = 9;
    MpsWeight weight;
    EvenCount even;

    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real* water, const Real* wall, const Real* d, Real r2, Real r, Real* sum) const {
        const Real share = wall[Wall::share], w = weight.value(r2), over_square = share * weight.over_square(r2, w);
        Real opening(0);
        for (int axis = 0; axis < Dim; ++axis) {
            opening = opening + (water[Water::velocity + axis] - wall[Wall::velocity + axis]) * d[axis];
        }
        const Real x = water[Water::concentration];
        sum[at_rate] = sum[at_rate] + (Real(1) + wall[Wall::mirrors]) * opening * over_square +
                       share * wall[Wall::opening] * x * w;
        sum[at_weight] = sum[at_weight] + share * w;
        sum[at_still] = sum[at_still] + wall[Wall::stands_still] * share * w;
        sum[at_slip] = sum[at_slip] + wall[Wall::slip] * share * x * w;
        sum[at_even] = sum[at_even] + share * even.of_pair(r, w);
        sum[at_count] = sum[at_count] + share * select(Real(0) < w, Real(1), Real(0));
        const Real over_r = over_square * r;
        for (int axis = 0; axis < Dim; ++axis) {
            sum[at_outward + axis] = sum[at_outward + axis] + over_r * d[axis];
        }
    }
};

}  // namespace riprap::fluid::wcmps
