// SPDX-License-Identifier: Apache-2.0
#include "riprap/wave/record_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "riprap/wave/wave_analysis.hpp"

namespace riprap::wave {

namespace {

constexpr double tapered = 0.1;  ///< of the record at either end
constexpr double highest = 6;    ///< frequencies looked at, over the mean of zero crossings
constexpr std::size_t most_rows = 1U << 15U;

/// Rows evenly apart, those that are not a number bridged.
std::vector<double> even_rows(std::span<const double> time, std::span<const double> elevation, std::size_t count) {
    std::vector<double> rows;
    const double step = (time.back() - time.front()) / static_cast<double>(count);
    std::size_t a = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double t = time.front() + (static_cast<double>(i) + 0.5) * step;
        while (a + 2 < time.size() && time[a + 1] <= t) {
            ++a;
        }
        rows.push_back(elevation[a] + (t - time[a]) / (time[a + 1] - time[a]) * (elevation[a + 1] - elevation[a]));
    }
    return rows;
}

/// Takes off the mean and fades both ends in and out.
void taper(std::vector<double>& rows) {
    double mean = 0;
    for (const double row : rows) {
        mean += row / static_cast<double>(rows.size());
    }
    const double edge = tapered * static_cast<double>(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double from = std::min(static_cast<double>(i), static_cast<double>(rows.size() - 1 - i)) + 0.5;
        const double share = from < edge ? 0.5 * (1 - std::cos(std::numbers::pi * from / edge)) : 1;
        rows[i] = share * (rows[i] - mean);
    }
}

/// |sum of rows exp(-2 pi i j n/count)|^2
double power(const std::vector<double>& rows, std::size_t j) {
    const std::complex<double> turn =
        std::polar(1.0, -2 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(rows.size()));
    std::complex<double> sum = 0, now = 1;
    for (const double row : rows) {
        sum += row * now;
        now *= turn;
    }
    return std::norm(sum);
}

}  // namespace

Spectrum spectrum_of(std::span<const double> time, std::span<const double> elevation, int bands) {
    std::vector<double> t, level;
    for (std::size_t i = 0; i < std::min(time.size(), elevation.size()); ++i) {
        if (std::isfinite(elevation[i])) {
            t.push_back(time[i]);
            level.push_back(elevation[i]);
        }
    }
    constexpr std::size_t least = 16;
    const WaveStatistics waves = statistics_of(t, level);
    if (t.size() < least || !(waves.mean_period > 0)) {
        return {};
    }
    std::vector<double> rows = even_rows(t, level, std::min(t.size(), most_rows));
    taper(rows);
    const double duration = t.back() - t.front();
    const auto last = std::min(rows.size() / 2, static_cast<std::size_t>(highest * duration / waves.mean_period));
    Spectrum spectrum;
    const auto width = static_cast<std::size_t>(std::max(1, bands));
    double sum = 0;
    for (std::size_t j = 1; j + width <= last + 1; j += width) {
        double mean = 0;
        for (std::size_t k = 0; k < width; ++k) {
            mean += power(rows, j + k) / static_cast<double>(width);
        }
        spectrum.frequency.push_back((static_cast<double>(j) + 0.5 * static_cast<double>(width - 1)) / duration);
        spectrum.density.push_back(mean);
        sum += mean * static_cast<double>(width) / duration;
    }
    const double variance = waves.spectral_height * waves.spectral_height / 16;
    for (double& density : spectrum.density) {
        density *= sum > 0 ? variance / sum : 0;
    }
    return spectrum;
}

double weighted_peak_period(const Spectrum& spectrum) {
    const double largest =
        spectrum.is_empty() ? 0 : *std::max_element(spectrum.density.begin(), spectrum.density.end());
    if (!(largest > 0)) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    double weight = 0, moment = 0;
    for (std::size_t i = 0; i < spectrum.frequency.size(); ++i) {
        const double fourth = std::pow(spectrum.density[i] / largest, 4);
        weight += fourth;
        moment += fourth * spectrum.frequency[i];
    }
    return weight / moment;
}

std::vector<Exceedance> exceedances(std::vector<double> heights) {
    std::sort(heights.begin(), heights.end(), std::greater<>());
    std::vector<Exceedance> found;
    for (const double share : {0.5, 0.2, 0.1, 0.05, 0.02, 0.01}) {
        const double rank = share * static_cast<double>(heights.size());
        if (rank >= 1 - 1e-9) {
            found.push_back({share, heights[static_cast<std::size_t>(rank + 1e-9) - 1]});
        }
    }
    return found;
}

Overtopping overtopping_of(std::span<const double> time, std::span<const double> flow) {
    Overtopping found{0, 0, 0, 0, 0};
    double event = 0, begin = 0;
    const auto close = [&] {
        if (event > 0) {
            found.events += 1;
            if (event > found.largest) {
                found.largest = event;
                found.at = begin;
            }
        }
        event = 0;
    };
    for (std::size_t i = 1; i < time.size(); ++i) {
        const double share = 0.5 * (flow[i] + flow[i - 1]) * (time[i] - time[i - 1]);
        if (!std::isfinite(share)) {
            continue;
        }
        found.volume += share;
        if (share > 0) {
            begin = event > 0 ? begin : time[i - 1];
            event += share;
        } else {
            close();
        }
    }
    close();
    found.mean = time.size() > 1 ? found.volume / (time.back() - time.front()) : 0;
    return found;
}

}  // namespace riprap::wave
