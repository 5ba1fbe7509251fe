// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/figures/running_figures.hpp"

#include <algorithm>
#include <cmath>

#include "riprap/sim/column_group.hpp"
#include "riprap/sim/reductions.hpp"

namespace riprap::run {

namespace {

/// Returns the mean time between crossings in one direction, from three crossings on [s].
double period_of(const RunningFigures& f) {
    return f.crossings < 3 ? missing : (f.last_crossing - f.first_crossing) / std::floor((f.crossings - 1) / 2);
}

/// Tells whether the lowest value is farther from zero than the highest.
bool is_lower_extreme(const RunningFigures& f) { return -f.minimum > f.maximum; }

}  // namespace

void look_at_time(RunningFigures& f, double time, double value, double at) {
    constexpr double forgiven = 1e-9;  // of a step: the end of a run may miss `at` by round-off
    f.at_time = at;
    if (time == at) {
        f.at = value;
    } else if (std::isnan(f.at) && f.previous_time < at && at <= time + forgiven * (time - f.previous_time)) {
        f.at = between(f, value, f.previous_time, time, at);
    }
}

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

}  // namespace riprap::run
