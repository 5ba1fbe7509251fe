// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/contact/law/mindlin.hpp"
#include "riprap/core/wide.hpp"

namespace riprap::contact {

/// Hyperbolic tangent of x >= 0, one value or eight. Within 1e-15 of the library's.
inline double tanh_of(double x) { return std::tanh(x); }
template <std::size_t N>
inline Wide<double, N> tanh_of(Wide<double, N> x) {
    for (std::int64_t lane = 0; lane < static_cast<std::int64_t>(N); ++lane) {
        x.set(lane, std::tanh(x[lane]));
    }
    return x;
}

/// Regularised friction without history [Mellado2021, eqs 4.15 to 4.22]: the smaller of
///
///     k_t |v| dt + c_t |v|   and   mu |F_n| tanh(|v|/v_0),
///
/// against the sliding velocity v. v_0 = 1/8 m/s in the source, which leaves the unit out. There is no friction at
/// rest: a block on a slope of angle beta creeps at v_0 atanh(tan(beta)/mu).
///
/// @param stiffness  k_t = 2/7 of 4/3 E* sqrt(R* delta) [N/m]; the source prints 8/21 E* sqrt(R*), short of a
/// length^(1/2)
/// @param damping    c_t = 2/7 of the normal dashpot [N s/m]
/// @param speed      v_0 [m/s]
template <class T>
inline TangentialResponse<T> tanh_friction(const Vec3T<T>& sliding, T stiffness, T damping, T normal_force, T friction,
                                           T speed, T dt) {
    using std::sqrt;
    const T v = sqrt(dot(sliding, sliding));
    const T spring = (stiffness * dt + damping) * v;
    const T coulomb = friction * normal_force * tanh_of(v / speed);
    const T size = smaller(spring, coulomb);
    const Vec3T<T> force = sliding * (-size / larger(v, T(1e-300)));
    return {force, size * v * dt, T(0.0), T(0.0)};
}

}  // namespace riprap::contact
