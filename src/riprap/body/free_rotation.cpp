// SPDX-License-Identifier: Apache-2.0
#include "riprap/body/free_rotation.hpp"

#include <array>

namespace riprap::body {

namespace {

/// The axis pair with the closest moments is (reference, first); `second` is the odd one out.
struct AxisOrder {
    int reference, first, second;
};

AxisOrder order_axes(const Vec3& moments) {
    const double d01 = std::abs(moments.x - moments.y), d12 = std::abs(moments.y - moments.z),
                 d20 = std::abs(moments.z - moments.x);
    if (d01 <= d12 && d01 <= d20) {
        return {0, 1, 2};
    }
    return d12 <= d20 ? AxisOrder{1, 2, 0} : AxisOrder{2, 0, 1};
}

/// Turns the principal frame about its own axis k by `rate` * L_k * dt.
void turn_about(Quat& frame, const Vec3& angular_momentum, int axis, double rate, double dt) {
    if (rate == 0) {
        return;
    }
    Vec3 turn{};
    turn[axis] = rate * rotate_back(frame, angular_momentum)[axis] * dt;
    frame = frame * from_rotation_vector(turn);
}

}  // namespace

Quat rotate_free(const Quat& orientation, const Vec3& angular_momentum, const Vec3& principal_moments,
                 const Quat& principal_axes, double dt) {
    if (principal_moments.x == principal_moments.y && principal_moments.y == principal_moments.z) {
        return normalized(from_rotation_vector((1 / principal_moments.x * dt) * angular_momentum) * orientation);
    }
    const AxisOrder order = order_axes(principal_moments);
    const double reference = 1 / principal_moments[order.reference];
    const double rate_first = 1 / principal_moments[order.first] - reference;
    const double rate_second = 1 / principal_moments[order.second] - reference;

    Quat turned = orientation;
    if (rate_first != 0 || rate_second != 0) {
        Quat frame = orientation * principal_axes;
        // The part of the odd axis is the large one; a vanishing first part makes its two halves one exact turn.
        turn_about(frame, angular_momentum, order.first, rate_first, 0.5 * dt);
        turn_about(frame, angular_momentum, order.second, rate_second, dt);
        turn_about(frame, angular_momentum, order.first, rate_first, 0.5 * dt);
        turned = frame * conjugate(principal_axes);
    }
    // The spherical part commutes with the others: it turns the body about the fixed L.
    return normalized(from_rotation_vector((reference * dt) * angular_momentum) * turned);
}

}  // namespace riprap::body
