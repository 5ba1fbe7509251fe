// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "riprap/wave/boussinesq_wave.hpp"
#include "riprap/wave/irregular_wave.hpp"
#include "riprap/wave/linear_wave.hpp"
#include "riprap/wave/second_order_wave.hpp"
#include "riprap/wave/steady_wave.hpp"

namespace riprap::wave {
namespace {

constexpr double g = 9.81;

/// Flow through a vertical at a distance from the crest [m^2/s], by Simpson's rule.
template <class Velocity>
double flow_through(const Velocity& velocity, double surface) {
    constexpr int n = 200;
    double sum = 0;
    for (int i = 0; i <= n; ++i) {
        sum += (i == 0 || i == n ? 1 : i % 2 == 1 ? 4 : 2) * velocity(surface * i / n);
    }
    return sum * surface / (3 * n);
}

TEST(SteadyWave, a_low_wave_is_that_of_linear_theory) {
    for (const double period : {1.2, 2.0, 6.0}) {
        const SteadyWave wave = regular_wave(1e-4, period, 0.5, g);
        EXPECT_NEAR(wave.celerity / linear_wave(1e-4, period, 0.5, g).celerity(), 1, 1e-4) << period;
        EXPECT_NEAR(wave.elevation(0), 0.5e-4, 1e-7);
    }
}

TEST(SteadyWave, a_steep_wave_has_one_pressure_and_no_flow_through_its_surface) {
    for (const auto& [height, period] : {std::pair{0.12, 1.2}, {0.15, 3.0}}) {
        const SteadyWave wave = regular_wave(height, period, 0.5, g, 24);
        EXPECT_NEAR(wave.elevation(0) - wave.elevation(0.5 * wave.length()), height, 1e-9);
        double low = 1e9, high = -1e9;
        for (double x = 0.013; x < 0.5 * wave.length(); x += 0.037) {
            const double eta = wave.elevation(x);
            const WaveVelocity v = wave.velocity(x, 0.5 + eta);
            const double u = v.along - wave.celerity;
            const double head = 0.5 * (u * u + v.up * v.up) / g + eta;
            low = std::min(low, head);
            high = std::max(high, head);
            const double slope = (wave.elevation(x + 1e-5) - wave.elevation(x - 1e-5)) / 2e-5;
            EXPECT_NEAR(v.up, u * slope, 1e-4);
        }
        EXPECT_NEAR(high - low, 0, 1e-4 * height);
    }
}

TEST(SteadyWave, a_stokes_wave_in_deep_water_runs_faster_by_half_the_square_of_its_steepness) {
    const SteadyWave wave = regular_wave(0.1, 1.0, 5, g);
    const double ak = 0.05 * wave.wave_number;
    EXPECT_NEAR(wave.celerity / std::sqrt(g / wave.wave_number), 1 + 0.5 * ak * ak, 0.2 * std::pow(ak, 3));
}

TEST(SteadyWave, a_solitary_wave_of_six_tenths_of_the_depth_carries_its_volume_at_its_own_speed) {
    const SteadyWave wave = solitary_wave(6, 10, g);
    EXPECT_NEAR(wave.elevation(0), 6, 1e-6);
    // series of c^2/(g d) in H/d to the ninth order [Fenton1972]
    double series = 1, power = 1;
    for (const double term :
         {1.0, -0.05, -0.0428571, -0.0342857, -0.0315195, -0.0292784, -0.0268451, -0.0302634, -0.0219347}) {
        power *= 0.6;
        series += term * power;
    }
    EXPECT_NEAR(wave.celerity / std::sqrt(g * 10 * series), 1, 5e-4);
    for (const double x : {0.0, 7.0, 20.0}) {
        const double surface = 10 + wave.elevation(x);
        const double flow = flow_through([&](double y) { return wave.velocity(x, y).along; }, surface);
        EXPECT_NEAR(flow / (wave.celerity * wave.elevation(x)), 1, 1e-4) << x;
    }
    EXPECT_NEAR(wave.elevation(110), 0, 1e-3);
}

TEST(SteadyWave, a_wave_that_cannot_be_is_refused_with_the_number_that_can) {
    EXPECT_THROW(solitary_wave(8, 10, g), NoSuchWave);
    EXPECT_THROW(regular_wave(0.4, 1.0, 0.5, g), NoSuchWave);
}

TEST(SecondOrderWave, differs_from_the_wave_of_all_orders_by_the_cube_of_its_height) {
    double before = 0;
    for (const double height : {0.04, 0.02}) {
        const SecondOrderWave wave = second_order_wave(height, 1.5, 0.5, g);
        const SteadyWave all = regular_wave(height, 1.5, 0.5, g);
        double error = 0;
        for (double phase = 0; phase < 6.2; phase += 0.1) {
            error = std::max(error, std::abs(wave.elevation(phase) - all.elevation(phase / all.wave_number)));
        }
        EXPECT_LT(error, 0.01 * height);
        if (before > 0) {
            EXPECT_NEAR(before / error, 8, 1.5);
        }
        before = error;
    }
}

TEST(SecondOrderWave, keeps_its_volume_from_bed_to_surface_to_its_order_and_is_refused_beyond_its_range) {
    const SecondOrderWave wave = second_order_wave(0.02, 1.5, 0.5, g);
    const double c = wave.first.celerity();
    const auto flow = [&](double phase) {
        return flow_through([&](double z) { return wave.velocity(phase, z).along; }, 0.5 + wave.elevation(phase));
    };
    // q(crest) - q(trough) = c (eta(crest) - eta(trough)) of a wave of permanent form
    EXPECT_NEAR((flow(0) - flow(M_PI)) / (c * (wave.elevation(0) - wave.elevation(M_PI))), 1, 2e-3);
    EXPECT_THROW(second_order_wave(0.2, 4.0, 0.5, g), NoSuchWave);
}

TEST(BoussinesqWave, under_the_crest_it_moves_more_water_than_its_volume_needs) {
    const SolitaryWave wave{6, 10, g};
    const double flow = flow_through([&](double y) { return boussinesq_velocity(wave, 0, y).along; }, 16);
    EXPECT_NEAR(flow / 16, 5.55, 0.01);
    EXPECT_NEAR(wave.mean_velocity(0), 4.70, 0.01);
    // eq. 6.3 is a divergence-free partner of eq. 6.2 to its order: w has the sign of -u_x
    EXPECT_GT(boussinesq_velocity(wave, 5, 8).up, 0);
}

TEST(IrregularWave, a_jonswap_sea_has_the_variance_of_its_significant_height) {
    const IrregularWave sea = jonswap_sea(2, 8, 3.3, 20, g, 200, 7);
    double sum = 0;
    for (const auto& c : sea.components) {
        sum += 0.5 * c.amplitude * c.amplitude;
    }
    EXPECT_NEAR(4 * std::sqrt(sum), 2, 1e-9);
    double integral = 0;
    for (double f = 0.5 / 8 + 1e-3; f < 3.0 / 8; f += 2e-3) {
        integral += 2e-3 * jonswap_density(f, 2, 8, 3.3);
    }
    EXPECT_NEAR(4 * std::sqrt(integral), 2, 0.01);
    EXPECT_EQ(jonswap_sea(2, 8, 3.3, 20, g, 200, 7).elevation(3, 5), sea.elevation(3, 5));
}

}  // namespace
}  // namespace riprap::wave
