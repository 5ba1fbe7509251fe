// SPDX-License-Identifier: Apache-2.0
#include "riprap/view/body_extremes.hpp"

namespace riprap::view {

void BodyExtremes::note(const BodyFrame& frame, const DrawnBodies& bodies) {
    const std::size_t count = bodies.shown.size();
    first_pose = first_pose.empty() ? frame.pose : first_pose;
    fields.resize(count);
    const auto length = [](const auto* v) {
        return std::hypot(static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2]));
    };
    for (std::size_t body = 0; body < bodies.body_count(); ++body) {
        const float* motion = &frame.motion[motion_values * body];
        const double* pose = &frame.pose[pose_values * body];
        const double* first = &first_pose[pose_values * body];
        const double moved[3] = {pose[0] - first[0], pose[1] - first[1], pose[2] - first[2]};
        speed = std::fmax(speed, length(motion));
        displacement = std::fmax(displacement, length(moved));
        if (!(motion[9] > 0)) {  // what a fixed body carries would drown the others
            continue;
        }
        force = std::fmax(force, length(motion + 6));
        for (std::size_t f = 0; f < count; ++f) {
            const auto value = static_cast<double>(frame.shown[count * body + f]);
            fields[f].low = std::fmin(fields[f].low, value);
            fields[f].high = std::fmax(fields[f].high, value);
        }
    }
}

}  // namespace riprap::view
