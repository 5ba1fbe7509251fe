// SPDX-License-Identifier: Apache-2.0
#include "riprap/validation/water/heaving_cylinder.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace riprap::validation::water {
namespace {

TEST(HeavingCylinder, fast_heave_moves_the_water_as_if_the_surface_gave_no_resistance) {
    // Half of rho pi a^2, the added mass of the whole cylinder far from any surface; A falls short by 4/(3 pi K a).
    EXPECT_NEAR(heave_loads(20).added_mass, 0.5 * M_PI, 0.05);
    EXPECT_NEAR(heave_loads(20).damping, 0, 1e-3);
}

TEST(HeavingCylinder, slow_heave_makes_the_waves_of_its_waterline) {
    // A waterline 2 a wide makes waves 2 K a times as high as its heave; their energy, sent both ways, is B: B = 4 rho
    // a^2 omega.
    EXPECT_NEAR(heave_loads(1e-4).damping, 4, 0.02);
    EXPECT_GT(heave_loads(1e-4).added_mass, heave_loads(1e-3).added_mass + 1);  // it grows as -ln K a
}

TEST(HeavingCylinder, waves_are_made_at_every_frequency_and_less_the_faster_it_heaves) {
    double last = 1e9;
    for (const double ka : {0.01, 0.1, 0.3, 1.0, 2.0, 4.0}) {
        const double damping = heave_loads(ka).damping;
        EXPECT_GT(damping, 0) << ka;
        EXPECT_LT(damping, last) << ka;
        last = damping;
    }
}

TEST(HeavingCylinder, a_release_begins_at_rest_where_it_was_held) {
    const HeaveDecay decay;
    EXPECT_NEAR(decay.at(0), 1, 1e-3);
    EXPECT_NEAR(decay.at(0.05), 1, 2e-3);
    EXPECT_NEAR(decay.at(60), 0, 5e-3);
}

/// The wave that goes to either side carries away what heave loses: over the whole decay the work of B is the energy at
/// the start, C y(0)^2/2 = 1: a check on at() that knows nothing of how it was found.
TEST(HeavingCylinder, all_of_its_energy_goes_into_waves) {
    const HeaveDecay decay;
    double lost = 0;
    const double width = 0.01;
    for (double w = 0.5 * width; w < 3; w += width) {  // |Y'(W)|^2 by the transform of y(t) itself
        double even = 0, odd = 0;
        const double step = 0.1;
        for (double t = 0.5 * step; t < 60; t += step) {
            const double speed = (decay.at(t + 0.01) - decay.at(t - 0.01)) / 0.02;
            even += speed * std::cos(w * t) * step;
            odd += speed * std::sin(w * t) * step;
        }
        lost += heave_loads(w * w).damping * w * (even * even + odd * odd) * width / M_PI;
    }
    EXPECT_NEAR(lost, 1, 0.02);
}

}  // namespace
}  // namespace riprap::validation::water
