// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/driven_travel.hpp"

#include <algorithm>
#include <cmath>

#include "riprap/solid/travel_bound.hpp"

namespace riprap::solid {

namespace {

/// Angle between two orientations [rad].
double turn_between(const Quat& p, const Quat& q) {
    const Quat turn = conjugate(p) * q;
    return 2 * std::atan2(norm(Vec3{turn.x, turn.y, turn.z}), std::abs(turn.w));
}

double travel_of(const body::BodySet& bodies, BodyId body, double reach, double from, double to) {
    constexpr int pieces = 4;
    double travel = 0;
    Pose before = driven_state(bodies, body, from).pose;
    for (int k = 1; k <= pieces; ++k) {
        const Pose now = driven_state(bodies, body, k < pieces ? from + k * (to - from) / pieces : to).pose;
        travel += norm(now.position - before.position) + reach * turn_between(before.orientation, now.orientation);
        before = now;
    }
    return travel;
}

}  // namespace

double driven_travel(const body::BodySet& bodies, const geometry::ShapeSet& shapes, double from, double to) {
    double most = 0;
    for (std::int32_t b = 0; b < bodies.size() && !bodies.driven_bodies.empty(); ++b) {
        if (bodies.drive[static_cast<std::size_t>(b)] == body::Drive::driven && !is_free(bodies, BodyId{b}, from)) {
            most = std::max(most, travel_of(bodies, BodyId{b}, reach_of(bodies, shapes, b), from, to));
        }
    }
    return most;
}

}  // namespace riprap::solid
