// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/drive/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace riprap::run {

namespace {
constexpr double terminal_period = 0.2;  // [s]
constexpr double plain_period = 30;      // [s]
constexpr int bar_width = 24;

double share_done(std::int64_t step, std::int64_t steps_left) {
    return steps_left > 0 ? static_cast<double>(step) / static_cast<double>(step + steps_left) : 1;
}
}  // namespace

std::string duration_text(double seconds) {
    const double s = std::max(0.0, seconds);
    if (!std::isfinite(s) || s > 1e9) {
        return "?";
    }
    const auto whole = static_cast<std::int64_t>(std::lround(s));
    if (whole >= 3600) {
        return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
    }
    if (whole >= 60) {
        return fmt::format("{} min {:02} s", whole / 60, whole % 60);
    }
    return s < 9.5 ? fmt::format("{:.1f} s", s) : fmt::format("{} s", whole);
}

Progress::Progress(std::int64_t first_step, std::int64_t body_count, std::int64_t particle_count, bool is_quiet)
    : first_step_(first_step),
      body_count_(std::max<std::int64_t>(1, body_count)),
      particle_count_(particle_count),
      is_quiet_(is_quiet),
      is_terminal_(isatty(STDOUT_FILENO) != 0),
      next_print_(is_terminal_ ? terminal_period : plain_period) {}

int Progress::tenths_done(std::int64_t step, std::int64_t steps_left) const {
    const auto done = static_cast<double>(step - first_step_);
    return static_cast<int>(10 * done / std::max(1.0, done + static_cast<double>(steps_left)));
}

double Progress::seconds_per_step(std::int64_t step) const {
    return step > first_step_ ? timer_.seconds() / static_cast<double>(step - first_step_) : 0;
}

std::string Progress::line(std::int64_t step, std::int64_t steps_left, double time) const {
    const double step_seconds = seconds_per_step(step);
    const std::string cost =
        particle_count_ > 0
            ? fmt::format("{:.0f} ns per particle-step", 1e9 * step_seconds / static_cast<double>(particle_count_))
            : fmt::format("{:.0f} ns per body-step", cost_per_body(step));
    return fmt::format("{:3.0f} %  t = {:.4g} s  step {}/{}  {}  {} left", 100 * share_done(step, steps_left), time,
                       step, step + steps_left, cost, duration_text(step_seconds * static_cast<double>(steps_left)));
}

void Progress::print(std::int64_t step, std::int64_t steps_left, double time) {
    if (!is_terminal_) {
        fmt::print("{}\n", line(step, steps_left, time));
    } else {
        const auto filled = static_cast<std::size_t>(std::lround(bar_width * share_done(step, steps_left)));
        fmt::print("\r\033[K[{:<{}}] {}", std::string(filled, '='), bar_width, line(step, steps_left, time));
    }
    std::fflush(stdout);
}

void Progress::show(std::int64_t step, std::int64_t steps_left, double time) {
    if (is_quiet_) {
        return;
    }
    const double now = timer_.seconds();
    const int tenths = tenths_done(step, steps_left);
    const bool is_tenth = !is_terminal_ && tenths > tenths_printed_ && steps_left > 0;
    if (now < next_print_ && !is_tenth) {
        return;
    }
    next_print_ = now + (is_terminal_ ? terminal_period : plain_period);
    tenths_printed_ = std::max(tenths_printed_, tenths);
    print(step, steps_left, time);
}

void Progress::finish(std::int64_t step, std::int64_t steps_left, double time) {
    if (is_quiet_) {
        return;
    }
    print(step, steps_left, time);
    if (is_terminal_) {
        fmt::print("\n");
    }
}

}  // namespace riprap::run
