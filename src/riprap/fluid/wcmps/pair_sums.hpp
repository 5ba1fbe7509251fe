// SPDX-License-Identifier: Apache-2.0
#pragma once

// Pair physics of weakly compressible MPS, with d = x_i - x_j, v = v_i - v_j, W the weight, x = n/n_0, q = p/x, C the
// concentration sum W/n_0, and b = V/l_0^D of wall particles; x = C = 1 in walls.

#include <array>

#include "riprap/fluid/particle/mps_lattice.hpp"
#include "riprap/fluid/particle/mps_weight.hpp"
#include "riprap/fluid/particle/sweep.hpp"
#include "riprap/fluid/sph/symmetric.hpp"
#include "riprap/fluid/wcmps/wall_opening.hpp"
#include "riprap/fluid/wcmps/wcmps_settings.hpp"

namespace riprap::fluid::wcmps {

/// The call operator of a mutual pair physics: one direction of its exchange.
template <class Pair, int Dim, class Real>
RIPRAP_HD void one_way(const Pair& pair, const Real* target, const Real* candidate, const Real* d, Real r2, Real r,
                       Real* sum) {
    Real back[Pair::back_sums];
    for (Real& number : back) {
        number = Real(0);
    }
    pair.template exchange<Dim>(target, candidate, d, r2, r, sum, back);
}

/// Rates of the number density and how neighbours stand about a particle:
///
///     sums[0]    = sum x_j v.d W/r^2                    times -D/n_0: dx/dt [Mellado2021, eq. 5.16]
///     sums[1]    = sum (p_j - p_i + rho_0 g.d) W        diffusion
///     sums[2]    = sum W,   sums[3] = sum 1             concentration, number of neighbours
///     sums[4..6] = sum W d/r                            outward where one side is empty [Mellado2021, eq. 5.35]
///     sums[7]    = sum v^2 W                            n_0 u^2: how fast neighbours pass each other
struct NumberContinuity {
    static constexpr int target_fields = 5;     ///< v, p, x
    static constexpr int candidate_fields = 5;  ///< the same
    // Places of the sums.
    static constexpr int at_rate = 0, at_diffusion = 1, at_weight = 2, at_count = 3, at_outward = 4, at_stir = 7;
    static constexpr int sums = 8, back_sums = sums;
    MpsWeight weight;
    double head[3];  ///< rho_0 g [N/m^3]; zero where all of n diffuses

    template <int Dim, class Real>
    RIPRAP_HD void exchange(const Real* a, const Real* b, const Real* d, Real r2, Real r, Real* sum, Real* back) const {
        const Real w = weight.value(r2), over_square = weight.over_square(r2, w);
        Real opening(0), uneven = b[3] - a[3], squares(0);
        for (int axis = 0; axis < Dim; ++axis) {
            const Real v = a[axis] - b[axis];
            opening = opening + v * d[axis];
            squares = squares + v * v;
            uneven = uneven + Real(head[axis]) * d[axis];
        }
        const Real rate = opening * over_square, flux = uneven * w, one = select(Real(0) < w, Real(1), Real(0));
        sum[at_rate] = sum[at_rate] + b[4] * rate;
        back[at_rate] = back[at_rate] + a[4] * rate;
        sum[at_diffusion] = sum[at_diffusion] + flux;
        back[at_diffusion] = back[at_diffusion] - flux;
        sum[at_weight] = sum[at_weight] + w;
        back[at_weight] = back[at_weight] + w;
        sum[at_count] = sum[at_count] + one;
        back[at_count] = back[at_count] + one;
        sum[at_stir] = sum[at_stir] + squares * w;
        back[at_stir] = back[at_stir] + squares * w;
        const Real over_r = over_square * r;
        for (int axis = 0; axis < Dim; ++axis) {
            const Real away = over_r * d[axis];
            sum[at_outward + axis] = sum[at_outward + axis] + away;
            back[at_outward + axis] = back[at_outward + axis] - away;
        }
    }
    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real* target, const Real* candidate, const Real* d, Real r2, Real r,
                              Real* sum) const {
        one_way<NumberContinuity, Dim>(*this, target, candidate, d, r2, r, sum);
    }
};

