// SPDX-License-Identifier: Apache-2.0
#include "riprap/wave/wave_analysis.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace riprap::wave {

namespace {

/// Mean over time by the trapezoidal rule; rows need not be equally far apart, those that are not a number are left
/// out.
template <class Value>
double mean_over(std::span<const double> time, std::size_t n, const Value& value) {
    double integral = 0, duration = 0;
    for (std::size_t i = 1; i < n; ++i) {
        const double middle = 0.5 * (value(i - 1) + value(i));
        if (!std::isnan(middle)) {
            integral += middle * (time[i] - time[i - 1]);
            duration += time[i] - time[i - 1];
        }
    }
    return integral / duration;
}

}  // namespace

std::vector<ZeroCrossingWave> zero_crossing_waves(std::span<const double> time, std::span<const double> elevation) {
    std::vector<ZeroCrossingWave> waves;
    const std::size_t n = std::min(time.size(), elevation.size());
    if (n < 3) {
        return waves;
    }
    const double mean = mean_over(time, n, [&](std::size_t i) { return elevation[i]; });
    double start = 0, crest = 0, trough = 0;
    bool is_inside = false;
    for (std::size_t i = 1; i < n; ++i) {
        const double before = elevation[i - 1] - mean, now = elevation[i] - mean;
        is_inside = is_inside && !std::isnan(now);
        if (before < 0 && now >= 0) {
            const double crossing = time[i - 1] + (time[i] - time[i - 1]) * before / (before - now);
            if (is_inside) {
                waves.push_back({start, crossing - start, crest - trough, crest});
            }
            start = crossing;
            crest = trough = now;
            is_inside = true;
        }
        crest = std::max(crest, now);
        trough = std::min(trough, now);
    }
    return waves;
}

WaveStatistics statistics_of(std::span<const double> time, std::span<const double> elevation) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    WaveStatistics result{none, 0, none, none, none, none, none, none};
    const std::size_t n = std::min(time.size(), elevation.size());
    if (n < 2) {
        return result;
    }
    const double mean = mean_over(time, n, [&](std::size_t i) { return elevation[i]; });
    const auto square = [&](std::size_t i) { return (elevation[i] - mean) * (elevation[i] - mean); };
    result.mean_level = mean;
    result.spectral_height = 4 * std::sqrt(mean_over(time, n, square));
    std::vector<ZeroCrossingWave> waves = zero_crossing_waves(time, elevation);
    result.count = static_cast<std::int64_t>(waves.size());
    if (waves.empty()) {
        return result;
    }
    std::sort(waves.begin(), waves.end(), [](const auto& a, const auto& b) { return a.height > b.height; });
    const auto average = [&](std::size_t count, double ZeroCrossingWave::*what) {
        double sum = 0;
        for (std::size_t i = 0; i < count; ++i) {
            sum += waves[i].*what;
        }
        return sum / static_cast<double>(count);
    };
    const std::size_t third = std::max<std::size_t>(1, waves.size() / 3);
    result.highest = waves.front().height;
    result.mean_height = average(waves.size(), &ZeroCrossingWave::height);
    result.mean_period = average(waves.size(), &ZeroCrossingWave::period);
    result.significant_height = average(third, &ZeroCrossingWave::height);
    result.significant_period = average(third, &ZeroCrossingWave::period);
    return result;
}

namespace {

/// Solves a 3 x 3 system by Cramer's rule; no numbers where its determinant is below `least`.
std::array<double, 3> solve(const std::array<std::array<double, 3>, 3>& m, const std::array<double, 3>& b,
                            double least) {
    const auto det = [](const std::array<std::array<double, 3>, 3>& a) {
        return a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1]) - a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0]) +
               a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]);
    };
    const double whole = det(m), none = std::numeric_limits<double>::quiet_NaN();
    std::array<double, 3> x{none, none, none};
    if (!(whole >= least)) {
        return x;
    }
    for (std::size_t c = 0; c < 3; ++c) {
        auto column = m;
        for (std::size_t r = 0; r < 3; ++r) {
            column[r][c] = b[r];
        }
        x[c] = det(column) / whole;
    }
    return x;
}

}  // namespace

void HarmonicSums::add(double angle, double elevation) {
    if (std::isnan(elevation)) {
        return;
    }
    const double c = std::cos(angle), s = std::sin(angle);
    rows += 1;
    cosine += c;
    sine += s;
    cosine_square += c * c;
    product += c * s;
    sine_square += s * s;
    value += elevation;
    with_cosine += c * elevation;
    with_sine += s * elevation;
}

std::complex<double> HarmonicSums::amplitude() const {
    const std::array<std::array<double, 3>, 3> normal{
        {{rows, cosine, sine}, {cosine, cosine_square, product}, {sine, product, sine_square}}};
    constexpr double share = 0.01;  // of the determinant of many whole periods, n^3/4
    const std::array<double, 3> fit =
        solve(normal, {value, with_cosine, with_sine}, std::max(1.0, share * 0.25 * rows * rows * rows));
    return {fit[1], fit[2]};  // Re((a + ib) exp(-iwt)) = a cos wt + b sin wt
}

std::complex<double> harmonic(std::span<const double> time, std::span<const double> elevation,
                              double angular_frequency) {
    HarmonicSums sums;
    for (std::size_t i = 0; i < std::min(time.size(), elevation.size()); ++i) {
        sums.add(angular_frequency * time[i], elevation[i]);
    }
    return sums.amplitude();
}

Separation separate_reflection(std::span<const double> place, std::span<const std::complex<double>> amplitude,
                               double wave_number) {
    using Complex = std::complex<double>;
    const std::size_t n = std::min(place.size(), amplitude.size());
    Complex twice{}, with_incident{}, with_reflected{};
    for (std::size_t m = 0; m < n; ++m) {
        const Complex forward = std::polar(1.0, wave_number * place[m]);
        twice += forward * forward;
        with_incident += std::conj(forward) * amplitude[m];
        with_reflected += forward * amplitude[m];
    }
    // Normal equations: n I + conj(twice) R = with_incident;  twice I + n R = with_reflected.
    const auto count = static_cast<double>(n);
    const double determinant = count * count - std::norm(twice);
    constexpr double least = 0.0955;  // sin^2(2 pi 0.05)
    if (!(determinant >= least * count * count)) {
        const double none = std::numeric_limits<double>::quiet_NaN();
        return {none, none, none, none};
    }
    const Complex incident = (count * with_incident - std::conj(twice) * with_reflected) / determinant;
    const Complex reflected = (count * with_reflected - twice * with_incident) / determinant;
    double left = 0;
    for (std::size_t m = 0; m < n; ++m) {
        const Complex forward = std::polar(1.0, wave_number * place[m]);
        left += std::norm(amplitude[m] - incident * forward - reflected * std::conj(forward));
    }
    return {std::abs(incident), std::abs(reflected), std::abs(reflected) / std::abs(incident),
            std::sqrt(left / count) / std::abs(incident)};
}

}  // namespace riprap::wave
