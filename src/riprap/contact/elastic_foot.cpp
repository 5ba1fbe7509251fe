// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/elastic_foot.hpp"

#include <algorithm>
#include <cmath>

namespace riprap::contact {

namespace {

/// x of the strip at the limit [m]
/// @param load  N [N]
/// @param lean  tan(slope) [-]
double strip(const ElasticFoot& foot, double load, double lean) {
    return std::cbrt(4 * foot.centre_height * (1 + lean * lean) * load / (9 * foot.stiffness * foot.length));
}

}  // namespace

double tipping_slope(const ElasticFoot& foot) {
    double lean = 0.5 * foot.width / foot.centre_height;
    for (int i = 0; i < 50; ++i) {  // the strip hardly depends on the lean: each turn gains two digits or more
        const double load = foot.weight / std::sqrt(1 + lean * lean);
        lean = std::max(0.0, (0.5 * foot.width - 1.5 * strip(foot, load, lean)) / foot.centre_height);
    }
    return std::atan(lean);
}

}  // namespace riprap::contact
