// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/particle/sweep/math.hpp"
#include "riprap/fluid/particle/sweep/symmetric.hpp"
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
    enum Field : int {
        velocity,
        volume = velocity + 3,
        dynamic_viscosity,
        bareness,
        stress,  ///< p B
        field_count = stress + symmetric_numbers,
    };
    static constexpr int target_fields = field_count, candidate_fields = field_count;
    // Places of the sums.
    static constexpr int at_force = 0, at_heat = 3, at_surface = 4;
    static constexpr int sums = 7, back_sums = 7;
    Kernel kernel;
    Viscosity viscosity;

    template <int Dim, class Real>
    RIPRAP_HD void exchange(const Real* a, const Real* b, const Real* d, Real r2, Real r, Real* sum, Real* back) const {
        const Real slope = kernel.slope_over_r(r);
        Real v[3], viscous[3], pressed[symmetric_numbers], push[3], heat(0);
        for (int k = 0; k < symmetric_used<Dim>; ++k) {
            pressed[k] = a[stress + k] + b[stress + k];
        }
        symmetric_apply<Dim>(pressed, d, push);
        for (int axis = 0; axis < Dim; ++axis) {
            v[axis] = a[velocity + axis] - b[velocity + axis];
        }
        viscosity.template add<Dim>(v, d, r2, r, slope, Real(1), a[dynamic_viscosity] + b[dynamic_viscosity], viscous);
        const Real bare_a = a[volume] * slope * a[bareness], bare_b = b[volume] * slope * b[bareness];
        for (int axis = 0; axis < Dim; ++axis) {
            const Real force = viscous[axis] - slope * push[axis];
            heat = heat + viscous[axis] * v[axis];
            sum[at_force + axis] = sum[at_force + axis] + b[volume] * force;
            back[at_force + axis] = back[at_force + axis] - a[volume] * force;
            sum[at_surface + axis] = sum[at_surface + axis] + bare_b * d[axis];
            back[at_surface + axis] = back[at_surface + axis] - bare_a * d[axis];
        }
        sum[at_heat] = sum[at_heat] - b[volume] * heat;
        back[at_heat] = back[at_heat] - a[volume] * heat;
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
    struct Water {
        enum : int {
            velocity,
            pressure = velocity + 3,
            dynamic_viscosity,
            correction,
            count = correction + symmetric_numbers,
        };
    };
    struct Wall {
        enum : int {
            mirrored_velocity,
            pressure = mirrored_velocity + 3,
            volume,
            grip,  ///< 0 on slippery walls, else 1
            velocity,
            count = velocity + 3,
        };
    };
    static constexpr int target_fields = Water::count, candidate_fields = Wall::count;
    // Places of the sums.
    static constexpr int at_force = 0, at_heat = 3, at_hold = 4, at_hold_power = 7;
    static constexpr int sums = 8;
    Kernel kernel;
    Viscosity viscosity;

    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real* water, const Real* wall, const Real* d, Real r2, Real r, Real* sum) const {
        const Real unit_slope = kernel.slope_over_r(r), slope = wall[Wall::volume] * unit_slope;
        Real v[3], viscous[3];
        for (int axis = 0; axis < Dim; ++axis) {
            v[axis] = water[Water::velocity + axis] - wall[Wall::mirrored_velocity + axis];
        }
        const Real mu = water[Water::dynamic_viscosity];
        viscosity.template add<Dim>(v, d, r2, r, unit_slope, wall[Wall::volume] * wall[Wall::grip], mu + mu, viscous);
        Real straight[3];
        symmetric_apply<Dim>(water + Water::correction, d, straight);
        const Real push = (water[Water::pressure] + wall[Wall::pressure]) * slope;
        for (int axis = 0; axis < Dim; ++axis) {
            const Real hold = wall[Wall::pressure] * slope * straight[axis], v_w = wall[Wall::velocity + axis];
            sum[at_force + axis] = sum[at_force + axis] + (viscous[axis] - push * straight[axis]);
            sum[at_heat] = sum[at_heat] - viscous[axis] * (water[Water::velocity + axis] - v_w);
            sum[at_hold + axis] = sum[at_hold + axis] + hold;
            sum[at_hold_power] = sum[at_hold_power] + hold * v_w;
        }
    }
};

