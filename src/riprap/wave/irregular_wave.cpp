// SPDX-License-Identifier: Apache-2.0
#include "riprap/wave/irregular_wave.hpp"

#include <algorithm>
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

/// Splits a variance given by its sums over intervals into components of equal variance.
/// @param frequency_at  (interval, share of it) -> f [1/s]
template <class FrequencyAt>
IrregularWave components_of(const std::vector<double>& sum, double significant_height, double depth, double gravity,
                            int count, std::uint64_t seed, const FrequencyAt& frequency_at) {
    std::mt19937_64 random(seed);
    IrregularWave sea{depth, {}};
    std::size_t interval = 0;
    for (int i = 0; i < count; ++i) {
        const double middle = (i + 0.5) / count * sum.back();
        while (sum[interval + 1] < middle) {
            ++interval;
        }
        const double share = (middle - sum[interval]) / (sum[interval + 1] - sum[interval]);
        const double omega = 2 * M_PI * frequency_at(interval, share);
        const double phase = 2 * M_PI * static_cast<double>(random() >> 11) * 0x1p-53;
        sea.components.push_back(
            {significant_height / 4 * std::sqrt(2.0 / count), omega, wave_number(omega, depth, gravity), phase});
    }
    return sea;
}

/// Integral of a spectrum from its first point to each other [m^2].
std::vector<double> cumulative(const Spectrum& spectrum) {
    std::vector<double> sum{0};
    for (std::size_t i = 1; i < spectrum.frequency.size(); ++i) {
        sum.push_back(sum.back() + 0.5 * (spectrum.density[i] + spectrum.density[i - 1]) *
                                       (spectrum.frequency[i] - spectrum.frequency[i - 1]));
    }
    return sum;
}

}  // namespace

double jonswap_density(double frequency, double significant_height, double peak_period, double gamma) {
    const double variance = significant_height * significant_height / 16;
    return variance / cumulative(gamma).back() * peak_period * shape(frequency * peak_period, gamma);
}

double Spectrum::significant_height() const { return 4 * std::sqrt(cumulative(*this).back()); }

double Spectrum::peak_period() const {
    const auto peak = std::max_element(density.begin(), density.end()) - density.begin();
    return 1 / frequency[static_cast<std::size_t>(peak)];
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
    const double step = (highest - lowest) / intervals;
    return components_of(cumulative(gamma), significant_height, depth, gravity, component_count, seed,
                         [&](std::size_t interval, double share) {
                             return (lowest + (static_cast<double>(interval) + share) * step) / peak_period;
                         });
}

IrregularWave sea_of(const Spectrum& spectrum, double depth, double gravity, int component_count, std::uint64_t seed) {
    return components_of(cumulative(spectrum), spectrum.significant_height(), depth, gravity, component_count, seed,
                         [&](std::size_t i, double share) {
                             // Place in the interval where the integral of a line from S_a to S_b is that share of it.
                             const double a = spectrum.density[i], b = spectrum.density[i + 1], sum = share * (a + b);
                             const double place = sum / (a + std::sqrt(a * a + (b - a) * sum));
                             return spectrum.frequency[i] + place * (spectrum.frequency[i + 1] - spectrum.frequency[i]);
                         });
}

}  // namespace riprap::wave
