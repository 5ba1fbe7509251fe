// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/sharp_push.hpp"

#include <algorithm>
#include <cmath>

namespace riprap::contact {

namespace {

/// Half of the thickness of a planar prism [m].
constexpr double half_thickness = 0.5;

/// cos of the least angle between the normals of two faces of a part whose edges are sharp: 29 degrees, between the 30
/// of regular prisms of twelve sides, which have corners, and the 27.7 of those of thirteen, so that no last digit
/// decides.
constexpr double bluntest = 0.8746197071393957;

/// (E_1/E_0)^(1-p): roughly the depth over l from which on a corner pushes as a punch [-].
constexpr double shallow = 0.005;
/// m [-].
constexpr double onset = 3;

bool is_end(const geometry::ConvexView& shape, int face, double side) {
    return shape.is_internal[face] != 0 && shape.normal_z[face] == side && shape.offset[face] == half_thickness;
}

}  // namespace

bool is_planar(const geometry::ConvexView& shape) {
    bool has_top = false, has_bottom = false;
    for (int f = 0; f < shape.face_count; ++f) {
        has_top = has_top || is_end(shape, f, 1);
        has_bottom = has_bottom || is_end(shape, f, -1);
    }
    return has_top && has_bottom;
}

bool is_sharp(const geometry::ConvexView& shape) {
    const bool is_prism = is_planar(shape);
    for (int f = 0; f < shape.face_count; ++f) {
        if (shape.is_internal[f] != 0) {
            if (!(is_prism && std::abs(shape.normal_z[f]) == 1)) {
                return false;
            }
            continue;
        }
        for (int g = 0; g < f; ++g) {
            if (shape.is_internal[g] == 0 && dot(shape.normal(f), shape.normal(g)) > bluntest) {
                return false;
            }
        }
    }
    return true;
}

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
