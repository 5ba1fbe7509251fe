// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/expects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>

#include "riprap/core/error.hpp"
#include "riprap/core/tint.hpp"
#include "riprap/sim/reductions.hpp"

namespace riprap::run {

namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr RunningFigures nothing_seen{missing, infinity, -infinity, 0,       0,       missing, missing, missing,
                                      missing, missing,  missing,   missing, missing, 0,       missing, missing};
constexpr std::size_t numbers_each = sizeof(RunningFigures) / sizeof(double);
constexpr std::size_t numbers_before_crossings = numbers_each - 3;  // in checkpoints of version 0.2

/// Interpolates the value at the moment when x, which went from x0 to x1 since the last step, was `level`.
double between(const RunningFigures& f, double value, double x0, double x1, double level) {
    return f.previous + (value - f.previous) * (level - x0) / (x1 - x0);
}

void look_at_time(RunningFigures& f, double time, double value, double at) {
    constexpr double forgiven = 1e-9;  // of a step: the end of a run may miss `at` by round-off
    f.at_time = at;
    if (time == at) {
        f.at = value;
    } else if (std::isnan(f.at) && f.previous_time < at && at <= time + forgiven * (time - f.previous_time)) {
        f.at = between(f, value, f.previous_time, time, at);
    }
}

/// Keeps the value of the first moment at which the trigger reaches its level.
void look_at_trigger(RunningFigures& f, double time, double trigger, double value, double level) {
    if (std::isnan(f.at)) {
        if (trigger == level) {
            f.at = value;
            f.at_time = time;
        } else if ((f.previous_trigger < level) != (trigger < level) && !std::isnan(f.previous_trigger)) {
            f.at = between(f, value, f.previous_trigger, trigger, level);
            f.at_time = f.previous_time +
                        (time - f.previous_time) * (level - f.previous_trigger) / (trigger - f.previous_trigger);
        }
    }
    f.previous_trigger = trigger;
}

/// Counts the crossings of a level, of which every other one is in the direction of the first; before add(), which
/// forgets the last value.
void look_at_crossing(RunningFigures& f, double time, double value, double level) {
    if (f.count == 0 || (f.previous < level) == (value < level)) {
        return;
    }
    f.crossings += 1;
    if (std::fmod(f.crossings, 2) == 1) {
        f.last_crossing = f.previous_time + (time - f.previous_time) * (level - f.previous) / (value - f.previous);
        f.first_crossing = f.crossings == 1 ? f.last_crossing : f.first_crossing;
    }
}

/// Returns the mean time between crossings in one direction, from three crossings on [s].
double period_of(const RunningFigures& f) {
    return f.crossings < 3 ? missing : (f.last_crossing - f.first_crossing) / std::floor((f.crossings - 1) / 2);
}

/// Keeps the values at the points of a curve that `along` reaches for the first time; before add().
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

void add(RunningFigures& f, double time, double value) {
    if (f.count > 0) {
        f.integral += 0.5 * (f.previous + value) * (time - f.previous_time);
    } else {
        f.first_time = time;
    }
    f.last = value;
    if (value < f.minimum) {
        f.minimum = value;
        f.minimum_time = time;
    }
    if (value > f.maximum) {
        f.maximum = value;
        f.maximum_time = time;
    }
    f.count += 1;
    f.previous_time = time;
    f.previous = value;
}

/// Keeps the values at the points of a curve along a profile at one time, between steps by the straight line; reads the
/// gauges only in the steps about that time, and before add().
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

/// Returns the error of a curve, the constant that makes it least taken off as far as the source allows; missing where
/// a point was not reached.
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

/// Tells whether the lowest value is farther from zero than the highest.
bool is_lower_extreme(const RunningFigures& f) { return -f.minimum > f.maximum; }

double reduce(const RunningFigures& f, const std::string& how) {
    if (f.count == 0) {
        return missing;
    }
    if (how == "min") {
        return f.minimum;
    }
    if (how == "max") {
        return f.maximum;
    }
    if (how == "extreme") {
        return is_lower_extreme(f) ? f.minimum : f.maximum;
    }
    if (how == "mean") {
        const double duration = f.previous_time - f.first_time;
        return duration > 0 ? f.integral / duration : f.last;
    }
    if (how == "period") {
        return period_of(f);
    }
    if (sim::is_time(how)) {
        return how == "time_of_min" ? f.minimum_time : f.maximum_time;
    }
    return how == "at" || how == "when" ? f.at : f.last;
}

/// Time of the figure that `reduce` returns; missing for a mean, a period and a curve [s].
double time_of(const RunningFigures& f, const std::string& how) {
    if (how == "min" || how == "time_of_min" || (how == "extreme" && is_lower_extreme(f))) {
        return f.minimum_time;
    }
    if (how == "max" || how == "time_of_max" || how == "extreme") {
        return f.maximum_time;
    }
    if (how == "last") {
        return f.previous_time;
    }
    return how == "at" || how == "when" ? (std::isnan(f.at) ? missing : f.at_time) : missing;
}

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

/// Returns the reason why there is no value.
std::string cause_of_none(const ExpectResult& result) {
    return result.reduce == "when"           ? "the quantity of 'when' did not reach its level"
           : result.reduce == "at"           ? "the quantity had none at that time"
           : sim::is_of_curve(result.reduce) ? "a point of the curve was not reached"
           : result.reduce == "period"       ? "it passed its level less than three times"
                                             : "no step of its window had one";
}

/// Colour of a verdict on a terminal.
Tint tint_of(Verdict verdict) {
    return verdict == Verdict::passed || verdict == Verdict::reported ? Tint::good
           : verdict == Verdict::failed                               ? Tint::bad
                                                                      : Tint::caution;
}

Diagnostic problem_of(const sim::Expect& expect, std::string message, std::string allowed) {
    return {{expect.place, 0, 0}, "expect '" + expect.name + "': " + std::move(message), std::move(allowed)};
}

}  // namespace

