// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/drive/pace.hpp"

#include <algorithm>
#include <limits>

namespace riprap::run {

namespace {

/// Share of the simulated time between two marks [-]; the pace is that since the mark before the last.
constexpr double between_marks = 0.05;

}  // namespace

double Stand::share() const {
    const double by_time = end > 0 ? std::clamp(time / end, 0.0, 1.0) : 1;
    const double by_steps =
        max_steps > 0 ? std::min(1.0, static_cast<double>(step) / static_cast<double>(max_steps)) : 0;
    return std::max(by_time, by_steps);
}

void Pace::note(const Stand& now, double seconds) {
    if (now.time < last_.time) {  // steps were taken back
        last_ = before_ = {std::min(now.time, before_.time), before_.seconds};
    } else if (now.time - last_.time >= between_marks * now.end) {
        before_ = last_;
        last_ = {now.time, seconds};
    }
    now_ = now;
    seconds_ = seconds;
}

double Pace::seconds_to_end() const {
    const double left = std::max(0.0, now_.end - now_.time), way = now_.time - before_.time;
    if (left == 0) {
        return 0;
    }
    return way > 0 ? left * (seconds_ - before_.seconds) / way : std::numeric_limits<double>::infinity();
}

double Pace::seconds_left() const {
    if (now_.max_steps < 0) {
        return seconds_to_end();
    }
    const auto steps = static_cast<double>(std::max<std::int64_t>(0, now_.max_steps - now_.step));
    return std::min(seconds_to_end(), steps * seconds_per_step());
}

double Pace::seconds_per_step() const {
    return now_.step > first_.step ? seconds_ / static_cast<double>(now_.step - first_.step) : 0;
}

double Pace::share_of_process() const {
    const double begin = first_.share();
    return begin < 1 ? std::clamp((now_.share() - begin) / (1 - begin), 0.0, 1.0) : 1;
}

}  // namespace riprap::run