/// The same of walls; no diffusion into them: sums[1..5] are sums 2, 3 and 4 to 6 above, times b, and
///
///     sums[0] = sum b ((1 + m) v.d W/r^2 + x_i g W),    sums[6] = sum b W over walls that stand still,
///     sums[7] = sum b x_i g' W,    g' the part of g that the forces have no conjugate of
///
/// Where m = 1, a wall particle moves as the mirror image of the neighbouring fluid particle. Where it has the mean
/// pressure of the water about it, m = 0, and g is the opening of that water over its sum of W: its particles share
/// that as they share in the mean.
struct NumberContinuityAtWalls {
    static constexpr int target_fields = 4;     ///< v, x
    static constexpr int candidate_fields = 8;  ///< v, b, m, g, 1 where it stands still, g'
    // Places of the sums.
    static constexpr int at_rate = 0, at_weight = 1, at_count = 2, at_outward = 3, at_still = 6, at_slip = 7;
    static constexpr int sums = 8;
    MpsWeight weight;

    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real* target, const Real* candidate, const Real* d, Real r2, Real r,
                              Real* sum) const {
        const Real w = weight.value(r2), over_square = candidate[3] * weight.over_square(r2, w);
        Real opening(0);
        for (int axis = 0; axis < Dim; ++axis) {
            opening = opening + (target[axis] - candidate[axis]) * d[axis];
        }
        sum[at_rate] = sum[at_rate] + (Real(1) + candidate[4]) * opening * over_square +
                       candidate[3] * candidate[5] * target[3] * w;
        sum[at_weight] = sum[at_weight] + candidate[3] * w;
        sum[at_still] = sum[at_still] + candidate[6] * candidate[3] * w;
        sum[at_slip] = sum[at_slip] + candidate[7] * candidate[3] * target[3] * w;
        sum[at_count] = sum[at_count] + candidate[3] * select(Real(0) < w, Real(1), Real(0));
        const Real over_r = over_square * r;
        for (int axis = 0; axis < Dim; ++axis) {
            sum[at_outward + axis] = sum[at_outward + axis] + over_r * d[axis];
        }
    }
};

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
    static constexpr int target_fields = 9;     ///< v, x, q, C, n
    static constexpr int candidate_fields = 9;  ///< the same
    // Places of the sums.
    static constexpr int at_force = 0, at_heat = 3, at_crowd = 4, at_front = 7;
    static constexpr int sums = 8, back_sums = sums;
    MpsWeight weight;
    double viscosity;  ///< k = 2 rho_0 nu/lambda, so that both parts take the factor D/n_0 [Pa s/m^2]
    double spacing;    ///< l_0 [m]

    template <int Dim, class Real>
    RIPRAP_HD void exchange(const Real* a, const Real* b, const Real* d, Real r2, Real, Real* sum, Real* back) const {
        const Real w = weight.value(r2), over_square = weight.over_square(r2, w);
        const Real push = (a[3] * b[4] + b[3] * a[4]) * over_square, crowd = (a[5] + b[5]) * over_square;
        const Real drag = Real(viscosity) * w;
        Real squares(0), turned[3];
        for (int axis = 0; axis < Dim; ++axis) {
            const Real v = a[axis] - b[axis], force = push * d[axis] - drag * v, slope = crowd * d[axis];
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
        sum[at_front] = sum[at_front] + reached * is_in_front<Dim>(spacing, a + 6, d, r2);
        back[at_front] = back[at_front] + reached * is_in_front<Dim>(spacing, b + 6, turned, r2);
    }
    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real* target, const Real* candidate, const Real* d, Real r2, Real r,
                              Real* sum) const {
        one_way<MpsMomentum, Dim>(*this, target, candidate, d, r2, r, sum);
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
    static constexpr int target_fields = 9;      ///< v, x, q, C, n
    static constexpr int candidate_fields = 14;  ///< u_w, v_w, b, grip (0 on slippery walls, else 1), m, H, A, h
    // Places of the sums.
    static constexpr int at_force = 0, at_heat = 3, at_crowd = 4, at_front = 7, at_hold = 8, at_hold_power = 11;
    static constexpr int sums = 12;
    MpsWeight weight;
    double viscosity;  ///< as above
    double spacing;

    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real* target, const Real* candidate, const Real* d, Real r2, Real,
                              Real* sum) const {
        const Real w = weight.value(r2), over_square = candidate[6] * weight.over_square(r2, w);
        Real given = candidate[9] * target[3];
        for (int axis = 0; axis < Dim; ++axis) {
            given = given - candidate[11 + axis] * d[axis];
        }
        const Real own = candidate[10] * target[3] + (Real(1) + candidate[8]) * target[4];
        const Real held = given * over_square, push = held + own * over_square;
        const Real crowd = (target[5] + Real(1)) * over_square;
        const Real drag = Real(viscosity) * candidate[7] * candidate[6] * w;
        for (int axis = 0; axis < Dim; ++axis) {
            const Real pull = drag * (candidate[axis] - target[axis]);
            sum[at_force + axis] = sum[at_force + axis] + push * d[axis] + pull;
            sum[at_heat] = sum[at_heat] - pull * (target[axis] - candidate[3 + axis]);
            sum[at_crowd + axis] = sum[at_crowd + axis] - crowd * d[axis];
            sum[at_hold + axis] = sum[at_hold + axis] - held * d[axis];
            sum[at_hold_power] = sum[at_hold_power] - held * d[axis] * candidate[3 + axis];
        }
        const Real reached = select(Real(0) < w, Real(1), Real(0));
        sum[at_front] = sum[at_front] + reached * is_in_front<Dim>(spacing, target + 6, d, r2);
    }
};

