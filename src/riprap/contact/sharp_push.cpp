// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/sharp_push.hpp"

#include <algorithm>
#include <cmath>

namespace riprap::contact {

namespace {

/// (E_1/E_0)^(1-p): roughly the depth over l from which on a corner pushes as a punch [-].
constexpr double shallow = 0.005;
/// m [-].
constexpr double onset = 3;

}  // namespace

SharpPush::SharpPush(double modulus, double per_area, bool is_planar)
    : power_(is_planar ? 2.0 / 3 : 0.75),
      energy_(modulus * std::pow(modulus / per_area, is_planar ? 2 : 3)),
      least_(energy_ * std::pow(shallow, 1 / (1 - power_))) {}

void SharpPush::stiffen(NormalContact& contact) const {
    const double p = power_, m = onset, e = std::max(contact.energy, 0.0), e1 = least_, sum = e + e1;
    const double share = e / sum, scale = std::pow(energy_ / sum, 1 - p) * std::pow(share, m - 2);
    const double slope = scale * share * (p * e + m * e1) / sum;
    const double bend =
        scale * (p * (p - 1) * e * e + 2 * m * (p - 1) * e * e1 + m * (m - 1) * e1 * e1) / (sum * sum * sum);
    const double spring = contact.stiffness;
    contact.stiffness = std::max((1 + slope) * spring + bend * norm_squared(contact.force), spring);
    contact.energy = e + scale * share * share * sum;
    contact.force *= 1 + slope;
    contact.moment *= 1 + slope;
    contact.spin_moment *= 1 + slope;
}

}  // namespace riprap::contact
