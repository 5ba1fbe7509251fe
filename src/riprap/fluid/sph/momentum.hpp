// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/particle/math.hpp"
#include "riprap/fluid/sph/symmetric.hpp"
#include "riprap/fluid/sph/wall_averages.hpp"

namespace riprap::fluid {

/// Forces of neighbours in the fluid on particle i per V_i, and where the surface is, in one sweep:
///
///     sums[0..2] = sum V_j (-(p_i B_i + p_j B_j) F d + viscous force)     [N/m^3]
///     sums[3]    = -sum V_j (viscous force . v)                   twice the heat made at i [W/m^3]
///     sums[4..6] = sum V_j F d b_j                                towards particles of the surface, b_j = 1 [1/m]
///
/// The pressure force is conjugate to Continuity: what it does to the motion is exactly what compression stores, for
/// one and the same kernel and the same corrections B (docs/theory/sph.md, 5 and 6).
template <class Kernel, class Viscosity>
struct Momentum {
    static constexpr int target_fields = 6 + symmetric_numbers;  ///< v, V, mu, b, p B
    static constexpr int candidate_fields = target_fields;       ///< the same
    // Places of the sums.
    static constexpr int at_force = 0, at_heat = 3, at_surface = 4;
    static constexpr int sums = 7, back_sums = 7;
    Kernel kernel;
    Viscosity viscosity;

    template <int Dim, class Real>
    RIPRAP_HD void exchange(const Real* a, const Real* b, const Real* d, Real r2, Real r, Real* sum, Real* back) const {
        const Real slope = kernel.slope_over_r(r);
        Real v[3], viscous[3], stress[symmetric_numbers], push[3], heat(0);
        for (int k = 0; k < symmetric_used<Dim>; ++k) {
            stress[k] = a[6 + k] + b[6 + k];
        }
        symmetric_apply<Dim>(stress, d, push);
        for (int axis = 0; axis < Dim; ++axis) {
            v[axis] = a[axis] - b[axis];
        }
        viscosity.template add<Dim>(v, d, r2, r, slope, Real(1), a[4] + b[4], viscous);
        const Real bare_a = a[3] * slope * a[5], bare_b = b[3] * slope * b[5];
        for (int axis = 0; axis < Dim; ++axis) {
            const Real force = viscous[axis] - slope * push[axis];
            heat = heat + viscous[axis] * v[axis];
            sum[at_force + axis] = sum[at_force + axis] + b[3] * force;
            back[at_force + axis] = back[at_force + axis] - a[3] * force;
            sum[at_surface + axis] = sum[at_surface + axis] + bare_b * d[axis];
            back[at_surface + axis] = back[at_surface + axis] - bare_a * d[axis];
        }
        sum[at_heat] = sum[at_heat] - b[3] * heat;
        back[at_heat] = back[at_heat] - a[3] * heat;
    }
    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real* target, const Real* candidate, const Real* d, Real r2, Real r,
                              Real* sum) const {
        Real back[back_sums];
        for (Real& number : back) {
            number = Real(0);
        }
        exchange<Dim>(target, candidate, d, r2, r, sum, back);
    }
};

/// The same from walls, whose viscous pull is that of a velocity mirrored in the wall, u_w, and whose motion is v_w:
///
///     sums[0..2] as Momentum with p_w, V_w, u_w and, for want of its own, the particle's B
///     sums[3]    = -sum V_w (viscous force . (v_i - v_w))    heat made at the wall [W/m^3]
///     sums[4..6] = sum V_w p_w F B_i d                       for the wall exchange, which is
///     sums[7]    = sum V_w p_w F B_i d.v_w                   sums[4..6].v_i - sums[7] (docs/theory/sph.md, 6)
template <class Kernel, class Viscosity>
struct MomentumFromWalls {
    static constexpr int target_fields = 5 + symmetric_numbers;  ///< v, p, mu, B
    static constexpr int candidate_fields = 9;  ///< u_w, p_w, V_w, grip (0 on slippery walls, else 1), v_w
    // Places of the sums.
    static constexpr int at_force = 0, at_heat = 3, at_hold = 4, at_hold_power = 7;
    static constexpr int sums = 8;
    Kernel kernel;
    Viscosity viscosity;

    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real* target, const Real* candidate, const Real* d, Real r2, Real r,
                              Real* sum) const {
        const Real unit_slope = kernel.slope_over_r(r), slope = candidate[4] * unit_slope;
        Real v[3], viscous[3];
        for (int axis = 0; axis < Dim; ++axis) {
            v[axis] = target[axis] - candidate[axis];
        }
        viscosity.template add<Dim>(v, d, r2, r, unit_slope, candidate[4] * candidate[5], target[4] + target[4],
                                    viscous);
        Real straight[3];
        symmetric_apply<Dim>(target + 5, d, straight);
        const Real push = (target[3] + candidate[3]) * slope;
        for (int axis = 0; axis < Dim; ++axis) {
            const Real hold = candidate[3] * slope * straight[axis];
            sum[at_force + axis] = sum[at_force + axis] + (viscous[axis] - push * straight[axis]);
            sum[at_heat] = sum[at_heat] - viscous[axis] * (target[axis] - candidate[6 + axis]);
            sum[at_hold + axis] = sum[at_hold + axis] + hold;
            sum[at_hold_power] = sum[at_hold_power] + hold * candidate[6 + axis];
        }
    }
};

