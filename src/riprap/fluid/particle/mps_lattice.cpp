// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/particle/mps_lattice.hpp"

#include <cmath>

namespace riprap::fluid {

MpsLattice mps_lattice(double support_ratio, double spacing, int dimension) {
    MpsLattice lattice{0, 0, 0, 0, dimension, spacing};
    const int reach = static_cast<int>(std::ceil(support_ratio)), reach_z = dimension == 3 ? reach : 0;
    double second = 0, zigzag = 0;
    for (int z = -reach_z; z <= reach_z; ++z) {
        for (int y = -reach; y <= reach; ++y) {
            for (int x = -reach; x <= reach; ++x) {
                const double r2 = x * x + y * y + z * z;
                if (r2 > 0 && r2 < support_ratio * support_ratio) {
                    const double weight = support_ratio / std::sqrt(r2) - 1;
                    lattice.number_density += weight;
                    second += weight * r2;
                    lattice.neighbours += 1;
                    // d/dx of W x/r^2; every other plane moves, by 2 u relative to this one
                    const double slope = weight / r2 + x * x / r2 * (2 - 3 * support_ratio / std::sqrt(r2)) / r2;
                    zigzag += x % 2 != 0 ? -2 * slope : 0;
                }
            }
        }
    }
    lattice.zigzag_stiffness = 2 * lattice.first_order() * zigzag / (spacing * spacing);
    lattice.lambda = second / lattice.number_density * spacing * spacing;
    return lattice;
}

}  // namespace riprap::fluid
