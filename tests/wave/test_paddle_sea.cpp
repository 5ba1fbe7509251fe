// SPDX-License-Identifier: Apache-2.0
#include "riprap/wave/paddle_sea.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "riprap/wave/linear_wave.hpp"
#include "riprap/wave/wave_maker.hpp"

namespace riprap::wave {
namespace {

constexpr double g = 9.81;

IrregularWave::Component component(double amplitude, double period, double depth, double phase = 0) {
    const double omega = 2 * std::numbers::pi / period;
    return {amplitude, omega, wave_number(omega, depth, g), phase};
}

/// Amplitude of a paddle at a frequency.
std::complex<double> at(const std::vector<StrokeHarmonic>& stroke, double omega) {
    std::complex<double> sum = 0;
    for (const StrokeHarmonic& one : stroke) {
        sum += std::abs(one.angular_frequency - omega) < 1e-9 * omega ? one.amplitude : 0;
    }
    return sum;
}

// Madsen's solution is the limit in shallow water; it leaves out evanescent modes.
TEST(PaddleSea, TheFreeSecondHarmonicOfOneWaveIsCancelledAsByMadsenInShallowWater) {
    for (const auto& [kd, tolerance] : {std::pair{0.1, 2e-4}, std::pair{0.3, 6e-3}, std::pair{0.5, 0.05}}) {
        const double depth = 1, omega = std::sqrt(g * kd * std::tanh(kd));
        const IrregularWave sea{depth, {component(0.025, 2 * std::numbers::pi / omega, depth)}};
        const std::complex<double> second = at(second_order_stroke(sea, g), 2 * omega);
        const double madsen = second_harmonic_stroke(linear_wave(0.05, 2 * std::numbers::pi / omega, depth, g));
        EXPECT_NEAR(second.imag() / -madsen, 1, tolerance) << "kd = " << kd;  // S_2 sin 2wt = Re(-i S_2 exp(2iwt))
        EXPECT_NEAR(second.real() / madsen, 0, tolerance) << "kd = " << kd;
    }
}

TEST(PaddleSea, ALaterSeaIsMadeByTheSameWayLater) {
    const double delay = 0.37;
    IrregularWave sea{0.4, {component(0.02, 1.9, 0.4, 0.3), component(0.03, 2.1, 0.4, 1.1)}}, later = sea;
    for (IrregularWave::Component& c : later.components) {
        c.phase += c.angular_frequency * delay;
    }
    for (const auto& [now, then] : {std::pair{first_order_stroke(sea), first_order_stroke(later)},
                                    std::pair{second_order_stroke(sea, g), second_order_stroke(later, g)}}) {
        ASSERT_EQ(now.size(), then.size());
        for (std::size_t i = 0; i < now.size(); ++i) {
            const auto turned = now[i].amplitude * std::polar(1.0, -now[i].angular_frequency * delay);
            EXPECT_LT(std::abs(then[i].amplitude - turned), 1e-12 * std::abs(turned) + 1e-18);
        }
    }
}

// Groups long against the depth carry a bound wave, eta_b = -S_xx/(rho (g d - c_g^2)) by the momentum of slowly varying
// waves [LonguetHiggins1962]; the paddle displaces its flow, c_g eta_b. Eight evanescent modes leave an error of 2.5 %,
// twenty of 1 %.
TEST(PaddleSea, LongWavesOfGroupsAreThoseOfTheirRadiationStress) {
    const double depth = 0.5, a = 0.01, omega = 2 * std::numbers::pi / 1.4, split = 1e-3;
    const IrregularWave sea{depth,
                            {component(a, 2 * std::numbers::pi / (omega * (1 + split)), depth),
                             component(a, 2 * std::numbers::pi / (omega * (1 - split)), depth)}};
    const double slow = 2 * split * omega;
    const LinearWave wave = linear_wave(2 * a, 1.4, depth, g);
    const double n = wave.group_velocity() / wave.celerity();
    // E = rho g a^2 (1 + cos(slow t)): its amplitude over rho.
    const double energy = g * a * a, stress = energy * (2 * n - 0.5), c_g = wave.group_velocity();
    const double bound = -stress / (g * depth - c_g * c_g);
    const std::complex<double> way = at(second_order_stroke(sea, g), slow);
    EXPECT_NEAR(std::abs(way) * slow * depth / std::abs(c_g * bound), 1, 0.03);
}

TEST(PaddleSea, RowsOfTheWayHaveItsRate) {
    const IrregularWave sea = jonswap_sea(0.06, 1.5, 3.3, 0.5, g, 40, 7);
    std::vector<StrokeHarmonic> stroke = first_order_stroke(sea);
    const auto second = second_order_stroke(sea, g);
    stroke.insert(stroke.end(), second.begin(), second.end());
    const MotionSeries series = series_of(stroke, 3.0, 0.005, 20);
    EXPECT_EQ(series.value.front(), 0);
    EXPECT_EQ(series.rate.front(), 0);
    EXPECT_GE(series.time.back(), 20);
    double worst = 0, fastest = 0;
    for (std::size_t i = 1; i + 1 < series.time.size(); ++i) {
        const double rate = (series.value[i + 1] - series.value[i - 1]) / (series.time[i + 1] - series.time[i - 1]);
        worst = std::max(worst, std::abs(rate - series.rate[i]));
        fastest = std::max(fastest, std::abs(series.rate[i]));
    }
    EXPECT_LT(worst, 2e-3 * fastest);
}

TEST(Spectrum, ASeaOfPointsHasTheirHeightAndFrequencies) {
    Spectrum points;
    for (int i = 0; i <= 500; ++i) {
        points.frequency.push_back(0.25 + 0.0025 * i);
        points.density.push_back(jonswap_density(points.frequency.back(), 0.1, 2, 3.3));
    }
    EXPECT_NEAR(points.significant_height(), 0.1, 1e-4);
    EXPECT_NEAR(points.peak_period(), 2, 1e-9);
    const IrregularWave sea = sea_of(points, 0.5, g, 100, 3), known = jonswap_sea(0.1, 2, 3.3, 0.5, g, 100, 3);
    ASSERT_EQ(sea.components.size(), known.components.size());
    for (std::size_t i = 0; i < sea.components.size(); ++i) {
        EXPECT_NEAR(sea.components[i].angular_frequency / known.components[i].angular_frequency, 1, 1e-3);
        EXPECT_EQ(sea.components[i].phase, known.components[i].phase);
    }
}

}  // namespace
}  // namespace riprap::wave
