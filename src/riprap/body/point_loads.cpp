// SPDX-License-Identifier: Apache-2.0
#include "riprap/body/point_loads.hpp"

#include <algorithm>

namespace riprap::body {

Vec3 ForceTable::at(double t) const {
    const auto next = std::upper_bound(time.begin(), time.end(), t);
    if (next == time.begin()) {
        return {};
    }
    const auto b = static_cast<std::size_t>(next - time.begin()), a = b - 1;
    if (next == time.end()) {
        return force.back();
    }
    const double share = (t - time[a]) / (time[b] - time[a]);
    return (1 - share) * force[a] + share * force[b];
}

Vec3 PointLoad::at(double time) const {
    if (time < start || time > stop) {
        return {};
    }
    const Vec3 full = table ? table->at(time - start) : force;
    return (ramp > 0 ? std::min(1.0, (time - start) / ramp) : 1.0) * full;
}

LoadView PointLoadSum::add(std::span<const PointLoad> loads, const BodyState& bodies, double time,
                           const LoadView& others) {
    if (loads.empty()) {
        return others;
    }
    const auto body_count = static_cast<std::size_t>(bodies.size());
    sum_.force.assign(others.force.begin(), others.force.end());
    sum_.torque.assign(others.torque.begin(), others.torque.end());
    sum_.pull.assign(others.pull.begin(), others.pull.end());
    sum_.force.resize(body_count);
    sum_.torque.resize(body_count);
    sum_.pull.resize(bodies.deforms() ? body_count : 0);
    for (const PointLoad& load : loads) {
        const auto i = static_cast<std::size_t>(load.body.value);
        const Vec3 force = load.at(time);
        const Vec3 arm = rotate(bodies.orientation[i], bodies.deforms() ? bodies.stretch[i] * load.point : load.point);
        sum_.force[i] += force;
        sum_.torque[i] += cross(arm, force);
        if (bodies.deforms()) {
            sum_.pull[i] += symmetric_product(force, arm);
        }
    }
    return sum_;
}

}  // namespace riprap::body
