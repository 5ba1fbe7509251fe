// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/mps/mps_settings.hpp"

namespace riprap::fluid::mps {

/// x_i - x_j to the nearest image, without z in planar scenes.
class Separation {
 public:
    explicit Separation(const Domain& domain) : nearest_(domain), is_planar_(domain.dimension == 2) {}
    Vec3 operator()(const Vec3& a, const Vec3& b) const {
        Vec3 d = nearest_(a - b);
        d.z = is_planar_ ? 0 : d.z;
        return d;
    }

 private:
    NearestImage nearest_;
    bool is_planar_;
};

}  // namespace riprap::fluid::mps
