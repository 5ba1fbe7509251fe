// SPDX-License-Identifier: Apache-2.0
#include "riprap/body/body_kinematics.hpp"

#include "riprap/core/parallel.hpp"

namespace riprap::body {

namespace {

/// R diag(1/I) R^T of a free body; its angular velocity is this times L.
Sym3 inverse_inertia_of(const BodySet& bodies, const BodyState& state, std::size_t i) {
    const Vec3& moments = bodies.principal_moments[i];
    if (moments.x <= 0) {
        return {};
    }
    const double a = 1 / moments.x, b = 1 / moments.y, c = 1 / moments.z;
    if (bodies.is_planar) {
        return {0, 0, c, 0, 0, 0};
    }
    if (a == b && b == c) {
        return {a, a, a, 0, 0, 0};
    }
    const Mat3 r = to_matrix(state.orientation[i] * bodies.principal_axes[i]);
    const auto entry = [&](int row, int column) {
        return a * r(row, 0) * r(column, 0) + b * r(row, 1) * r(column, 1) + c * r(row, 2) * r(column, 2);
    };
    return {entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(0, 2), entry(1, 2)};
}

}  // namespace

void update_kinematics_of(const BodySet& bodies, const BodyState& state, std::int64_t index, double time,
                          BodyKinematics& kinematics) {
    const auto i = static_cast<std::size_t>(index);
    if (is_free(bodies, BodyId{static_cast<std::int32_t>(index)}, time)) {
        kinematics.inverse_inertia[i] = inverse_inertia_of(bodies, state, i);
        kinematics.inverse_mass[i] = 1 / bodies.mass[i];
        kinematics.angular_velocity[i] = kinematics.inverse_inertia[i] * state.angular_momentum[i];
        return;
    }
    kinematics.inverse_inertia[i] = {};
    kinematics.inverse_mass[i] = 0;
    kinematics.angular_velocity[i] =
        bodies.drive[i] == Drive::driven
            ? driven_state(bodies, BodyId{static_cast<std::int32_t>(i)}, time).angular_velocity
            : Vec3{};
}

void update_kinematics(const BodySet& bodies, const BodyState& state, double time, BodyKinematics& kinematics) {
    const auto count = static_cast<std::size_t>(bodies.size());
    kinematics.angular_velocity.resize(count);
    kinematics.inverse_inertia.resize(count);
    kinematics.inverse_mass.resize(count);
    parallel::for_each(bodies.size(),
                       [&](std::int64_t index) { update_kinematics_of(bodies, state, index, time, kinematics); });
}

}  // namespace riprap::body
