// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/flow/flows.hpp"

#include <cmath>

namespace riprap::fluid {

KeyList<TaylorGreenFlow> TaylorGreenFlow::keys() {
    using S = TaylorGreenFlow;
    return {key::number(&S::speed, "speed", dimension::velocity, key::any(), "U, the largest speed at the start."),
            key::number(&S::wave_length, "wave_length", dimension::length, key::positive(),
                        "Of the pattern: two vortices along each axis.")
                .required()};
}

double TaylorGreenFlow::stream(const Vec3& x, double t, double nu) const {
    const double k = 2 * M_PI / wave_length;
    return speed / k * std::sin(k * x.x) * std::sin(k * x.y) * std::exp(-2 * nu * k * k * t);
}

Vec3 TaylorGreenFlow::velocity(const Vec3& x, double t, double nu) const {
    const double k = 2 * M_PI / wave_length, now = speed * std::exp(-2 * nu * k * k * t);
    return {now * std::sin(k * x.x) * std::cos(k * x.y), -now * std::cos(k * x.x) * std::sin(k * x.y), 0};
}

KeyList<KovasznayFlow> KovasznayFlow::keys() {
    using S = KovasznayFlow;
    return {key::number(&S::speed, "speed", dimension::velocity, key::positive(), "U, the mean speed along x."),
            key::number(&S::wave_length, "wave_length", dimension::length, key::positive(), "Distance of the bars.")
                .required()};
}

namespace {
/// b of the formula, written so that a small viscosity cancels nothing; 0 without any [-].
double decay_of(const KovasznayFlow& flow, double nu) {
    const double reynolds = flow.speed * flow.wave_length / nu;
    return -8 * M_PI * M_PI / (reynolds + std::sqrt(reynolds * reynolds + 16 * M_PI * M_PI));
}
}  // namespace

double KovasznayFlow::stream(const Vec3& x, double /*t*/, double nu) const {
    const double k = 2 * M_PI / wave_length;
    return speed * (x.y - std::exp(decay_of(*this, nu) * x.x / wave_length) * std::sin(k * x.y) / k);
}

Vec3 KovasznayFlow::velocity(const Vec3& x, double /*t*/, double nu) const {
    const double k = 2 * M_PI / wave_length, b = decay_of(*this, nu), share = std::exp(b * x.x / wave_length);
    return {speed * (1 - share * std::cos(k * x.y)), speed * b / (2 * M_PI) * share * std::sin(k * x.y), 0};
}

KeyList<RotationFlow> RotationFlow::keys() {
    using S = RotationFlow;
    return {key::vector(&S::center, "center", dimension::length, key::any(), "A point of the axis.").required(),
            key::number(&S::rate, "rate", dimension::angular_velocity, key::any(), "Angular velocity.").required()};
}

double RotationFlow::stream(const Vec3& x, double /*t*/, double /*nu*/) const {
    const double dx = x.x - center.x, dy = x.y - center.y;
    return -0.5 * rate * (dx * dx + dy * dy);
}

Vec3 RotationFlow::velocity(const Vec3& x, double /*t*/, double /*nu*/) const {
    return {-rate * (x.y - center.y), rate * (x.x - center.x), 0};
}

KeyList<VortexFlow> VortexFlow::keys() {
    using S = VortexFlow;
    return {key::vector(&S::low, "low", dimension::length, key::any(), "Low corner of the box."),
            key::number(&S::length, "length", dimension::length, key::positive(), "Length of its sides.").required(),
            key::number(&S::speed, "speed", dimension::velocity, key::any(), "U, the largest speed at the start."),
            key::number(&S::period, "period", dimension::time, key::positive(),
                        "The flow turns back at half of it, and all is where it was at its end.")
                .required()};
}

double VortexFlow::stream(const Vec3& x, double t, double /*nu*/) const {
    const double sine = std::sin(M_PI * (x.x - low.x) / length) * std::sin(M_PI * (x.y - low.y) / length);
    return -speed * length / M_PI * sine * sine * std::cos(M_PI * t / period);
}

Vec3 VortexFlow::velocity(const Vec3& x, double t, double /*nu*/) const {
    const double a = M_PI * (x.x - low.x) / length, b = M_PI * (x.y - low.y) / length;
    const double now = speed * std::cos(M_PI * t / period);
    return {-now * std::pow(std::sin(a), 2) * std::sin(2 * b), now * std::sin(2 * a) * std::pow(std::sin(b), 2), 0};
}

KeyList<StrainFlow> StrainFlow::keys() {
    using S = StrainFlow;
    return {key::vector(&S::center, "center", dimension::length, key::any(), "Where the water stands still."),
            key::number(&S::rate, "rate", dimension::frequency, key::any(), "Rate of stretching along y.").required()};
}

double StrainFlow::stream(const Vec3& x, double /*t*/, double /*nu*/) const {
    return -rate * (x.x - center.x) * (x.y - center.y);
}

Vec3 StrainFlow::velocity(const Vec3& x, double /*t*/, double /*nu*/) const {
    return {-rate * (x.x - center.x), rate * (x.y - center.y), 0};
}

KeyList<StandingWaveFlow> StandingWaveFlow::keys() {
    using S = StandingWaveFlow;
    return {
        key::vector(&S::low, "low", dimension::length, key::any(), "A point of the bed under a crest to come."),
        key::number(&S::speed, "speed", dimension::velocity, key::any(), "U, speed of the surface there.").required(),
        key::number(&S::wave_length, "wave_length", dimension::length, key::positive(), "L of the wave.").required(),
        key::number(&S::depth, "depth", dimension::length, key::positive(), "Depth of the water.").required(),
        key::number(&S::period, "period", dimension::time, key::positive(), "Of the wave.").required()};
}

double StandingWaveFlow::stream(const Vec3& x, double t, double /*nu*/) const {
    const double k = 2 * M_PI / wave_length, now = speed / std::sinh(k * depth) * std::cos(2 * M_PI * t / period);
    return -now / k * std::sin(k * (x.x - low.x)) * std::sinh(k * (x.y - low.y));
}

Vec3 StandingWaveFlow::velocity(const Vec3& x, double t, double /*nu*/) const {
    const double k = 2 * M_PI / wave_length, now = speed / std::sinh(k * depth) * std::cos(2 * M_PI * t / period);
    const double a = k * (x.x - low.x), b = k * (x.y - low.y);
    return {-now * std::sin(a) * std::cosh(b), now * std::cos(a) * std::sinh(b), 0};
}

}  // namespace riprap::fluid
