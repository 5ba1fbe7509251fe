// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "riprap/fluid/mps/mps_settings.hpp"
#include "riprap/fluid/mps_operators/mps_lattice.hpp"

namespace riprap::fluid::mps {

/// Counts pairs in the number density: with the smooth weight by Wendland's kernel (1 - q)^4 (1 + 4 q), whose
/// slope over distance is -20 W/r^2 but for its size: forces along d W/r^2 then follow from the density as from a
/// potential, and a particle counts itself. W itself falls where particles come nearer than 0.4 r_e, which lets them
/// pair and stirs water at rest. The reciprocal weight counts as it is.
class Crowding {
 public:
    explicit Crowding(const MpsSettings& settings)
        : reach_(settings.support_radius()), is_smooth_(settings.weight_law == MpsWeightLaw::smooth) {
        const double ratio = settings.support_ratio();
        const int reach = static_cast<int>(std::ceil(ratio)), reach_z = settings.domain.dimension == 3 ? reach : 0;
        full_ = is_smooth_ ? own() : settings.lattice().number_density;
        for (int z = -reach_z; is_smooth_ && z <= reach_z; ++z) {
            for (int y = -reach; y <= reach; ++y) {
                for (int x = -reach; x <= reach; ++x) {
                    const double r = settings.spacing * std::sqrt(x * x + y * y + z * z);
                    full_ += r > 0 ? of_pair(r * r, 0) : 0;
                }
            }
        }
    }
    /// @param weight  W of the pair [-]
    double of_pair(double r2, double weight) const {
        if (!is_smooth_) {
            return weight;
        }
        const double q = std::sqrt(r2) / reach_, rest = std::max(0.0, 1 - q);
        return rest * rest * rest * rest * (1 + 4 * q);
    }
    double own() const { return is_smooth_ ? 1 : 0; }  ///< of a particle itself
    double full() const { return full_; }              ///< n_0 of this count

 private:
    double reach_, full_{0};
    bool is_smooth_;
};

}  // namespace riprap::fluid::mps
