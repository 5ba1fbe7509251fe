// SPDX-License-Identifier: Apache-2.0
#include "riprap/validation/water/water_trial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <stdexcept>

namespace riprap::validation::water {

namespace {

double processor_time() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

}  // namespace

WaterTrial::WaterTrial(const CaseSetting& setting, std::span<const std::string> overrides)
    : loaded_(scene::read_case((setting.folder / "case.toml").string(), overrides)),
      state_(loaded_.state),
      after_step_(setting.after_step) {
    const sim::Model& model = loaded_.model;
    interval_ = model.output.probe_interval > 0 ? model.output.probe_interval : model.time.end / 1000;
    columns_ = sim::record_columns(model);
    values_.resize(columns_.size());
}

void WaterTrial::record(const std::string& name, std::function<double(const WaterTrial&)> value) {
    own_.push_back({name, std::move(value)});
    values_.emplace_back();
}

double WaterTrial::processor_seconds() const { return earlier_.processor + processor_time() - processor_at_start_; }

void WaterTrial::begin() {
    sim::initialise(loaded_.model, state_);
    initial_ = state_;
    timer_.restart();
    since_save_.restart();
    processor_at_start_ = processor_time();
    earlier_.program = kept_in_.empty() ? 0 : program_identity();
    if (!kept_in_.empty() && take_up_trial(kept_in_, loaded_.model, state_, earlier_)) {
        take_up();
    }
}

/// Rows of the saved trial, by column.
void WaterTrial::take_up() {
    time_ = earlier_.time;
    for (std::size_t row = 0; row < time_.size(); ++row) {
        for (std::size_t c = 0; c < values_.size(); ++c) {
            values_[c].push_back(earlier_.values.at(row * values_.size() + c));
        }
    }
}

/// Once a minute, and before the last row: a finished trial is taken up there and has its report after one row.
void WaterTrial::save() {
    const double left = loaded_.model.time.end - state_.time;
    if (left <= 1e-9 * loaded_.model.time.end || (left > 1.5 * interval_ && since_save_.seconds() < save_every)) {
        return;
    }
    TrialRecord record{time_, {}, wall_seconds(), processor_seconds(), earlier_.program};
    for (std::size_t row = 0; row < time_.size(); ++row) {
        for (const std::vector<double>& column : values_) {
            record.values.push_back(column[row]);
        }
    }
    save_trial(kept_in_, loaded_.model, state_, record);
    since_save_.restart();
}

bool WaterTrial::step_to_row() {
    const double due = interval_ * static_cast<double>(time_.size() + 1);
    for (;;) {
        const sim::TimeStep next = sim::choose_time_step(loaded_.model, state_, scratch_);
        if (next.steps_left == 0) {
            return false;
        }
        const bool is_row = state_.time + 1.5 * next.dt > due || next.steps_left == 1;
        report_ =
            sim::advance(loaded_.model, state_, scratch_, next.dt, is_row ? sim::Measure::energy : sim::Measure::flow);
        if (!report_.status.ok()) {
            throw std::runtime_error(report_.status.text);
        }
        if (after_step_) {
            after_step_(state_.time, loaded_.model.time.end);
        }
        if (is_row) {
            add_row();
            if (!kept_in_.empty()) {
                save();
            }
            return true;
        }
    }
}

void WaterTrial::add_row() {
    time_.push_back(state_.time);
    const sim::Moment moment{loaded_.model, initial_, state_, &scratch_, &report_};
    for (std::size_t c = 0; c < columns_.size(); ++c) {
        values_[c].push_back(sim::evaluate(columns_[c], moment));
    }
    for (std::size_t k = 0; k < own_.size(); ++k) {
        values_[columns_.size() + k].push_back(own_[k].value(*this));
    }
}

const std::vector<double>& WaterTrial::column(const std::string& name) const {
    for (std::size_t c = 0; c < columns_.size(); ++c) {
        if (columns_[c].name == name) {
            return values_[c];
        }
    }
    for (std::size_t k = 0; k < own_.size(); ++k) {
        if (own_[k].name == name) {
            return values_[columns_.size() + k];
        }
    }
    throw std::runtime_error(fmt::format("the case records no '{}'", name));
}

double WaterTrial::mean(const std::string& name, double start, double end) const {
    return integral(time_, column(name), start, end) / (end - start);
}

void judge_ledger(CaseReport& report, const WaterTrial& trial, const std::string& run) {
    const std::string prefix = run.empty() ? "" : run + ": ";
    report.judge_below(
        {prefix + "energy that the ledger misses over what was turned over", "-", {}, 0.0, {}, Kind::bookkeeping},
        trial.column("energy_residual").back() / trial.column("energy_turnover").back(), 0.01);
}

double water_area(const WaterTrial& trial) {
    double area = 0;
    for (const double density : trial.state().fluid.density) {
        area += trial.sph().particle_mass / density;
    }
    return area;
}

double interpolated(std::span<const double> x, std::span<const double> y, double at) {
    const auto next = static_cast<std::size_t>(std::lower_bound(x.begin(), x.end(), at) - x.begin());
    if (next == 0) {
        return y.front();
    }
    if (next == x.size()) {
        return y.back();
    }
    const double part = (at - x[next - 1]) / (x[next] - x[next - 1]);
    return (1 - part) * y[next - 1] + part * y[next];
}

double integral(std::span<const double> x, std::span<const double> y, double start, double end) {
    double sum = 0, last_x = start, last_y = interpolated(x, y, start);
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (x[i] > start && x[i] < end) {
            sum += 0.5 * (last_y + y[i]) * (x[i] - last_x);
            last_x = x[i];
            last_y = y[i];
        }
    }
    return sum + 0.5 * (last_y + interpolated(x, y, end)) * (end - last_x);
}

Crest crest_of(std::span<const double> time, std::span<const double> level, double until) {
    const auto last = std::upper_bound(time.begin(), time.end(), until) - time.begin();
    const auto top = static_cast<std::size_t>(std::max_element(level.begin(), level.begin() + last) - level.begin());
    if (top == 0 || top + 1 >= static_cast<std::size_t>(last)) {
        return {std::nan(""), std::nan("")};  // still rising: no crest
    }
    const double a = level[top - 1], b = level[top], c = level[top + 1];
    const double bend = a - 2 * b + c, shift = bend < 0 ? 0.5 * (a - c) / bend : 0;
    return {time[top] + shift * (time[top] - time[top - 1]), b - 0.25 * (a - c) * shift};
}

std::vector<double> crossings(std::span<const double> x, std::span<const double> y, double level) {
    std::vector<double> found;
    for (std::size_t i = 1; i < x.size(); ++i) {
        const double a = y[i - 1] - level, b = y[i] - level;
        if ((a < 0 && b >= 0) || (a > 0 && b <= 0)) {
            found.push_back(x[i - 1] + a / (a - b) * (x[i] - x[i - 1]));
        }
    }
    return found;
}

}  // namespace riprap::validation::water
