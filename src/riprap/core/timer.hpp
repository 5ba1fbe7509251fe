// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

namespace riprap {

/// Monotonic wall-clock seconds since construction or the last restart.
class Timer {
 public:
    double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
    void restart() { start_ = Clock::now(); }

 private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point start_{Clock::now()};
};

/// Adds the lifetime of the object to a running total [s].
class ScopedTimer {
 public:
    explicit ScopedTimer(double& total) : total_(total) {}
    ScopedTimer(const ScopedTimer&) = delete;
    ScopedTimer& operator=(const ScopedTimer&) = delete;
    ~ScopedTimer() { total_ += timer_.seconds(); }

 private:
    Timer timer_;
    double& total_;
};

/// Splits the time that passes in a function among its stages.
class Laps {
 public:
    /// Adds the time since the last call, or since construction, to the total of a stage [s].
    void end(double& total) {
        total += timer_.seconds();
        timer_.restart();
    }

 private:
    Timer timer_;
};

}  // namespace riprap
