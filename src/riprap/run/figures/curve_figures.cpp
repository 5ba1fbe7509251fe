// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numeric>

#include "riprap/run/figures/running_figures.hpp"
#include "riprap/sim/column_group.hpp"
#include "riprap/sim/model.hpp"

namespace riprap::run {

namespace {

/// Returns the constant that makes the error least: the middle of the extremes, the median or the mean [their unit].
double best_shift(std::vector<double> differences, const std::string& how) {
    if (how == "worst") {
        const auto [low, high] = std::minmax_element(differences.begin(), differences.end());
        return 0.5 * (*low + *high);
    }
    if (how == "mean_error") {
        const auto middle = differences.begin() + static_cast<std::ptrdiff_t>(differences.size() / 2);
        std::nth_element(differences.begin(), middle, differences.end());
        return *middle;
    }
    return std::accumulate(differences.begin(), differences.end(), 0.0) / static_cast<double>(differences.size());
}

}  // namespace

void look_at_curve(RunningFigures& f, std::vector<double>& met, const sim::ExpectCurve& curve, double along,
                   double value) {
    constexpr double forgiven = 1e-9;  // of a step: the end of a run may miss the last point by round-off
    const double before = f.previous_trigger, reached = along + forgiven * (along - before);
    for (std::size_t i = 0; i < met.size(); ++i) {
        const double point = curve.along[i];
        if (!std::isnan(met[i])) {
            continue;
        }
        if (along == point) {
            met[i] = value;
        } else if (!std::isnan(before) && (before < point) != (reached < point)) {
            met[i] = between(f, value, before, along, point);
        }
    }
    f.previous_trigger = along;
}

void look_at_profile(RunningFigures& f, std::vector<double>& met, const sim::Expect& expect,
                     const sim::Profile& profile, const sim::Moment& moment) {
    constexpr double forgiven = 1e-9;  // of a step: the end of a run may miss the time by round-off
    constexpr double ahead = 4;        // steps that may grow meanwhile
    const double time = moment.state.time, step = f.count > 0 ? time - f.previous_time : 0;
    const bool is_over = f.count > 0 && f.previous_time >= expect.at;
    if (!is_over && (f.count == 0 || time + ahead * step >= expect.at)) {
        const double share =
            time + forgiven * step >= expect.at && f.count > 0 ? (expect.at - f.previous_time) / step : 1;
        for (std::size_t i = 0; i < met.size(); ++i) {
            const double now = evaluate(profile, expect.curve.along[i], moment);
            met[i] = share < 1 && !std::isnan(met[i]) ? met[i] + share * (now - met[i]) : now;
        }
    }
    add(f, time, 0);
}

double error_of(const std::vector<double>& met, const sim::ExpectCurve& curve, const std::string& how) {
    std::vector<double> differences;
    for (std::size_t i = 0; i < met.size(); ++i) {
        differences.push_back(met[i] - curve.value[i]);
        if (std::isnan(differences.back())) {
            return missing;
        }
    }
    const double shift = std::clamp(best_shift(differences, how), -curve.shift, curve.shift);
    double sum = 0, square = 0, largest = 0;
    for (const double difference : differences) {
        const double error = std::abs(difference - shift);
        sum += error;
        square += error * error;
        largest = std::max(largest, error);
    }
    const auto count = static_cast<double>(differences.size());
    return how == "worst" ? largest : how == "mean_error" ? sum / count : std::sqrt(square / count);
}

}  // namespace riprap::run
