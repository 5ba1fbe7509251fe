// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "riprap/contact/law/hertz.hpp"

namespace riprap::contact {

/// Damping ratio of a linear spring and dashpot that may pull, of restitution e [-]: xi = -ln e/sqrt(pi^2 + ln^2 e).
inline double linear_damping_ratio(double restitution) {
    const double log = std::log(restitution);
    return -log / std::sqrt(M_PI * M_PI + log * log);
}

/// Restitution of a linear spring and dashpot whose force never pulls, where the impact ends as the force falls to zero
/// [-]: with cos(psi) = xi,
///
///     x(t) ~ exp(-xi w t) sin(w_d t),   F = 0 at w_d t = 2 psi,   e = exp(-2 xi psi/sin(psi)),
///
/// and with cosh, sinh for xi > 1 [SchwagerPoeschel2007].
inline double linear_restitution_without_pull(double damping_ratio) {
    const double xi = damping_ratio, square = 1 - xi * xi;
    // psi/sin(psi) is 1 + (1 - xi)/3 next to xi = 1
    const double arc = std::abs(square) < 1e-8 ? 1 + (1 - xi) / 3
                       : square > 0            ? std::acos(xi) / std::sqrt(square)
                                               : std::acosh(xi) / std::sqrt(-square);
    return std::exp(-2 * xi * arc);
}

/// Damping ratio whose restitution that is [-].
inline double linear_damping_ratio_without_pull(double restitution) {
    double low = 0, high = 1e4;  // e = 1/(4 xi^2) of a large xi
    for (int i = 0; i < 80; ++i) {
        const double middle = 0.5 * (low + high);
        (linear_restitution_without_pull(middle) > restitution ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

/// Duration of an impact [s]: pi sqrt(m*/k)/sqrt(1 - xi^2), the same at every speed.
inline double linear_contact_time(double stiffness, double mass, double damping_ratio) {
    return M_PI * std::sqrt(mass / (stiffness * (1 - damping_ratio * damping_ratio)));
}

/// Linear spring and dashpot: F = k delta, c = 2 xi sqrt(m* k), energy k delta^2/2. Restitution and duration of an
/// impact do not depend on its speed.
/// @param stiffness  k [N/m]
/// @param ratio      xi [-]
template <class T>
inline NormalResponse<T> linear_spring(T stiffness, T mass, T ratio, T overlap) {
    using std::sqrt;
    const T elastic = stiffness * overlap;
    return {elastic, T(2.0) * ratio * sqrt(mass * stiffness), overlap, T(0.5) * elastic * overlap};
}

}  // namespace riprap::contact
