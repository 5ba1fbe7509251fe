// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/sph/courant_bound.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "riprap/core/vec3.hpp"
#include "riprap/fluid/particle/kernel.hpp"
#include "riprap/fluid/sph/acoustic_damping.hpp"

namespace riprap::fluid {
namespace {

/// Symbols of gradient and Laplacian on the lattice: h g and h^2 L.
struct Symbols {
    double gradient, diffusion;
};

/// @param wave  wave number times spacing
Symbols symbols_of(const SphSettings& settings, const Vec3& wave) {
    const int dimension = settings.domain.dimension;
    const double ratio = settings.smoothing_ratio;  // h, in spacings
    const WendlandC2 kernel(ratio, dimension);
    const int reach = static_cast<int>(std::ceil(2 * ratio)), depth = dimension == 3 ? reach : 0;
    Vec3 gradient{};
    double diffusion = 0;
    for (int z = -depth; z <= depth; ++z) {
        for (int y = -reach; y <= reach; ++y) {
            for (int x = -reach; x <= reach; ++x) {
                const Vec3 d{double(x), double(y), double(z)};
                const double slope = -kernel.slope_over_r(norm(d));
                gradient += slope * std::sin(dot(wave, d)) * d;
                diffusion += slope * (1 - std::cos(dot(wave, d)));
            }
        }
    }
    return {ratio * norm(gradient), ratio * ratio * diffusion};
}

/// The largest C for one wave: the smaller root of 4 = w^2 + 2 l + 2 r - l r, no more than l = 2 allows.
double bound_of(double delta, double damping, const Symbols& wave) {
    const double l = 2 * delta * wave.diffusion, r = damping * wave.gradient * wave.gradient;  // per C
    const double square = wave.gradient * wave.gradient - l * r, linear = 2 * (l + r);
    const double from_diffusion = l > 0 ? 2 / l : std::numeric_limits<double>::infinity();
    const double root = linear * linear + 16 * square;
    if (root < 0 || linear + std::sqrt(root) == 0) {
        return from_diffusion;
    }
    return std::min(from_diffusion, 8 / (linear + std::sqrt(root)));
}

}  // namespace

double courant_bound(const SphSettings& settings) {
    constexpr int steps = 64;
    const double damping = strength_of_damping(settings);
    double bound = std::numeric_limits<double>::infinity();
    for (int axes = 1; axes <= settings.domain.dimension; ++axes) {
        for (int k = 1; k <= steps; ++k) {
            const double wave = std::numbers::pi * k / steps;
            const Symbols symbols = symbols_of(settings, {wave, axes >= 2 ? wave : 0, axes == 3 ? wave : 0});
            bound = std::min(bound, bound_of(settings.density_diffusion, damping, symbols));
        }
    }
    return bound;
}

}  // namespace riprap::fluid
