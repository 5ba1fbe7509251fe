// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/mps_operators/mps_lattice.hpp"

#include <algorithm>
#include <cmath>

namespace riprap::fluid {
namespace {

/// x^2/r d/dr (W/r^2) at a place of the lattice, in spacings.
double bend(MpsWeightLaw law, double support_ratio, double x2, double r2) {
    const double r = std::sqrt(r2);
    if (law == MpsWeightLaw::smooth) {
        const double rest = 1 - r / support_ratio;
        return -3 * x2 * rest * rest / (support_ratio * support_ratio * support_ratio * r);
    }
    return x2 / r2 * (2 - 3 * support_ratio / r) / r2;
}

}  // namespace

double lattice_weight(MpsWeightLaw law, double support_ratio, double r) {
    if (law == MpsWeightLaw::smooth) {
        const double q = r / support_ratio, rest = std::max(0.0, 1 - q);
        return q * q * rest * rest * rest;
    }
    return std::max(0.0, support_ratio / r - 1);
}

MpsLattice mps_lattice(MpsWeightLaw law, double support_ratio, double spacing, int dimension) {
    MpsLattice lattice{0, 0, 0, 0, dimension, spacing};
    const int reach = static_cast<int>(std::ceil(support_ratio)), reach_z = dimension == 3 ? reach : 0;
    double second = 0, short_wave = 0, long_wave = 0;
    for (int z = -reach_z; z <= reach_z; ++z) {
        for (int y = -reach; y <= reach; ++y) {
            for (int x = -reach; x <= reach; ++x) {
                const double r2 = x * x + y * y + z * z;
                if (r2 > 0 && r2 < support_ratio * support_ratio) {
                    const double weight = lattice_weight(law, support_ratio, std::sqrt(r2));
                    lattice.number_density += weight;
                    second += weight * r2;
                    lattice.neighbours += 1;
                    // d/dx of W x/r^2; planes at x move by 1 - cos less than this one
                    const double slope = weight / r2 + bend(law, support_ratio, x * x, r2);
                    short_wave += x % 2 != 0 ? -2 * slope : 0;
                    long_wave += x % 2 != 0 ? -slope : x % 4 != 0 ? -2 * slope : 0;
                }
            }
        }
    }
    lattice.wave_stiffness = 2 * lattice.first_order() * std::max(short_wave, long_wave) / (spacing * spacing);
    lattice.lambda = second / lattice.number_density * spacing * spacing;
    return lattice;
}

}  // namespace riprap::fluid
