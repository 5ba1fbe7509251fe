// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace riprap::sim {
struct Expect;
struct ExpectCurve;
struct Moment;
struct Profile;
}  // namespace riprap::sim

namespace riprap::run {

/// Running figures of one quantity. State of a run: kept in its checkpoints.
struct RunningFigures {
    double last, minimum, maximum;
    double integral;  ///< over time, by the trapezoidal rule [its unit times s]: steps may differ in length
    double count, first_time, previous_time, previous, previous_trigger, at;
    double minimum_time, maximum_time, at_time;       ///< when these were first there [s]
    double crossings, first_crossing, last_crossing;  ///< of a level; times of the first direction [-], [s], [s]
};

/// Stands for a value that never came.
constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// The figures of a quantity of which no value came yet.
constexpr RunningFigures nothing_seen{missing,
                                      std::numeric_limits<double>::infinity(),
                                      -std::numeric_limits<double>::infinity(),
                                      0,
                                      0,
                                      missing,
                                      missing,
                                      missing,
                                      missing,
                                      missing,
                                      missing,
                                      missing,
                                      missing,
                                      0,
                                      missing,
                                      missing};

/// Interpolates the value at the moment when x, which went from x0 to x1 since the last step, was `level`.
inline double between(const RunningFigures& f, double value, double x0, double x1, double level) {
    return f.previous + (value - f.previous) * (level - x0) / (x1 - x0);
}

/// Takes the next value. What looks at a time, a trigger, a crossing or a curve comes before, as this forgets the last
/// value.
void add(RunningFigures& f, double time, double value);

/// Keeps the value at the time `at` [s], between steps by the straight line.
void look_at_time(RunningFigures& f, double time, double value, double at);

/// Keeps the value of the first moment at which the trigger reaches its level.
void look_at_trigger(RunningFigures& f, double time, double trigger, double value, double level);

/// Counts the crossings of a level, of which every other one is in the direction of the first.
void look_at_crossing(RunningFigures& f, double time, double value, double level);

/// Keeps the values at the points of a curve that `along` reaches for the first time.
void look_at_curve(RunningFigures& f, std::vector<double>& met, const sim::ExpectCurve& curve, double along,
                   double value);

/// Keeps the values at the points of a curve along a profile at one time, between steps by the straight line; reads the
/// gauges only in the steps about that time. Takes the next value too.
void look_at_profile(RunningFigures& f, std::vector<double>& met, const sim::Expect& expect,
                     const sim::Profile& profile, const sim::Moment& moment);

/// Takes the next value into the numbers of reduce = "noise": the last four values, the largest noise and the largest
/// size.
void look_at_noise(std::vector<double>& numbers, double value);
constexpr std::size_t noise_numbers = 6, wave_numbers = 9;  ///< of an answer; of a gauge

/// Returns the largest difference from the cubic through the two values before and the two after, over the largest
/// size; missing before the fifth value [-].
double noise_of(const std::vector<double>& numbers);

/// Takes the levels of a profile at one moment into the sums of reduce = "incident" and "reflection", a harmonic fit
/// (wave::HarmonicSums) for each gauge.
void look_at_waves(std::vector<double>& sums, const sim::Expect& expect, const sim::Profile& profile,
                   const sim::Moment& moment);

/// Returns the amplitude of the waves that come in [m], or of those that go back over it [-]; missing where the sums
/// cannot tell.
double waves_of(const std::vector<double>& sums, const sim::Expect& expect, const sim::Profile& profile);

/// Returns the figure that a `reduce` asks for (sim/reductions.hpp), curves left out; missing where none came.
double reduce(const RunningFigures& f, const std::string& how);

/// Time of the figure that `reduce` returns; missing for a mean, a period and a curve [s].
double time_of(const RunningFigures& f, const std::string& how);

/// Returns the error of a curve, the constant that makes it least taken off as far as the source allows; missing where
/// a point was not reached.
double error_of(const std::vector<double>& met, const sim::ExpectCurve& curve, const std::string& how);

}  // namespace riprap::run
