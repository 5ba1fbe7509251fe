// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace riprap::run {

/// When something is due that is asked for at regular times. Steps all last `dt`, so the k-th time, k * interval, is
/// met at the nearest step, round(k * interval / dt): known from the step number alone, hence the same after a
/// restart. An interval below dt means every step.
class Schedule {
 public:
    Schedule(double interval, double dt) : steps_between_(std::max(1.0, interval / dt)) {}

    /// Step at which the k-th time is due.
    std::int64_t step_of(std::int64_t k) const { return std::llround(static_cast<double>(k) * steps_between_); }
    /// The k of the time due at `step`, or -1 when nothing is due.
    std::int64_t due_at(std::int64_t step) const {
        const auto near = static_cast<std::int64_t>(std::floor(static_cast<double>(step) / steps_between_));
        for (std::int64_t k = std::max<std::int64_t>(0, near - 1); k <= near + 1; ++k) {
            if (step_of(k) == step) {
                return k;
            }
        }
        return -1;
    }

    /// How many times are due from step 0 to `last_step`.
    std::int64_t due_count(std::int64_t last_step) const {
        auto k = static_cast<std::int64_t>(std::floor(static_cast<double>(last_step) / steps_between_)) + 1;
        while (k >= 0 && step_of(k) > last_step) {
            --k;
        }
        return k + 1;
    }

 private:
    double steps_between_;
};

/// Steps of a run: the first step count n with n * dt >= end, round-off in end/dt forgiven, and at most max_steps
/// (where not negative). The last step is not shortened: a run may end up to one dt after `end`.
inline std::int64_t count_steps(double end, double dt, std::int64_t max_steps) {
    constexpr double forgiven = 1e-9;  // of a step; end/dt carries a few units in the last place of error
    const double steps = std::ceil(end / dt * (1 - 1e-15) - forgiven);
    const auto whole = static_cast<std::int64_t>(std::clamp(steps, 0.0, 9e18));
    return max_steps >= 0 ? std::min(whole, max_steps) : whole;
}

}  // namespace riprap::run
