// SPDX-License-Identifier: Apache-2.0
#pragma once

// Pair physics of semi-implicit MPS besides that which it shares with weakly compressible MPS; d = x_i - x_j,
// v = v_i - v_j, W the weight.

#include <array>

#include "riprap/fluid/mps/mps_settings.hpp"
#include "riprap/fluid/particle/mps_lattice.hpp"
#include "riprap/fluid/particle/mps_weight.hpp"
#include "riprap/fluid/particle/sweep.hpp"

namespace riprap::fluid::mps {

/// Viscous forces [Amaro2021, eq. 7]: sums[0..2] = -k sum v W.
struct Viscosity {
    static constexpr int target_fields = 3;     ///< v
    static constexpr int candidate_fields = 3;  ///< the same
    static constexpr int sums = 3, back_sums = sums;
    MpsWeight weight;
    double viscosity;  ///< k

    template <int Dim, class Real>
    RIPRAP_HD void exchange(const Real* a, const Real* b, const Real*, Real r2, Real, Real* sum, Real* back) const {
        const Real drag = Real(viscosity) * weight.value(r2);
        for (int axis = 0; axis < Dim; ++axis) {
            const Real force = drag * (a[axis] - b[axis]);
            sum[axis] = sum[axis] - force;
            back[axis] = back[axis] + force;
        }
    }
    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real* target, const Real* candidate, const Real* d, Real r2, Real r,
                              Real* sum) const {
        Real back[3] = {Real(0), Real(0), Real(0)};
        exchange<Dim>(target, candidate, d, r2, r, sum, back);
    }
};

/// Viscosity from walls: sums[0..2] = k sum b (u_w - v_i) W.
struct ViscosityFromWalls {
    static constexpr int target_fields = 3;     ///< v
    static constexpr int candidate_fields = 4;  ///< u_w, b times grip (0 on slippery walls, else 1)
    static constexpr int sums = 3;
    MpsWeight weight;
    double viscosity;  ///< k

    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real* target, const Real* candidate, const Real*, Real r2, Real, Real* sum) const {
        const Real drag = Real(viscosity) * candidate[3] * weight.value(r2);
        for (int axis = 0; axis < Dim; ++axis) {
            sum[axis] = sum[axis] + drag * (candidate[axis] - target[axis]);
        }
    }
};

/// Slope of the water about walls, sums[0..2] = sum d W/r^2.
struct SlopeAtWalls {
    static constexpr int target_fields = 0;
    static constexpr int candidate_fields = 0;
    static constexpr int sums = 3;
    MpsWeight weight;

    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real*, const Real*, const Real* d, Real r2, Real, Real* sum) const {
        const Real slope = weight.over_square(r2, weight.value(r2));
        for (int axis = 0; axis < Dim; ++axis) {
            sum[axis] = sum[axis] + slope * d[axis];
        }
    }
};

/// The water about walls and the parts of its loads on walls whose pressure is averaged, with d = x_w - x_j:
///
///     sums[0] = sum W,   sums[1] = sum p_j W,   sums[2..4] = sum d W,   sums[5..7] = sum d W/r^2,
///     sums[8..10] = sum p_j d W/r^2
struct PressureAtWalls {
    static constexpr int target_fields = 0;
    static constexpr int candidate_fields = 1;  ///< p
    // Places of the sums.
    static constexpr int at_weight = 0, at_pressure = 1, at_moment = 2, at_slope = 5, at_push = 8;
    static constexpr int sums = 11;
    MpsWeight weight;

    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real*, const Real* candidate, const Real* d, Real r2, Real, Real* sum) const {
        const Real w = weight.value(r2), over_square = weight.over_square(r2, w);
        sum[at_weight] = sum[at_weight] + w;
        sum[at_pressure] = sum[at_pressure] + candidate[0] * w;
        for (int axis = 0; axis < Dim; ++axis) {
            const Real slope = over_square * d[axis];
            sum[at_moment + axis] = sum[at_moment + axis] + w * d[axis];
            sum[at_slope + axis] = sum[at_slope + axis] + slope;
            sum[at_push + axis] = sum[at_push + axis] + candidate[0] * slope;
        }
    }
};

/// sums[0] = number of particles nearer than the collision distance that approach.
struct Approach {
    static constexpr int target_fields = 3;     ///< v
    static constexpr int candidate_fields = 3;  ///< the same
    static constexpr int sums = 1, back_sums = 1;
    double contact;  ///< square of the collision distance [m^2]

    template <int Dim, class Real>
    RIPRAP_HD void exchange(const Real* a, const Real* b, const Real* d, Real r2, Real, Real* sum, Real* back) const {
        Real opening(0);
        for (int axis = 0; axis < Dim; ++axis) {
            opening = opening + (a[axis] - b[axis]) * d[axis];
        }
        const Real one = select(r2 < Real(contact), select(opening < Real(0), Real(1), Real(0)), Real(0));
        sum[0] = sum[0] + one;
        back[0] = back[0] + one;
    }
    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real* target, const Real* candidate, const Real* d, Real r2, Real r,
                              Real* sum) const {
        Real back[1] = {Real(0)};
        exchange<Dim>(target, candidate, d, r2, r, sum, back);
    }
};

/// Collisions of fluid with walls, one way for either side: sums[0..2] = -s sum (v.d) d/r^2 over pairs nearer than the
/// collision distance that approach, s that of the fluid particle and 1 for walls, so that the product is the same.
struct CollisionWithWalls {
    static constexpr int target_fields = 4;     ///< v, s
    static constexpr int candidate_fields = 4;  ///< the same
    static constexpr int sums = 3;
    double contact;  ///< square of the collision distance [m^2]
    double tiny;     ///< small against it [m^2]

    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real* target, const Real* candidate, const Real* d, Real r2, Real,
                              Real* sum) const {
        Real opening(0);
        for (int axis = 0; axis < Dim; ++axis) {
            opening = opening + (target[axis] - candidate[axis]) * d[axis];
        }
        const Real closing = select(r2 < Real(contact), min(opening, Real(0)), Real(0));
        const Real size = target[3] * candidate[3] * closing * reciprocal(r2 + Real(tiny));
        for (int axis = 0; axis < Dim; ++axis) {
            sum[axis] = sum[axis] - size * d[axis];
        }
    }
};

/// sweep(), or the plain one where the settings ask for it. Defined in mps/kernels.cpp.
template <PairPhysics Pair>
void add_pair_sums(const MpsSettings& settings, const Pair& pair, const SweepSide<Pair::target_fields>& targets,
                   const SweepSide<Pair::candidate_fields>& candidates,
                   const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>& sums, SweepScratch& scratch);

/// exchange_within(), or the plain sweep where the settings ask for it.
template <MutualPhysics Pair>
void add_pair_sums_within(const MpsSettings& settings, const Pair& pair,
                          const SweepSide<Pair::target_fields>& particles,
                          const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>& sums,
                          SweepScratch& scratch);

}  // namespace riprap::fluid::mps
