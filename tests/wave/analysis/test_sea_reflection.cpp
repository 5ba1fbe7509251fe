// SPDX-License-Identifier: Apache-2.0
#include "riprap/wave/analysis/sea_reflection.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <utility>

#include "riprap/wave/analysis/sea_statistics.hpp"
#include "riprap/wave/irregular_wave.hpp"
#include "riprap/wave/linear_wave.hpp"
#include "riprap/wave/wave_analysis.hpp"

namespace riprap::wave {
namespace {

constexpr double g = 9.81, depth = 0.7, height = 0.12, peak = 1.6;

/// Second order of the sums of frequencies in deep water: 1/2 Re(sum a exp(i theta) sum k a exp(i theta)).
double bound(const IrregularWave& sea, double x, double t) {
    std::complex<double> first, second;
    for (const IrregularWave::Component& one : sea.components) {
        const std::complex<double> wave =
            std::polar(one.amplitude, one.wave_number * x - one.angular_frequency * t + one.phase);
        first += wave;
        second += one.wave_number * wave;
    }
    return 0.5 * (first * second).real();
}

struct Parts {
    double reflection{0}, noise{0};  ///< K_r; deviation over H_m0
    bool has_bound{false};
    double step{0.05}, duration{500};
};

/// A sea towards +x, and as much of it as `reflection` back again, delayed by its way to a wall and back.
SeaRecord sea_at(const std::vector<double>& place, const Parts& parts, std::uint64_t seed = 3) {
    const IrregularWave sea = jonswap_sea(height, peak, 3.3, depth, g, 100, seed);
    std::mt19937_64 engine(seed);
    std::normal_distribution<double> noise(0, parts.noise * height);
    SeaRecord record{{}, place, std::vector<std::vector<double>>(place.size()), depth, g};
    for (double t = 0; t < parts.duration; t += parts.step) {
        record.time.push_back(t);
        for (std::size_t m = 0; m < place.size(); ++m) {
            constexpr double way = 22;  // from the origin to the wall and back
            double level = sea.elevation(place[m], t) + parts.reflection * sea.elevation(way - place[m], t);
            level += parts.has_bound ? bound(sea, place[m], t) : 0;
            level += parts.noise > 0 ? noise(engine) : 0;
            record.levels[m].push_back(depth + level);
        }
    }
    return record;
}

const std::vector<double> three{2.0, 2.45, 3.25};

/// H_m0 of the sea towards +x alone at the first gauge over the times of a record, faded as the records are.
double incident_height(const SeaRecord& record, std::uint64_t seed = 3) {
    const IrregularWave sea = jonswap_sea(height, peak, 3.3, depth, g, 100, seed);
    std::vector<double> level;
    level.reserve(record.time.size());
    for (const double t : record.time) {
        level.push_back(sea.elevation(record.place[0], t));
    }
    EvenRecord even = even_record(record.time, level, record.time.size());
    const double weight = fade(even, 0.05);
    double square = 0;
    for (const double row : even.rows) {
        square += row * row / static_cast<double>(even.rows.size());
    }
    return 4 * std::sqrt(square / weight);
}

TEST(SeaReflection, ASeaIsTakenApart) {
    for (const double reflection : {0.0, 0.1, 0.9}) {
        const SeaRecord record = sea_at(three, {reflection});
        const SeaReflection found = reflect_sea(record);
        EXPECT_NEAR(found.coefficient, reflection, 0.01) << reflection;
        EXPECT_NEAR(found.incident_height / incident_height(record), 1, 0.01) << reflection;
        EXPECT_NEAR(found.reflected_height, reflection * found.incident_height, 0.01 * height) << reflection;
        EXPECT_NEAR(found.peak_period, peak, 0.03 * peak);
        EXPECT_LT(found.blind_share, 0.01);
        EXPECT_LT(found.noise, 1e-3);
    }
}

TEST(SeaReflection, NoiseAndBoundWavesLeaveReflectionAndHeight) {
    const std::vector<std::pair<double, bool>> seas{{0.0, true}, {0.0, false}, {0.35, true}, {0.9, true}};
    for (const auto& [reflection, has_bound] : seas) {
        const SeaRecord record = sea_at(three, {reflection, 0.02, has_bound});
        const SeaReflection found = reflect_sea(record);
        EXPECT_NEAR(found.coefficient, reflection, 0.02) << reflection << has_bound;
        EXPECT_NEAR(found.incident_height / incident_height(record), 1, 0.01) << reflection << has_bound;
        EXPECT_GT(found.noise, 1e-4);
    }
}

TEST(SeaReflection, FourGaugesAndAnotherSeedGiveTheSame) {
    const SeaRecord record = sea_at({2.0, 2.3, 2.9, 3.8}, {0.35, 0.02, true}, 17);
    const SeaReflection found = reflect_sea(record);
    EXPECT_NEAR(found.coefficient, 0.35, 0.02);
    EXPECT_NEAR(found.incident_height / incident_height(record, 17), 1, 0.01);
}

TEST(SeaReflection, CoarseAndUnevenRowsLoseNoHeight) {
    // Straight lines between rows an eighteenth of the peak period apart lost 1 % of it.
    SeaRecord record = sea_at(three, {0.35, 0, false, 0.085});
    EXPECT_NEAR(reflect_sea(record).incident_height / incident_height(record), 1, 0.01);
    const SeaRecord fine = sea_at(three, {0.35, 0, false, 0.02, 200});
    record = {{}, fine.place, std::vector<std::vector<double>>(3), depth, g};
    for (std::size_t i = 0; i < fine.time.size(); i += 3 + i % 2) {
        record.time.push_back(fine.time[i]);
        for (std::size_t m = 0; m < 3; ++m) {
            record.levels[m].push_back(fine.levels[m][i]);
        }
    }
    EXPECT_NEAR(reflect_sea(record).incident_height, reflect_sea(fine).incident_height, 0.003 * height);
}

TEST(SeaReflection, FrequenciesThatTheGaugesCannotTellApartAreNamed) {
    // Two gauges half a wave of 1.2 s apart, within the sea; a third that mends it.
    const double half = 0.5 * linear_wave(0, 1.2, depth, g).length();
    const SeaReflection two = reflect_sea(sea_at({2.0, 2.0 + half}, {0.35, 0.02}));
    ASSERT_FALSE(two.blind.empty());
    bool is_named = false;
    for (const BlindBand& band : two.blind) {
        is_named = is_named || (band.low < 1 / 1.2 && band.high > 1 / 1.2);
        if (band.low < 1 / 1.2 && band.high > 1 / 1.2) {
            EXPECT_NEAR(band.length, 2 * half, 0.1 * half);
            EXPECT_GT(band.share, 0.05);
        }
    }
    EXPECT_TRUE(is_named);
    EXPECT_NEAR(two.coefficient, 0.35, 0.02);  // of what is left
    EXPECT_GT(two.blind_share, 0.05);
    const SeaRecord third = sea_at({2.0, 2.0 + half, 2.0 + 0.4 * half}, {0.35, 0.02});
    const SeaReflection mended = reflect_sea(third);
    EXPECT_LT(mended.blind_share, 0.01);
    EXPECT_NEAR(mended.incident_height / incident_height(third), 1, 0.01);
}

TEST(SeaReflection, IncidentWavesHaveTheHeightsOfTheSeaWithoutItsEcho) {
    const SeaReflection found = reflect_sea(sea_at({2.0, 2.3, 2.8}, {0.6}));  // gauges that see all of the sea
    const EvenRecord& record = found.incident_record;
    const IrregularWave sea = jonswap_sea(height, peak, 3.3, depth, g, 100, 3);
    double square = 0, miss = 0;
    for (std::size_t i = 0; i < record.rows.size(); ++i) {
        const double level = sea.elevation(2.0, record.time(i));
        square += level * level;
        miss += (record.rows[i] - level) * (record.rows[i] - level);
    }
    EXPECT_LT(std::sqrt(miss / square), 0.06);
}

TEST(SeaReflection, WithoutWavesOrWithOneGaugeThereIsNothing) {
    EXPECT_TRUE(reflect_sea(sea_at({2.0}, {0.35})).is_empty());
    SeaRecord still = sea_at(three, {0.35});
    for (std::vector<double>& level : still.levels) {
        std::fill(level.begin(), level.end(), depth);
    }
    EXPECT_TRUE(reflect_sea(still).is_empty());
}

TEST(SeaStatistics, TheEnergyPeriodIsThatOfTheSpectrum) {
    const IrregularWave sea = jonswap_sea(height, peak, 3.3, depth, g, 300, 5);
    double all = 0, longer = 0;
    for (const IrregularWave::Component& one : sea.components) {
        all += one.amplitude * one.amplitude;
        longer += one.amplitude * one.amplitude * 2 * std::numbers::pi / one.angular_frequency;
    }
    const SeaRecord record = sea_at({0.0}, {});
    EXPECT_NEAR(energy_period_of(record.time, record.levels[0]), longer / all, 0.01 * longer / all);
    EXPECT_NEAR(longer / all, peak / 1.1, 0.03 * peak);  // of JONSWAP
}

TEST(SeaStatistics, TwoInAHundredWavesExceedTheirHeight) {
    std::vector<double> heights;
    for (int i = 1; i <= 999; ++i) {
        heights.push_back(std::sqrt(-std::log((1000 - i) / 1000.0) / 2));  // Rayleigh's, H/H_s
    }
    EXPECT_NEAR(exceeded_by(heights, 0.02, 999), 1.3986, 1e-3);  // sqrt(ln(50)/2)
    EXPECT_NEAR(mean_of_highest(heights, 1, 3), 1.0, 2e-3);
    EXPECT_NEAR(mean_of_highest(heights, 1, 250), 1.8, 0.03);  // Goda's 1.80 H_1/3
    EXPECT_TRUE(std::isnan(exceeded_by({1, 2, 3}, 0.02, 3)));
    EXPECT_EQ(exceeded_by({3, 2, 1}, 0.02, 999), 0);  // three of 999 waves run up at all
    EXPECT_EQ(exceeded_by({3, 2, 1}, 0.25, 3), 3);
}

TEST(SeaStatistics, NineOfTenBandsHoldTheMean) {
    std::mt19937_64 engine(1);
    std::normal_distribution<double> of(5, 2);
    int holds = 0;
    constexpr int trials = 4000;
    for (int i = 0; i < trials; ++i) {
        const std::vector<double> samples{of(engine), of(engine), of(engine), of(engine), of(engine)};
        const Confidence band = confidence_of(samples);
        holds += band.low < 5 && band.high > 5 ? 1 : 0;
    }
    EXPECT_NEAR(static_cast<double>(holds) / trials, 0.9, 0.015);
    EXPECT_TRUE(std::isnan(confidence_of(std::vector{1.0}).low));
    std::vector<double> many;
    for (int i = 0; i < 41; ++i) {
        many.push_back(i % 2);
    }
    const Confidence band = confidence_of(many);
    EXPECT_NEAR((band.high - band.mean) / std::sqrt(20.0 * 21 / 41 / 40 / 41), 1.6839, 2e-4);  // t of 40 degrees
}

TEST(SeaStatistics, PeaksAreOneAWave) {
    EXPECT_EQ(peaks_above(std::vector<double>{3, 2, -1, 1, 4, 2, 0, 5, -2}, 0), (std::vector<double>{4, 5}));
    const std::vector<double> time{0, 1, 2, 3, 4, 5, 6, 7, 8};
    EXPECT_EQ(separate_peaks(time, std::vector<double>{0, 2, 1, 3, 0, 0, 1, 0, 0}, 3), (std::vector<double>{3, 1}));
}

}  // namespace
}  // namespace riprap::wave
