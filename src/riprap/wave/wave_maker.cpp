// SPDX-License-Identifier: Apache-2.0
#include "riprap/wave/wave_maker.hpp"

#include <cmath>
#include <numbers>

namespace riprap::wave {

double height_over_stroke(Paddle paddle, double kd) {
    // Scaled by exp(-2 kd), so that deep water does not overflow.
    const double decay = std::exp(-2 * kd);
    const double cosh_2 = 0.5 * (1 + decay * decay);
    const double sinh_2 = 0.5 * (1 - decay * decay);
    const double below = sinh_2 + 2 * kd * decay;
    if (paddle == Paddle::piston) {
        return 2 * (cosh_2 - decay) / below;
    }
    const double sinh_1 = 0.5 * (1 - decay);  // sinh kd exp(-kd)
    const double cosh_1 = 0.5 * (1 + decay);
    return 4 * (sinh_1 / kd) * (kd * sinh_1 - cosh_1 + std::exp(-kd)) / below;
}

double second_harmonic_stroke(const LinearWave& wave) {
    const double kd = wave.kd();
    const double sinh_kd = std::sinh(kd);
    return wave.height * wave.height / (32 * wave.depth) *
           (3 * std::cosh(kd) / (sinh_kd * sinh_kd * sinh_kd) - 2 / height_over_stroke(Paddle::piston, kd));
}

MotionSeries regular_motion(const RegularMaker& maker, double end) {
    const LinearWave& wave = maker.wave;
    const double omega = wave.angular_frequency;
    const double half_stroke = 0.5 * wave.height / height_over_stroke(maker.paddle, wave.kd());
    const double second = maker.second_order ? second_harmonic_stroke(wave) : 0.0;
    const double start =
        maker.ramp > 0 ? 0.0 : half_stroke * std::sin(maker.phase) + second * std::sin(2 * maker.phase);
    const double step = 2 * std::numbers::pi / omega / 80;
    const auto rows = static_cast<long>(std::ceil(end / step)) + 1;
    MotionSeries series;
    for (long i = 0; i < rows; ++i) {
        const double t = static_cast<double>(i) * step;
        const double angle = omega * t + maker.phase;
        const double full = half_stroke * std::sin(angle) + second * std::sin(2 * angle);
        const double full_rate = omega * (half_stroke * std::cos(angle) + 2 * second * std::cos(2 * angle));
        double share = 1;
        double share_rate = 0;
        if (t < maker.ramp) {
            const double phi = std::numbers::pi * t / maker.ramp;
            share = 0.5 * (1 - std::cos(phi));
            share_rate = 0.5 * std::numbers::pi / maker.ramp * std::sin(phi);
        }
        series.time.push_back(t);
        series.value.push_back(share * full - start);
        series.rate.push_back(share * full_rate + share_rate * full);
    }
    return series;
}

MotionSeries solitary_motion(const SolitaryWave& wave) {
    const double shape = wave.shape_number();
    const double celerity = wave.celerity();
    const double half_stroke = wave.height / (shape * wave.depth);
    // The paddle is followed by its phase p = K (c t - x), in which its place is explicit: x = H/(K d) tanh p.
    const double end_phase = std::atanh(0.999);
    constexpr int rows = 400;
    MotionSeries series;
    for (int i = 0; i <= rows; ++i) {
        const double p = end_phase * (2.0 * i / rows - 1);
        const double x = half_stroke * std::tanh(p);
        const double sech = 1 / std::cosh(p);
        const double eta = wave.height * sech * sech;
        series.time.push_back((p / shape + x) / celerity);
        series.value.push_back(x);
        series.rate.push_back(celerity * eta / (wave.depth + eta));
    }
    const double first_time = series.time.front();
    const double first_value = series.value.front();
    for (std::size_t i = 0; i < series.time.size(); ++i) {
        series.time[i] -= first_time;
        series.value[i] -= first_value;
    }
    return series;
}

}  // namespace riprap::wave
