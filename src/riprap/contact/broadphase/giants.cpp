// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/broadphase/giants.hpp"

#include <algorithm>
#include <cmath>

namespace riprap::contact {

namespace {
/// Finite giants at most; each costs one test per part and rebuild.
constexpr std::size_t giant_limit = 16;
/// R_m / R_(m+1) that sets giants apart [-]. Twice the default ratio of size classes, so that at least one class
/// between giants and the rest is empty.
constexpr double giant_gap = 4;
}  // namespace

std::vector<std::int32_t> choose_giants(std::span<const double> radius) {
    std::vector<double> finite;
    for (const double r : radius) {
        if (std::isfinite(r)) {
            finite.push_back(r);
        }
    }
    const std::size_t top = std::min(finite.size(), giant_limit + 1);
    std::partial_sort(finite.begin(), finite.begin() + static_cast<std::ptrdiff_t>(top), finite.end(),
                      std::greater<>());
    double smallest_giant = std::numeric_limits<double>::infinity();
    for (std::size_t m = 1; m < top; ++m) {
        if (finite[m - 1] > 0 && finite[m - 1] >= giant_gap * finite[m]) {
            smallest_giant = finite[m - 1];
        }
    }
    std::vector<std::int32_t> giants;
    for (std::size_t i = 0; i < radius.size(); ++i) {
        if (radius[i] >= smallest_giant) {
            giants.push_back(static_cast<std::int32_t>(i));
        }
    }
    return giants;
}

void GiantPlanes::assign(const PartBounds& bounds, std::span<const Giant> giants) {
    part_.clear();
    origin_.clear();
    radius_.clear();
    face_begin_.assign(1, 0);
    normal_.clear();
    offset_.clear();
    for (const Giant& giant : giants) {
        const auto part = static_cast<std::size_t>(giant.part);
        const bool is_finite_part = std::isfinite(bounds.radius[part]);
        const Vec3 origin = is_finite_part ? bounds.center[part] : giant.frame.origin;
        part_.push_back(giant.part);
        origin_.push_back(origin);
        radius_.push_back(bounds.radius[part]);
        for (int j = 0; j < giant.shape.face_count; ++j) {
            const Vec3 normal = giant.frame.axes * giant.shape.normal(j);
            normal_.push_back(normal);
            offset_.push_back(giant.shape.offset[j] - dot(normal, origin - giant.frame.origin));
        }
        face_begin_.push_back(normal_.size());
    }
}

double GiantPlanes::plane_change(const GiantPlanes& before, std::size_t giant, const Vec3& center,
                                 double radius) const {
    double change = 0;
    for (std::size_t f = face_begin_[giant]; f < face_begin_[giant + 1]; ++f) {
        // h'(c) - h(c), with the normals' difference taken first: no cancellation far from the origin.
        const Vec3 turn = normal_[f] - before.normal_[f];
        const Vec3 shift = origin_[giant] - before.origin_[giant];
        const double at_center =
            offset_[f] - before.offset_[f] - dot(turn, center - before.origin_[giant]) + dot(normal_[f], shift);
        change = std::max(change, std::abs(at_center) + norm(turn) * radius);
    }
    return change;
}

double GiantPlanes::displacement_since(const GiantPlanes& before, std::int32_t giant, const Vec3& center, double radius,
                                       double largest_guest) const {
    const auto g = static_cast<std::size_t>(giant);
    const double near_all = plane_change(before, g, center, radius);
    if (!std::isfinite(radius_[g])) {
        return near_all;
    }
    const double near_giant = plane_change(before, g, origin_[g], radius_[g] + largest_guest);
    return std::max(norm(origin_[g] - before.origin_[g]), std::min(near_all, near_giant));
}

bool GiantPlanes::is_at_rest(const GiantPlanes& other) const {
    return part_ == other.part_ && origin_ == other.origin_ && radius_ == other.radius_ && normal_ == other.normal_ &&
           offset_ == other.offset_;
}

}  // namespace riprap::contact
