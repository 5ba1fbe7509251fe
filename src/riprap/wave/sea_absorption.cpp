// SPDX-License-Identifier: Apache-2.0
#include "riprap/wave/sea_absorption.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "riprap/wave/linear_wave.hpp"
#include "riprap/wave/paddle_sea.hpp"
#include "riprap/wave/wave_maker.hpp"

namespace riprap::wave {

namespace {

using Complex = std::complex<double>;
constexpr Complex i_unit{0, 1};

/// k d beyond which a paddle makes twice its stroke, and its formula overflows.
constexpr double deepest = 300;

/// A frequency at a paddle.
struct Wave {
    double weight;  ///< its energy
    double w, k, x;
    double made;      ///< c
    double standing;  ///< C

    Complex returned(const AbsorptionLaw& law) const {
        const double lag = w * law.delay;
        const Complex answer = law.gain / Complex{1 - absorption_bend * lag * lag, lag - law.home / w};
        const Complex own = answer * (made * std::exp(-i_unit * (k * x)) - i_unit * standing) / w;
        return 1.0 - made / w * 2.0 * answer * std::cos(k * x) / (1.0 + own);
    }
};

Wave wave_of(double w, double weight, const GaugedPaddle& paddle) {
    const LinearWave linear{0, paddle.depth, paddle.gravity, w, wave_number(w, paddle.depth, paddle.gravity)};
    return {weight,
            w,
            linear.wave_number,
            paddle.distance,
            height_over_stroke(Paddle::piston, std::min(linear.kd(), deepest)),
            evanescent_elevation(linear, paddle.distance)};
}

/// The components of a sea, and without energy the waves up to the shortest.
std::vector<Wave> waves_of(const IrregularWave& sea, const GaugedPaddle& paddle, double shortest) {
    std::vector<Wave> waves;
    double low = 1e300;
    for (const IrregularWave::Component& c : sea.components) {
        waves.push_back(wave_of(c.angular_frequency, c.amplitude * c.amplitude, paddle));
        low = std::min(low, c.angular_frequency);
    }
    const double k = shortest / paddle.distance;
    const double high = std::sqrt(paddle.gravity * k * std::tanh(k * paddle.depth));
    constexpr int count = 40;
    for (int i = 1; i <= count && high > low; ++i) {
        waves.push_back(wave_of(low + (high - low) * i / count, 0, paddle));
    }
    return waves;
}

AbsorptionLaw judged(const std::vector<Wave>& waves, AbsorptionLaw law) {
    double energy = 0;
    for (const Wave& wave : waves) {
        const double returned = std::abs(wave.returned(law));
        law.returned += wave.weight * returned * returned;
        law.highest = std::max(law.highest, returned);
        energy += wave.weight;
    }
    law.returned /= energy;
    return law;
}

/// Less of what grows comes before less of what returns.
bool is_better(const AbsorptionLaw& a, const AbsorptionLaw& b) {
    const double grown_a = std::max(a.highest, most_returned), grown_b = std::max(b.highest, most_returned);
    return grown_a != grown_b ? grown_a < grown_b : a.returned < b.returned;
}

}  // namespace

std::complex<double> returned_by(const AbsorptionLaw& law, const GaugedPaddle& paddle, double angular_frequency) {
    return wave_of(angular_frequency, 1, paddle).returned(law);
}

AbsorptionLaw absorption_of_sea(const IrregularWave& sea, const GaugedPaddle& paddle, double home, double shortest) {
    const std::vector<Wave> waves = waves_of(sea, paddle, shortest);
    const double gain = std::sqrt(paddle.gravity / paddle.depth);
    const double way = paddle.distance / std::sqrt(paddle.gravity * paddle.depth);
    constexpr int steps = 40;
    AbsorptionLaw best;
    best.highest = 1e300;
    for (int i = 1; i <= steps; ++i) {
        for (int j = 1; j <= steps; ++j) {
            const AbsorptionLaw law = judged(waves, {1.6 / steps * i * gain, 8.0 / steps * j * way, home});
            best = is_better(law, best) ? law : best;
        }
    }
    return best;
}

OwnSurface::OwnSurface(const IrregularWave& sea, const GaugedPaddle& paddle, double ramp) : ramp_(ramp) {
    for (const StrokeHarmonic& stroke : first_order_stroke(sea)) {
        const Wave wave = wave_of(stroke.angular_frequency, 1, paddle);
        modes_.push_back({wave.w, wave.k, i_unit * wave.made * stroke.amplitude * std::exp(-i_unit * (wave.k * wave.x)),
                          wave.standing * stroke.amplitude});
    }
}

double OwnSurface::elevation(double time, double stroke) const {
    if (time < 0) {
        return 0;
    }
    double sum = 0;
    for (const Mode& mode : modes_) {
        const double angle = mode.angular_frequency * time;
        sum += (mode.progressive * std::polar(1.0, angle - mode.wave_number * stroke)).real() +
               (mode.evanescent * std::polar(1.0, angle)).real();
    }
    return time < ramp_ ? 0.5 * (1 - std::cos(std::numbers::pi * time / ramp_)) * sum : sum;
}

}  // namespace riprap::wave
