// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "riprap/wave/wave_analysis.hpp"
#include "riprap/wave/wave_maker.hpp"

namespace riprap::wave {
namespace {

constexpr double g = 9.81;

TEST(LinearWave, wave_numbers_satisfy_the_dispersion_relation_in_shallow_and_deep_water) {
    for (const double depth : {1e-3, 0.1, 1.0, 20.0, 5000.0}) {
        for (const double period : {0.3, 1.0, 5.0, 20.0, 900.0}) {
            const double omega = 2 * std::numbers::pi / period;
            const double k = wave_number(omega, depth, g);
            EXPECT_NEAR(g * k * std::tanh(k * depth) / (omega * omega), 1, 1e-13) << depth << " m, " << period << " s";
        }
    }
}

TEST(LinearWave, lengths_and_speeds_of_three_flumes_are_those_of_the_tables) {
    // Lengths and celerities worked out independently to six digits.
    const struct {
        double period, depth, length, celerity, piston, flap;
    } rows[] = {{1.2, 0.5, 2.04833, 1.70694, 1.41675, 0.82085},
                {2.0, 0.4, 3.69495, 1.84748, 0.67723, 0.35110},
                {1.5, 0.7, 3.11812, 2.07875, 1.32762, 0.75564}};
    for (const auto& row : rows) {
        const LinearWave wave = linear_wave(0.1, row.period, row.depth, g);
        EXPECT_NEAR(wave.length(), row.length, 1e-5);
        EXPECT_NEAR(wave.celerity(), row.celerity, 1e-5);
        EXPECT_NEAR(height_over_stroke(Paddle::piston, wave.kd()), row.piston, 1e-5);
        EXPECT_NEAR(height_over_stroke(Paddle::flap, wave.kd()), row.flap, 1e-5);
    }
}

TEST(LinearWave, groups_travel_at_half_the_celerity_in_deep_water_and_at_it_in_shallow_water) {
    const LinearWave deep = linear_wave(1, 2, 1000, g);
    const LinearWave shallow = linear_wave(0.01, 100, 0.5, g);
    EXPECT_NEAR(deep.group_velocity() / deep.celerity(), 0.5, 1e-12);
    EXPECT_NEAR(shallow.group_velocity() / shallow.celerity(), 1, 1e-3);
}

TEST(WaveMaker, a_piston_in_shallow_water_makes_kd_times_its_stroke) {
    EXPECT_NEAR(height_over_stroke(Paddle::piston, 1e-3) / 1e-3, 1, 1e-5);
    EXPECT_NEAR(height_over_stroke(Paddle::flap, 1e-2) / 0.5e-2, 1, 1e-3);
    EXPECT_NEAR(height_over_stroke(Paddle::piston, 400.0), 2, 1e-12);
}

/// Largest difference between the given rates and central differences of the values.
double rate_error(const MotionSeries& series) {
    double worst = 0;
    for (std::size_t i = 1; i + 1 < series.time.size(); ++i) {
        const double difference =
            (series.value[i + 1] - series.value[i - 1]) / (series.time[i + 1] - series.time[i - 1]);
        worst = std::max(worst, std::abs(difference - series.rate[i]));
    }
    return worst;
}

TEST(WaveMaker, the_stroke_of_a_piston_is_that_of_its_transfer_function) {
    const LinearWave wave = linear_wave(0.4, 4, 2, g);
    const RegularStroke stroke = regular_stroke(wave, Paddle::piston, false);
    EXPECT_NEAR(2 * stroke.first, 0.4 / 0.769, 1e-3);  // H/S = 0.769 for this depth and period
    EXPECT_EQ(stroke.second, 0);
    EXPECT_EQ(regular_stroke(wave, Paddle::piston, true).second, second_harmonic_stroke(wave));
}

TEST(WaveMaker, the_near_field_of_a_piston_is_that_of_an_impulse_when_it_swings_fast_and_none_when_slowly) {
    // Fast, the surface is one of no pressure: k_j = (j - 1/2) pi/d, and the sum is 4/pi artanh exp(-pi x/(2 d)).
    const LinearWave fast = linear_wave(0.01, 1e-3, 1, g);
    for (const double x : {0.1, 0.4, 1.0}) {
        EXPECT_NEAR(evanescent_elevation(fast, x),
                    4 / std::numbers::pi * std::atanh(std::exp(-std::numbers::pi * x / 2)), 1e-4);
    }
    EXPECT_LT(evanescent_elevation(linear_wave(0.01, 100, 1, g), 0.1), 1e-3);
}

TEST(WaveMaker, the_second_harmonic_vanishes_with_the_square_of_the_height) {
    const double full = second_harmonic_stroke(linear_wave(0.1, 2, 0.4, g));
    const double half = second_harmonic_stroke(linear_wave(0.05, 2, 0.4, g));
    EXPECT_NEAR(full / half, 4, 1e-12);
    EXPECT_GT(full, 0);
}

TEST(WaveMaker, a_solitary_motion_displaces_the_water_of_the_wave) {
    // The paddle sweeps stroke x depth; the wave holds 2 H/K above still water: equal for the first-order wave.
    const SolitaryWave wave{0.1, 0.5, g};
    EXPECT_NEAR(wave.celerity(), 2.42611, 1e-5);
    EXPECT_NEAR(wave.shape_number(), 0.77460, 1e-5);
    const MotionSeries motion = solitary_motion(wave);
    EXPECT_NEAR(motion.value.back() * wave.depth, 0.999 * wave.volume(), 1e-12);
    EXPECT_LT(rate_error(motion), 1e-3 * wave.mean_velocity(0));
    EXPECT_GT(motion.rate.front(), 0);
    EXPECT_LT(motion.rate.front(), 0.01 * wave.mean_velocity(0));
}

TEST(WaveAnalysis, a_sine_has_its_height_and_period) {
    std::vector<double> time, level;
    for (int i = 0; i < 2000; ++i) {
        time.push_back(0.01 * i);
        level.push_back(1.5 + 0.05 * std::sin(2 * std::numbers::pi * time.back() / 1.3 + 0.4));
    }
    const auto waves = zero_crossing_waves(time, level);
    ASSERT_EQ(waves.size(), 14U);
    for (const ZeroCrossingWave& wave : waves) {
        EXPECT_NEAR(wave.height, 0.1, 2e-4);
        EXPECT_NEAR(wave.period, 1.3, 2e-3);
    }
}

TEST(WaveAnalysis, statistics_take_the_highest_third_of_the_waves) {
    // Nine waves of 1 s, one after another, 0.1 to 0.9 m high, rows unevenly apart. The record begins in the first one
    // and the last has no end: seven are whole.
    std::vector<double> time, level;
    for (int i = 250; i < 9000; ++i) {
        const double t = 0.001 * i + 2e-4 * std::sin(i);
        time.push_back(t);
        level.push_back(2 + 0.05 * (1 + std::floor(t)) * std::sin(2 * std::numbers::pi * t));
    }
    const WaveStatistics waves = statistics_of(time, level);
    EXPECT_NEAR(waves.mean_level, 2 - 0.05 / (2 * std::numbers::pi) / 8.75, 1e-4);  // a quarter wave is missing
    EXPECT_EQ(waves.count, 7);
    EXPECT_NEAR(waves.highest, 0.8, 1e-3);
    EXPECT_NEAR(waves.mean_height, 0.5, 1e-3);
    EXPECT_NEAR(waves.significant_height, 0.75, 1e-3);  // of 0.8 and 0.7
    EXPECT_NEAR(waves.mean_period, 1, 1e-3);
    // m_0 = mean of a^2/2 over a = 0.05 ... 0.45, a quarter of the first left out.
    EXPECT_NEAR(waves.spectral_height, 4 * std::sqrt(0.05 * 0.05 * (285 - 0.25) / 8.75 / 2), 1e-3);
}

TEST(WaveAnalysis, a_record_without_a_wave_has_a_level_and_no_heights) {
    const std::vector<double> time{0, 1, 2, 3}, level{0.5, 0.5, 0.5, 0.5};
    const WaveStatistics waves = statistics_of(time, level);
    EXPECT_EQ(waves.mean_level, 0.5);
    EXPECT_EQ(waves.spectral_height, 0);
    EXPECT_EQ(waves.count, 0);
    EXPECT_TRUE(std::isnan(waves.mean_height) && std::isnan(waves.significant_period));
    EXPECT_TRUE(std::isnan(statistics_of({}, {}).mean_level));
}

TEST(WaveAnalysis, incident_and_reflected_waves_come_apart_exactly) {
    const LinearWave wave = linear_wave(0.2, 1.5, 0.7, g);
    const double place[] = {3.0, 3.4, 4.1};
    std::vector<std::complex<double>> amplitude;
    for (const double x : place) {
        std::vector<double> time, level;
        for (int i = 0; i < 700; ++i) {  // not a whole number of periods
            const double t = 0.0173 * i;
            time.push_back(t);
            level.push_back(0.7 + 0.1 * std::cos(wave.wave_number * x - wave.angular_frequency * t + 0.3) +
                            0.03 * std::cos(-wave.wave_number * x - wave.angular_frequency * t + 1.1));
        }
        amplitude.push_back(harmonic(time, level, wave.angular_frequency));
    }
    const Separation parts = separate_reflection(place, amplitude, wave.wave_number);
    EXPECT_NEAR(parts.incident, 0.1, 1e-12);
    EXPECT_NEAR(parts.reflected, 0.03, 1e-12);
    EXPECT_NEAR(parts.reflection, 0.3, 1e-11);
}

TEST(WaveAnalysis, gauges_half_a_wavelength_apart_cannot_tell_the_parts) {
    const LinearWave wave = linear_wave(0.2, 1.5, 0.7, g);
    const double place[] = {1.0, 1.0 + 0.5 * wave.length()};
    const std::complex<double> amplitude[] = {{0.1, 0}, {-0.1, 0}};
    EXPECT_TRUE(std::isnan(separate_reflection(place, amplitude, wave.wave_number).incident));
}

TEST(WaveAnalysis, two_gauges_are_good_from_a_twentieth_of_a_wavelength_to_that_less_than_half) {
    // An error e of one record comes out e/sin(k dx) times as large: 3.2 e at 0.05 L.
    const LinearWave wave = linear_wave(0.2, 1.5, 0.7, g);
    const auto reflected = [&](double share) {
        const double place[] = {0, share * wave.length()};
        const std::complex<double> amplitude[] = {
            0.1, 0.98 * 0.1 * std::polar(1.0, wave.wave_number * place[1])};  // the second reads 2 % too little
        return separate_reflection(place, amplitude, wave.wave_number).reflected;
    };
    for (const double share : {0.01, 0.04, 0.46, 0.49}) {
        EXPECT_TRUE(std::isnan(reflected(share))) << share;
    }
    for (const double share : {0.051, 0.2, 0.449, 0.7}) {
        EXPECT_LT(reflected(share), 0.1 * 0.02 * 3.3 / 2) << share;
    }
}

TEST(WaveAnalysis, rows_half_a_period_apart_have_no_harmonic) {
    const auto amplitude = [](double step) {
        std::vector<double> time, level;
        for (int i = 0; i < 40; ++i) {
            time.push_back(step * i);
            level.push_back(0.1 * std::cos(2 * std::numbers::pi / 1.5 * time.back() - 0.4));
        }
        return std::abs(harmonic(time, level, 2 * std::numbers::pi / 1.5));
    };
    EXPECT_NEAR(amplitude(0.2), 0.1, 1e-12);
    EXPECT_TRUE(std::isnan(amplitude(0.75)));
    EXPECT_TRUE(std::isnan(amplitude(1.5)));
    EXPECT_TRUE(std::isnan(amplitude(1e-4)));  // 40 rows in a four-hundredth of a period
}

TEST(WaveAnalysis, a_wave_with_missing_rows_is_left_out) {
    std::vector<double> time, level;
    for (int i = 25; i < 1000; ++i) {
        time.push_back(0.01 * i);
        const bool is_missing = i >= 330 && i < 430;  // from the fourth wave into the fifth
        level.push_back(is_missing ? std::nan("") : 1 + 0.1 * std::sin(2 * std::numbers::pi * time.back()));
    }
    const auto waves = zero_crossing_waves(time, level);
    EXPECT_EQ(waves.size(), 6U);  // of 1 to 2 s, 2 to 3 s, and 5 to 9 s
    for (const ZeroCrossingWave& wave : waves) {
        EXPECT_NEAR(wave.period, 1, 2e-3);
        EXPECT_NEAR(wave.height, 0.2, 2e-3);
    }
    EXPECT_NEAR(2 * std::abs(harmonic(time, level, 2 * std::numbers::pi)), 0.2, 1e-12);
}

}  // namespace
}  // namespace riprap::wave
