// SPDX-License-Identifier: Apache-2.0
#include "riprap/body/locks.hpp"

#include <algorithm>

#include "riprap/body/free_rotation.hpp"
#include "riprap/core/error.hpp"

namespace riprap::body {

void guide(BodySet& bodies, BodyState& state, BodyId body, const Locks& locks) {
    const auto b = static_cast<std::size_t>(body.value);
    RIPRAP_ASSERT(bodies.driven[b] == -1, "a body is held by one motion or one set of guides");
    if (locks.any() || !bodies.locks.empty()) {
        bodies.locks.resize(bodies.mass.size(), 0);
        bodies.locks[b] = locks.bits;
    }
    state.velocity[b] = locks.free_translation(state.velocity[b]);
    state.angular_momentum[b] = locks.free_rotation(state.angular_momentum[b]);
}

bool are_free(const BodySet& bodies, std::int64_t first, std::int64_t count) {
    const auto drive = bodies.drive.begin() + first;
    const auto is_locked = [](std::uint8_t bits) { return bits != 0; };
    return std::all_of(drive, drive + count, [](Drive one) { return one == Drive::free; }) &&
           (bodies.locks.empty() ||
            std::none_of(bodies.locks.begin() + first, bodies.locks.begin() + first + count, is_locked));
}

Sym3 lock(const Locks& locks, const Sym3& inverse_inertia) {
    Sym3 w = inverse_inertia;
    for (int k = 0; k < Locks::axes; ++k) {
        if (!locks.rotation(k)) {
            continue;
        }
        Vec3 axis{};
        axis[k] = 1;
        const Vec3 column = w * axis;
        if (column[k] > 0) {
            w += (-1 / column[k]) * symmetric_product(column, column);
        }
        // Clear what rounding leaves of the row and the column.
        const bool x = k == 0, y = k == 1, z = k == 2;
        w = {x ? 0 : w.xx, y ? 0 : w.yy, z ? 0 : w.zz, x || y ? 0 : w.xy, x || z ? 0 : w.xz, y || z ? 0 : w.yz};
    }
    return w;
}

Sym3 inverse_inertia_of(const BodySet& bodies, std::size_t body, const Quat& orientation) {
    const Vec3& moments = bodies.principal_moments[body];
    if (moments.x <= 0) {
        return {};
    }
    const double a = 1 / moments.x, b = 1 / moments.y, c = 1 / moments.z;
    Sym3 inverse{a, a, a, 0, 0, 0};
    if (bodies.is_planar) {
        inverse = {0, 0, c, 0, 0, 0};
    } else if (!(a == b && b == c)) {
        const Mat3 r = to_matrix(orientation * bodies.principal_axes[body]);
        const auto entry = [&](int row, int column) {
            return a * r(row, 0) * r(column, 0) + b * r(row, 1) * r(column, 1) + c * r(row, 2) * r(column, 2);
        };
        inverse = {entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(0, 2), entry(1, 2)};
    }
    const Locks locks = locks_of(bodies, body);
    return locks.any_rotation() ? lock(locks, inverse) : inverse;
}

Quat turn_body(const BodySet& bodies, std::size_t body, const Quat& orientation, const Vec3& angular_momentum,
               double dt) {
    if (!locks_of(bodies, body).any_rotation()) {
        return rotate_free(orientation, angular_momentum, bodies.principal_moments[body], bodies.principal_axes[body],
                           dt);
    }
    const auto turned = [&](double time, const Quat& where) {
        const Vec3 spin = inverse_inertia_of(bodies, body, where) * angular_momentum;
        return normalized(from_rotation_vector(time * spin) * orientation);
    };
    constexpr int passes = 4;  // what they leave is of order (omega dt)^5
    Quat middle = orientation;
    for (int pass = 0; pass < passes; ++pass) {
        middle = turned(0.5 * dt, middle);
    }
    return turned(dt, middle);
}

}  // namespace riprap::body
