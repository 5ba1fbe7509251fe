// SPDX-License-Identifier: Apache-2.0
#include "riprap/wave/analysis/sea_statistics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "riprap/wave/analysis/even_record.hpp"
#include "riprap/wave/record_spectrum.hpp"

namespace riprap::wave {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Student's t that 95 % lie below, for 1 to 30 degrees of freedom; beyond that by Cornish and Fisher's expansion of
/// the normal one, whose error is below 1e-4 there.
double student(std::int64_t freedom) {
    constexpr std::array<double, 30> table{6.3138, 2.9200, 2.3534, 2.1318, 2.0150, 1.9432, 1.8946, 1.8595,
                                           1.8331, 1.8125, 1.7959, 1.7823, 1.7709, 1.7613, 1.7531, 1.7459,
                                           1.7396, 1.7341, 1.7291, 1.7247, 1.7207, 1.7171, 1.7139, 1.7109,
                                           1.7081, 1.7056, 1.7033, 1.7011, 1.6991, 1.6973};
    if (freedom <= std::ssize(table)) {
        return table[static_cast<std::size_t>(freedom - 1)];
    }
    constexpr double z = 1.6448536;
    const auto n = static_cast<double>(freedom);
    return z + (z * z * z + z) / (4 * n) + (5 * std::pow(z, 5) + 16 * z * z * z + 3 * z) / (96 * n * n);
}

}  // namespace

double mean_of_highest(std::vector<double> values, double count, double of) {
    if (values.empty()) {
        return none;
    }
    std::sort(values.begin(), values.end(), std::greater<>());
    const auto taken =
        std::max<std::size_t>(1, static_cast<std::size_t>(static_cast<double>(values.size()) * count / of + 1e-9));
    double sum = 0;
    for (std::size_t i = 0; i < taken; ++i) {
        sum += values[i] / static_cast<double>(taken);
    }
    return sum;
}

double exceeded_by(std::vector<double> values, double share, double of) {
    std::sort(values.begin(), values.end(), std::greater<>());
    const double rank = share * (of + 1);
    if (rank < 1 - 1e-9 || values.empty()) {
        return none;
    }
    const auto below = static_cast<std::size_t>(rank + 1e-9);
    if (below > values.size()) {
        return 0;  // fewer waves than the share have a value at all
    }
    if (below == values.size()) {
        return values.back();
    }
    return values[below - 1] + (rank - static_cast<double>(below)) * (values[below] - values[below - 1]);
}

double energy_period_of(std::span<const double> time, std::span<const double> elevation) {
    constexpr double faded = 0.05, lowest = 0.5, highest = 4;
    const double peak = weighted_peak_period(spectrum_of(time, elevation, 1));
    EvenRecord record = even_record(time, elevation, std::min<std::size_t>(time.size(), 1U << 15U));
    if (!std::isfinite(peak) || record.rows.empty()) {
        return none;
    }
    fade(record, faded);
    const double spacing = 1 / (record.step * static_cast<double>(record.rows.size()));
    double longer = 0, all = 0;
    for (double j = std::ceil(lowest / peak / spacing); j * spacing <= std::min(highest / peak, 0.25 / record.step);
         ++j) {
        const double square = std::norm(amplitude_of(record, 2 * std::numbers::pi * j * spacing));
        all += square;
        longer += square / (j * spacing);
    }
    return longer / all;
}

Confidence confidence_of(std::span<const double> samples) {
    double sum = 0, squares = 0;
    std::int64_t count = 0;
    for (const double one : samples) {
        if (std::isfinite(one)) {
            sum += one;
            ++count;
        }
    }
    const double mean = sum / static_cast<double>(count);
    for (const double one : samples) {
        squares += std::isfinite(one) ? (one - mean) * (one - mean) : 0;
    }
    if (count < 2) {
        return {count == 1 ? mean : none, none, none, count};
    }
    const auto n = static_cast<double>(count);
    const double reach = student(count - 1) * std::sqrt(squares / (n - 1) / n);
    return {mean, mean - reach, mean + reach, count};
}

std::vector<double> peaks_above(std::span<const double> values, double level) {
    std::vector<double> peaks;
    bool is_above = true;  // what the record begins with is cut
    for (const double value : values) {
        if (!(value > level)) {
            is_above = is_above && std::isnan(value);
        } else if (!is_above) {
            peaks.push_back(value);
            is_above = true;
        } else if (!peaks.empty()) {
            peaks.back() = std::max(peaks.back(), value);
        }
    }
    return peaks;
}

std::vector<double> separate_peaks(std::span<const double> time, std::span<const double> values, double period) {
    std::vector<double> peaks;
    const std::size_t n = std::min(time.size(), values.size());
    double last = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i + 1 < n; ++i) {
        if (!(values[i] >= values[i - 1] && values[i] > values[i + 1])) {
            continue;
        }
        if (time[i] - last >= period) {
            peaks.push_back(values[i]);
            last = time[i];
        } else if (values[i] > peaks.back()) {
            peaks.back() = values[i];
            last = time[i];
        }
    }
    return peaks;
}

}  // namespace riprap::wave
