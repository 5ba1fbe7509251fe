// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/sph/courant_bound.hpp"

#include <gtest/gtest.h>

#include "fluid/sph/water.hpp"

namespace riprap::fluid::testing {
namespace {

double bound(int dimension, double ratio, double damping, double diffusion = 0.1) {
    SphSettings settings;
    settings.domain.dimension = dimension;
    settings.smoothing_ratio = ratio;
    settings.acoustic_damping = damping;
    settings.density_diffusion = diffusion;
    return courant_bound(settings);
}

TEST(CourantBound, is_that_of_a_scan_over_all_wave_numbers) {  // docs/theory/sph.md, 8
    EXPECT_NEAR(bound(2, 1.2, 1), 1.04, 0.006);
    EXPECT_NEAR(bound(2, 1.5, 1), 1.00, 0.006);
    EXPECT_NEAR(bound(2, 1.5, 0), 1.56, 0.006);
    EXPECT_NEAR(bound(3, 1.5, 1), 0.96, 0.006);
    EXPECT_NEAR(bound(3, 1.732, 1), 0.96, 0.006);
    EXPECT_NEAR(bound(3, 1.5, 0), 1.52, 0.006);
    EXPECT_NEAR(bound(3, 2.0, 0), 1.51, 0.006);
    EXPECT_LT(bound(3, 1.5, 1, 0.3), 0.9);
    EXPECT_LT(bound(3, 1.5, 1, 1.0), 0.35);
}

TEST(CourantBound, without_corrected_gradients_nothing_is_damped) {
    SphSettings settings;
    settings.gradient_correction = false;
    EXPECT_EQ(courant_bound(settings), bound(settings.domain.dimension, 1.5, 0));
}

/// Energy of a checkered noise of density in still water without walls, over that at the start.
double growth_of_noise(double courant) {
    Water water;
    water.settings = settings_2d(1.0 / 24, 20);
    water.settings.domain = {{0, 0, 0}, {1, 1, 0}, {true, true, false}, 2};
    water.settings.viscosity.get<ArtificialViscosity>().alpha = 0;
    water.settings.shifting = 0;
    water.settings.courant = courant;
    int number = 0;
    for_lattice(1.0 / 24, 1, 1, [&](double x, double y) {
        number += 1;
        water.add_particle({x, y, 0}, {}, 1e-3 * ((number * 7919) % 13 - 6));
    });
    water.step();
    const double start = water.report.kinetic + water.report.internal;
    for (int k = 0; k < 400 && water.report.problem.empty(); ++k) {
        water.step();
    }
    return water.report.problem.empty() ? (water.report.kinetic + water.report.internal) / start : 1e300;
}

TEST(CourantBound, noise_dies_below_it_and_grows_above) {  // 1.00; c in the step is that at the highest density
    EXPECT_LT(growth_of_noise(0.95), 1);
    EXPECT_GT(growth_of_noise(1.10), 1e6);
}

}  // namespace
}  // namespace riprap::fluid::testing
