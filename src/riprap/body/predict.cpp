// SPDX-License-Identifier: Apache-2.0
#include "riprap/body/predict.hpp"

#include "riprap/body/locks.hpp"
#include "riprap/core/index.hpp"

namespace riprap::body {

namespace {

/// Returns the acceleration of a driven body over the step: where its velocity jumps, the jump is spread over the step.
Acceleration driven_acceleration(const BodySet& bodies, std::size_t b, double time, double dt) {
    const BodyId body{static_cast<std::int32_t>(b)};
    const double moment = 0.5 * dt;
    const DrivenState before = driven_state(bodies, body, time - moment);
    const DrivenState after = driven_state(bodies, body, time + moment);
    return {(after.velocity - before.velocity) / (2 * moment),
            (after.angular_velocity - before.angular_velocity) / (2 * moment)};
}

}  // namespace

void fill_motion(const BodySet& bodies, const BodyState& state, const BodyKinematics& kinematics,
                 std::span<const Acceleration> acceleration, std::span<const Vec3> correction, double time,
                 double ahead, double dt, Motion& motion) {
    const auto count = at(bodies.size());
    motion.pose.resize(count);
    motion.velocity.resize(count);
    motion.angular_velocity.resize(count);
    motion.acceleration.resize(count);
    motion.angular_acceleration.resize(count);
    motion.stretch = state.stretch;
    motion.stretch_rate = state.stretch_rate;
    for (std::size_t b = 0; b < count; ++b) {
        Acceleration a;
        const bool is_free = kinematics.inverse_mass[b] > 0;
        if (is_free) {
            const Locks locks = locks_of(bodies, b);
            a = {locks.free_translation(acceleration[b].linear), locks.free_rotation(acceleration[b].angular)};
        } else if (bodies.drive[b] == Drive::driven) {
            a = driven_acceleration(bodies, b, time, dt);
            a.linear += correction.empty() ? Vec3{} : correction[b];
        }
        const double later = is_free ? ahead : 0;
        motion.pose[b] = {state.position[b], state.orientation[b]};
        motion.velocity[b] = state.velocity[b] + later * a.linear;
        motion.angular_velocity[b] = kinematics.angular_velocity[b] + later * a.angular;
        motion.acceleration[b] = a.linear;
        motion.angular_acceleration[b] = a.angular;
    }
}

}  // namespace riprap::body
