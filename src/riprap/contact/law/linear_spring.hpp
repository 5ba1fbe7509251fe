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
