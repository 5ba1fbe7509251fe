// SPDX-License-Identifier: Apache-2.0
#include "riprap/wave/wave_analysis.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace riprap::wave {

std::vector<ZeroCrossingWave> zero_crossing_waves(std::span<const double> time, std::span<const double> elevation) {
    std::vector<ZeroCrossingWave> waves;
    const std::size_t n = std::min(time.size(), elevation.size());
    if (n < 3) {
        return waves;
    }
    const double mean = std::accumulate(elevation.begin(), elevation.end(), 0.0) / static_cast<double>(n);
    double start = 0, crest = 0, trough = 0;
    bool is_inside = false;
    for (std::size_t i = 1; i < n; ++i) {
        const double before = elevation[i - 1] - mean, now = elevation[i] - mean;
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

namespace {

/// Solves a 3 x 3 system by Cramer's rule.
std::array<double, 3> solve(const std::array<std::array<double, 3>, 3>& m, const std::array<double, 3>& b) {
    const auto det = [](const std::array<std::array<double, 3>, 3>& a) {
        return a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1]) - a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0]) +
               a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]);
    };
    const double whole = det(m);
    std::array<double, 3> x{};
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

std::complex<double> harmonic(std::span<const double> time, std::span<const double> elevation,
                              double angular_frequency) {
    std::array<std::array<double, 3>, 3> normal{};
    std::array<double, 3> right{};
    const std::size_t n = std::min(time.size(), elevation.size());
    for (std::size_t i = 0; i < n; ++i) {
        const double angle = angular_frequency * time[i];
        const std::array<double, 3> base{1.0, std::cos(angle), std::sin(angle)};
        for (std::size_t r = 0; r < 3; ++r) {
            right[r] += base[r] * elevation[i];
            for (std::size_t c = 0; c < 3; ++c) {
                normal[r][c] += base[r] * base[c];
            }
        }
    }
    const std::array<double, 3> fit = solve(normal, right);
    return {fit[1], fit[2]};  // Re((a + ib) exp(-iwt)) = a cos wt + b sin wt
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
    if (!(determinant > 1e-6 * count * count)) {
        const double none = std::numeric_limits<double>::quiet_NaN();
        return {none, none, none};
    }
    const double incident = std::abs(count * with_incident - std::conj(twice) * with_reflected) / determinant;
    const double reflected = std::abs(count * with_reflected - twice * with_incident) / determinant;
    return {incident, reflected, reflected / incident};
}

}  // namespace riprap::wave
