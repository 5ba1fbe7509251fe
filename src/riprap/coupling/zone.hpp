// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "riprap/fluid/particle/sweep/cell_grid.hpp"
#include "riprap/fluid/particle/sweep/periodic_images.hpp"

namespace riprap::coupling {

/// All places within a distance of some points, across periodic sides too.
class Zone {
 public:
    Zone(std::span<const Vec3> points, const fluid::Domain& domain, double distance)
        : points_(points.begin(), points.end()), images_(domain), distance_(distance) {
        if (!points_.empty()) {
            cells_.build(points_, fluid::Domain{}, distance);
        }
    }
    bool holds(const Vec3& x) const {
        const auto is_near = [&](const Vec3& shift) {
            return cells_.view().any_near(x + shift, [&](std::int64_t k) {
                return norm_squared(x + shift - points_[static_cast<std::size_t>(k)]) <= distance_ * distance_;
            });
        };
        return !points_.empty() && std::any_of(images_.shifts().begin(), images_.shifts().end(), is_near);
    }

 private:
    std::vector<Vec3> points_;
    fluid::PeriodicImages images_;
    double distance_;
    fluid::CellGrid cells_;
};

}  // namespace riprap::coupling
