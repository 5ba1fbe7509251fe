// SPDX-License-Identifier: Apache-2.0
#pragma once

// Pair physics of the forces of weakly compressible MPS, with d = x_i - x_j, v = v_i - v_j, W the weight, x = n/n_0,
// q = p/x, C the concentration sum W/n_0, and b = V/l_0^D of wall particles; x = C = 1 in walls.

#include "riprap/fluid/mps_operators/mps_weight.hpp"

namespace riprap::fluid::wcmps {

/// 1 where a neighbour lies in the region in front of a particle that is empty before a free surface
/// [Mellado2021, eq. 5.34]: with the outward normal n of i and s = x_i + l_0 n,
///
///     |x_j - s| < l_0 beyond sqrt(2) l_0 from i,    |n.(x_j - s)| + |t.(x_j - s)| < l_0 nearer to it,
///
/// t the direction across n. The source prints t for two dimensions only.
template <int Dim, class Real>
RIPRAP_HD Real is_in_front(double spacing, const Real* normal, const Real* d, Real r2) {
    const Real l(spacing), square(spacing * spacing), zero(0);
    Real along(0);
    for (int axis = 0; axis < Dim; ++axis) {
        along = along + normal[axis] * d[axis];
    }
    const Real gap = along + l, margin = max(l - max(gap, zero - gap), zero);
    const Real across2 = max(r2 - along * along, zero);
    const Real near = select(across2 < margin * margin, Real(1), zero);
    const Real far = select(r2 + Real(2) * l * along < zero, Real(1), zero);
    return select(r2 < Real(2) * square, near, far);
}

/// Forces, the gradient of concentration and the scan for a surface:
///
///     sums[0..2] = sum (x_i q_j + x_j q_i) d W/r^2 - k v W        [Pa/m], [Mellado2021, eqs. 5.14, 5.15]
///     sums[3]    = k sum v^2 W                                    twice the heat
///     sums[4..6] = -sum (C_i + C_j) d W/r^2                       grad C n_0/D [Mellado2021, eq. 5.33]
///     sums[7]    = neighbours in front
struct MpsMomentum {
    enum Field : int {
        velocity,
        concentration = velocity + 3,
        pressure_over_concentration,
        crowding,  ///< C
        normal,
        field_count = normal + 3,
    };
    static constexpr int target_fields = field_count, candidate_fields = field_count;
    // Places of the sums.
    static constexpr int at_force = 0, at_heat = 3, at_crowd = 4, at_front = 7;
    static constexpr int sums = 8, back_sums = sums;
    MpsWeight weight;
    double viscosity;  ///< k = 2 rho_0 nu/lambda, so that both parts take the factor D/n_0 [Pa s/m^2]
    double spacing;    ///< l_0 [m]

    template <int Dim, class Real>
    RIPRAP_HD void exchange(const Real* a, const Real* b, const Real* d, Real r2, Real, Real* sum, Real* back) const {
        const Real w = weight.value(r2), over_square = weight.over_square(r2, w);
        const Real push =
            (a[concentration] * b[pressure_over_concentration] + b[concentration] * a[pressure_over_concentration]) *
            over_square;
        const Real crowd = (a[crowding] + b[crowding]) * over_square;
        const Real drag = Real(viscosity) * w;
        Real squares(0), turned[3];
        for (int axis = 0; axis < Dim; ++axis) {
            const Real v = a[velocity + axis] - b[velocity + axis], force = push * d[axis] - drag * v,
                       slope = crowd * d[axis];
            squares = squares + v * v;
            sum[at_force + axis] = sum[at_force + axis] + force;
            back[at_force + axis] = back[at_force + axis] - force;
            sum[at_crowd + axis] = sum[at_crowd + axis] - slope;
            back[at_crowd + axis] = back[at_crowd + axis] + slope;
            turned[axis] = Real(0) - d[axis];
        }
        sum[at_heat] = sum[at_heat] + drag * squares;
        back[at_heat] = back[at_heat] + drag * squares;
        const Real reached = select(Real(0) < w, Real(1), Real(0));
        sum[at_front] = sum[at_front] + reached * is_in_front<Dim>(spacing, a + normal, d, r2);
        back[at_front] = back[at_front] + reached * is_in_front<Dim>(spacing, b + normal, turned, r2);
    }
};

/// The same from walls of velocity v_w and, mirrored in them, u_w (docs/theory/wcmps.md, 5). Their pressure is A + H: A
/// the mean of the water about them, H what carries it on to the wall as in still water, or a given one. Or it is that
/// of the particle, m = 1 and A = H = 0, carried on by h = rho_0 (g - a_w). With F = x_i H - h.d,
///
///     sums[0..2] = sum b (x_i A + F + (1 + m) q_i) d W/r^2 + viscous force
///     sums[3]    = -sum (viscous force).(v_i - v_w)                  heat, which counts once
///     sums[4..7] as above
///     sums[8..10] = -sum b F d W/r^2,   sums[11] = the same . v_w    for the wall exchange
struct MpsMomentumFromWalls {
    using Water = MpsMomentum;
    struct Wall {
        enum : int {
            mirrored_velocity,
            velocity = mirrored_velocity + 3,
            share = velocity + 3,  ///< b
            grip,                  ///< 0 on slippery walls, else 1
            mirrors,               ///< m
            held,                  ///< H
            averaged,              ///< A
            head,                  ///< h
            count = head + 3,
        };
    };
    static constexpr int target_fields = Water::field_count, candidate_fields = Wall::count;
    // Places of the sums.
    static constexpr int at_force = 0, at_heat = 3, at_crowd = 4, at_front = 7, at_hold = 8, at_hold_power = 11;
    static constexpr int sums = 12;
    MpsWeight weight;
    double viscosity;  ///< as above
    double spacing;

    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real* water, const Real* wall, const Real* d, Real r2, Real, Real* sum) const {
        const Real w = weight.value(r2), over_square = wall[Wall::share] * weight.over_square(r2, w);
        const Real x = water[Water::concentration];
        Real given = wall[Wall::held] * x;
        for (int axis = 0; axis < Dim; ++axis) {
            given = given - wall[Wall::head + axis] * d[axis];
        }
        const Real own =
            wall[Wall::averaged] * x + (Real(1) + wall[Wall::mirrors]) * water[Water::pressure_over_concentration];
        const Real held = given * over_square, push = held + own * over_square;
        const Real crowd = (water[Water::crowding] + Real(1)) * over_square;
        const Real drag = Real(viscosity) * wall[Wall::grip] * wall[Wall::share] * w;
        for (int axis = 0; axis < Dim; ++axis) {
            const Real v = water[Water::velocity + axis], v_w = wall[Wall::velocity + axis];
            const Real pull = drag * (wall[Wall::mirrored_velocity + axis] - v);
            sum[at_force + axis] = sum[at_force + axis] + push * d[axis] + pull;
            sum[at_heat] = sum[at_heat] - pull * (v - v_w);
            sum[at_crowd + axis] = sum[at_crowd + axis] - crowd * d[axis];
            sum[at_hold + axis] = sum[at_hold + axis] - held * d[axis];
            sum[at_hold_power] = sum[at_hold_power] - held * d[axis] * v_w;
        }
        const Real reached = select(Real(0) < w, Real(1), Real(0));
        sum[at_front] = sum[at_front] + reached * is_in_front<Dim>(spacing, water + Water::normal, d, r2);
    }
};

}  // namespace riprap::fluid::wcmps
