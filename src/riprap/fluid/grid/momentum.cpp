// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/grid/momentum.hpp"

#include <cmath>

#include "riprap/fluid/grid/boundary.hpp"
#include "riprap/fluid/grid/porous.hpp"
#include "riprap/fluid/grid/surface.hpp"
#include "riprap/fluid/grid/viscous.hpp"

namespace riprap::fluid::grid {

namespace {

/// Koren's limiter: third order where the flow is smooth, no new extremes [-].
double koren(double r) { return std::max(0.0, std::min({2 * r, (1 + 2 * r) / 3, 2.0})); }

/// Velocity that a mass takes along through a face between `up` and `down`, `far` beyond `up`; `courant` of the mass in
/// its velocity cell moves the value half a step upstream in time.
double carried(double far, double up, double down, double courant) {
    const double rise = down - up;
    if (rise == 0) {
        return up;
    }
    return up + 0.5 * (1 - courant) * koren((up - far) / rise) * rise;
}

struct Transport {
    const GridSettings& settings;
    const GridScratch& s;
    const std::vector<double>& u;  ///< pore velocity of the component
    int a;
    bool is_midpoint;

    /// Mass through a face of the mesh in the step [kg].
    double mass_flux(int b, std::int64_t f) const {
        const double water = s.water_flux[at(b)][at(f)];
        return settings.has_surface
                   ? settings.water.density * water + settings.air.density * (s.flux[at(b)][at(f)] - water)
                   : settings.water.density * water;
    }
    /// Momentum through the lower face, across b, of the velocity cell at face i [kg m/s]; adds its mass to `in`.
    double momentum_flux(int b, std::int64_t i, double inverse_mass, double& mass) const {
        const std::int64_t t = settings.mesh.box.stride[at(b)], sa = settings.mesh.box.stride[at(a)];
        mass = b == a ? 0.5 * (mass_flux(a, i - t) + mass_flux(a, i)) : 0.5 * (mass_flux(b, i - sa) + mass_flux(b, i));
        if (mass == 0) {
            return 0;
        }
        const double courant = is_midpoint ? 0 : std::min(1.0, std::abs(mass) * inverse_mass);
        return mass * (mass > 0 ? carried(u[at(i - 2 * t)], u[at(i - t)], u[at(i)], courant)
                                : carried(u[at(i + t)], u[at(i)], u[at(i - t)], courant));
    }
    /// Pore velocity after the transport alone.
    double advance(std::int64_t i, bool is_on_rim) const {
        const CellBox& box = settings.mesh.box;
        const std::int64_t sa = box.stride[at(a)];
        const double before = 0.5 * (s.mass_before[at(i - sa)] + s.mass_before[at(i)]);
        const double after = 0.5 * (s.mass[at(i - sa)] + s.mass[at(i)]);
        const double start = s.start_velocity[at(a)][at(i)];
        if (!(after > 0)) {
            return start;
        }
        const double inverse = 1 / after;
        double momentum = before * start, in = 0, out = 0, upwind = before * start;
        for (int b = 0; b < box.axes; ++b) {
            const std::int64_t t = box.stride[at(b)];
            double low_mass = 0, high_mass = 0;
            const double low = momentum_flux(b, i, inverse, low_mass);
            const double high = momentum_flux(b, i + t, inverse, high_mass);
            momentum += low - high;
            in += std::max(0.0, low_mass) + std::max(0.0, -high_mass);
            out += std::max(0.0, -low_mass) + std::max(0.0, high_mass);
            upwind += std::max(0.0, low_mass) * u[at(i - t)] + std::max(0.0, -high_mass) * u[at(i + t)];
        }
        // A sliver beside a solid, flushed in the step, takes the mean of what comes in: bounded for any step. So does
        // a velocity cell on an open side, half of which lies outside.
        const bool is_flushed = is_on_rim || (s.open.has_bodies && in > 0.45 * std::min(before, after));
        if (is_flushed) {
            return upwind / (before + in);
        }
        if (s.open.has_bodies && !(before + in - out > 0)) {  // uncovered in this step, and nothing has come in yet
            return start;
        }
        // Where solids move, the mass that stays is that of the fluxes: a uniform flow stays uniform around them.
        return momentum / (s.open.has_bodies ? before + in - out : after);
    }
};

/// Height of the surface at a face, g.x on it, for the jump of the density there [m^2/s^2].
double surface_potential(const GridSettings& settings, const GridState& state, const GridScratch& s, const Vec3& g,
                         int a, std::int64_t f, const std::array<int, 3>& place) {
    const Mesh& mesh = settings.mesh;
    const auto on_plane = [&](std::int64_t c, const std::array<int, 3>& p) {
        const CellPlane& plane = s.plane[at(c)];
        const double size = plane.n[0] * plane.n[0] + plane.n[1] * plane.n[1] + plane.n[2] * plane.n[2];
        double potential = 0;
        for (int b = 0; b < 3; ++b) {
            const double offset = size > 0 ? plane.d * plane.n[at(b)] / size : 0;
            potential += g[b] * (mesh.centre(b, p[at(b)]) + offset * mesh.h(b, p[at(b)]));
        }
        return potential;
    };
    std::array<int, 3> below = place;
    below[at(a)] -= 1;
    const std::int64_t low = f - mesh.box.stride[at(a)];
    const bool is_low = is_mixed(state.fraction[at(low)]), is_high = is_mixed(state.fraction[at(f)]);
    if (is_low && is_high) {
        return 0.5 * (on_plane(low, below) + on_plane(f, place));
    }
    if (is_low || is_high) {
        return is_low ? on_plane(low, below) : on_plane(f, place);
    }
    double potential = 0;
    for (int b = 0; b < 3; ++b) {
        potential += g[b] * (b == a ? mesh.edge[at(b)][at(place[at(b)])] : mesh.centre(b, place[at(b)]));
    }
    return potential;
}

}  // namespace

double density_of(const GridSettings& settings, double fraction) {
    return settings.has_surface ? settings.air.density + fraction * (settings.water.density - settings.air.density)
                                : settings.water.density;
}

double viscosity_of(const GridSettings& settings, double fraction) {
    constexpr double inviscid = 1e-30;  // keeps 1/mu finite
    const double water = std::max(inviscid, settings.water.density * settings.water.kinematic_viscosity);
    const double air = std::max(inviscid, settings.air.density * settings.air.kinematic_viscosity);
    return settings.has_surface ? 1 / (fraction / water + (1 - fraction) / air) : water;
}

Vec3 body_force(const GridSettings& settings, double time) {
    return settings.frame_acceleration ? settings.gravity + settings.frame_acceleration(time) : settings.gravity;
}

void find_masses(const GridSettings& settings, const GridState& state, GridScratch& s) {
    const CellBox& box = settings.mesh.box;
    std::array<int, 3> first{}, last = box.cells;
    for (int a = 0; a < box.axes; ++a) {
        first[at(a)] = -1;
        last[at(a)] += 1;
    }
    for_box(box, first, last, [&](std::int64_t c, int, int, int) {
        s.mass_before[at(c)] = s.capacity_before[at(c)] * density_of(settings, s.start_fraction[at(c)]);
        s.mass[at(c)] = s.capacity[at(c)] * density_of(settings, state.fraction[at(c)]);
        s.viscosity[at(c)] =
            viscosity_of(settings, state.fraction[at(c)]) +
            (s.eddy_viscosity.empty() ? 0.0 : density_of(settings, state.fraction[at(c)]) * s.eddy_viscosity[at(c)]);
    });
    if (settings.has_surface) {
        reconstruct_surface(settings.mesh, state.fraction, s.plane);
    }
}

void predict_velocity(const GridSettings& settings, const GridState& state, GridScratch& s,
                      const std::array<std::vector<double>, 3>& advected, bool is_midpoint, double dt) {
    const Mesh& mesh = settings.mesh;
    const CellBox& box = mesh.box;
    const Vec3 g = body_force(settings, state.time + dt);
    const double jump = settings.water.density - settings.air.density;
    for (int a = 0; a < box.axes; ++a) {
        const std::int64_t sa = box.stride[at(a)];
        const bool low_open = settings.side[at(low_side(a))].kind == SideKind::open;
        const bool high_open = settings.side[at(high_side(a))].kind == SideKind::open;
        const Transport transport{settings, s, advected[at(a)], a, is_midpoint};
        for_faces(box, a, [&](std::int64_t f, int i, int j, int k) {
            const std::array<int, 3> place{i, j, k};
            const int p = place[at(a)];
            double& predicted = s.predicted[at(a)][at(f)];
            double& mobility = s.mobility[at(a)][at(f)];
            const bool is_given = (p == 0 && !low_open) || (p == box.cells[at(a)] && !high_open);
            if (is_given || s.area[at(a)][at(f)] == 0) {
                predicted = is_given ? state.velocity[at(a)][at(f)] : s.open.body_velocity[at(a)][at(f)];
                mobility = 0;
                return;
            }
            const double share_low = 0.5 * mesh.h(a, p - 1) / mesh.d(a, p), share_high = 1 - share_low;
            const double low_fraction = state.fraction[at(f - sa)], high_fraction = state.fraction[at(f)];
            const double density =
                share_low * density_of(settings, low_fraction) + share_high * density_of(settings, high_fraction);
            const FaceMedium medium = face_medium(settings, s, f, sa, share_low, density,
                                                  0.5 * (s.viscosity[at(f - sa)] + s.viscosity[at(f)]));
            double force = viscous_force(settings, s, a, f, place) / medium.porosity;
            if (!settings.has_surface) {
                force += density * g[a];
            } else if (low_fraction != high_fraction) {
                const double rise = (high_fraction - low_fraction) / mesh.d(a, p);
                force -= surface_potential(settings, state, s, g, a, f, place) * jump * rise;
                if (settings.surface_tension > 0) {
                    const double low = s.curvature[at(f - sa)], high = s.curvature[at(f)];
                    const double curvature = low != 0 && high != 0 ? 0.5 * (low + high) : low + high;
                    force += settings.surface_tension * curvature * rise;
                }
            }
            const double start = s.start_velocity[at(a)][at(f)];
            const double moved =
                start + (transport.advance(f, p == 0 || p == box.cells[at(a)]) - start) / (1 + medium.added_mass);
            const double inertia = (1 + medium.added_mass) * density;
            const double speed = medium.quadratic > 0 ? filter_speed(settings, s, a, f) : 0;
            const double resistance = medium.porosity * (medium.linear + medium.quadratic * speed);
            const double wall = s.open.has_bodies ? s.wall_drag[at(a)][at(f)] : 0;
            const double wall_velocity = s.open.has_bodies ? s.open.body_velocity[at(a)][at(f)] : 0;
            const double factor = medium.porosity / (inertia + dt * (resistance + wall));
            predicted = factor * (inertia * moved + dt * (force + wall * wall_velocity));
            mobility = factor;
        });
    }
}

}  // namespace riprap::fluid::grid