std::string_view to_string(Verdict verdict) {
    switch (verdict) {
        case Verdict::passed:
            return "passed";
        case Verdict::failed:
            return "failed";
        case Verdict::reported:
            return "reported";
        default:
            return "not_judged";
    }
}

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
        if (expect.curve.quantity == sim::along_profile && sim::is_of_curve(expect.reduce)) {
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
        columns_.push_back(std::move(columns));
        met_.emplace_back(expect.curve.along.size(), missing);
    }
    if (!problems.empty()) {
        throw CaseError(std::move(problems));
    }
}

void ExpectWatch::look(const sim::Moment& moment) {
    for (std::size_t i = 0; i < columns_.size(); ++i) {
        const sim::Expect& expect = model_.expects[i];
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
                            .unit = expect.reduce == "period" ? "s" : columns_[i].unit,
                            .citation = expect.citation,
                            .value = sim::is_of_curve(expect.reduce) ? error_of(met_[i], expect.curve, expect.reduce)
                                                                     : reduce(figures_[i], expect.reduce),
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

std::string verdict_table(const std::vector<ExpectResult>& results, bool is_coloured) {
    if (results.empty()) {
        return {};
    }
    std::size_t width = 6;
    for (const ExpectResult& result : results) {
        width = std::max(width, result.name.size());
    }
    std::string text = fmt::format("{:<{}}  {:>14}  {:>10}  {:>29}  {:<8}  verdict\n", "expect", width, "value",
                                   "at [s]", "band", "unit");
    for (const ExpectResult& result : results) {
        const std::string time = std::isnan(result.time) ? "-" : fmt::format("{:.5g}", result.time);
        const std::string band =
            result.low == -infinity ? "" : fmt::format("{:>13.7g} .. {:>12.7g}", result.low, result.high);
        text += fmt::format("{:<{}}  {:>14.7g}  {:>10}  {:>29}  {:<8}  {}\n", result.name, width, result.value, time,
                            band, result.unit,
                            tinted(result.verdict == Verdict::not_judged ? "not judged" : to_string(result.verdict),
                                   tint_of(result.verdict), is_coloured));
    }
    for (const ExpectResult& result : results) {
        if (result.verdict == Verdict::failed && std::isnan(result.value)) {
            text += fmt::format("'{}' has no value: {}\n", result.name, cause_of_none(result));
        }
    }
    return text;
}

}  // namespace riprap::run
