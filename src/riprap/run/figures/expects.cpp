// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/figures/expects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "riprap/core/error.hpp"
#include "riprap/sim/reductions.hpp"

namespace riprap::run {

namespace {

constexpr std::size_t numbers_each = sizeof(RunningFigures) / sizeof(double);
constexpr std::size_t numbers_before_crossings = numbers_each - 3;  // in checkpoints of version 0.2

/// Tells whether the run lasts to the end of the window of an expected answer.
bool is_reached(const sim::Expect& expect, double end) {
    const sim::ExpectCurve& curve = expect.curve;
    const bool has_points = curve.quantity != "time" || curve.along.empty() ||
                            *std::max_element(curve.along.begin(), curve.along.end()) <= end;
    return has_points && expect.at <= end && expect.from <= end && (std::isinf(expect.to) || expect.to <= end);
}

/// Returns the unit of a quotient.
std::string unit_over(const std::string& above, const std::string& below) {
    return below == "-" ? above : above == below ? "-" : fmt::format("({})/({})", above, below);
}

/// Returns the unit of a reduced value.
std::string unit_of(const std::string& reduce, const std::string& unit) {
    return reduce == "period" ? "s" : reduce == "noise" || reduce == "reflection" ? "-" : unit;
}

/// Returns the numbers that an answer keeps beside its running figures, before the first value.
std::vector<double> numbers_of(const sim::Expect& expect, const std::optional<sim::Profile>& profile) {
    if (sim::is_of_waves(expect.reduce) && profile) {
        return std::vector<double>(profile->columns.size() * wave_numbers, 0.0);
    }
    return std::vector<double>(expect.reduce == "noise" ? noise_numbers : expect.curve.along.size(), missing);
}

Diagnostic problem_of(const sim::Expect& expect, std::string message, std::string allowed) {
    return {{expect.place, 0, 0}, "expect '" + expect.name + "': " + std::move(message), std::move(allowed)};
}

}  // namespace

ExpectWatch::ExpectWatch(const sim::Model& model) : model_(model), figures_(model.expects.size(), nothing_seen) {
    std::vector<Diagnostic> problems;
    for (const sim::Expect& expect : model.expects) {
        if (std::find(sim::reductions.begin(), sim::reductions.end(), expect.reduce) == sim::reductions.end()) {
            problems.push_back(problem_of(expect, "reduce = '" + expect.reduce + "' is unknown",
                                          fmt::format("one of {}", fmt::join(sim::reductions, ", "))));
        }
        const auto find = [&](const std::string& quantity) {
            std::optional<sim::ColumnGroup> column = sim::find_columns(model, quantity);
            if (!column) {
                problems.push_back(
                    problem_of(expect, "there is no quantity '" + quantity + "'",
                               "a column of a probe, a quantity of the scene, or body.quantity, vectors with .x, .y or "
                               ".z"));
            }
            return column.value_or(sim::ColumnGroup{{}, {{}}});
        };
        Columns columns;
        if (sim::is_of_waves(expect.reduce) ||
            (expect.curve.quantity == sim::along_profile && sim::is_of_curve(expect.reduce))) {
            columns.profile = sim::find_profile(model, expect.quantity);
        }
        columns.quantity =
            columns.profile ? sim::ColumnGroup{{}, {columns.profile->columns.front()}} : find(expect.quantity);
        columns.unit = sim::is_time(expect.reduce) ? "s" : columns.quantity.columns.front().unit;
        if (!expect.relative_to.empty()) {
            columns.relative_to = find(expect.relative_to);
        }
        if (!columns.profile && (expect.reduce == "when" || sim::is_of_curve(expect.reduce))) {
            columns.trigger = find(expect.reduce == "when" ? expect.when : expect.curve.quantity);
        }
        met_.push_back(numbers_of(expect, columns.profile));
        columns_.push_back(std::move(columns));
    }
    if (!problems.empty()) {
        throw CaseError(std::move(problems));
    }
}

void ExpectWatch::look(const sim::Moment& moment) {
    for (std::size_t i = 0; i < columns_.size(); ++i) {
        const sim::Expect& expect = model_.expects[i];
        if (sim::is_of_waves(expect.reduce)) {
            look_at_waves(met_[i], expect, *columns_[i].profile, moment);
            continue;
        }
        if (columns_[i].profile) {
            look_at_profile(figures_[i], met_[i], expect, *columns_[i].profile, moment);
            continue;
        }
        const double off = expect.relative_to.empty() ? 0 : evaluate(columns_[i].relative_to, moment);
        const double value = evaluate(columns_[i].quantity, moment) - off;
        if (!std::isnan(value) && moment.state.time >= expect.from && moment.state.time <= expect.to) {
            if (expect.reduce == "at") {
                look_at_time(figures_[i], moment.state.time, value, expect.at);
            } else if (expect.reduce == "when") {
                look_at_trigger(figures_[i], moment.state.time, evaluate(columns_[i].trigger, moment), value,
                                expect.reaches);
            } else if (sim::is_of_curve(expect.reduce)) {
                look_at_curve(figures_[i], met_[i], expect.curve, evaluate(columns_[i].trigger, moment), value);
            } else if (expect.reduce == "period") {
                look_at_crossing(figures_[i], moment.state.time, value, expect.reaches);
            } else if (expect.reduce == "noise") {
                look_at_noise(met_[i], value);
            }
            add(figures_[i], moment.state.time, value);
        }
    }
}

std::vector<ExpectResult> ExpectWatch::judge(bool at_end) const {
    std::vector<ExpectResult> results;
    std::vector<bool> is_known;  // whether an answer has come: those that name it wait for it
    for (std::size_t i = 0; i < columns_.size(); ++i) {
        const sim::Expect& expect = model_.expects[i];
        ExpectResult result{.name = expect.name,
                            .quantity = expect.quantity,
                            .reduce = expect.reduce,
                            .unit = unit_of(expect.reduce, columns_[i].unit),
                            .citation = expect.citation,
                            .value = value_of(i),
                            .time = time_of(figures_[i], expect.reduce),
                            .low = expect.low,
                            .high = expect.high};
        const bool has_happened = expect.reduce == "when" && !std::isnan(result.value);
        bool is_due = has_happened || is_reached(expect, model_.time.end);
        if (expect.minus >= 0) {
            result.value -= results[static_cast<std::size_t>(expect.minus)].value;
            is_due = is_due && is_known[static_cast<std::size_t>(expect.minus)];
        }
        if (expect.over >= 0) {
            const ExpectResult& below = results[static_cast<std::size_t>(expect.over)];
            result.value /= below.value;
            result.unit = unit_over(result.unit, below.unit);
            is_due = is_due && is_known[static_cast<std::size_t>(expect.over)];
        }
        is_known.push_back(is_due);
        if (at_end && is_due && expect.is_reported && !std::isnan(result.value)) {
            result.verdict = Verdict::reported;
        } else if (at_end && is_due) {
            const bool is_within = expect.low <= result.value && result.value <= expect.high;  // false for NaN
            result.verdict = is_within ? Verdict::passed : Verdict::failed;
        }
        results.push_back(std::move(result));
    }
    return results;
}

double ExpectWatch::value_of(std::size_t i) const {
    const sim::Expect& expect = model_.expects[i];
    if (sim::is_of_waves(expect.reduce)) {
        return waves_of(met_[i], expect, *columns_[i].profile);
    }
    if (sim::is_of_curve(expect.reduce)) {
        return error_of(met_[i], expect.curve, expect.reduce);
    }
    return expect.reduce == "noise" ? noise_of(met_[i]) : reduce(figures_[i], expect.reduce);
}

std::vector<double> ExpectWatch::save() const {
    std::vector<double> numbers(figures_.size() * numbers_each);
    if (!numbers.empty()) {
        std::memcpy(numbers.data(), figures_.data(), numbers.size() * sizeof(double));
    }
    for (const std::vector<double>& met : met_) {
        numbers.insert(numbers.end(), met.begin(), met.end());
    }
    return numbers;
}

void ExpectWatch::load(const std::vector<double>& numbers) {
    std::size_t points = 0;
    for (const std::vector<double>& met : met_) {
        points += met.size();
    }
    const bool is_before_crossings = points == 0 && numbers.size() == figures_.size() * numbers_before_crossings;
    if (numbers.size() != figures_.size() * numbers_each + points && !is_before_crossings) {
        throw CheckpointError(
            "the expected answers in the checkpoint are not those of the case, or another version of Riprap wrote "
            "them");
    }
    const std::size_t stored = is_before_crossings ? numbers_before_crossings : numbers_each;
    for (std::size_t i = 0; i < figures_.size(); ++i) {
        figures_[i] = nothing_seen;
        std::memcpy(static_cast<void*>(&figures_[i]), numbers.data() + i * stored, stored * sizeof(double));
    }
    auto next = numbers.begin() + static_cast<std::ptrdiff_t>(figures_.size() * stored);
    for (std::vector<double>& met : met_) {
        std::copy_n(next, met.size(), met.begin());
        next += static_cast<std::ptrdiff_t>(met.size());
    }
}

}  // namespace riprap::run
