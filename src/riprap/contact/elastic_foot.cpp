// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/elastic_foot.hpp"

#include <algorithm>
#include <cmath>

namespace riprap::contact {

namespace {

/// x of the strip at the limit [m]
/// @param load  N [N]
/// @param lean  tan(slope) or acceleration over gravity [-]
double strip(const ElasticFoot& foot, double load, double lean) {
    return std::cbrt(4 * foot.centre_height * (1 + lean * lean) * load / (9 * foot.stiffness * foot.length));
}

/// Solves b/2 - c lean = 1.5 x(lean). The strip hardly depends on the lean: each turn gains two digits or more.
template <class Load>
double tipping_lean(const ElasticFoot& foot, Load load) {
    double lean = 0.5 * foot.width / foot.centre_height;
    for (int i = 0; i < 50; ++i) {
        lean = std::max(0.0, (0.5 * foot.width - 1.5 * strip(foot, load(lean), lean)) / foot.centre_height);
    }
    return lean;
}

double load_on_slope(const ElasticFoot& foot, double lean) { return foot.weight / std::sqrt(1 + lean * lean); }

}  // namespace

double tipping_slope(const ElasticFoot& foot) {
    return std::atan(tipping_lean(foot, [&](double lean) { return load_on_slope(foot, lean); }));
}

double tipping_acceleration(const ElasticFoot& foot) {
    return tipping_lean(foot, [&](double) { return foot.weight; });
}

double tipping_tilt(const ElasticFoot& foot) {
    const double lean = std::tan(tipping_slope(foot));
    // 2 N/(9 K l x^2) = x/H
    return strip(foot, load_on_slope(foot, lean), lean) / (2 * foot.centre_height * (1 + lean * lean));
}

}  // namespace riprap::contact
