// SPDX-License-Identifier: Apache-2.0
#pragma once

// Pair physics of semi-implicit MPS besides that which it shares with weakly compressible MPS; d = x_i - x_j,
// v = v_i - v_j, W the weight.

#include "riprap/fluid/mps_operators/mps_weight.hpp"

namespace riprap::fluid::mps {

/// Viscous forces [Amaro2021, eq. 7]: sums[0..2] = -k sum v W.
struct Viscosity {
    enum Field : int { velocity, field_count = velocity + 3 };
    static constexpr int target_fields = field_count, candidate_fields = field_count;
    static constexpr int sums = 3, back_sums = sums;
    MpsWeight weight;
    double viscosity;  ///< k

    template <int Dim, class Real>
    RIPRAP_HD void exchange(const Real* a, const Real* b, const Real*, Real r2, Real, Real* sum, Real* back) const {
        const Real drag = Real(viscosity) * weight.value(r2);
        for (int axis = 0; axis < Dim; ++axis) {
            const Real force = drag * (a[velocity + axis] - b[velocity + axis]);
            sum[axis] = sum[axis] - force;
            back[axis] = back[axis] + force;
        }
    }
};

/// Viscosity from walls: sums[0..2] = k sum b (u_w - v_i) W.
struct ViscosityFromWalls {
    struct Water {
        enum : int { velocity, count = velocity + 3 };
    };
    struct Wall {
        enum : int {
            mirrored_velocity,
            grip_share = mirrored_velocity + 3,  ///< b, 0 on slippery walls
            count,
        };
    };
    static constexpr int target_fields = Water::count, candidate_fields = Wall::count;
    static constexpr int sums = 3;
    MpsWeight weight;
    double viscosity;  ///< k

    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real* water, const Real* wall, const Real*, Real r2, Real, Real* sum) const {
        const Real drag = Real(viscosity) * wall[Wall::grip_share] * weight.value(r2);
        for (int axis = 0; axis < Dim; ++axis) {
            sum[axis] = sum[axis] + drag * (wall[Wall::mirrored_velocity + axis] - water[Water::velocity + axis]);
        }
    }
};

/// Slope of the water about walls, sums[0..2] = sum d W/r^2.
struct SlopeAtWalls {
    static constexpr int target_fields = 0, candidate_fields = 0;
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
    struct Water {
        enum : int { pressure, count };
    };
    static constexpr int target_fields = 0, candidate_fields = Water::count;
    // Places of the sums.
    static constexpr int at_weight = 0, at_pressure = 1, at_moment = 2, at_slope = 5, at_push = 8;
    static constexpr int sums = 11;
    MpsWeight weight;

    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real*, const Real* water, const Real* d, Real r2, Real, Real* sum) const {
        const Real w = weight.value(r2), over_square = weight.over_square(r2, w);
        sum[at_weight] = sum[at_weight] + w;
        sum[at_pressure] = sum[at_pressure] + water[Water::pressure] * w;
        for (int axis = 0; axis < Dim; ++axis) {
            const Real slope = over_square * d[axis];
            sum[at_moment + axis] = sum[at_moment + axis] + w * d[axis];
            sum[at_slope + axis] = sum[at_slope + axis] + slope;
            sum[at_push + axis] = sum[at_push + axis] + water[Water::pressure] * slope;
        }
    }
};

/// sums[0] = number of particles nearer than the collision distance that approach.
struct Approach {
    enum Field : int { velocity, field_count = velocity + 3 };
    static constexpr int target_fields = field_count, candidate_fields = field_count;
    static constexpr int sums = 1, back_sums = 1;
    double contact;  ///< square of the collision distance [m^2]

    template <int Dim, class Real>
    RIPRAP_HD void exchange(const Real* a, const Real* b, const Real* d, Real r2, Real, Real* sum, Real* back) const {
        Real opening(0);
        for (int axis = 0; axis < Dim; ++axis) {
            opening = opening + (a[velocity + axis] - b[velocity + axis]) * d[axis];
        }
        const Real one = select(r2 < Real(contact), select(opening < Real(0), Real(1), Real(0)), Real(0));
        sum[0] = sum[0] + one;
        back[0] = back[0] + one;
    }
};

/// Collisions of fluid with walls, one way for either side: sums[0..2] = -s sum (v.d) d/r^2 over pairs nearer than the
/// collision distance that approach, s that of the fluid particle and 1 for walls, so that the product is the same.
struct CollisionWithWalls {
    enum Field : int { velocity, share = velocity + 3, field_count };
    static constexpr int target_fields = field_count, candidate_fields = field_count;
    static constexpr int sums = 3;
    double contact;  ///< square of the collision distance [m^2]
    double tiny;     ///< small against it [m^2]

    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real* target, const Real* candidate, const Real* d, Real r2, Real,
                              Real* sum) const {
        Real opening(0);
        for (int axis = 0; axis < Dim; ++axis) {
            opening = opening + (target[velocity + axis] - candidate[velocity + axis]) * d[axis];
        }
        const Real closing = select(r2 < Real(contact), min(opening, Real(0)), Real(0));
        const Real size = target[share] * candidate[share] * closing * reciprocal(r2 + Real(tiny));
        for (int axis = 0; axis < Dim; ++axis) {
            sum[axis] = sum[axis] - size * d[axis];
        }
    }
};

}  // namespace riprap::fluid::mps
