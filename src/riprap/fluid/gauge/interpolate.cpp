// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/gauge/interpolate.hpp"

#include <algorithm>

#include "riprap/core/selection.hpp"

namespace riprap::fluid {

namespace {

/// A place with less water than this share counts as dry [-].
constexpr double dry_fraction = 0.1;
/// With less than this share of the support filled, as on a lip of spray, a slope would be a guess [-].
constexpr double slope_fraction = 0.2;
/// Smallest pivot, over the sum of weights, at which the particles determine a slope. A half-filled support has 0.02.
constexpr double smallest_pivot = 1e-3;

}  // namespace

double spline_weight(double distance, double width) {
    const double u = std::abs(distance) / width;
    if (u >= 2) {
        return 0;
    }
    const double tail = (2 - u) * (2 - u) * (2 - u);
    return (u < 1 ? 4 - 6 * u * u + 3 * u * u * u : tail) / (6 * width);
}

namespace {

/// Integral of the spline of width 1 from -2 to u.
double spline_integral(double u) {
    const double x = std::min(std::abs(u), 2.0), rest = 2 - x;
    const double beyond = x < 1 ? 0.5 - x * (4 - x * x * (2 - 0.75 * x)) / 6 : rest * rest * rest * rest / 24;
    return u < 0 ? beyond : 1 - beyond;
}

}  // namespace

double sensor_weight(double distance, double width, double side) {
    constexpr double least = 1e-4;  // of the width: less is a point, as the difference below would lose digits
    if (side < least * width) {
        return spline_weight(distance, width);
    }
    const double half = 0.5 * side;
    return (spline_integral((distance + half) / width) - spline_integral((distance - half) / width)) / side;
}

std::vector<std::size_t> particles_near_line(const Vec3& a, const Vec3& b, const ParticleSettings& settings,
                                             const ParticleState& state) {
    const double reach = settings.support_radius();
    const Vec3 way = b - a;
    const double length_squared = norm_squared(way);
    const PeriodicImages images(settings.domain);
    const auto is_near = [&](const Vec3& x) {
        const Vec3 d = x - a;
        const double share = length_squared > 0 ? std::clamp(dot(d, way) / length_squared, 0.0, 1.0) : 0.0;
        return norm_squared(d - share * way) < reach * reach;
    };
    return parallel::select(state.size(), [&](std::size_t j) {
        return std::any_of(images.shifts().begin(), images.shifts().end(),
                           [&](const Vec3& shift) { return is_near(state.position[j] + shift); });
    });
}

double water_fraction(const Vec3& x, const ParticleSettings& settings, const ParticleState& state,
                      const std::vector<std::size_t>& near) {
    const WendlandC2 kernel(settings.smoothing_length(), settings.domain.dimension);
    const PeriodicImages images(settings.domain);
    double sum = 0;
    for (const std::size_t j : near) {
        sum += settings.particle_mass / state.density[j] * kernel.value(norm(images.nearest(state.position[j], x) - x));
    }
    return sum;
}

void LinearFit::add(double weight, const std::array<double, 4>& base, double value) {
    for (std::size_t r = 0; r < 4; ++r) {
        values[r] += weight * base[r] * value;
        for (std::size_t c = 0; c < 4; ++c) {
            moments[r][c] += weight * base[r] * base[c];
        }
    }
}

double LinearFit::value(int dimension) const {
    const double fraction = moments[0][0];
    if (fraction < dry_fraction) {
        return 0;
    }
    const double mean = values[0] / fraction;
    if (fraction < slope_fraction) {
        return mean;
    }
    // Cholesky without roots, from the last base function to the first, so that the first unknown is the last pivot.
    auto m = moments;
    auto v = values;
    for (auto k = static_cast<std::size_t>(dimension); k > 0; --k) {
        if (m[k][k] < smallest_pivot * fraction) {
            return mean;
        }
        for (std::size_t r = 0; r < k; ++r) {
            const double factor = m[r][k] / m[k][k];
            for (std::size_t c = 0; c <= r; ++c) {
                m[r][c] -= factor * m[c][k];
                m[c][r] = m[r][c];
            }
            v[r] -= factor * v[k];
        }
    }
    return m[0][0] < smallest_pivot * fraction ? mean : v[0] / m[0][0];
}

}  // namespace riprap::fluid
