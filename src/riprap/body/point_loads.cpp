// SPDX-License-Identifier: Apache-2.0
#include "riprap/body/point_loads.hpp"

#include <algorithm>

namespace riprap::body {

Vec3 PointLoad::at(double time) const {
    if (time < start || time > stop) {
        return {};
    }
    return (ramp > 0 ? std::min(1.0, (time - start) / ramp) : 1.0) * force;
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
