// SPDX-License-Identifier: Apache-2.0
#include "heaving_cylinder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <vector>

namespace riprap::validation::water {
namespace {

TEST(HeavingCylinder, fast_heave_moves_the_water_as_if_the_surface_gave_no_resistance) {
    // Half of rho pi a^2, the added mass of the whole cylinder far from any surface, less 2 rho a^2/(3 K a)
    // [Ursell1949].
    EXPECT_NEAR(heave_loads(20).added_mass, 0.5 * M_PI - 2.0 / (3 * 20), 3e-3);
    EXPECT_LT(heave_loads(12).damping / heave_loads(6).damping, 1.0 / 8);  // in the end as (K a)^-4
}

TEST(HeavingCylinder, the_waves_carry_away_the_power_of_the_damping) {
    for (const double ka : {0.01, 0.1, 0.5, 1.0, 2.0, 4.0}) {
        const HeaveLoads loads = heave_loads(ka);
        EXPECT_NEAR(M_PI * M_PI * std::norm(loads.source), loads.damping, 2e-4 * loads.damping) << ka;
    }
}

TEST(HeavingCylinder, the_added_mass_is_least_where_waves_are_about_as_long_as_in_ursells_table) {
    // 0.605 of rho pi a^2/2 at K a = 1, least near 0.8.
    EXPECT_NEAR(heave_loads(1).added_mass, 0.605 * 0.5 * M_PI, 2e-3);
    EXPECT_LT(heave_loads(0.8).added_mass, heave_loads(0.6).added_mass);
    EXPECT_LT(heave_loads(0.8).added_mass, heave_loads(1).added_mass);
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

TEST(HeavingCylinder, a_release_begins_with_the_weight_that_is_missing_over_the_mass_and_that_of_fast_heave) {
    const HeaveDecay decay;
    EXPECT_NEAR(decay.at(0), 1, 1e-3);
    EXPECT_NEAR(decay.at(0.3), 1 - 0.09 / M_PI, 5e-4);  // y'' = -C/(M + A) = -2/pi
    EXPECT_NEAR(decay.at(60), 0, 5e-3);
}

/// The wave that goes to either side carries away what heave loses: over the whole decay the work of B is the energy at
/// the start, C y(0)^2/2 = 1: a check on at() that knows nothing of how it was found.
TEST(HeavingCylinder, all_of_its_energy_goes_into_waves) {
    const HeaveDecay decay;
    constexpr double step = 0.1, width = 0.01;
    std::vector<double> speed;
    for (double t = 0.5 * step; t < 60; t += step) {
        speed.push_back((decay.at(t + 0.01) - decay.at(t - 0.01)) / 0.02);
    }
    double lost = 0;
    for (double w = 0.5 * width; w < 3; w += width) {  // |Y'(W)|^2 by the transform of y(t) itself
        double even = 0, odd = 0;
        for (std::size_t i = 0; i < speed.size(); ++i) {
            const double t = (static_cast<double>(i) + 0.5) * step;
            even += speed[i] * std::cos(w * t) * step;
            odd += speed[i] * std::sin(w * t) * step;
        }
        lost += heave_loads(w * w).damping * w * (even * even + odd * odd) * width / M_PI;
    }
    EXPECT_NEAR(lost, 1, 0.02);
}

}  // namespace
}  // namespace riprap::validation::water
