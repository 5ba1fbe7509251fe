// SPDX-License-Identifier: Apache-2.0
#include "riprap/body/prescribed_motion.hpp"

#include <algorithm>
#include <numbers>

namespace riprap::body {

namespace {

struct Offset {
    Vec3 displacement;
    Vec3 velocity;
};

Offset offset_at(const LinearMotion& law, double t) { return {t * law.velocity, law.velocity}; }

Offset offset_at(const SinusoidalMotion& law, double t) {
    const double omega = 2 * std::numbers::pi / law.period;
    const double phase = omega * t + law.phase;
    return {(std::sin(phase) - std::sin(law.phase)) * law.amplitude, (omega * std::cos(phase)) * law.amplitude};
}

Offset offset_at(const TableMotion& law, double t) {
    if (law.time.empty()) {
        return {};
    }
    const auto next = std::upper_bound(law.time.begin(), law.time.end(), t);
    if (next == law.time.begin()) {
        return {law.displacement.front(), {}};
    }
    if (next == law.time.end()) {
        return {law.displacement.back(), {}};
    }
    const auto i = static_cast<std::size_t>(next - law.time.begin());
    const Vec3 velocity = (law.displacement[i] - law.displacement[i - 1]) / (law.time[i] - law.time[i - 1]);
    return {law.displacement[i - 1] + (t - law.time[i - 1]) * velocity, velocity};
}

DrivenState apply(const RotatingMotion& law, const Pose& initial, double t) {
    const double omega = 2 * std::numbers::pi / law.period;
    const double angle = law.rate * t + law.amplitude * (std::sin(omega * t + law.phase) - std::sin(law.phase));
    const double rate = law.rate + law.amplitude * omega * std::cos(omega * t + law.phase);
    const Quat turn = from_rotation_vector(angle * law.axis);
    const Vec3 arm = rotate(turn, initial.position - law.center);
    const Vec3 angular_velocity = rate * law.axis;
    return {{law.center + arm, normalized(turn * initial.orientation)}, cross(angular_velocity, arm), angular_velocity};
}

template <class Law>
DrivenState apply(const Law& law, const Pose& initial, double t) {
    const Offset offset = offset_at(law, t);
    return {{initial.position + offset.displacement, initial.orientation}, offset.velocity, {}};
}

}  // namespace

DrivenState evaluate(const PrescribedMotion& motion, const Pose& initial, double time) {
    const double t = std::clamp(time, motion.start, motion.stop) - motion.start;
    DrivenState state = std::visit([&](const auto& law) { return apply(law, initial, t); }, motion.law);
    if (time < motion.start || time >= motion.stop) {
        state.velocity = {};
        state.angular_velocity = {};
    }
    return state;
}

}  // namespace riprap::body
