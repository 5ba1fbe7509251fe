// SPDX-License-Identifier: Apache-2.0
#include "riprap/body/prescribed_motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace riprap::body {

namespace {

struct Stroke {
    double value, rate;
};

/// An oscillation that grows over `ramp`, or starts at once, from the value `start` that it has at t = 0.
Stroke grown(const Stroke& full, double start, double ramp, double t) {
    if (t < ramp) {
        const double rise = std::numbers::pi / ramp;
        const double share = 0.5 * (1 - std::cos(rise * t)), share_rate = 0.5 * rise * std::sin(rise * t);
        return {share * full.value, share * full.rate + share_rate * full.value};
    }
    return {full.value - (ramp > 0 ? 0.0 : start), full.rate};
}

/// s(t) of SinusoidalMotion.
Stroke sine_at(double omega, double phase, double ramp, double t) {
    const double angle = omega * t + phase;
    return grown({std::sin(angle), omega * std::cos(angle)}, std::sin(phase), ramp, t);
}

/// The body turned by `angle` about an axis through `center`, and its velocities.
DrivenState turned(const Pose& initial, const Vec3& center, const Vec3& axis, double angle, double rate) {
    const Quat turn = from_rotation_vector(angle * axis);
    const Vec3 arm = rotate(turn, initial.position - center);
    const Vec3 angular_velocity = rate * axis;
    return {{center + arm, normalized(turn * initial.orientation)}, cross(angular_velocity, arm), angular_velocity};
}

Stroke stroke_at(const SplineMotion& law, double t) {
    if (law.time.empty()) {
        return {0, 0};
    }
    const auto next = std::upper_bound(law.time.begin(), law.time.end(), t);
    if (next == law.time.begin()) {
        return {law.stroke.front(), 0};
    }
    if (next == law.time.end()) {
        return {law.stroke.back(), 0};
    }
    const auto b = static_cast<std::size_t>(next - law.time.begin());
    const std::size_t a = b - 1;
    const double span = law.time[b] - law.time[a];
    const double u = (t - law.time[a]) / span;
    const double rise = law.stroke[b] - law.stroke[a];
    // With p(u) = s_a + u span r_a + u^2 c + u^3 d, matched to value and rate at u = 1.
    const double from = span * law.rate[a], to = span * law.rate[b];
    const double c = 3 * rise - 2 * from - to;
    const double d = from + to - 2 * rise;
    return {law.stroke[a] + u * (from + u * (c + u * d)), (from + u * (2 * c + u * 3 * d)) / span};
}

Stroke stroke_at(const HarmonicMotion& law, double t) {
    const double w = law.angular_frequency, angle = w * t + law.phase;
    const auto [a, b] = law.amplitude;
    const double full = a * std::sin(angle) + b * std::sin(2 * angle);
    const double full_rate = w * (a * std::cos(angle) + 2 * b * std::cos(2 * angle));
    return grown({full, full_rate}, a * std::sin(law.phase) + b * std::sin(2 * law.phase), law.ramp, t);
}

/// The body displaced without a turn.
DrivenState displaced(const Pose& initial, const Vec3& displacement, const Vec3& velocity) {
    return {{initial.position + displacement, initial.orientation}, velocity, {}};
}

}  // namespace

KeyList<LinearMotion> LinearMotion::keys() {
    return {key::vector(&LinearMotion::velocity, "velocity", dimension::velocity, key::any(), "Velocity.").required()};
}

DrivenState LinearMotion::at(const Pose& initial, double t) const { return displaced(initial, t * velocity, velocity); }

KeyList<SinusoidalMotion> SinusoidalMotion::keys() {
    using S = SinusoidalMotion;
    return {key::vector(&S::amplitude, "amplitude", dimension::length, key::any(), "Amplitude of the displacement.")
                .required(),
            key::number(&S::period, "period", dimension::time, key::positive(), "Period.").required(),
            key::number(&S::phase, "phase", dimension::angle, key::any(), "Phase at the start."),
            key::number(&S::ramp, "ramp", dimension::time, key::non_negative(),
                        "Time in which it grows from rest to its full size.")};
}

DrivenState SinusoidalMotion::at(const Pose& initial, double t) const {
    const Stroke sine = sine_at(2 * std::numbers::pi / period, phase, ramp, t);
    return displaced(initial, sine.value * amplitude, sine.rate * amplitude);
}

DrivenState TableMotion::at(const Pose& initial, double t) const {
    if (time.empty()) {
        return displaced(initial, {}, {});
    }
    const auto next = std::upper_bound(time.begin(), time.end(), t);
    if (next == time.begin()) {
        return displaced(initial, displacement.front(), {});
    }
    if (next == time.end()) {
        return displaced(initial, displacement.back(), {});
    }
    const auto i = static_cast<std::size_t>(next - time.begin());
    const Vec3 velocity = (displacement[i] - displacement[i - 1]) / (time[i] - time[i - 1]);
    return displaced(initial, displacement[i - 1] + (t - time[i - 1]) * velocity, velocity);
}

KeyList<RotatingMotion> RotatingMotion::keys() {
    using S = RotatingMotion;
    return {
        key::vector(&S::center, "center", dimension::length, key::any(), "A point of the axis.").required(),
        key::axis(&S::axis, "axis", "Direction of the axis."),
        key::number(&S::rate, "rate", dimension::angular_velocity, key::any(), "Angular velocity of the steady turn."),
        key::number(&S::amplitude, "amplitude", dimension::angle, key::any(),
                    "Amplitude of an oscillation added to it."),
        key::number(&S::period, "period", dimension::time, key::positive(), "Period of the oscillation."),
        key::number(&S::phase, "phase", dimension::angle, key::any(), "Phase of the oscillation at the start."),
        key::number(&S::ramp, "ramp", dimension::time, key::non_negative(),
                    "Time in which the oscillation grows from rest to its full size.")};
}

DrivenState RotatingMotion::at(const Pose& initial, double t) const {
    const Stroke sine = sine_at(2 * std::numbers::pi / period, phase, ramp, t);
    return turned(initial, center, axis, rate * t + amplitude * sine.value, rate + amplitude * sine.rate);
}

DrivenState SplineMotion::at(const Pose& initial, double t) const {
    const Stroke now = stroke_at(*this, t);
    return is_turn ? turned(initial, center, direction, now.value, now.rate)
                   : displaced(initial, now.value * direction, now.rate * direction);
}

DrivenState HarmonicMotion::at(const Pose& initial, double t) const {
    const Stroke stroke = stroke_at(*this, t);
    if (arm > 0) {
        const double slope = stroke.value / arm;
        return turned(initial, center, direction, std::atan(slope), stroke.rate / (arm * (1 + slope * slope)));
    }
    return displaced(initial, stroke.value * direction, stroke.rate * direction);
}

double HarmonicMotion::shortest_period() const {
    return 2 * std::numbers::pi / angular_frequency / (amplitude[1] != 0 ? 2 : 1);
}

double shortest_period(const PrescribedMotion& motion) {
    return std::visit([](const auto& law) { return law.shortest_period(); }, motion.law);
}

DrivenState evaluate(const PrescribedMotion& motion, const Pose& initial, double time) {
    const double t = std::clamp(time, motion.start, motion.stop) - motion.start;
    DrivenState state = std::visit([&](const auto& law) { return law.at(initial, t); }, motion.law);
    if (time < motion.start || time >= motion.stop) {
        state.velocity = {};
        state.angular_velocity = {};
    }
    return state;
}

}  // namespace riprap::body
