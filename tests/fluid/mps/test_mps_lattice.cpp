// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/particle/mps_lattice.hpp"

#include <gtest/gtest.h>

#include "riprap/fluid/particle/mps_weight.hpp"

namespace riprap::fluid {
namespace {

TEST(MpsLattice, has_the_sums_that_were_computed_by_hand) {
    struct Row {
        int dimension;
        double ratio, number_density, lambda, neighbours;
    };
    for (const Row& row : {Row{2, 2.1, 6.539697, 1.388351, 12}, Row{2, 3.1, 18.976417, 2.448472, 28},
                           Row{3, 2.1, 14.418575, 1.701738, 32}, Row{3, 3.1, 54.321209, 3.243422, 122}}) {
        const MpsLattice lattice = mps_lattice(row.ratio, 0.02, row.dimension);
        EXPECT_NEAR(lattice.number_density, row.number_density, 1e-6);
        EXPECT_NEAR(lattice.lambda, row.lambda * 0.02 * 0.02, 1e-6 * 0.02 * 0.02);
        EXPECT_EQ(lattice.neighbours, row.neighbours);
    }
}

TEST(MpsLattice, stiffness_of_a_zigzag_is_the_difference_of_its_sums) {
    const double ratio = 3.1, shift = 1e-4;
    const MpsWeight weight(ratio, 1);
    const auto push = [&](double u) {  // 2 D/n_0 sum W d/r^2 about a particle whose neighbours at odd places lag by u
        double sum = 0;
        for (int y = -4; y <= 4; ++y) {
            for (int x = -4; x <= 4; ++x) {
                const double dx = -x + (x % 2 != 0 ? u : 0), r2 = dx * dx + y * y;
                sum += x * x + y * y < ratio * ratio ? weight.over_square(r2, weight.value(r2)) * dx : 0;
            }
        }
        return 2 * mps_lattice(ratio, 1, 2).first_order() * sum;
    };
    const double slope = (push(2 * shift) - push(-2 * shift)) / (2 * shift);
    EXPECT_NEAR(mps_lattice(ratio, 1, 2).zigzag_stiffness, -slope, 1e-3 * -slope);
    EXPECT_NEAR(mps_lattice(ratio, 0.02, 2).zigzag_stiffness, -slope / 0.0004, 1e-3 * -slope / 0.0004);
}

TEST(MpsWeight, is_zero_at_its_end_beyond_it_and_where_a_particle_meets_itself) {
    const MpsWeight weight(3.1, 1);
    EXPECT_NEAR(weight.value(1.0), 2.1, 1e-7);
    EXPECT_NEAR(weight.value(2.0 * 2.0), 0.55, 1e-7);
    EXPECT_EQ(weight.value(3.1001 * 3.1001), 0);
    EXPECT_EQ(weight.value(100.0), 0);
    EXPECT_EQ(weight.value(0.0), 0);
}

TEST(MpsWeight, has_a_bound_where_particles_all_but_meet) {
    const MpsWeight weight(3.1, 1);
    for (const double r : {0.5, 0.3, 0.01}) {
        EXPECT_NEAR(weight.value(r * r), 3.1 / 0.5 - 1, 1e-6) << r;
        EXPECT_NEAR(weight.over_square(r * r, weight.value(r * r)), (3.1 / 0.5 - 1) / 0.25, 1e-5) << r;
    }
}

}  // namespace
}  // namespace riprap::fluid
