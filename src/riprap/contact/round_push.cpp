// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/round_push.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "riprap/contact/narrowphase/sphere_convex.hpp"

namespace riprap::contact {

RoundPush::RoundPush(const PlacedShape& a, double stiffness_a, const PlacedShape& b, double stiffness_b)
    : a_(a),
      b_(b),
      modulus_(stiffness_a + stiffness_b),
      radius_a_(a.shape.round_radius),
      radius_b_(b.shape.round_radius),
      is_round_((radius_a_ > 0 || radius_b_ > 0) && !a.shape.has_cut && !b.shape.has_cut) {}

bool RoundPush::overlaps(NormalContact& contact, Vec3& normal) const {
    const Vec3 &at_a = a_.frame.origin, &at_b = b_.frame.origin;
    if (radius_a_ > 0 && radius_b_ > 0) {
        const double distance = norm(at_b - at_a);
        contact.depth = radius_a_ + radius_b_ - distance;
        normal = distance > 0 ? (at_b - at_a) / distance : a_.frame.axes * Vec3{1, 0, 0};
        contact.point = at_a + (radius_a_ - 0.5 * contact.depth) * normal;
        return contact.depth > 0;
    }
    const bool is_a = radius_a_ > 0;
    const PlacedShape& other = is_a ? b_ : a_;
    const SphereTouch touch = touch_convex(other.shape, other.frame, is_a ? at_a : at_b, is_a ? radius_a_ : radius_b_);
    contact.depth = touch.overlap;
    normal = is_a ? touch.normal : -touch.normal;
    contact.point = touch.point + 0.5 * touch.overlap * touch.normal;
    return touch.overlap > 0;
}

bool RoundPush::push(NormalContact& contact, Vec3& normal) const {
    if (!overlaps(contact, normal)) {
        return false;
    }
    const double d = contact.depth, k = modulus_;
    const double least =
        radius_a_ > 0 && radius_b_ > 0 ? std::min(radius_a_, radius_b_) : std::max(radius_a_, radius_b_);
    const double r = radius_a_ > 0 && radius_b_ > 0 ? radius_a_ * radius_b_ / (radius_a_ + radius_b_) : least;
    const double half_width = std::sqrt(r * d);
    const geometry::ConvexView& shape = radius_a_ > 0 ? a_.shape : b_.shape;
    double force = 0;
    if (shape.is_planar) {
        const double thickness = 2 * std::abs(shape.vertex_z[0]);
        contact.stiffness = 0.25 * std::numbers::pi * k * thickness;
        force = contact.stiffness * d;
        contact.energy = 0.5 * force * d;
        contact.area = 2 * half_width * thickness;
        contact.spin_moment = 0;
    } else {
        contact.stiffness = 2 * k * half_width;
        force = contact.stiffness * d * 2 / 3;
        contact.energy = 0.4 * force * d;
        contact.area = std::numbers::pi * half_width * half_width;
        contact.spin_moment = 3 * std::numbers::pi / 16 * force * half_width;  // of the pressure of Hertz
    }
    contact.force = -force * normal;
    contact.moment = {};
    contact.potential = d / std::min({least, a_.shape.inscribed_radius, b_.shape.inscribed_radius});
    return true;
}

}  // namespace riprap::contact
