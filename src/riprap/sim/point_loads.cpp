// SPDX-License-Identifier: Apache-2.0
#include "riprap/sim/point_loads.hpp"

#include <algorithm>

namespace riprap::sim {

Vec3 PointLoad::at(double time) const {
    if (time < start || time > stop) {
        return {};
    }
    return (ramp > 0 ? std::min(1.0, (time - start) / ramp) : 1.0) * force;
}

solid::ExternalLoads PointLoadSum::add(std::span<const PointLoad> loads, const body::BodyState& bodies, double time,
                                       const solid::ExternalLoads& others) {
    if (loads.empty()) {
        return others;
    }
    const auto body_count = static_cast<std::size_t>(bodies.size());
    force_.assign(others.force.begin(), others.force.end());
    torque_.assign(others.torque.begin(), others.torque.end());
    force_.resize(body_count);
    torque_.resize(body_count);
    for (const PointLoad& load : loads) {
        const auto i = static_cast<std::size_t>(load.body.value);
        const Vec3 force = load.at(time);
        force_[i] += force;
        torque_[i] += cross(rotate(bodies.orientation[i], load.point), force);
    }
    return {force_, torque_};
}

}  // namespace riprap::sim