/// The same pressures seen from the wall, in two parts that do not depend on how the wall moves: the force on wall
/// particle w per V_w is -(p_w sums[0..2] + sums[3..5]),
///
///     sums[0..2] = sum V_j F B_j d,   sums[3..5] = sum V_j p_j F B_j d,   d = x_w - x_j.
template <class Kernel>
struct PressureOnWalls {
    static constexpr int target_fields = 0;
    static constexpr int candidate_fields = 2 + symmetric_numbers;  ///< p, V, B
    // Places of the sums.
    static constexpr int at_slope = 0, at_push = 3;
    static constexpr int sums = 6;
    Kernel kernel;

    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real*, const Real* candidate, const Real* d, Real, Real r, Real* sum) const {
        Real straight[3];
        symmetric_apply<Dim>(candidate + 2, d, straight);
        const Real slope = candidate[1] * kernel.slope_over_r(r), push = candidate[0] * slope;
        for (int axis = 0; axis < Dim; ++axis) {
            sum[at_slope + axis] = sum[at_slope + axis] + slope * straight[axis];
            sum[at_push + axis] = sum[at_push + axis] + push * straight[axis];
        }
    }
};

/// WallAverages and PressureOnWalls in one, which meet the same pairs.
template <class Kernel>
struct WaterOnWalls {
    static constexpr int target_fields = 0;
    static constexpr int candidate_fields = 6 + symmetric_numbers;  ///< v, p, rho, V, B
    static constexpr int sums = WallAverages::sums + PressureOnWalls<Kernel>::sums;
    WallAverages averages;
    PressureOnWalls<Kernel> pressure;

    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real* target, const Real* candidate, const Real* d, Real r2, Real r,
                              Real* sum) const {
        averages.template operator()<Dim>(target, candidate, d, r2, r, sum);
        Real pressed[PressureOnWalls<Kernel>::candidate_fields];
        pressed[0] = candidate[3];
        for (int k = 0; k < 1 + symmetric_numbers; ++k) {
            pressed[1 + k] = candidate[5 + k];
        }
        pressure.template operator()<Dim>(target, pressed, d, r2, r, sum + WallAverages::sums);
    }
};

/// And the viscous forces: that on wall particle w per V_w is sums[0..2] = sum V_j viscous force, d = x_w - x_j.
template <class Kernel, class Viscosity>
struct ViscosityOnWalls {
    static constexpr int target_fields = 4;     ///< u_w, grip
    static constexpr int candidate_fields = 5;  ///< v, V, mu
    static constexpr int sums = 3;
    Kernel kernel;
    Viscosity viscosity;

    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real* target, const Real* candidate, const Real* d, Real r2, Real r,
                              Real* sum) const {
        Real v[3], viscous[3];
        for (int axis = 0; axis < Dim; ++axis) {
            v[axis] = target[axis] - candidate[axis];
        }
        viscosity.template add<Dim>(v, d, r2, r, kernel.slope_over_r(r), candidate[3] * target[3],
                                    candidate[4] + candidate[4], viscous);
        for (int axis = 0; axis < Dim; ++axis) {
            sum[axis] = sum[axis] + viscous[axis];
        }
    }
};

}  // namespace riprap::fluid
