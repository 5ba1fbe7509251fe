// SPDX-License-Identifier: Apache-2.0
#include "riprap/body/gravity.hpp"

#include <algorithm>

#include "riprap/core/quat.hpp"

namespace riprap::body {

Vec3 Gravity::at(double time) const {
    const double share = ramp > 0 ? std::clamp(time / ramp, 0.0, 1.0) : 1.0;
    const Vec3 scaled = share * value;
    if (rate == 0) {
        return scaled;
    }
    const double angle = rate * (std::clamp(time, start, stop) - start);
    return rotate(from_rotation_vector(angle * axis), scaled);
}

}  // namespace riprap::body
