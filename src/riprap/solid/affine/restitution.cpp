// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/affine/restitution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace riprap::solid::affine {

double restitution_of(double damping_ratio) {
    const double z = damping_ratio;
    if (z > 1) {
        const double s = std::sqrt(z * z - 1);
        return std::exp(-z / s * std::log((z + s) / (z - s)));
    }
    if (z == 1) {
        return std::exp(-2.0);
    }
    const double s = std::sqrt(1 - z * z), angle = std::asin(std::min(1.0, 2 * z * s));
    return std::exp(-z / s * (2 * z * z <= 1 ? std::numbers::pi - angle : angle));
}

double damping_ratio_of(double restitution) {
    double low = 0, high = 1;
    while (restitution_of(high) > restitution && high < 1e6) {
        high *= 2;
    }
    for (int k = 0; k < 100; ++k) {
        const double middle = 0.5 * (low + high);
        (restitution_of(middle) > restitution ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

double damping_ratio_of(const material::MaterialSet& materials, MaterialId a, MaterialId b) {
    const material::PairProperties& pair = materials.pair(a, b);
    std::optional<double> restitution = pair.restitution;
    const auto &of_a = materials[a].restitution, &of_b = materials[b].restitution;
    if (!restitution && of_a && of_b) {
        restitution = material::mix(materials.restitution_mixing, *of_a, *of_b);
    }
    return restitution ? std::max(damping_ratio_of(*restitution), std::numeric_limits<double>::min())
                       : pair.damping_ratio;
}

}  // namespace riprap::solid::affine
