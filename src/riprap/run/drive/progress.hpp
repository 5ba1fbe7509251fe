// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "riprap/core/timer.hpp"

namespace riprap::run {

/// Reports the progress and cost of a run: one line that is written over on a terminal, a line per tenth (and at least
/// every half minute) anywhere else.
class Progress {
 public:
    /// @param particle_count  of water; costs are then told per particle instead of per body
    /// @param is_quiet        nothing is printed at all
    Progress(std::int64_t first_step, std::int64_t body_count, std::int64_t particle_count, bool is_quiet);

    /// Called after every step; prints now and then. How many steps are left may change from step to step.
    void show(std::int64_t step, std::int64_t steps_left, double time);
    /// The last line.
    void finish(std::int64_t step, std::int64_t steps_left, double time);

    /// Wall-clock cost so far [s]; 0 before the first step.
    double seconds_per_step(std::int64_t step) const;
    /// Wall-clock cost so far per body [ns per body and step].
    double cost_per_body(std::int64_t step) const {
        return 1e9 * seconds_per_step(step) / static_cast<double>(body_count_);
    }
    double seconds() const { return timer_.seconds(); }

 private:
    std::string line(std::int64_t step, std::int64_t steps_left, double time) const;
    /// Returns the tenths of the steps of this process that are done.
    int tenths_done(std::int64_t step, std::int64_t steps_left) const;
    void print(std::int64_t step, std::int64_t steps_left, double time);

    Timer timer_;
    std::int64_t first_step_, body_count_, particle_count_;
    bool is_quiet_, is_terminal_;
    double next_print_;      ///< [s] of the timer
    int tenths_printed_{0};  ///< off a terminal
};

/// "1 h 02 min", "3 min 20 s", "12 s"
std::string duration_text(double seconds);

}  // namespace riprap::run
