// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

#include "riprap/fluid/particle/sweep/domain.hpp"

namespace riprap::fluid {

/// The places that a place stands for in a domain with periodic sides: shifted by whole periods.
class PeriodicImages {
 public:
    explicit PeriodicImages(const Domain& domain) : shifts_{{}} {
        for (int axis = 0; axis < domain.dimension; ++axis) {
            if (!domain.is_periodic[static_cast<std::size_t>(axis)]) {
                continue;
            }
            period_[axis] = domain.high[axis] - domain.low[axis];
            const std::vector<Vec3> before = shifts_;
            for (const double sign : {1.0, -1.0}) {
                for (Vec3 shift : before) {
                    shift[axis] = sign * period_[axis];
                    shifts_.push_back(shift);
                }
            }
        }
    }

    /// The image of x that is nearest to `about`, by minimum image: |x - about| is at most half a period per axis.
    Vec3 nearest(Vec3 x, const Vec3& about) const {
        for (int axis = 0; axis < 3; ++axis) {
            if (period_[axis] > 0) {
                x[axis] -= period_[axis] * std::round((x[axis] - about[axis]) / period_[axis]);
            }
        }
        return x;
    }

    /// From an image to itself and to those around it: none first.
    const std::vector<Vec3>& shifts() const { return shifts_; }

 private:
    Vec3 period_{};  ///< 0 along axes that do not repeat [m]
    std::vector<Vec3> shifts_;
};

}  // namespace riprap::fluid
