// SPDX-License-Identifier: Apache-2.0
#include "riprap/body/prescribed_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace riprap::body {

namespace {

struct Offset {
    Vec3 displacement;
    Vec3 velocity;
};

Offset offset_at(const LinearMotion& law, double t) { return {t * law.velocity, law.velocity}; }

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

Offset offset_at(const SinusoidalMotion& law, double t) {
    const Stroke sine = sine_at(2 * std::numbers::pi / law.period, law.phase, law.ramp, t);
    return {sine.value * law.amplitude, sine.rate * law.amplitude};
}

Offset offset_at(const TableMotion& law, double t) {
    if (law.time.empty()) {
        return {};
    }
    const auto next = std::upper_bound(law.time.begin(), law.time.end(), t);
    if (next == law.time.begin()) {
        return {law.displacement.front(), {}};
    }
    if (next == law.time.end()) {
        return {law.displacement.back(), {}};
    }
    const auto i = static_cast<std::size_t>(next - law.time.begin());
    const Vec3 velocity = (law.displacement[i] - law.displacement[i - 1]) / (law.time[i] - law.time[i - 1]);
    return {law.displacement[i - 1] + (t - law.time[i - 1]) * velocity, velocity};
}

/// The body turned by `angle` about an axis through `center`, and its velocities.
DrivenState turned(const Pose& initial, const Vec3& center, const Vec3& axis, double angle, double rate) {
    const Quat turn = from_rotation_vector(angle * axis);
    const Vec3 arm = rotate(turn, initial.position - center);
    const Vec3 angular_velocity = rate * axis;
    return {{center + arm, normalized(turn * initial.orientation)}, cross(angular_velocity, arm), angular_velocity};
}

DrivenState apply(const RotatingMotion& law, const Pose& initial, double t) {
    const Stroke sine = sine_at(2 * std::numbers::pi / law.period, law.phase, law.ramp, t);
    return turned(initial, law.center, law.axis, law.rate * t + law.amplitude * sine.value,
                  law.rate + law.amplitude * sine.rate);
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

DrivenState apply(const SplineMotion& law, const Pose& initial, double t) {
    const Stroke stroke = stroke_at(law, t);
    if (law.is_turn) {
        return turned(initial, law.center, law.direction, stroke.value, stroke.rate);
    }
    return {{initial.position + stroke.value * law.direction, initial.orientation}, stroke.rate * law.direction, {}};
}

Stroke stroke_at(const HarmonicMotion& law, double t) {
    const double w = law.angular_frequency, angle = w * t + law.phase;
    const auto [a, b] = law.amplitude;
    const double full = a * std::sin(angle) + b * std::sin(2 * angle);
    const double full_rate = w * (a * std::cos(angle) + 2 * b * std::cos(2 * angle));
    return grown({full, full_rate}, a * std::sin(law.phase) + b * std::sin(2 * law.phase), law.ramp, t);
}

DrivenState apply(const HarmonicMotion& law, const Pose& initial, double t) {
    const Stroke stroke = stroke_at(law, t);
    if (law.arm > 0) {
        const double slope = stroke.value / law.arm;
        return turned(initial, law.center, law.direction, std::atan(slope),
                      stroke.rate / (law.arm * (1 + slope * slope)));
    }
    return {{initial.position + stroke.value * law.direction, initial.orientation}, stroke.rate * law.direction, {}};
}

template <class Law>
double period_of(const Law&) {
    return std::numeric_limits<double>::infinity();
}
double period_of(const SinusoidalMotion& law) { return law.period; }
double period_of(const RotatingMotion& law) {
    return law.amplitude != 0 ? law.period : std::numeric_limits<double>::infinity();
}
double period_of(const HarmonicMotion& law) {
    return 2 * std::numbers::pi / law.angular_frequency / (law.amplitude[1] != 0 ? 2 : 1);
}

template <class Law>
DrivenState apply(const Law& law, const Pose& initial, double t) {
    const Offset offset = offset_at(law, t);
    return {{initial.position + offset.displacement, initial.orientation}, offset.velocity, {}};
}

}  // namespace

double shortest_period(const PrescribedMotion& motion) {
    return std::visit([](const auto& law) { return period_of(law); }, motion.law);
}

DrivenState evaluate(const PrescribedMotion& motion, const Pose& initial, double time) {
    const double t = std::clamp(time, motion.start, motion.stop) - motion.start;
    DrivenState state = std::visit([&](const auto& law) { return apply(law, initial, t); }, motion.law);
    if (time < motion.start || time >= motion.stop) {
        state.velocity = {};
        state.angular_velocity = {};
    }
    return state;
}

}  // namespace riprap::body