/// The same pressures seen from the wall, in two parts that do not depend on how the wall moves: the force on wall
/// particle w per V_w is -(p_w sums[0..2] + sums[3..5]),
///
///     sums[0..2] = sum V_j F B_j d,   sums[3..5] = sum V_j p_j F B_j d,   d = x_w - x_j.
template <class Kernel>
struct PressureOnWalls {
    struct Water {
        enum : int { pressure, volume, correction, count = correction + symmetric_numbers };
    };
    static constexpr int target_fields = 0, candidate_fields = Water::count;
    // Places of the sums.
    static constexpr int at_slope = 0, at_push = 3;
    static constexpr int sums = 6;
    Kernel kernel;

    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real*, const Real* water, const Real* d, Real, Real r, Real* sum) const {
        Real straight[3];
        symmetric_apply<Dim>(water + Water::correction, d, straight);
        const Real slope = water[Water::volume] * kernel.slope_over_r(r), push = water[Water::pressure] * slope;
        for (int axis = 0; axis < Dim; ++axis) {
            sum[at_slope + axis] = sum[at_slope + axis] + slope * straight[axis];
            sum[at_push + axis] = sum[at_push + axis] + push * straight[axis];
        }
    }
};

/// WallAverages and PressureOnWalls in one, which meet the same pairs.
template <class Kernel>
struct WaterOnWalls {
    struct Water {
        enum : int {
            velocity = WallAverages::Water::velocity,
            pressure = WallAverages::Water::pressure,
            density = WallAverages::Water::density,
            volume,
            correction,
            count = correction + symmetric_numbers,
        };
    };
    static constexpr int target_fields = 0, candidate_fields = Water::count;
    static constexpr int sums = WallAverages::sums + PressureOnWalls<Kernel>::sums;
    WallAverages averages;
    PressureOnWalls<Kernel> pressure;

    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real* none, const Real* water, const Real* d, Real r2, Real r, Real* sum) const {
        averages.template operator()<Dim>(none, water, d, r2, r, sum);
        using Pressing = typename PressureOnWalls<Kernel>::Water;
        Real pressing[Pressing::count];
        pressing[Pressing::pressure] = water[Water::pressure];
        pressing[Pressing::volume] = water[Water::volume];
        for (int k = 0; k < symmetric_numbers; ++k) {
            pressing[Pressing::correction + k] = water[Water::correction + k];
        }
        pressure.template operator()<Dim>(none, pressing, d, r2, r, sum + WallAverages::sums);
    }
};

/// And the viscous forces: that on wall particle w per V_w is sums[0..2] = sum V_j viscous force, d = x_w - x_j.
template <class Kernel, class Viscosity>
struct ViscosityOnWalls {
    struct Wall {
        enum : int { mirrored_velocity, grip = mirrored_velocity + 3, count };
    };
    struct Water {
        enum : int { velocity, volume = velocity + 3, dynamic_viscosity, count };
    };
    static constexpr int target_fields = Wall::count, candidate_fields = Water::count;
    static constexpr int sums = 3;
    Kernel kernel;
    Viscosity viscosity;

    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real* wall, const Real* water, const Real* d, Real r2, Real r, Real* sum) const {
        Real v[3], viscous[3];
        for (int axis = 0; axis < Dim; ++axis) {
            v[axis] = wall[Wall::mirrored_velocity + axis] - water[Water::velocity + axis];
        }
        const Real mu = water[Water::dynamic_viscosity];
        viscosity.template add<Dim>(v, d, r2, r, kernel.slope_over_r(r), water[Water::volume] * wall[Wall::grip],
                                    mu + mu, viscous);
        for (int axis = 0; axis < Dim; ++axis) {
            sum[axis] = sum[axis] + viscous[axis];
        }
    }
};

}  // namespace riprap::fluid
