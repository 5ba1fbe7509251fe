// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "riprap/fluid/particle/state_equation.hpp"
#include "riprap/fluid/sph/sph_settings.hpp"

namespace riprap::fluid {
namespace {

SphSettings water(StateEquation equation) {
    SphSettings settings;
    settings.sound_speed = 30;
    settings.state_equation = equation;
    return settings;
}

class EveryStateEquation : public ::testing::TestWithParam<StateEquation> {};

TEST_P(EveryStateEquation, has_no_pressure_and_no_energy_at_rest_and_the_sound_speed_as_slope) {
    const SphSettings s = water(GetParam());
    EXPECT_EQ(pressure_of(s, 1000), 0);
    EXPECT_EQ(internal_energy_of(s, 1000), 0);
    const double step = 1e-3, slope = (pressure_of(s, 1000 + step) - pressure_of(s, 1000 - step)) / (2 * step);
    EXPECT_NEAR(slope, 900, 1e-4);
}

TEST_P(EveryStateEquation, gives_back_the_density_of_a_pressure) {
    const SphSettings s = water(GetParam());
    for (const double density : {960.0, 1000.0, 1013.0, 1200.0}) {
        EXPECT_NEAR(density_of(s, pressure_of(s, density)), density, 1e-9);
    }
}

TEST_P(EveryStateEquation, stores_the_work_of_compression) {
    const SphSettings s = water(GetParam());
    // de = p/rho^2 drho, by the midpoint rule
    const double from = 980, to = 1100;
    const int steps = 20000;
    double work = 0;
    for (int k = 0; k < steps; ++k) {
        const double density = from + (to - from) * (k + 0.5) / steps;
        work += pressure_of(s, density) / (density * density) * (to - from) / steps;
    }
    EXPECT_NEAR(internal_energy_of(s, to) - internal_energy_of(s, from), work, 1e-7 * work);
    EXPECT_GT(internal_energy_of(s, from), 0);
}

TEST_P(EveryStateEquation, has_the_slope_of_pressure_as_squared_sound_speed_everywhere) {
    const SphSettings s = water(GetParam());
    for (const double density : {970.0, 1050.0}) {
        const double slope = (pressure_of(s, density + 1e-3) - pressure_of(s, density - 1e-3)) / 2e-3;
        EXPECT_NEAR(sound_speed_of(s, density), std::sqrt(slope), 1e-6 * std::sqrt(slope));
    }
}

INSTANTIATE_TEST_SUITE_P(, EveryStateEquation, ::testing::Values(StateEquation::tait, StateEquation::linear));

TEST(SoundSpeed, is_ten_times_the_fastest_wave_or_motion_and_says_which) {
    const SoundSpeed by_waves = choose_sound_speed(9.81, 0.55, 1.0);
    EXPECT_NEAR(by_waves.value, 10 * std::sqrt(9.81 * 0.55), 1e-12);
    EXPECT_NE(by_waves.reason.find("sqrt(g depth)"), std::string::npos);
    const SoundSpeed by_motion = choose_sound_speed(9.81, 0.1, 3.0);
    EXPECT_NEAR(by_motion.value, 30, 1e-12);
    EXPECT_NE(by_motion.reason.find("fastest motion"), std::string::npos);
}

}  // namespace
}  // namespace riprap::fluid
