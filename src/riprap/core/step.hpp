// SPDX-License-Identifier: Apache-2.0
#pragma once

// The words in which solids, fluids and the driver of a step speak about time.

#include <limits>
#include <string>

namespace riprap {

/// A piece of time that a method advances over.
struct TimeSpan {
    double time;  ///< at its beginning [s]
    double dt;    ///< its length [s]
    double middle() const { return time + 0.5 * dt; }
    double end() const { return time + dt; }
};

/// Result of one verb of a method; `problem` empty = done.
struct Outcome {
    std::string problem;   ///< quantity, body or cell, and time, e.g. "speed of block[3] is 2.1e6 m/s at t = 0.01 s"
    double shorten{0};     ///< share of the span to try instead; 0 = no shorter one helps [-]
    std::string remedy{};  ///< what to change in the case, where that follows from the problem
    bool ok() const { return problem.empty(); }
};

/// The step that a method allows, or wants, from a Model and State.
struct StepLimit {
    double longest{std::numeric_limits<double>::infinity()};  ///< [s]
    bool is_wanted{false};  ///< an implicit method's own step: it is cut for nobody else's sake
    std::string reason;     ///< in words, for the log
    /// Of automatic steps, soon after things were let go, where this grows from little [s]. A step that the case fixes
    /// does not grow, and needs to be no longer than `longest` only.
    double at_start{std::numeric_limits<double>::infinity()};
};

}  // namespace riprap
