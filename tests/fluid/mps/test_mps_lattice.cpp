// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/mps_operators/mps_lattice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "riprap/fluid/mps_operators/mps_weight.hpp"

namespace riprap::fluid {
namespace {

constexpr MpsWeightLaw smooth = MpsWeightLaw::smooth, reciprocal = MpsWeightLaw::reciprocal;

TEST(MpsLattice, has_the_sums_that_were_computed_by_hand) {
    struct Row {
        MpsWeightLaw law;
        int dimension;
        double ratio, number_density, lambda, neighbours;
    };
    for (const Row& row :
         {Row{reciprocal, 2, 2.1, 6.539697, 1.388351, 12}, Row{reciprocal, 2, 3.1, 18.976417, 2.448472, 28},
          Row{reciprocal, 3, 2.1, 14.418575, 1.701738, 32}, Row{reciprocal, 3, 3.1, 54.321209, 3.243422, 122},
          Row{smooth, 2, 2.1, 0.193928, 1.331837, 12}, Row{smooth, 2, 3.1, 0.430107, 2.706730, 28},
          Row{smooth, 3, 2.1, 0.414932, 1.602128, 32}, Row{smooth, 3, 3.1, 1.338270, 3.236839, 122}}) {
        const MpsLattice lattice = mps_lattice(row.law, row.ratio, 0.02, row.dimension);
        EXPECT_NEAR(lattice.number_density, row.number_density, 1e-6);
        EXPECT_NEAR(lattice.lambda, row.lambda * 0.02 * 0.02, 1e-6 * 0.02 * 0.02);
        EXPECT_EQ(lattice.neighbours, row.neighbours);
    }
}

/// Change of 2 D/n_0 sum W d/r^2 about a particle of a wave of planes `period` spacings long, per its displacement.
double stiffness_of_wave(MpsWeightLaw law, double ratio, int period) {
    const MpsWeight weight(ratio, 1, law);
    const auto push = [&](double u) {
        double sum = 0;
        for (int y = -4; y <= 4; ++y) {
            for (int x = -4; x <= 4; ++x) {
                const double lag = u * (1 - std::cos(2 * std::numbers::pi * x / period));
                const double dx = -x + lag, r2 = dx * dx + y * y;
                sum += x * x + y * y < ratio * ratio ? weight.over_square(r2, weight.value(r2)) * dx : 0;
            }
        }
        return 2 * mps_lattice(law, ratio, 1, 2).first_order() * sum;
    };
    constexpr double shift = 1e-4;
    return -(push(shift) - push(-shift)) / (2 * shift);
}

TEST(MpsLattice, stiffness_is_that_of_the_stiffer_wave_of_two_or_four_planes) {
    for (const MpsWeightLaw law : {smooth, reciprocal}) {
        for (const double ratio : {2.1, 3.1}) {
            const double expected = std::max(stiffness_of_wave(law, ratio, 2), stiffness_of_wave(law, ratio, 4));
            EXPECT_NEAR(mps_lattice(law, ratio, 1, 2).wave_stiffness, expected, 1e-3 * expected);
            EXPECT_NEAR(mps_lattice(law, ratio, 0.02, 2).wave_stiffness, expected / 0.0004, 1e-3 * expected / 0.0004);
        }
    }
    EXPECT_GT(stiffness_of_wave(smooth, 3.1, 4), 2 * stiffness_of_wave(smooth, 3.1, 2));
}

/// Largest shear that two half planes of the lattice bear on each other under a pressure of 1 while one slides over the
/// other by a spacing.
double shear_held(MpsWeightLaw law, double ratio) {
    const MpsWeight weight(ratio, 1, law);
    const double factor = 2 * mps_lattice(law, ratio, 1, 2).first_order();
    double most = 0;
    for (double slid = 0; slid < 1; slid += 0.025) {
        double shear = 0;
        for (int rows = 1; rows <= 4; ++rows) {  // as many pairs of rows are so many spacings apart
            for (int x = -5; x <= 5; ++x) {
                const double dx = x + slid, r2 = dx * dx + rows * rows;
                shear += rows * factor * weight.over_square(r2, weight.value(r2)) * dx;
            }
        }
        most = std::max(most, std::abs(shear));
    }
    return most;
}

// The force of the reciprocal weight grows as 1/r^3, and rows lock: water at rest had a yield stress.
TEST(MpsWeight, rows_of_water_slide_under_the_smooth_weight_and_lock_under_the_reciprocal_one) {
    EXPECT_LT(shear_held(smooth, 2.1), 0.001);
    EXPECT_LT(shear_held(smooth, 3.1), 0.001);
    EXPECT_GT(shear_held(reciprocal, 2.1), 0.015);
    EXPECT_GT(shear_held(reciprocal, 3.1), 0.005);
}

TEST(MpsWeight, is_zero_at_its_end_beyond_it_and_where_a_particle_meets_itself) {
    const MpsWeight published(3.1, 1, reciprocal), own(3.1, 1, smooth);
    EXPECT_NEAR(published.value(1.0), 2.1, 1e-7);
    EXPECT_NEAR(published.value(2.0 * 2.0), 0.55, 1e-7);
    EXPECT_NEAR(own.value(1.0), 2.1 * 2.1 * 2.1 / std::pow(3.1, 5), 1e-9);  // q^2 (1 - q)^3
    EXPECT_NEAR(own.value(2.0 * 2.0), 4 * 1.1 * 1.1 * 1.1 / std::pow(3.1, 5), 1e-9);
    EXPECT_NEAR(own.over_square(4.0, own.value(4.0)), own.value(4.0) / 4, 1e-12);
    for (const MpsWeight& weight : {published, own}) {
        EXPECT_EQ(weight.value(3.1001 * 3.1001), 0);
        EXPECT_EQ(weight.value(100.0), 0);
        EXPECT_EQ(weight.value(0.0), 0);
        EXPECT_EQ(weight.over_square(0.0, 0.0), 0);
    }
}

TEST(MpsWeight, has_a_bound_where_particles_all_but_meet) {
    const MpsWeight published(3.1, 1, reciprocal), own(3.1, 1, smooth);
    for (const double r : {0.5, 0.3, 0.01}) {
        EXPECT_NEAR(published.value(r * r), 3.1 / 0.5 - 1, 1e-6) << r;
        EXPECT_NEAR(published.over_square(r * r, published.value(r * r)), (3.1 / 0.5 - 1) / 0.25, 1e-5) << r;
        EXPECT_NEAR(own.over_square(r * r, own.value(r * r)), std::pow(1 - r / 3.1, 3) / (3.1 * 3.1), 1e-6) << r;
    }
}

}  // namespace
}  // namespace riprap::fluid
