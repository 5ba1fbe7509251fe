// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/mps_operators/even_count.hpp"

#include <cmath>

#include "riprap/fluid/mps_operators/mps_lattice.hpp"

namespace riprap::fluid {

namespace {

/// Sums over the lattice places that lie `row` layers and more above one: w, W, and W d/r along the way up [-].
struct Above {
    double count{0}, weight{0}, outward{0};
};

Above above(MpsWeightLaw law, double support_ratio, int dimension, int row) {
    const EvenCount even(support_ratio, law);
    const int reach = static_cast<int>(std::ceil(support_ratio)), deep = dimension == 3 ? reach : 0;
    Above sums;
    for (int up = row; up <= reach; ++up) {
        for (int x = -reach; x <= reach; ++x) {
            for (int z = -deep; z <= deep; ++z) {
                const double r = std::sqrt(up * up + x * x + z * z);
                const double weight = r > 0 ? lattice_weight(law, support_ratio, r) : 0;
                sums.count += even.of_pair(r, weight);
                sums.weight += weight;
                sums.outward += r > 0 ? weight * up / r : 0;
            }
        }
    }
    return sums;
}

}  // namespace

EvenLattice even_lattice(MpsWeightLaw law, double support_ratio, int dimension) {
    const int reach = static_cast<int>(std::ceil(support_ratio));
    const Above all = above(law, support_ratio, dimension, -reach);
    EvenLattice lattice;
    lattice.full = all.count;
    const auto row = [&](int number) {
        Above sums = above(law, support_ratio, dimension, number);
        sums.count /= lattice.full;
        sums.outward /= all.weight;
        return sums;
    };
    const Above first = row(1), second = row(2);
    const double ratio = first.count / first.outward;
    lattice.b = second.outward > 0 ? (ratio - second.count / second.outward) / (first.outward - second.outward) : 0;
    lattice.a = ratio - lattice.b * first.outward;
    return lattice;
}

}  // namespace riprap::fluid
