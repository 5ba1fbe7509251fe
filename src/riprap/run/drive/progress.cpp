// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/drive/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace riprap::run {

namespace {
constexpr double terminal_period = 0.2;  // [s]
constexpr double plain_period = 30;      // [s]
constexpr int bar_width = 24;
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

Progress::Progress(const Stand& first, CostUnit unit, std::string label, bool is_quiet)
    : pace_(first),
      now_(first),
      unit_(std::move(unit)),
      label_(std::move(label)),
      is_quiet_(is_quiet),
      is_terminal_(isatty(STDOUT_FILENO) != 0),
      next_print_(is_terminal_ ? terminal_period : plain_period) {}

std::string Progress::line() const {
    const double cost = pace_.seconds_per_step();
    const std::string cost_text =
        unit_.name.empty()
            ? fmt::format("{:.3g} ms per step", 1e3 * cost)
            : fmt::format("{:.0f} ns per {}-step", 1e9 * cost / static_cast<double>(unit_.count), unit_.name);
    return fmt::format("{:3.0f} %  t = {:.4g} s  step {}  {}  {} left", 100 * now_.share(), now_.time, now_.step,
                       cost_text, duration_text(pace_.seconds_left()));
}

void Progress::print() {
    if (!is_terminal_) {
        fmt::print("{}{}\n", label_, line());
    } else {
        const auto filled = static_cast<std::size_t>(std::lround(bar_width * now_.share()));
        fmt::print("\r\033[K{}[{:<{}}] {}", label_, std::string(filled, '='), bar_width, line());
    }
    std::fflush(stdout);
}

void Progress::show(const Stand& now) {
    now_ = now;
    const double seconds = timer_.seconds();
    pace_.note(now, seconds);
    const int tenths = static_cast<int>(10 * pace_.share_of_process());
    const bool is_tenth = !is_terminal_ && label_.empty() && tenths > tenths_printed_ && tenths < 10;
    if (is_quiet_ || (seconds < next_print_ && !is_tenth)) {
        return;
    }
    next_print_ = seconds + (is_terminal_ ? terminal_period : plain_period);
    tenths_printed_ = std::max(tenths_printed_, tenths);
    print();
}

void Progress::finish(const Stand& now) {
    now_ = now;
    pace_.note(now, timer_.seconds());
    if (is_quiet_) {
        return;
    }
    print();
    if (is_terminal_) {
        fmt::print("\n");
    }
}

}  // namespace riprap::run
