// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "riprap/wave/linear_wave.hpp"
#include "riprap/wave/sea_absorption.hpp"
#include "riprap/wave/wave_maker.hpp"

namespace riprap::wave {
namespace {

using Complex = std::complex<double>;
constexpr double g = 9.81;
constexpr Complex i{0, 1};

TEST(SeaAbsorption, AWaveThatArrivesGoesBackAsTheFieldAtTheFaceSays) {
    const GaugedPaddle paddle{0.3, g, 0.1};
    const AbsorptionLaw law{5, 0.09, 0.1, 0, 0};
    for (const double w : {2.0, 4.0, 7.0}) {
        const double k = wave_number(w, 0.3, g);
        const LinearWave linear{0, 0.3, g, w, k};
        const double made = height_over_stroke(Paddle::piston, k * 0.3), standing = evanescent_elevation(linear, 0.1);
        // A wave of amplitude 1 and what a resting paddle reflects, then the paddle's way X: u = i w X.
        const Complex back = returned_by(law, paddle, w);
        const Complex x = (back - 1.0) / (i * made);
        const Complex eta = std::exp(i * (k * 0.1)) + back * std::exp(-i * (k * 0.1)) + standing * x;
        const Complex u = i * w * x;
        const Complex left =
            absorption_bend * law.delay * law.delay * (i * w) * (i * w) * u + law.delay * i * w * u + u;
        EXPECT_LT(std::abs(left + law.gain * eta + law.home * x), 1e-12 * std::abs(u) + 1e-12) << w;
    }
}

TEST(SeaAbsorption, AShallowPaddleWithoutADelayTakesUpLongWavesByTheRootOfGOverD) {
    const GaugedPaddle paddle{0.3, g, 1e-3};
    EXPECT_LT(std::abs(returned_by({std::sqrt(g / 0.3), 0, 0, 0, 0}, paddle, 0.2)), 2e-3);
}

TEST(SeaAbsorption, TheLawOfASeaReturnsLittleOfItAndNoWaveMuchHigherThanItCame) {
    for (const double period : {1.3, 1.6, 2.2}) {
        const IrregularWave sea = jonswap_sea(0.03, period, 3.3, 0.3, g, 100, 1);
        const GaugedPaddle paddle{0.3, g, 0.08};
        const double shortest = 2.5;
        const AbsorptionLaw law = absorption_of_sea(sea, paddle, 0.2 / period, shortest);
        EXPECT_LE(law.highest, most_returned) << period;
        EXPECT_LT(law.returned, 0.06) << period;
        EXPECT_GT(law.returned, 0) << period;
        double returned = 0;
        for (const IrregularWave::Component& c : sea.components) {
            returned += std::norm(returned_by(law, paddle, c.angular_frequency)) / 100;
        }
        EXPECT_NEAR(returned, law.returned, 1e-9) << period;
    }
}

TEST(SeaAbsorption, ADelayOfFirstOrderWouldReturnShortWavesHigherThanTheyCame) {
    // The reason for the second order: sqrt(g/d) with the surface read 0.1 m before the face, as for a single wave.
    const GaugedPaddle paddle{0.3, g, 0.1};
    const double k = 2 / paddle.distance, w = std::sqrt(g * k * std::tanh(k * 0.3));
    EXPECT_GT(std::abs(returned_by({std::sqrt(g / 0.3), 0, 0, 0, 0}, paddle, w)), 1.3);
}

TEST(SeaAbsorption, TheOwnSurfaceIsThatOfTheSeaAndItsEvanescentModes) {
    const IrregularWave sea = jonswap_sea(0.03, 1.6, 3.3, 0.3, g, 50, 3);
    const OwnSurface far(sea, {0.3, g, 3.0}, 0);  // ten depths: evanescent modes are gone
    for (const double t : {0.0, 1.7, 8.3}) {
        EXPECT_NEAR(far.elevation(t, 0.02), sea.elevation(3.02, t), 1e-9);
    }
    const OwnSurface ramped(sea, {0.3, g, 3.0}, 4);
    EXPECT_NEAR(ramped.elevation(2, 0), 0.5 * sea.elevation(3, 2), 1e-9);
    EXPECT_EQ(ramped.elevation(-1, 0), 0);
}

}  // namespace
}  // namespace riprap::wave
