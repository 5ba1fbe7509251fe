// SPDX-License-Identifier: Apache-2.0
#include "riprap/wave/paddle_sea.hpp"

#include <cmath>
#include <numbers>

#include "riprap/wave/linear_wave.hpp"

namespace riprap::wave {

namespace {

using Complex = std::complex<double>;
constexpr Complex i_unit{0, 1};

/// Evanescent modes that take part: the long waves of groups are good to 3 %, and what is left falls as 1/modes.
constexpr int evanescent_modes = 8;

/// A frequency before a piston at its place of rest: its way, and the modes that it makes.
struct Modes {
    double frequency;          ///< w [rad/s]
    Complex stroke;            ///< X [m]
    std::vector<Complex> k;    ///< wave numbers, the progressive one first [rad/m]
    std::vector<Complex> eta;  ///< amplitudes of the surface, a_j [m]
};

Modes modes_of(const IrregularWave::Component& c, double depth, double gravity) {
    const double kd = c.wave_number * depth, made = height_over_stroke(Paddle::piston, kd);
    const Complex a = std::polar(c.amplitude, -c.phase);  // eta = Re a exp(i (w t - k x))
    Modes modes{c.angular_frequency, a / (i_unit * made), {c.wave_number}, {a}};
    const double lift = c.angular_frequency * c.angular_frequency * depth / gravity;
    for (int j = 1; j <= evanescent_modes; ++j) {
        constexpr int passes = 60;
        double q = j * std::numbers::pi;  // q tan q = -lift, by a contraction
        for (int pass = 0; pass < passes; ++pass) {
            q = j * std::numbers::pi - std::atan(lift / q);
        }
        const double sine = std::sin(q);
        modes.k.push_back(-i_unit * (q / depth));
        modes.eta.push_back(modes.stroke * (4 * sine * sine / (2 * q + std::sin(2 * q))));
    }
    return modes;
}

/// Writes the waves with exp(-i w t), as they enter a difference.
Modes conjugate(Modes modes) {
    modes.frequency = -modes.frequency;
    modes.stroke = std::conj(modes.stroke);
    for (std::size_t j = 0; j < modes.k.size(); ++j) {
        modes.k[j] = -std::conj(modes.k[j]);
        modes.eta[j] = std::conj(modes.eta[j]);
    }
    return modes;
}

/// The bracket of second_order_stroke for one order of a pair.
Complex mismatch(const Modes& n, const Modes& m, double frequency, double free_k, double g) {
    const double w = m.frequency, k0 = free_k * free_k;
    Complex sum = 0;
    for (std::size_t l = 0; l < m.k.size(); ++l) {
        const Complex k = m.k[l], k_squared = k * k, a = m.eta[l];
        sum += -i_unit * g * n.stroke * a * k_squared * ((w * w - frequency * frequency) / w) / (k_squared - k0);
        for (std::size_t j = 0; j < n.k.size(); ++j) {
            const Complex both = n.k[j] + k;
            const Complex r = -i_unit * n.eta[j] * a *
                              (frequency * (g * g * n.k[j] * k / (n.frequency * w) - n.frequency * w) +
                               g * g * k_squared / w - w * w * w);
            sum += -i_unit * both * r / (both * both - k0);
        }
    }
    return sum;
}

StrokeHarmonic harmonic_of(const Modes& n, const Modes& m, bool is_same, double depth, double g) {
    const double frequency = n.frequency + m.frequency, k0 = wave_number(frequency, depth, g);
    Complex sum = mismatch(n, m, frequency, k0, g);
    if (!is_same) {
        sum += mismatch(m, n, frequency, k0, g);
    }
    return {-i_unit * (0.5 * k0 * k0 / (frequency * frequency * frequency)) * sum, frequency};
}

}  // namespace

std::vector<StrokeHarmonic> first_order_stroke(const IrregularWave& sea) {
    std::vector<StrokeHarmonic> stroke;
    for (const IrregularWave::Component& c : sea.components) {
        const double made = height_over_stroke(Paddle::piston, c.wave_number * sea.depth);
        stroke.push_back({std::polar(c.amplitude, -c.phase) / (i_unit * made), c.angular_frequency});
    }
    return stroke;
}

std::vector<StrokeHarmonic> second_order_stroke(const IrregularWave& sea, double gravity) {
    std::vector<Modes> all, conjugates;
    for (const IrregularWave::Component& c : sea.components) {
        all.push_back(modes_of(c, sea.depth, gravity));
        conjugates.push_back(conjugate(all.back()));
    }
    std::vector<StrokeHarmonic> stroke;
    for (std::size_t n = 0; n < all.size(); ++n) {
        for (std::size_t m = 0; m <= n; ++m) {
            stroke.push_back(harmonic_of(all[n], all[m], n == m, sea.depth, gravity));
            if (all[n].frequency != all[m].frequency) {
                const bool is_above = all[n].frequency > all[m].frequency;
                stroke.push_back(
                    harmonic_of(all[is_above ? n : m], conjugates[is_above ? m : n], false, sea.depth, gravity));
            }
        }
    }
    return stroke;
}

MotionSeries series_of(std::span<const StrokeHarmonic> stroke, double ramp, double step, double end) {
    MotionSeries series;
    const auto rows = static_cast<std::size_t>(std::ceil(end / step)) + 2;
    series.value.assign(rows, 0);
    series.rate.assign(rows, 0);
    for (const StrokeHarmonic& one : stroke) {
        const Complex turn = std::polar(1.0, one.angular_frequency * step);
        Complex now = one.amplitude;
        for (std::size_t i = 0; i < rows; ++i) {
            series.value[i] += now.real();
            series.rate[i] -= one.angular_frequency * now.imag();
            now *= turn;
        }
    }
    for (std::size_t i = 0; i < rows; ++i) {
        const double t = step * static_cast<double>(i);
        series.time.push_back(t);
        if (t < ramp) {
            const double rise = std::numbers::pi / ramp;
            const double share = 0.5 * (1 - std::cos(rise * t)), share_rate = 0.5 * rise * std::sin(rise * t);
            series.rate[i] = share * series.rate[i] + share_rate * series.value[i];
            series.value[i] *= share;
        }
    }
    return series;
}

}  // namespace riprap::wave
