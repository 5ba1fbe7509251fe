// SPDX-License-Identifier: Apache-2.0
#include "riprap/body/gravity.hpp"

#include <algorithm>
#include <cstddef>

#include "riprap/core/quat.hpp"

namespace riprap::body {

double Gravity::angle(double time) const {
    if (times.empty()) {
        return rate * (std::clamp(time, start, stop) - start);
    }
    const auto next = std::upper_bound(times.begin(), times.end(), time);
    if (next == times.begin() || next == times.end()) {
        return next == times.begin() ? angles.front() : angles.back();
    }
    const auto i = static_cast<std::size_t>(next - times.begin());
    return angles[i - 1] + (angles[i] - angles[i - 1]) * (time - times[i - 1]) / (times[i] - times[i - 1]);
}

Vec3 Gravity::at(double time) const {
    const double share = ramp > 0 ? std::clamp(time / ramp, 0.0, 1.0) : 1.0;
    const Vec3 scaled = share * value;
    return turns() ? rotate(from_rotation_vector(angle(time) * axis), scaled) : scaled;
}

Gravity Gravity::held() const {
    Gravity still;
    still.value = value;
    still.ramp = ramp;
    if (!times.empty()) {
        still.value = rotate(from_rotation_vector(angle(0) * axis), value);
    }
    return still;
}

}  // namespace riprap::body
