// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/particle_walls/side_forces.hpp"

#include <algorithm>
#include <cmath>

#include "riprap/core/selection.hpp"
#include "riprap/fluid/mps_operators/mps_lattice.hpp"
#include "riprap/fluid/mps_operators/wall_pairs.hpp"
#include "riprap/fluid/particle/kernel.hpp"
#include "riprap/fluid/particle/state_equation.hpp"
#include "riprap/fluid/particle/sweep/periodic_images.hpp"
#include "riprap/fluid/sph/gradient_correction.hpp"

namespace riprap::coupling {

namespace {

constexpr double behind = 0.5;  ///< spacings behind the plane from which on water is on its other side

/// p of a particle by the law of its scheme [Pa].
double pressure_in(const fluid::ParticleSettings& settings, double density) {
    return fluid::pressure_of(settings, density);
}
double pressure_in(const fluid::WcmpsSettings& settings, double density) {
    return fluid::pressure_of(settings, density / settings.rest_density);
}

/// x and q of MpsPressureOnWalls.
std::array<double, 2> carried_by(const fluid::WcmpsSettings& settings, double density, double pressure) {
    const double x = density / settings.rest_density;
    return {x, pressure / x};
}
std::array<double, 2> carried_by(const fluid::MpsSettings& /*settings*/, double /*density*/, double pressure) {
    return {1, pressure};
}

}  // namespace

SideForces::SideForces(const WaterAtFace& water, const fluid::BoundaryParticles& walls, const Vec3& place,
                       const Vec3& normal, double reach)
    : water_(water), walls_(walls), place_(place), reach_(reach) {
    std::visit(
        [&](const auto& settings) {
            const fluid::PeriodicImages images(settings.domain);
            const std::vector<Vec3>& places = water.particles.position;
            const auto is_near = [&](std::size_t j) {
                return !(norm_squared(images.nearest(places[j], place) - place) > reach * reach);
            };
            for (const std::size_t j : parallel::select(water.particles.size(), is_near)) {
                const Vec3 x = images.nearest(places[j], place);
                const double density = water.particles.density[j];
                const bool is_in_front = dot(x - place, normal) > -behind * settings.spacing;
                near_.push_back({x, pressure_in(settings, density), settings.particle_mass / density, density,
                                 fluid::unit_tensor, is_in_front});
                has_water_behind_ = has_water_behind_ || !is_in_front;
            }
        },
        water.scheme);
    const auto* const sph = std::get_if<fluid::SphSettings>(&water.scheme);
    if (has_water_behind_ && sph != nullptr && sph->gradient_correction) {
        correct_gradients(*sph);
    }
}

/// Finds B of the particles behind the plane, whose supports lie within the reach where it matters.
void SideForces::correct_gradients(const fluid::SphSettings& settings) {
    const int dimension = settings.domain.dimension;
    const fluid::WendlandC2 kernel(settings.smoothing_length(), dimension);
    const fluid::PeriodicImages images(settings.domain);
    const double support = 2 * settings.smoothing_length();
    const auto add = [&](const Vec3& d, double volume, fluid::Symmetric& moments) {
        if (norm_squared(d) > support * support) {
            return;
        }
        const double slope = volume * kernel.slope_over_r(norm(d));
        moments[0] -= slope * d.x * d.x;
        moments[1] -= slope * d.y * d.y;
        moments[2] -= slope * d.x * d.y;
        moments[3] -= slope * d.z * d.z;
        moments[4] -= slope * d.x * d.z;
        moments[5] -= slope * d.y * d.z;
    };
    std::vector<std::pair<Vec3, double>> solid;
    for (std::size_t w = 0; w < walls_.position.size(); ++w) {
        const Vec3 x = images.nearest(walls_.position[w], place_);
        if (norm_squared(x - place_) < reach_ * reach_) {
            solid.emplace_back(x, walls_.volume[w]);
        }
    }
    for (Near& one : near_) {
        if (one.is_in_front) {
            continue;  // correction_by() reads those behind alone
        }
        fluid::Symmetric moments{};
        for (const Near& other : near_) {
            add(one.place - other.place, other.volume, moments);
        }
        for (const auto& [x, volume] : solid) {
            add(one.place - x, volume, moments);
        }
        one.correction = fluid::gradient_correction(dimension, moments).tensor;
    }
}

Vec3 SideForces::correction(std::size_t wall) const {
    const auto* const wcmps = std::get_if<fluid::WcmpsSettings>(&water_.scheme);
    if (wcmps != nullptr && wcmps->wall_loads == fluid::WallLoads::pressure_area) {
        return {};  // a load of the first layer along its normal
    }
    return std::visit([&](const auto& settings) { return correction_by(settings, wall); }, water_.scheme);
}

/// SPH: -V_w sum V_j (p_w + p_j) B_j grad W (docs/theory/sph.md, 5).
Vec3 SideForces::correction_by(const fluid::SphSettings& settings, std::size_t wall) const {
    const fluid::WendlandC2 kernel(settings.smoothing_length(), settings.domain.dimension);
    const fluid::PeriodicImages images(settings.domain);
    const Vec3 x = images.nearest(walls_.position[wall], place_);
    Vec3 sum{};
    for (const Near& water : near_) {
        if (!water.is_in_front) {
            const Vec3 d = x - water.place;
            sum += (walls_.pressure[wall] + water.pressure) * water.volume * kernel.slope_over_r(norm(d)) *
                   fluid::symmetric_apply(water.correction, d);
        }
    }
    return walls_.volume[wall] * sum;
}

/// Moving particles: b D/n_0 (q_j + x_j p_w) d W/r^2, or (2 q_j + h.d) of mirrored walls (docs/theory/wcmps.md, 5).
template <class Scheme>
Vec3 SideForces::correction_by(const Scheme& settings, std::size_t wall) const {
    const fluid::PeriodicImages images(settings.domain);
    const Vec3 x = images.nearest(walls_.position[wall], place_), pull = water_.gravity - walls_.acceleration[wall];
    const fluid::MpsPressureOnWalls law{settings.weight()};
    std::array<double, fluid::MpsPressureOnWalls::sums> sums{};
    const double* const none = nullptr;  // a boundary particle brings no number of its own
    for (const Near& water : near_) {
        if (water.is_in_front) {
            continue;
        }
        const Vec3 way = x - water.place;
        const double d[3] = {way.x, way.y, way.z};
        const std::array<double, 2> carried = carried_by(settings, water.density, water.pressure);
        if (settings.domain.dimension == 2) {
            law.template operator()<2>(none, carried.data(), d, norm_squared(way), norm(way), sums.data());
        } else {
            law.template operator()<3>(none, carried.data(), d, norm_squared(way), norm(way), sums.data());
        }
    }
    const auto at = [&](int k) { return sums[static_cast<std::size_t>(k)]; };
    using Sums = fluid::MpsPressureOnWalls;
    const Vec3 slope{at(Sums::at_slope), at(Sums::at_slope + 1), at(Sums::at_slope + 2)};
    const Vec3 push{at(Sums::at_push), at(Sums::at_push + 1), at(Sums::at_push + 2)};
    Vec3 felt = push + walls_.pressure[wall] * slope;
    if (settings.wall_pressure == fluid::MpsWallPressure::mirrored) {
        constexpr int moment = Sums::at_moment;
        felt = 2.0 * push + fluid::symmetric_apply({at(moment), at(moment + 1), at(moment + 2), at(moment + 3),
                                                    at(moment + 4), at(moment + 5)},
                                                   settings.rest_density * pull);
    }
    return -(settings.lattice().first_order() * walls_.volume[wall]) * felt;
}

}  // namespace riprap::coupling
