// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/travel_bound.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"

namespace riprap::solid {

namespace {

/// The two largest speeds of many.
struct Fastest {
    double first{0}, second{0};
};

Fastest join(const Fastest& a, const Fastest& b) {
    return {std::max(a.first, b.first), std::max(std::min(a.first, b.first), std::max(a.second, b.second))};
}

}  // namespace

double reach_of(const body::BodySet& bodies, const geometry::ShapeSet& shapes, std::int64_t body) {
    double reach = 0;
    for (std::int32_t p = bodies.part_begin[at(body)]; p < bodies.part_begin[at(body) + 1]; ++p) {
        const geometry::ConvexView shape = shapes.view(bodies.parts[at(p)].shape);
        if (!std::isfinite(shape.circumradius)) {
            continue;
        }
        const double half_length = bodies.is_planar && shape.vertex_count > 0 ? shape.vertex(0).z : 0;
        const double radius =
            std::sqrt(std::max(0.0, shape.circumradius * shape.circumradius - half_length * half_length));
        reach = std::max(reach, norm(bodies.parts[at(p)].local.position) + radius);
    }
    return reach;
}

double smallest_radius(const body::BodySet& bodies, const geometry::ShapeSet& shapes) {
    return parallel::reduce(
        bodies.part_count(), std::numeric_limits<double>::infinity(),
        [&](std::int64_t p) { return shapes.view(bodies.parts[at(p)].shape).inscribed_radius; },
        [](double a, double b) { return std::min(a, b); });
}

namespace {

/// Sum of the two largest of a speed per body [m/s].
template <class SpeedOf>
double two_largest(const body::BodySet& bodies, const SpeedOf& speed_of) {
    const Fastest fastest = parallel::reduce(
        bodies.size(), Fastest{},
        [&](std::int64_t b) {
            return Fastest{speed_of(b), 0};
        },
        join);
    return fastest.first + fastest.second;
}

}  // namespace

double fastest_approach(const body::BodySet& bodies, const geometry::ShapeSet& shapes, const body::BodyState& state) {
    return two_largest(bodies, [&](std::int64_t b) {
        const double spin = norm(angular_velocity(bodies, state, BodyId{static_cast<std::int32_t>(b)}));
        return norm(state.velocity[at(b)]) + (spin > 0 ? spin * reach_of(bodies, shapes, b) : 0);
    });
}

double approach_limit(const body::BodySet& bodies, const geometry::ShapeSet& shapes, const body::BodyState& state) {
    return two_largest(bodies, [&](std::int64_t b) {
        const Vec3& moments = bodies.principal_moments[at(b)];
        const double momentum = norm(state.angular_momentum[at(b)]);
        const double least = bodies.is_planar ? moments.z : std::min({moments.x, moments.y, moments.z});
        return norm(state.velocity[at(b)]) +
               (momentum > 0 && least > 0 ? momentum / least * reach_of(bodies, shapes, b) : 0);
    });
}

}  // namespace riprap::solid
