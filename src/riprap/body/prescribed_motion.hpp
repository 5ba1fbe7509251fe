// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <limits>
#include <variant>
#include <vector>

#include "riprap/core/key.hpp"
#include "riprap/core/kind_list.hpp"
#include "riprap/core/quat.hpp"

namespace riprap::body {

/// Pose and velocities of a driven body at one time.
struct DrivenState {
    Pose pose;
    Vec3 velocity;          ///< [m/s]
    Vec3 angular_velocity;  ///< world axes [rad/s]
};

// Laws of motion, each a struct with
//
//     DrivenState at(const Pose& initial, double t) const;   // of a body that starts at `initial`
//     double shortest_period() const;                        // [s]; `aperiodic` where it has none
//
// and, where a case names it, with its word, a few words and its formula for the manual, and its keys. One line in
// MotionLaws registers such a law.

inline constexpr double aperiodic = std::numeric_limits<double>::infinity();

/// x(t) = x0 + velocity * t [m]
struct LinearMotion {
    static constexpr std::string_view word = "linear", brief = "Constant velocity.", help = brief;
    Vec3 velocity;  ///< [m/s]
    static KeyList<LinearMotion> keys();
    DrivenState at(const Pose& initial, double t) const;
    double shortest_period() const { return aperiodic; }
};

/// x(t) = x0 + amplitude * s(t), over [start, stop]; held outside.
///
///     s(t) = sin(2 pi t/period + phase) - sin(phase), or, where it grows from rest over a time `ramp`,
///     s(t) = r(t) sin(2 pi t/period + phase),   r = (1 - cos(pi t/ramp))/2 up to `ramp`, then 1.
struct SinusoidalMotion {
    static constexpr std::string_view word = "sinusoidal", brief = "A sine.",
                                      help =
                                          "x(t) = x0 + amplitude (sin(2 pi t/period + phase) - sin(phase)). It starts "
                                          "with its speed at that phase, as if struck; from rest with phase = \"90 "
                                          "deg\", on one side of its start then, or with a ramp: x0 + r(t) amplitude "
                                          "sin(2 pi t/period + phase), r growing from 0 to 1.";
    Vec3 amplitude;    ///< [m]
    double period{1};  ///< [s]
    double phase{0};   ///< [rad]
    double ramp{0};    ///< [s]
    static KeyList<SinusoidalMotion> keys();
    DrivenState at(const Pose& initial, double t) const;
    double shortest_period() const { return period; }
};

/// x(t) = x0 + displacement(t), piecewise linear between rows, constant beyond both ends.
struct TableMotion {
    static constexpr std::string_view word = "table", brief = "Displacements from a table.",
                                      help =
                                          "Displacement against time, linear between rows, constant beyond both ends.";
    std::vector<double> time;        ///< increasing [s]
    std::vector<Vec3> displacement;  ///< [m]
    DrivenState at(const Pose& initial, double t) const;
    double shortest_period() const { return aperiodic; }
};

/// Turns about a fixed axis through `center`: angle(t) = rate * t + amplitude * s(t), s that of SinusoidalMotion.
struct RotatingMotion {
    static constexpr std::string_view word = "rotation", brief = "A turn about a fixed axis.",
                                      help =
                                          "A turn about a fixed axis: angle(t) = rate t + amplitude (sin(2 pi t/period "
                                          "+ phase) - sin(phase)), with a ramp rate t + r(t) amplitude sin(2 pi "
                                          "t/period + phase), r growing from 0 to 1.";
    Vec3 center;          ///< a point of the axis [m]
    Vec3 axis{0, 0, 1};   ///< unit vector [-]
    double rate{0};       ///< [rad/s]
    double amplitude{0};  ///< of an oscillation added to the steady turn [rad]
    double period{1};     ///< [s]
    double phase{0};      ///< [rad]
    double ramp{0};       ///< in which the oscillation grows from rest [s]
    static KeyList<RotatingMotion> keys();
    DrivenState at(const Pose& initial, double t) const;
    double shortest_period() const { return amplitude != 0 ? period : aperiodic; }
};

/// Laws that a case names, in the order of the manual.
using MotionLaws = KindList<LinearMotion, SinusoidalMotion, TableMotion, RotatingMotion>;

/// A stroke known with its rate at rows, cubic Hermite between them, at rest beyond both ends: smooth where a linear
/// table jumps in velocity. Moves the body by stroke * direction [m], or turns it by stroke [rad] about `direction`.
struct SplineMotion {
    std::vector<double> time;    ///< increasing [s]
    std::vector<double> stroke;  ///< [m] or [rad]
    std::vector<double> rate;    ///< [m/s] or [rad/s]
    Vec3 direction{1, 0, 0};     ///< unit vector: of the way, or the axis of the turn [-]
    Vec3 center{};               ///< a point of the axis [m]
    bool is_turn{false};
    DrivenState at(const Pose& initial, double t) const;
    double shortest_period() const { return aperiodic; }
};

/// An oscillation with its second harmonic that grows from rest, known at all times: the way of a paddle,
///
///     s(t) = r(t) (a_1 sin(wt + phase) + a_2 sin(2 (wt + phase))) - s_0,   r = (1 - cos(pi t/ramp))/2 up to `ramp`,
///     then 1,
///
/// s_0 what the phase adds at t = 0 where there is no ramp. Moves the body by s * direction, or, where `arm` is not 0,
/// turns it by atan(s/arm) about `direction`.
struct HarmonicMotion {
    std::array<double, 2> amplitude{};  ///< a_1, a_2 [m]
    double angular_frequency{1};        ///< w [rad/s]
    double phase{0};                    ///< [rad]
    double ramp{0};                     ///< [s]
    Vec3 direction{1, 0, 0};            ///< unit vector: of the way, or the axis of the turn [-]
    Vec3 center{};                      ///< a point of the axis [m]
    double arm{0};                      ///< distance of the axis from the line that moves by s [m]
    DrivenState at(const Pose& initial, double t) const;
    double shortest_period() const;
};

/// Prescribed motion of a body. Outside [start, stop] the body rests where the motion put it.
struct PrescribedMotion {
    MotionLaws::VariantWith<SplineMotion, HarmonicMotion> law;
    double start{0};  ///< the law's t counts from here [s]
    double stop{std::numeric_limits<double>::infinity()};
};

/// The shortest period of the law [s]; infinity where it has none.
double shortest_period(const PrescribedMotion& motion);

/// Evaluates a motion at `time` for a body that starts at `initial`. Exact in time: no accumulated error.
DrivenState evaluate(const PrescribedMotion& motion, const Pose& initial, double time);

}  // namespace riprap::body
