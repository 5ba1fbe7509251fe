// SPDX-License-Identifier: Apache-2.0
#include "riprap/body/body_kinematics.hpp"

#include "riprap/body/locks.hpp"
#include "riprap/core/parallel.hpp"

namespace riprap::body {

void update_kinematics_of(const BodySet& bodies, const BodyState& state, std::int64_t index, double time,
                          BodyKinematics& kinematics) {
    const auto i = static_cast<std::size_t>(index);
    if (is_free(bodies, BodyId{static_cast<std::int32_t>(index)}, time)) {
        kinematics.inverse_inertia[i] = inverse_inertia_of(bodies, i, state.orientation[i]);
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
