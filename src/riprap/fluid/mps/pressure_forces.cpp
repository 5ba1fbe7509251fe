// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "riprap/core/mat3.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/fluid/mps/mps.hpp"
#include "riprap/fluid/mps/separation.hpp"

namespace riprap::fluid {

using mps::Separation;

namespace {

/// Force on i by pairs in balance, P_i + P_j; walls have a pressure, or 2 P_i - h.d stands for both.
Vec3 conservative_force(const MpsSettings& settings, const Separation& separation, std::size_t i, const MpsScratch& s) {
    const MpsWeight weight = settings.weight();
    Vec3 force{};
    for (std::int64_t e = s.around.fluid.first(i); e < s.around.fluid.end(i); ++e) {
        const std::size_t j = s.around.fluid.index(e);
        const Vec3 d = separation(s.around.predicted[i], s.around.predicted[j]);
        force += (s.water.pressure[i] + s.water.pressure[j]) *
                 weight.over_square(norm_squared(d), s.around.fluid.weight(e)) * d;
    }
    for (std::int64_t e = s.around.walls.first(i); e < s.around.walls.end(i); ++e) {
        const std::size_t w = s.around.walls.index(e);
        const Vec3 d = separation(s.around.predicted[i], s.around.predicted_walls[w]);
        const double m = s.walls.mirrors[w];
        const double push = (1 + m) * s.water.pressure[i] + s.walls.pressure[w] - m * dot(s.walls.head[w], d);
        force += push * s.walls.share[w] * weight.over_square(norm_squared(d), s.around.walls.weight(e)) * d;
    }
    return force;
}

/// n_0/D times minus the gradient that is exact for linear pressures, with P_j - min P in place of P_j - P_i.
Vec3 corrected_force(const MpsSettings& settings, const MpsLattice& lattice, const Separation& separation,
                     std::size_t i, const MpsScratch& s) {
    const MpsWeight weight = settings.weight();
    const auto wall_pressure = [&](std::size_t w, const Vec3& d) {
        return std::max(0.0, s.walls.follows[w] * s.water.pressure[i] + s.walls.given[w] - dot(s.walls.head[w], d));
    };
    double least = s.water.pressure[i];
    for (std::int64_t e = s.around.fluid.first(i); e < s.around.fluid.end(i); ++e) {
        least = std::min(least, s.water.pressure[s.around.fluid.index(e)]);
    }
    for (std::int64_t e = s.around.walls.first(i); e < s.around.walls.end(i); ++e) {
        const std::size_t w = s.around.walls.index(e);
        least = std::min(least, wall_pressure(w, separation(s.around.predicted[i], s.around.predicted_walls[w])));
    }
    Vec3 sum{};
    Mat3 moment = settings.domain.dimension == 2 ? Mat3::diagonal({0, 0, lattice.number_density}) : Mat3{};
    const auto add = [&](const Vec3& d, double w, double pressure) {
        const Vec3 slope = weight.over_square(norm_squared(d), w) * d;
        sum += (pressure - least) * slope;
        moment = moment + outer(slope, d);
    };
    for (std::int64_t e = s.around.fluid.first(i); e < s.around.fluid.end(i); ++e) {
        const std::size_t j = s.around.fluid.index(e);
        add(separation(s.around.predicted[i], s.around.predicted[j]), s.around.fluid.weight(e), s.water.pressure[j]);
    }
    for (std::int64_t e = s.around.walls.first(i); e < s.around.walls.end(i); ++e) {
        const std::size_t w = s.around.walls.index(e);
        const Vec3 d = separation(s.around.predicted[i], s.around.predicted_walls[w]);
        add(d, s.walls.share[w] * s.around.walls.weight(e), wall_pressure(w, d));
    }
    const double even = lattice.number_density / settings.domain.dimension;
    const bool is_regular = determinant(moment) > 1e-3 * lattice.number_density * even * even;
    return is_regular ? even * (inverse(moment) * sum) : sum;
}

}  // namespace

void Mps::find_pressure_forces() {
    MpsScratch& s = scratch_;
    const Separation separation(settings_.domain);
    const double factor = lattice_.first_order() * settings_.particle_mass / settings_.rest_density;
    s.water.pressure_force.resize(s.around.predicted.size());
    parallel::for_each_uneven(static_cast<std::int64_t>(s.around.predicted.size()), 256, [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        s.water.pressure_force[i] = factor * (settings_.gradient == MpsGradient::conservative
                                                  ? conservative_force(settings_, separation, i, s)
                                                  : corrected_force(settings_, lattice_, separation, i, s));
    });
}

}  // namespace riprap::fluid