/// Averages of the fluid at wall particles [Adami2012, eqs. 22, 23, 27]:
///
///     sums[0] = sum W,   sums[1] = sum p_j W,   sums[2..4] = rho_0 sum d W,   sums[5..7] = sum v_j W.
struct MpsWallAverages {
    static constexpr int target_fields = 0;
    static constexpr int candidate_fields = 4;  ///< v, p
    // Places of the sums.
    static constexpr int at_weight = 0, at_pressure = 1, at_moment = 2, at_velocity = 5;
    static constexpr int sums = 8;
    MpsWeight weight;
    double rest_density;

    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real*, const Real* candidate, const Real* d, Real r2, Real, Real* sum) const {
        const Real w = weight.value(r2), heavy = Real(rest_density) * w;
        sum[at_weight] = sum[at_weight] + w;
        sum[at_pressure] = sum[at_pressure] + candidate[3] * w;
        for (int axis = 0; axis < Dim; ++axis) {
            sum[at_moment + axis] = sum[at_moment + axis] + heavy * d[axis];
            sum[at_velocity + axis] = sum[at_velocity + axis] + candidate[axis] * w;
        }
    }
};

/// Pressure loads on wall particles in three parts that do not depend on how walls move, with d = x_w - x_j:
///
///     sums[0..2] = sum x_j d W/r^2,    sums[3..5] = sum q_j d W/r^2,    sums[6..11] = sum d d^T W/r^2,
///
/// b ((1 + m) sums[3..5] + (A + H) sums[0..2] + sums[6..11] h) being the reaction to MpsMomentumFromWalls.
struct MpsPressureOnWalls {
    static constexpr int target_fields = 0;
    static constexpr int candidate_fields = 2;  ///< x, q
    // Places of the sums.
    static constexpr int at_slope = 0, at_push = 3, at_moment = 6;
    static constexpr int sums = 6 + symmetric_numbers;
    MpsWeight weight;

    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real*, const Real* candidate, const Real* d, Real r2, Real, Real* sum) const {
        const Real over_square = weight.over_square(r2, weight.value(r2));
        Real moment[symmetric_numbers];
        symmetric_square<Dim>(d, moment);
        for (int axis = 0; axis < Dim; ++axis) {
            const Real slope = over_square * d[axis];
            sum[at_slope + axis] = sum[at_slope + axis] + candidate[0] * slope;
            sum[at_push + axis] = sum[at_push + axis] + candidate[1] * slope;
        }
        for (int k = 0; k < symmetric_used<Dim>; ++k) {
            sum[at_moment + k] = sum[at_moment + k] + over_square * moment[k];
        }
    }
};

/// And viscous loads: sums[0..2] = k grip sum (v_j - u_w) W.
struct MpsViscosityOnWalls {
    static constexpr int target_fields = 4;     ///< u_w, grip
    static constexpr int candidate_fields = 3;  ///< v
    static constexpr int sums = 3;
    MpsWeight weight;
    double viscosity;

    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real* target, const Real* candidate, const Real*, Real r2, Real, Real* sum) const {
        const Real drag = Real(viscosity) * target[3] * weight.value(r2);
        for (int axis = 0; axis < Dim; ++axis) {
            sum[axis] = sum[axis] + drag * (candidate[axis] - target[axis]);
        }
    }
};

/// Surface particles around, f = 1 in class F:
///
///     sums[0] = number in class F within 2.1 l_0,   sums[1..3] = sum f_j n_j W [Mellado2021, eq. 5.37]
struct MpsSurface {
    static constexpr int target_fields = 4;     ///< f, f n
    static constexpr int candidate_fields = 4;  ///< the same
    static constexpr int mark = 0;              ///< pairs without class F add nothing, see particle/patch_sweep.hpp
    static constexpr bool needs_both_marks = false;
    // Places of the sums.
    static constexpr int at_adjacent = 0, at_normal = 1;
    static constexpr int sums = 4, back_sums = sums;
    MpsWeight weight;
    double adjacent;  ///< square of 2.1 l_0 [m^2]

