// SPDX-License-Identifier: Apache-2.0
#include "riprap/wave/analysis/even_record.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace riprap::wave {

namespace {

/// Value at a time by the cubic through the two rows before and the two after it; by a straight line at the ends.
double between(const std::vector<double>& t, const std::vector<double>& v, std::size_t before, double now) {
    if (before == 0 || before + 2 >= t.size()) {
        return v[before] + (now - t[before]) / (t[before + 1] - t[before]) * (v[before + 1] - v[before]);
    }
    double sum = 0;
    for (std::size_t i = before - 1; i <= before + 2; ++i) {
        double weight = 1;
        for (std::size_t j = before - 1; j <= before + 2; ++j) {
            weight *= j == i ? 1 : (now - t[j]) / (t[i] - t[j]);
        }
        sum += weight * v[i];
    }
    return sum;
}

}  // namespace

EvenRecord even_record(std::span<const double> time, std::span<const double> values, std::size_t count) {
    std::vector<double> t, v;
    const std::size_t n = std::min(time.size(), values.size());
    for (std::size_t i = 0; i < n; ++i) {
        if (std::isfinite(values[i])) {
            t.push_back(time[i]);
            v.push_back(values[i]);
        }
    }
    if (t.size() < 2 || count < 2) {
        return {};
    }
    EvenRecord record{time.front(), (time[n - 1] - time.front()) / static_cast<double>(count - 1), {}};
    std::size_t a = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double now = std::clamp(record.time(i), t.front(), t.back());
        while (a + 2 < t.size() && t[a + 1] <= now) {
            ++a;
        }
        record.rows.push_back(between(t, v, a, now));
    }
    return record;
}

double fading(std::size_t row, std::size_t count, double share) {
    const double edge = share * static_cast<double>(count);
    const double from = std::min(static_cast<double>(row), static_cast<double>(count - 1 - row)) + 0.5;
    return from < edge ? 0.5 * (1 - std::cos(std::numbers::pi * from / edge)) : 1;
}

double fade(EvenRecord& record, double share) {
    const auto count = static_cast<double>(record.rows.size());
    double mean = 0, square = 0;
    for (const double row : record.rows) {
        mean += row / count;
    }
    for (std::size_t i = 0; i < record.rows.size(); ++i) {
        const double weight = fading(i, record.rows.size(), share);
        record.rows[i] = weight * (record.rows[i] - mean);
        square += weight * weight / count;
    }
    return square;
}

std::complex<double> amplitude_of(const EvenRecord& record, double angular_frequency) {
    const std::complex<double> turn = std::polar(1.0, angular_frequency * record.step);
    std::complex<double> sum = 0, now = std::polar(1.0, angular_frequency * record.start);
    for (const double row : record.rows) {
        sum += row * now;
        now *= turn;
    }
    return 2.0 * sum / static_cast<double>(record.rows.size());
}

}  // namespace riprap::wave
