// SPDX-License-Identifier: Apache-2.0
#include "riprap/wave/irregular_wave.hpp"

#include <cmath>
#include <random>

#include "riprap/wave/linear_wave.hpp"

namespace riprap::wave {

namespace {

constexpr double lowest = 0.5, highest = 3;  ///< frequencies of a sea over that of the peak [-]
constexpr int intervals = 4000;              ///< of the sum over the spectrum

/// The density for unit height and peak frequency, without the factor A.
double shape(double ratio, double gamma) {
    const double width = ratio <= 1 ? 0.07 : 0.09;
    return std::pow(ratio, -5) * std::exp(-1.25 * std::pow(ratio, -4)) *
           std::pow(gamma, std::exp(-std::pow((ratio - 1) / width, 2) / 2));
}

/// Integral of the shape over f/f_p from `lowest` to each interval's end.
std::vector<double> cumulative(double gamma) {
    std::vector<double> sum{0};
    const double step = (highest - lowest) / intervals;
    for (int i = 0; i < intervals; ++i) {
        sum.push_back(sum.back() + step * shape(lowest + (i + 0.5) * step, gamma));
    }
    return sum;
}

}  // namespace

double jonswap_density(double frequency, double significant_height, double peak_period, double gamma) {
    const double variance = significant_height * significant_height / 16;
    return variance / cumulative(gamma).back() * peak_period * shape(frequency * peak_period, gamma);
}

double IrregularWave::elevation(double x, double time) const {
    double sum = 0;
    for (const Component& c : components) {
        sum += c.amplitude * std::cos(c.wave_number * x - c.angular_frequency * time + c.phase);
    }
    return sum;
}

WaveVelocity IrregularWave::velocity(double x, double above_bed, double time) const {
    WaveVelocity velocity{0, 0};
    const double y = std::min(above_bed, depth);
    for (const Component& c : components) {
        const double angle = c.wave_number * x - c.angular_frequency * time + c.phase;
        // cosh(ky)/sinh(kd) and sinh(ky)/sinh(kd) for any kd
        const double k = c.wave_number, rise = std::exp(k * (y - depth)), drop = std::exp(-2 * k * y),
                     bottom = 1 - std::exp(-2 * k * depth), size = c.amplitude * c.angular_frequency;
        velocity.along += size * rise * (1 + drop) / bottom * std::cos(angle);
        velocity.up += size * rise * (1 - drop) / bottom * std::sin(angle);
    }
    return velocity;
}

IrregularWave jonswap_sea(double significant_height, double peak_period, double gamma, double depth, double gravity,
                          int component_count, std::uint64_t seed) {
    const std::vector<double> sum = cumulative(gamma);
    const double step = (highest - lowest) / intervals;
    std::mt19937_64 random(seed);
    IrregularWave sea{depth, {}};
    std::size_t interval = 0;
    for (int i = 0; i < component_count; ++i) {
        const double middle = (i + 0.5) / component_count * sum.back();
        while (sum[interval + 1] < middle) {
            ++interval;
        }
        const double share = (middle - sum[interval]) / (sum[interval + 1] - sum[interval]);
        const double ratio = lowest + (static_cast<double>(interval) + share) * step;
        const double omega = 2 * M_PI * ratio / peak_period;
        const double phase = 2 * M_PI * static_cast<double>(random() >> 11) * 0x1p-53;
        sea.components.push_back({significant_height / 4 * std::sqrt(2.0 / component_count), omega,
                                  wave_number(omega, depth, gravity), phase});
    }
    return sea;
}

}  // namespace riprap::wave