    template <int Dim, class Real>
    RIPRAP_HD void exchange(const Real* a, const Real* b, const Real*, Real r2, Real, Real* sum, Real* back) const {
        const Real w = weight.value(r2), reached = select(Real(0) < w, Real(1), Real(0));
        const Real is_adjacent = select(r2 < Real(adjacent), reached, Real(0));
        for (int axis = 0; axis < Dim; ++axis) {
            sum[at_normal + axis] = sum[at_normal + axis] + b[1 + axis] * w;
            back[at_normal + axis] = back[at_normal + axis] + a[1 + axis] * w;
        }
        sum[at_adjacent] = sum[at_adjacent] + b[0] * is_adjacent;
        back[at_adjacent] = back[at_adjacent] + a[0] * is_adjacent;
    }
    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real* target, const Real* candidate, const Real* d, Real r2, Real r,
                              Real* sum) const {
        one_way<MpsSurface, Dim>(*this, target, candidate, d, r2, r, sum);
    }
};

/// Pairs about to collide, of which one particle or both may, s > 0:
///
///     sums[0] = number nearer than the collision distance that approach
struct MpsApproach {
    static constexpr int target_fields = 4;     ///< v, s
    static constexpr int candidate_fields = 4;  ///< the same
    static constexpr int mark = 3;
    static constexpr bool needs_both_marks = false;
    static constexpr int sums = 1, back_sums = sums;
    double contact;  ///< square of the collision distance [m^2]

    template <int Dim, class Real>
    RIPRAP_HD void exchange(const Real* a, const Real* b, const Real* d, Real r2, Real, Real* sum, Real* back) const {
        Real opening(0);
        for (int axis = 0; axis < Dim; ++axis) {
            opening = opening + (a[axis] - b[axis]) * d[axis];
        }
        const Real may = select(Real(0) < a[3] + b[3], Real(1), Real(0));
        const Real one = select(r2 < Real(contact), select(opening < Real(0), may, Real(0)), Real(0));
        sum[0] = sum[0] + one;
        back[0] = back[0] + one;
    }
    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real* target, const Real* candidate, const Real* d, Real r2, Real r,
                              Real* sum) const {
        one_way<MpsApproach, Dim>(*this, target, candidate, d, r2, r, sum);
    }
};

/// Changes of velocity by collisions [Mellado2021, eqs. 5.38, 5.39], signs as in docs/theory/wcmps.md, 6:
///
///     sums[0..2] = -min(s_i, s_j) sum (v.d) d/r^2 over pairs nearer than the collision distance that approach,
///
/// s = (1 + e)/2 over the number of pairs that a particle is in, 0 where it does not collide.
struct MpsCollision {
    static constexpr int target_fields = 4;     ///< v, s
    static constexpr int candidate_fields = 4;  ///< the same
    static constexpr int mark = 3;
    static constexpr bool needs_both_marks = true;
    static constexpr int sums = 3, back_sums = sums;
    double contact;  ///< square of the collision distance [m^2]
    double tiny;     ///< small against it, for a particle that meets itself [m^2]

    template <int Dim, class Real>
    RIPRAP_HD void exchange(const Real* a, const Real* b, const Real* d, Real r2, Real, Real* sum, Real* back) const {
        Real opening(0);
        for (int axis = 0; axis < Dim; ++axis) {
            opening = opening + (a[axis] - b[axis]) * d[axis];
        }
        const Real closing = select(r2 < Real(contact), min(opening, Real(0)), Real(0));
        const Real size = min(a[3], b[3]) * closing * reciprocal(r2 + Real(tiny));
        for (int axis = 0; axis < Dim; ++axis) {
            sum[axis] = sum[axis] - size * d[axis];
            back[axis] = back[axis] + size * d[axis];
        }
    }
    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real* target, const Real* candidate, const Real* d, Real r2, Real r,
                              Real* sum) const {
        one_way<MpsCollision, Dim>(*this, target, candidate, d, r2, r, sum);
    }
};

/// sweep(), or the plain one where the settings ask for it. Defined for the pair physics above in kernels.cpp.
template <PairPhysics Pair>
void add_pair_sums(const WcmpsSettings& settings, const Pair& pair, const SweepSide<Pair::target_fields>& targets,
                   const SweepSide<Pair::candidate_fields>& candidates,
                   const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>& sums, SweepScratch& scratch);

/// exchange_within(), or the plain sweep where the settings ask for it.
template <MutualPhysics Pair>
void add_pair_sums_within(const WcmpsSettings& settings, const Pair& pair,
                          const SweepSide<Pair::target_fields>& particles,
                          const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>& sums,
                          SweepScratch& scratch);

}  // namespace riprap::fluid::wcmps
