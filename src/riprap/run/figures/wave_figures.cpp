// SPDX-License-Identifier: Apache-2.0
// Figures of records that swing.
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstring>

#include "riprap/run/figures/running_figures.hpp"
#include "riprap/sim/column_group.hpp"
#include "riprap/sim/model.hpp"
#include "riprap/wave/wave_analysis.hpp"

namespace riprap::run {

void look_at_noise(std::vector<double>& numbers, double value) {
    const auto [a, b, c, d] = std::array{numbers[0], numbers[1], numbers[2], numbers[3]};
    numbers[5] = std::isnan(numbers[5]) ? std::abs(value) : std::max(numbers[5], std::abs(value));
    const double smooth = (-a + 4 * b + 4 * d - value) / 6;  // of the cubic, at the place of c
    if (!std::isnan(a)) {
        numbers[4] = std::isnan(numbers[4]) ? std::abs(c - smooth) : std::max(numbers[4], std::abs(c - smooth));
    }
    numbers[0] = b;
    numbers[1] = c;
    numbers[2] = d;
    numbers[3] = value;
}

double noise_of(const std::vector<double>& numbers) { return numbers[4] / numbers[5]; }

namespace {

constexpr std::size_t numbers_each = wave_numbers;
static_assert(sizeof(wave::HarmonicSums) == numbers_each * sizeof(double));

wave::HarmonicSums sums_of(const std::vector<double>& sums, std::size_t gauge) {
    wave::HarmonicSums all;
    std::memcpy(static_cast<void*>(&all), sums.data() + gauge * numbers_each, sizeof all);
    return all;
}

}  // namespace

void look_at_waves(std::vector<double>& sums, const sim::Expect& expect, const sim::Profile& profile,
                   const sim::Moment& moment) {
    const double time = moment.state.time;
    if (time < expect.from || time > expect.to) {
        return;
    }
    for (std::size_t g = 0; g < profile.columns.size(); ++g) {
        wave::HarmonicSums all = sums_of(sums, g);
        all.add(2 * M_PI / expect.wave_period * time, sim::evaluate({{}, {profile.columns[g]}}, moment));
        std::memcpy(sums.data() + g * numbers_each, &all, sizeof all);
    }
}

double waves_of(const std::vector<double>& sums, const sim::Expect& expect, const sim::Profile& profile) {
    std::vector<std::complex<double>> amplitudes;
    for (std::size_t g = 0; g < profile.place.size(); ++g) {
        amplitudes.push_back(sums_of(sums, g).amplitude());
    }
    const wave::Separation parts = wave::separate_reflection(profile.place, amplitudes, 2 * M_PI / expect.wave_length);
    return expect.reduce == "incident" ? parts.incident : parts.reflection;
}

}  // namespace riprap::run
