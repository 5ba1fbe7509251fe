// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "riprap/core/timer.hpp"
#include "riprap/run/drive/pace.hpp"

namespace riprap::run {

/// Names what the cost of a step is divided by.
struct CostUnit {
    std::string name;       ///< "particle", "body"; empty = the whole step
    std::int64_t count{1};  ///< of them
};

/// Reports the progress and cost of a run: one line that is written over on a terminal, a line per tenth (and at least
/// every half minute) anywhere else.
class Progress {
 public:
    /// @param label     before each line, as "settling"; with one there is no line per tenth
    /// @param is_quiet  nothing is printed at all
    Progress(const Stand& first, CostUnit unit, std::string label, bool is_quiet);

    /// Called after every step; prints now and then.
    void show(const Stand& now);
    /// The last line.
    void finish(const Stand& now);

    const Pace& pace() const { return pace_; }
    double seconds() const { return timer_.seconds(); }

 private:
    std::string line() const;
    void print();

    Timer timer_;
    Pace pace_;
    Stand now_;
    CostUnit unit_;
    std::string label_;
    bool is_quiet_, is_terminal_;
    double next_print_;      ///< [s] of the timer
    int tenths_printed_{0};  ///< off a terminal
};

/// "1 h 02 min", "3 min 20 s", "12 s"
std::string duration_text(double seconds);

}  // namespace riprap::run
