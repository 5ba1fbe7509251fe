// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/particle_walls/paddle_absorption.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "riprap/fluid/gauge/gauge_kinds.hpp"
#include "riprap/wave/wave_maker.hpp"

namespace riprap::coupling {

namespace {

/// Periods within which the correction of a paddle returns to zero.
constexpr double periods_to_return = 5;

/// Moves the answer of a paddle that makes a sea over dt: a tau^2 u'' + tau u' + u = wanted.
double answered(const wave::AbsorptionLaw& law, double wanted, double now, double dt, double& surge) {
    const double bend = wave::absorption_bend * law.delay * law.delay;
    surge = (surge + dt * (wanted - now) / bend) / (1 + dt * (law.delay + dt) / bend);
    return now + dt * surge;
}

}  // namespace

void prepare_sea(PaddleAbsorption& paddle, double spacing) {
    // Particles carry no waves shorter than about ten spacings.
    constexpr double shortest_length = 10;
    const wave::GaugedPaddle gauged{paddle.depth, paddle.gravity, absorption_gauge_distance * spacing};
    const double shortest = 2 * std::numbers::pi * absorption_gauge_distance / shortest_length;
    paddle.law = wave::absorption_of_sea(*paddle.sea, gauged, 1 / (periods_to_return * paddle.sea_period), shortest);
    paddle.own = wave::OwnSurface(*paddle.sea, gauged, paddle.ramp);
}

double surface_at_paddle(const PaddleAbsorption& paddle, double shift, const fluid::ParticleSettings& settings,
                         const fluid::ParticleState& water) {
    fluid::Gauge gauge;
    gauge.kind = &fluid::surface_gauge;
    gauge.up = paddle.up;
    gauge.point = paddle.foot + (shift + absorption_gauge_distance * settings.spacing) * paddle.direction;
    gauge.end = gauge.point + (2 * paddle.depth) * paddle.up;  // waves break below
    return read_gauge(gauge, settings, water)[0];
}

double absorbing_velocity(const PaddleAbsorption& paddle, double time, double reading, double driven, double offset,
                          double gauge_distance) {
    const double eta = reading - paddle.still, t = std::max(0.0, time - paddle.start);
    const bool has_begun = time >= paddle.start;
    if (paddle.solitary) {
        const wave::SolitaryWave& wave = *paddle.solitary;
        const double from_crest = gauge_distance + driven - wave.celerity() * (t - paddle.solitary_crest);
        const double own = has_begun ? wave.elevation(from_crest) : 0.0;
        return -std::sqrt(wave.gravity / wave.depth) * (eta - own);
    }
    if (paddle.sea) {
        return -paddle.law.gain * (eta - paddle.own.elevation(time - paddle.start, driven)) - paddle.law.home * offset;
    }
    if (!paddle.regular) {
        return -std::sqrt(paddle.gravity / paddle.depth) * eta;
    }
    const wave::LinearWave& wave = *paddle.regular;
    const double share = t < paddle.ramp ? 0.5 * (1 - std::cos(std::numbers::pi * t / paddle.ramp)) : 1.0;
    const double angle = wave.angular_frequency * t + paddle.phase - wave.wave_number * gauge_distance;
    const double made = has_begun ? 0.5 * wave.height * share * std::cos(angle) : 0.0;
    const double own = made + wave::evanescent_elevation(wave, gauge_distance) * driven;
    const double gain = wave.angular_frequency / height_over_stroke(wave::Paddle::piston, wave.kd());
    const double back = wave.angular_frequency / (2 * std::numbers::pi * periods_to_return);
    return -gain * (eta - own) - back * offset;
}

double absorption_delay(const PaddleAbsorption& paddle, double spacing, double gauge_distance) {
    const double least = spacing / std::sqrt(paddle.gravity * paddle.depth);
    if (!paddle.regular) {
        return least;
    }
    const double made = height_over_stroke(wave::Paddle::piston, paddle.regular->kd());
    return std::max(least, wave::evanescent_elevation(*paddle.regular, gauge_distance) /
                               (made * paddle.regular->angular_frequency));
}

void absorb_waves(std::span<const PaddleAbsorption> paddles, const body::BodySet& bodies, double time, double dt,
                  const fluid::ParticleSettings& settings, const fluid::ParticleState& water,
                  std::vector<double>& surge, body::BodyState& state) {
    for (const PaddleAbsorption& paddle : paddles) {
        const auto b = static_cast<std::size_t>(paddle.body.value);
        const Vec3 at_rest = bodies.driven_bodies[static_cast<std::size_t>(bodies.driven[b])].start.position;
        const double offset = dot(state.drive_offset[b], paddle.direction);
        const double shift = dot(state.position[b] - at_rest, paddle.direction);
        const double reading = surface_at_paddle(paddle, shift, settings, water);
        const double distance = absorption_gauge_distance * settings.spacing;
        // Where the gauge is dry nothing is known of a wave: the paddle stays where corrections have brought it.
        const double wanted =
            reading > 0 ? absorbing_velocity(paddle, time, reading, shift - offset, offset, distance) : 0.0;
        const double now = dot(state.drive_rate[b], paddle.direction);
        if (paddle.sea) {
            state.drive_rate[b] = answered(paddle.law, wanted, now, dt, surge[b]) * paddle.direction;
            continue;
        }
        const double delay = absorption_delay(paddle, settings.spacing, distance);
        state.drive_rate[b] = (now + (wanted - now) * (1 - std::exp(-dt / delay))) * paddle.direction;
    }
}

}  // namespace riprap::coupling
