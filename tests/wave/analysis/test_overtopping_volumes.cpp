// SPDX-License-Identifier: Apache-2.0
#include "riprap/wave/analysis/overtopping_volumes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace riprap::wave {
namespace {

double sum_of(const OvertoppingVolumes& found) {
    double sum = found.rest;
    for (const OvertoppingWave& wave : found.waves) {
        sum += wave.volume;
    }
    return sum;
}

TEST(OvertoppingVolumes, OfThreeTongues) {
    std::vector<double> time, flow;
    for (int i = 0; i <= 3000; ++i) {
        const double t = 0.01 * i;
        const auto tongue = [t](double begin, double size) {
            return t > begin && t < begin + 1 ? size * std::pow(std::sin(M_PI * (t - begin)), 2) : 0;
        };
        time.push_back(t);
        flow.push_back(tongue(4, 2) + tongue(5.2, 1) + tongue(15, 6) - tongue(17, 0.5));
    }
    const OvertoppingVolumes found = overtopping_volumes(time, flow, 2);
    ASSERT_EQ(found.waves.size(), 2U);  // the second tongue is of the first wave
    EXPECT_NEAR(found.waves[0].volume, 1.5, 1e-6);
    EXPECT_NEAR(found.waves[1].volume, 2.75, 1e-6);  // what flows back is of the wave that brought it
    EXPECT_NEAR(found.waves[1].begin, 15, 0.011);
    EXPECT_NEAR(found.largest(), 2.75, 1e-6);
    EXPECT_NEAR(found.total, 4.25, 1e-6);
    EXPECT_EQ(overtopping_volumes(time, flow, 1).waves.size(), 3U);
}

TEST(OvertoppingVolumes, AddUpToTheTotal) {
    std::mt19937_64 engine(2);
    std::normal_distribution<double> of(0.1, 1);
    std::vector<double> time, flow;
    for (int i = 0; i < 20000; ++i) {
        time.push_back(0.05 * i + 0.01 * (i % 3));
        flow.push_back(i % 977 == 5 ? std::nan("") : of(engine));
    }
    for (const double apart : {0.0, 0.5, 4.0}) {
        const OvertoppingVolumes found = overtopping_volumes(time, flow, apart);
        EXPECT_NEAR(sum_of(found), found.total, 1e-9 * std::abs(found.total)) << apart;
        EXPECT_GT(found.waves.size(), 100U);
    }
    EXPECT_EQ(overtopping_volumes(std::vector<double>{0}, std::vector<double>{1}, 1).total, 0);
}

}  // namespace
}  // namespace riprap::wave
