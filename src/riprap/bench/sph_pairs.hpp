// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/core/vec3.hpp"
#include "riprap/fluid/particle/kernel.hpp"

namespace riprap::bench {

/// Constants that the two pairs below share.
struct SphConstants {
    fluid::WendlandC2 kernel;
    double smoothing_length;   ///< h [m]
    double sound_speed;        ///< c_0 [m/s]
    double rest_density;       ///< rho_0 [kg/m^3]
    double particle_mass;      ///< m [kg]
    double density_diffusion;  ///< delta [-]
    double viscosity;          ///< alpha of the artificial viscosity [-]
    Vec3 gravity;              ///< [m/s^2]
};

/// Rate of density of a weakly compressible fluid, with the diffusion of the part of density that is not hydrostatic
/// [Fourtakas2019]:
///
///     d rho_i/dt = sum_j V_j (rho_i v_ij . d - 2 delta h c_0 (rho_j - rho_i - rho_0/c_0^2 g . x_ji)) (dW/dr)/r
struct DensityRatePair {
    static constexpr int target_fields = 5;     // vx, vy, vz, rho - rho_0, volume
    static constexpr int candidate_fields = 5;  // the same
    static constexpr int sums = 1;
    static constexpr int back_sums = 1;
    SphConstants c;

    template <int Dim, class Real>
    RIPRAP_HD void exchange(const Real* a, const Real* b, const Real* d, Real, Real r, Real* sum, Real* back) const {
        using namespace fluid;
        const Real slope = c.kernel.slope_over_r(r);
        Real divergence(0), hydrostatic(0);
        for (int axis = 0; axis < Dim; ++axis) {
            divergence += (a[axis] - b[axis]) * d[axis];
            hydrostatic += Real(c.gravity[axis] * c.rest_density / (c.sound_speed * c.sound_speed)) * d[axis];
        }
        const Real excess = b[3] - a[3] + hydrostatic;
        const Real diffusion = Real(2 * c.density_diffusion * c.smoothing_length * c.sound_speed) * excess;
        sum[0] += b[4] * slope * ((a[3] + Real(c.rest_density)) * divergence - diffusion);
        back[0] += a[4] * slope * ((b[3] + Real(c.rest_density)) * divergence + diffusion);
    }
};

/// Acceleration by pressure and artificial viscosity [Monaghan1992]:
///
///     a_i = -m sum_j (p_i/rho_i^2 + p_j/rho_j^2 + Pi_ij) d (dW/dr)/r,
///     Pi_ij = -2 alpha c_0 h min(v_ij . d, 0) / ((r^2 + 0.01 h^2) (rho_i + rho_j))
struct AccelerationPair {
    static constexpr int target_fields = 5;     // vx, vy, vz, p/rho^2, rho
    static constexpr int candidate_fields = 5;  // the same
    static constexpr int sums = 3;
    static constexpr int back_sums = 3;
    SphConstants c;

    template <int Dim, class Real>
    RIPRAP_HD void exchange(const Real* target, const Real* candidate, const Real* d, Real r2, Real r, Real* sum,
                            Real* back) const {
        using namespace fluid;
        const Real slope = c.kernel.slope_over_r(r);
        Real approach(0);
        for (int axis = 0; axis < Dim; ++axis) {
            approach += (target[axis] - candidate[axis]) * d[axis];
        }
        const auto softening = Real(0.01 * c.smoothing_length * c.smoothing_length);
        const Real viscous = Real(-2 * c.viscosity * c.sound_speed * c.smoothing_length) * min(approach, Real(0)) *
                             reciprocal((r2 + softening) * (target[4] + candidate[4]));
        const Real push = Real(-c.particle_mass) * slope * (target[3] + candidate[3] + viscous);
        for (int axis = 0; axis < Dim; ++axis) {
            sum[axis] += push * d[axis];
            back[axis] -= push * d[axis];
        }
    }
};

/// Counts who acts on a target.
struct CountPair {
    static constexpr int target_fields = 0;
    static constexpr int candidate_fields = 0;
    static constexpr int sums = 1;
    SphConstants c;

    template <int Dim, class Real>
    RIPRAP_HD void operator()(const Real*, const Real*, const Real*, Real, Real r, Real* sum) const {
        using namespace fluid;
        sum[0] += select(c.kernel.value(r) > Real(0), Real(1), Real(0));
    }
};

}  // namespace riprap::bench
