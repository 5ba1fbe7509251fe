// SPDX-License-Identifier: Apache-2.0
// Expected answers of records that swing: noise from step to step, waves that come and go.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "riprap/core/error.hpp"
#include "riprap/run/figures/running_figures.hpp"
#include "riprap/scene/read_case.hpp"
#include "riprap/wave/wave_analysis.hpp"

namespace riprap::run {
namespace {

using ::testing::HasSubstr;

double noise_in(const std::vector<double>& values) {
    std::vector<double> numbers(noise_numbers, missing);
    for (const double value : values) {
        look_at_noise(numbers, value);
    }
    return noise_of(numbers);
}

TEST(ExpectWaves, ACubicHasNoNoiseAndOneStepBesideItHasItsOwn) {
    std::vector<double> values;
    for (int i = 0; i < 12; ++i) {
        values.push_back(3 - 0.7 * i + 0.2 * i * i + 0.01 * i * i * i);
    }
    EXPECT_NEAR(noise_in(values), 0, 1e-14);
    const double largest = values.back();
    values[6] += 0.5;
    EXPECT_NEAR(noise_in(values), 0.5 * 1 / largest, 1e-12) << "of the step itself; two thirds of it beside";
    EXPECT_TRUE(std::isnan(noise_in({1, 2, 3, 4}))) << "too few";
}

TEST(ExpectWaves, SumsTakenRowByRowGiveTheHarmonicOfTheRecord) {
    const double omega = 1.7;
    std::vector<double> time, level;
    wave::HarmonicSums sums;
    for (int i = 0; i < 300; ++i) {
        time.push_back(0.031 * i);
        level.push_back(0.4 + 0.2 * std::cos(omega * time.back()) - 0.1 * std::sin(omega * time.back()) +
                        0.01 * (i % 3));
        sums.add(omega * time.back(), level.back());
    }
    const std::complex<double> amplitude = sums.amplitude();
    EXPECT_EQ(amplitude, wave::harmonic(time, level, omega));
    EXPECT_NEAR(amplitude.real(), 0.2, 1e-3);
    EXPECT_NEAR(amplitude.imag(), -0.1, 1e-3);
}

/// Problems of a flume with a profile of levels and one expected answer.
std::vector<std::string> problems_of(const std::string& expect) {
    const std::string flume = R"(
dimension = 2
gravity = [0.0, -9.81]
end = 1.0
[fluid]
method = "grid"
spacing = 0.1
domain = { low = [0.0, 0.0], high = [4.0, 1.0] }
[[fluid.region]]
box = { low = [0.0, 0.0], high = [4.0, 0.5] }
[[output.gauge]]
name = "level"
kind = "level"
point = [1.0, 0.0]
end = [2.0, 0.0]
count = 3
[[expect]]
name = "a"
value = 0.0
tolerance = 1.0
citation = "test"
)";
    std::vector<std::string> found;
    try {
        scene::read_case_text(flume + expect, "case.toml", ".");
    } catch (const CaseError& error) {
        for (const Diagnostic& problem : error.problems()) {
            found.push_back(to_string(problem));
        }
    }
    return found;
}

TEST(ExpectWaves, WavesAreAskedForWithTheirPeriodAndOfAProfile) {
    const std::string waves = "waves = { period = 1.0, length = 1.5 }\n";
    EXPECT_THAT(problems_of("quantity = 'level'\nreduce = 'reflection'\n" + waves), ::testing::IsEmpty());
    EXPECT_THAT(problems_of("quantity = 'level'\nreduce = 'incident'\n"),
                ::testing::ElementsAre(HasSubstr("case.toml:17:1: 'waves' goes with reduce")));
    EXPECT_THAT(problems_of("quantity = 'level_1'\nreduce = 'max'\n" + waves),
                ::testing::ElementsAre(HasSubstr("'waves' goes with reduce")));
    EXPECT_THAT(problems_of("quantity = 'level_1'\nreduce = 'incident'\n" + waves),
                ::testing::ElementsAre(HasSubstr("there is no profile 'level_1'")));
    EXPECT_THAT(problems_of("quantity = 'level'\nreduce = 'incident'\nrelative_to = 'level_1'\n" + waves),
                ::testing::ElementsAre(HasSubstr("'relative_to' says nothing of a profile")));
}

}  // namespace
}  // namespace riprap::run
