// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "riprap/fluid/particle/kernel.hpp"
#include "riprap/fluid/particle/particle_settings.hpp"
#include "riprap/fluid/particle/particle_state.hpp"
#include "riprap/fluid/particle/sweep/periodic_images.hpp"

namespace riprap::fluid {

/// Cubic B-spline of width w: a weight across a line or plane that ends at 2 w. Its sum over points w apart is exactly
/// 1/w wherever they begin, so rows of particles at their spacing count exactly.
double spline_weight(double distance, double width);  ///< [1/m]

/// Mean of that spline over the distances from `distance` - side/2 to `distance` + side/2: what a sensor as long as
/// `side` takes of a point. It goes over into the spline where the side goes to 0, and its sum over points w apart is
/// exactly 1/w too.
double sensor_weight(double distance, double width, double side);  ///< [1/m]

/// Indices of the particles that have an image within a support of the line from a to b, ascending.
std::vector<std::size_t> particles_near_line(const Vec3& a, const Vec3& b, const ParticleSettings& settings,
                                             const ParticleState& state);

/// sum_j V_j W(|x - x_j|) over the nearest images of the listed particles: 1 inside water, about one half at its
/// surface and on a wall [-].
double water_fraction(const Vec3& x, const ParticleSettings& settings, const ParticleState& state,
                      const std::vector<std::size_t>& near);

/// Sums of a first-order moving least-squares fit about one point: the moments of the weights and of weight times value
/// against the base {1, dx/h, dy/h, dz/h}.
struct LinearFit {
    std::array<std::array<double, 4>, 4> moments{};
    std::array<double, 4> values{};

    void add(double weight, const std::array<double, 4>& base, double value);
    /// The value of the fit at the point. The weighted mean where the particles do not determine a slope, 0 where the
    /// place is dry.
    double value(int dimension) const;
};

/// A field of the particles at x by moving least squares; `field(j)` is its value at particle j.
template <class Field>
double interpolate(const Vec3& x, const ParticleSettings& settings, const ParticleState& state, const Field& field) {
    const double h = settings.smoothing_length();
    const WendlandC2 kernel(h, settings.domain.dimension);
    const PeriodicImages images(settings.domain);
    LinearFit fit;
    for (const std::size_t j : particles_near_line(x, x, settings, state)) {
        const Vec3 d = images.nearest(state.position[j], x) - x;
        const double weight = settings.particle_mass / state.density[j] * kernel.value(norm(d));
        fit.add(weight, {1, d.x / h, d.y / h, d.z / h}, field(j));
    }
    return fit.value(settings.domain.dimension);
}

}  // namespace riprap::fluid
