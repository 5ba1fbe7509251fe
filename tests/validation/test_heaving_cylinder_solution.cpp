// SPDX-License-Identifier: Apache-2.0
#include "heaving_cylinder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <string>
#include <utility>

#include "riprap/core/error.hpp"

namespace riprap::validation::water {

namespace {

using Complex = std::complex<double>;
constexpr std::size_t terms = 64;
using Matrix = std::vector<std::array<Complex, terms>>;

/// Exponential integral gamma + ln w + sum w^n/(n n!), Re w > 0.
Complex exponential_integral(Complex w) {
    constexpr double euler = 0.5772156649015329;
    Complex sum = euler + std::log(w), power = 1;
    constexpr int most = 200;  // |w| < 30: the terms are below the last digit from the hundredth on
    for (int n = 1; n < most; ++n) {
        power *= w / static_cast<double>(n);
        sum += power / static_cast<double>(n);
    }
    return sum;
}

/// The potentials at the point theta of the cylinder and what they do to d phi/dr there.
struct Basis {
    std::array<Complex, terms> value, slope;

    Basis(double k, double theta) {
        const Complex z = std::polar(1.0, -theta);  // also dz/dr
        const Complex source = -std::exp(-k * z) * exponential_integral(k * z), wave = std::exp(-k * z);
        value[0] = {source.real(), M_PI * wave.real()};
        slope[0] = {((-k * source - 1.0 / z) * z).real(), M_PI * (-k * wave * z).real()};
        for (std::size_t m = 1; m < terms; ++m) {
            const double even = 2 * static_cast<double>(m), odd = even - 1;
            value[m] = std::cos(even * theta) + k / odd * std::cos(odd * theta);
            slope[m] = -even * std::cos(even * theta) - k * std::cos(odd * theta);
        }
    }
};

/// Solves A x = b by elimination with pivots.
std::array<Complex, terms> solve(Matrix a, std::array<Complex, terms> b) {
    for (std::size_t i = 0; i < terms; ++i) {
        std::size_t pivot = i;
        for (std::size_t row = i; row < terms; ++row) {
            pivot = std::abs(a[row][i]) > std::abs(a[pivot][i]) ? row : pivot;
        }
        std::swap(a[i], a[pivot]);
        std::swap(b[i], b[pivot]);
        for (std::size_t row = i + 1; row < terms; ++row) {
            const Complex share = a[row][i] / a[i][i];
            for (std::size_t k = i; k < terms; ++k) {
                a[row][k] -= share * a[i][k];
            }
            b[row] -= share * b[i];
        }
    }
    for (std::size_t i = terms; i-- > 0;) {
        for (std::size_t k = i + 1; k < terms; ++k) {
            b[i] -= a[i][k] * b[k];
        }
        b[i] /= a[i][i];
    }
    return b;
}

}  // namespace

HeaveLoads heave_loads(double ka) {
    RIPRAP_ASSERT(ka > 0 && ka < 30, std::to_string(ka));
    constexpr double width = 0.5 * M_PI / static_cast<double>(terms);  // of theta about each point
    const auto angle = [](std::size_t point) { return (static_cast<double>(point) + 0.5) * width; };
    Matrix slopes(terms), values(terms);
    std::array<Complex, terms> speed;
    for (std::size_t point = 0; point < terms; ++point) {
        const Basis basis(ka, angle(point));
        slopes[point] = basis.slope;
        values[point] = basis.value;
        speed[point] = std::cos(angle(point));
    }
    const std::array<Complex, terms> strength = solve(slopes, speed);
    Complex integral = 0;
    for (std::size_t point = 0; point < terms; ++point) {
        Complex potential = 0;
        for (std::size_t m = 0; m < terms; ++m) {
            potential += strength[m] * values[point][m];
        }
        integral += 2 * width * std::cos(angle(point)) * potential;  // both sides
    }
    return {-integral.real(), -integral.imag(), strength[0]};
}

HeaveDecay::HeaveDecay() {
    constexpr double width = 0.01, highest = 3.2;  // as said above
    constexpr double mass = 0.5 * M_PI, stiffness = 2;
    for (double w = 0.5 * width; w < highest; w += width) {
        const HeaveLoads loads = heave_loads(w * w);
        const Complex s(0, w);
        const Complex inertia = s * (mass + loads.added_mass) + loads.damping * w;
        frequency_.push_back(w);
        response_.push_back(2 / M_PI * width * (inertia / (s * inertia + stiffness)).real());
    }
}

double HeaveDecay::at(double time) const {
    double sum = 0;
    for (std::size_t i = 0; i < frequency_.size(); ++i) {
        sum += response_[i] * std::cos(frequency_[i] * time);
    }
    return sum;
}

}  // namespace riprap::validation::water
