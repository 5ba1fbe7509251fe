// SPDX-License-Identifier: Apache-2.0
#include "riprap/wave/record_spectrum.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace riprap::wave {
namespace {

constexpr double g = 9.81;

struct Record {
    std::vector<double> time, level;
};

Record record_of(const IrregularWave& sea, double duration, double step) {
    Record record;
    for (double t = 0; t < duration; t += step) {
        record.time.push_back(t);
        record.level.push_back(1 + sea.elevation(0, t));
    }
    return record;
}

TEST(RecordSpectrum, ASineHasItsPeriodAndItsVariance) {
    Record record;
    for (int i = 0; i < 3000; ++i) {
        record.time.push_back(0.02 * i + (i % 3) * 0.004);  // rows unevenly apart
        record.level.push_back(0.05 * std::sin(2 * std::numbers::pi * record.time.back() / 1.7));
    }
    record.level[100] = std::numeric_limits<double>::quiet_NaN();
    const Spectrum spectrum = spectrum_of(record.time, record.level, 1);
    // Frequencies are 1/60 s apart: a line of a spectrum is told to half of that.
    EXPECT_NEAR(1 / weighted_peak_period(spectrum), 1 / 1.7, 0.5 / 60);
    double variance = 0;
    for (const double density : spectrum.density) {
        variance += density * (spectrum.frequency[1] - spectrum.frequency[0]);
    }
    EXPECT_NEAR(variance, 0.05 * 0.05 / 2, 2e-5);
}

TEST(RecordSpectrum, ASeaHasThePeakOfItsSpectrum) {
    const Record record = record_of(jonswap_sea(0.1, 2, 3.3, 0.6, g, 200, 5), 800, 0.05);
    EXPECT_NEAR(weighted_peak_period(spectrum_of(record.time, record.level, 10)), 2, 0.06);
}

TEST(RecordSpectrum, AShareOfTheWavesIsHigher) {
    std::vector<double> heights;
    for (int i = 1; i <= 100; ++i) {
        heights.push_back(0.01 * i);
    }
    const std::vector<Exceedance> found = exceedances(heights);
    ASSERT_EQ(found.size(), 6U);
    EXPECT_DOUBLE_EQ(found[0].height, 0.51);
    EXPECT_DOUBLE_EQ(found[2].height, 0.91);
    EXPECT_DOUBLE_EQ(found[5].height, 1.0);
    EXPECT_EQ(exceedances({1, 2, 3}).size(), 1U);  // of three waves none is one in ten
}

TEST(RecordSpectrum, OvertoppingAddsEventsAndTakesOffWhatGoesBack) {
    const std::vector<double> time{0, 1, 2, 3, 4, 5, 6, 7}, flow{0, 2, 0, -1, 0, 0, 4, 0};
    const Overtopping over = overtopping_of(time, flow);
    EXPECT_EQ(over.events, 2);
    EXPECT_DOUBLE_EQ(over.volume, 5);
    EXPECT_DOUBLE_EQ(over.mean, 5.0 / 7);
    EXPECT_DOUBLE_EQ(over.largest, 4);
    EXPECT_DOUBLE_EQ(over.at, 5);
}

}  // namespace
}  // namespace riprap::wave
