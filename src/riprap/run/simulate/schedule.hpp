// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace riprap::run {

/// When something is due that is asked for at regular times k * interval, k = 0, 1, 2, ...: at the first step at or
/// after each of them. Steps may differ in length. Several times within one step are met together, so an interval
/// below dt means every step. `next` is all that a restart needs.
class Schedule {
 public:
    explicit Schedule(double interval, std::int64_t next = 0) : interval_(interval), next_(next) {}

    /// The k of the first time that was not met yet.
    std::int64_t next() const { return next_; }
    /// @param dt  of the step that ends at `time`: a time missed by round-off counts as met
    bool is_due(double time, double dt) const { return time + forgiven * dt >= static_cast<double>(next_) * interval_; }
    /// Everything due until `time` is done.
    void meet(double time, double dt) {
        const double last = std::floor((time + forgiven * dt) / interval_);
        next_ = std::max(next_, static_cast<std::int64_t>(std::clamp(last, 0.0, 9e18))) + 1;
    }

 private:
    static constexpr double forgiven = 1e-9;  // of a step
    double interval_;
    std::int64_t next_;
};

/// Returns how many times are met by `steps` equal steps from time 0 on, the times of step 0 included.
inline double due_count(double interval, double dt, double steps) {
    return 1 + std::min(steps, std::floor((steps + 1e-9) * dt / interval));
}

}  // namespace riprap::run
