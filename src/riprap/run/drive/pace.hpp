// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace riprap::run {

/// Where a run stands between its first step and its last.
struct Stand {
    std::int64_t step;
    double time, end;            ///< [s]
    std::int64_t max_steps{-1};  ///< the run stops there if it is not at its end before; -1 = no limit

    /// Share of the run that is done, by simulated time or by max_steps, whichever is nearer to its end [-]: steps to
    /// the end cannot be counted, as their length changes.
    double share() const;
};

/// Predicts how long the rest of a run takes, from what the last twentieth to tenth of its simulated time took: water
/// that breaks and piles that fall apart change both the cost of a step and its length.
class Pace {
 public:
    explicit Pace(const Stand& first) : first_(first), before_{first.time, 0}, last_{first.time, 0} {}

    /// @param seconds  wall-clock time since the first step of this process [s]
    void note(const Stand& now, double seconds);

    /// Wall-clock time from the last note to the end of the simulated time, whatever max_steps says [s]; infinite
    /// before the first step.
    double seconds_to_end() const;
    /// ... or to max_steps, whichever comes first [s].
    double seconds_left() const;
    /// Of this process, up to the last note [s].
    double seconds_per_step() const;
    /// Share of what this process has to do that is done [-].
    double share_of_process() const;

 private:
    struct Mark {
        double time, seconds;
    };
    Stand first_, now_{first_};
    Mark before_, last_;
    double seconds_{0};
};

}  // namespace riprap::run
