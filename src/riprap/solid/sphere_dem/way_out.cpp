// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/sphere_dem/way_out.hpp"

#include <cmath>

namespace riprap::solid::sphere_dem {

namespace {

/// Depths that differ by less than this share of the inscribed radius are equal [-].
constexpr double equal_share = 1e-6;
/// Cosine of the largest angle between a face and the way out between several.
constexpr double across = 0.1;

double depth_below(const geometry::ConvexView& shape, std::int32_t face, const Vec3& local) {
    return shape.offset[face] - dot(shape.normal(face), local);
}

}  // namespace

WayOut next_way_out(const geometry::ConvexView& shape, const Vec3& local, std::int32_t but) {
    WayOut next;
    for (std::int32_t f = 0; f < shape.face_count; ++f) {
        const double depth = depth_below(shape, f, local);
        if (f != but && shape.is_internal[f] == 0 && (next.face < 0 || depth < next.depth)) {
            next = {f, depth};
        }
    }
    return next;
}

MiddleWay middle_way_out(const geometry::ConvexView& shape, const Vec3& local, std::int32_t face) {
    const double depth = depth_below(shape, face, local), tolerance = equal_share * shape.inscribed_radius;
    const auto is_equal = [&](std::int32_t f) {
        return shape.is_internal[f] == 0 && std::abs(depth_below(shape, f, local) - depth) < tolerance;
    };
    Vec3 sum{};
    int count = 0;
    for (std::int32_t f = 0; f < shape.face_count; ++f) {
        if (is_equal(f)) {
            sum += shape.normal(f);
            ++count;
        }
    }
    if (count < 2 || !(norm(sum) > across * count)) {
        return {};
    }
    MiddleWay way{normalized(sum), 0};
    for (std::int32_t f = 0; f < shape.face_count; ++f) {
        if (is_equal(f)) {
            const double cosine = dot(shape.normal(f), way.outward);
            if (cosine < across) {
                return {};
            }
            const double length = depth_below(shape, f, local) / cosine;
            way.length = way.length > 0 ? std::fmin(way.length, length) : length;
        }
    }
    return way;
}

}  // namespace riprap::solid::sphere_dem
