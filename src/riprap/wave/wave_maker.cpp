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

double evanescent_elevation(const LinearWave& wave, double x) {
    constexpr int modes = 200, passes = 60;
    constexpr double nothing = 1e-15;  // of a sum of order one
    const double lift = wave.angular_frequency * wave.angular_frequency * wave.depth / wave.gravity;
    double sum = 0;
    for (int j = 1; j <= modes; ++j) {
        // q tan q = -lift has one root between (j - 1/2) pi and j pi: q = j pi - atan(lift/q), a contraction.
        double q = j * std::numbers::pi;
        for (int pass = 0; pass < passes; ++pass) {
            q = j * std::numbers::pi - std::atan(lift / q);
        }
        if (std::exp(-q * x / wave.depth) < nothing) {
            break;
        }
        const double sine = std::sin(q);
        sum += 4 * sine * sine / (2 * q + std::sin(2 * q)) * std::exp(-q * x / wave.depth);
    }
    return sum;
}

RegularStroke regular_stroke(const LinearWave& wave, Paddle paddle, bool is_second_order) {
    return {0.5 * wave.height / height_over_stroke(paddle, wave.kd()),
            is_second_order ? second_harmonic_stroke(wave) : 0.0};
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
