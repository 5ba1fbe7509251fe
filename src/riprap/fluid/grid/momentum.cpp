// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/grid/momentum.hpp"

#include <cmath>

#include "riprap/fluid/grid/boundary.hpp"
#include "riprap/fluid/grid/datum.hpp"
#include "riprap/fluid/grid/porous.hpp"
#include "riprap/fluid/grid/surface.hpp"
#include "riprap/fluid/grid/transport.hpp"
#include "riprap/fluid/grid/viscous.hpp"

namespace riprap::fluid::grid {

namespace {

/// Height of the surface at a face, g.(x - datum) on it, for the jump of the density there [m^2/s^2].
double surface_potential(const GridSettings& settings, const GridState& state, const GridScratch& s, const Vec3& g,
                         int a, std::int64_t f, const std::array<int, 3>& place) {
    const Mesh& mesh = settings.mesh;
    const Vec3 datum = datum_of(mesh);
    const auto on_plane = [&](std::int64_t c, const std::array<int, 3>& p) {
        const CellPlane& plane = s.moved.plane[at(c)];
        const double size = plane.n[0] * plane.n[0] + plane.n[1] * plane.n[1] + plane.n[2] * plane.n[2];
        double potential = 0;
        for (int b = 0; b < 3; ++b) {
            const double offset = size > 0 ? plane.d * plane.n[at(b)] / size : 0;
            potential += g[b] * (mesh.centre(b, p[at(b)]) - datum[b] + offset * mesh.h(b, p[at(b)]));
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
        potential += g[b] * ((b == a ? mesh.edge[at(b)][at(place[at(b)])] : mesh.centre(b, place[at(b)])) - datum[b]);
    }
    return potential;
}

}  // namespace

double density_of(const GridSettings& settings, double fraction) {
    const double share = std::min(1.0, fraction);  // pockets may be over-full
    return settings.has_surface ? settings.air.density + share * (settings.water.density - settings.air.density)
                                : settings.water.density;
}

double viscosity_of(const GridSettings& settings, double fraction) {
    constexpr double inviscid = 1e-30;  // keeps 1/mu finite
    const double water = std::max(inviscid, settings.water.density * settings.water.kinematic_viscosity);
    const double air = std::max(inviscid, settings.air.density * settings.air.kinematic_viscosity);
    const double share = std::min(1.0, fraction);  // pockets may be over-full
    return settings.has_surface ? 1 / (share / water + (1 - share) / air) : water;
}

Vec3 body_force(const GridSettings& settings, double time) {
    return settings.frame_acceleration ? settings.gravity + settings.frame_acceleration(time) : settings.gravity;
}

namespace {

/// Sum of the rates of all sponges at a face, of water and air alike [1/s].
double sponge_rate(const GridSettings& settings, int a, const std::array<int, 3>& place) {
    double rate = 0;
    for (const Sponge& sponge : settings.sponges) {
        Vec3 x = settings.mesh.centre(place[0], place[1], place[2]);
        x[a] = settings.mesh.edge[at(a)][at(place[at(a)])];
        rate += sponge.rate(x);
    }
    return rate;
}

/// Calls f(index, i, j, k) for cells and the first layer of ghosts.
template <class F>
void for_cells_and_beside(const CellBox& box, const F& f) {
    std::array<int, 3> first{}, last = box.cells;
    for (int a = 0; a < box.axes; ++a) {
        first[at(a)] = -1;
        last[at(a)] += 1;
    }
    for_box(box, first, last, f);
}

}  // namespace

void find_masses_before(const GridSettings& settings, const GridState& state, GridScratch& s) {
    const std::vector<double>& room = s.room.before();
    for_cells_and_beside(settings.mesh.box, [&](std::int64_t c, int, int, int) {
        s.inertia.mass_before[at(c)] = room[at(c)] * density_of(settings, state.fraction[at(c)]);
    });
}

void find_masses(const GridSettings& settings, const GridState& state, GridScratch& s) {
    for_cells_and_beside(settings.mesh.box, [&](std::int64_t c, int, int, int) {
        s.inertia.mass[at(c)] = s.room.capacity[at(c)] * density_of(settings, state.fraction[at(c)]);
    });
    if (settings.has_surface) {
        reconstruct_surface(settings.mesh, state.fraction, s.moved.plane);
    }
}

void find_viscosity(const GridSettings& settings, const GridState& state, GridScratch& s) {
    for_cells_and_beside(settings.mesh.box, [&](std::int64_t c, int, int, int) {
        s.stress.viscosity[at(c)] = viscosity_of(settings, state.fraction[at(c)]) +
                                    (s.stress.eddy_viscosity.empty() ? 0.0
                                                                     : density_of(settings, state.fraction[at(c)]) *
                                                                           s.stress.eddy_viscosity[at(c)]);
    });
}

namespace {

/// Forces and resistances on the velocity cells of one component.
struct Prediction {
    const GridSettings& settings;
    const GridState& state;
    GridScratch& s;
    const Vec3 g;
    const int a;
    const double dt;

    bool is_given(int p) const {
        return (p == 0 && settings.side[at(low_side(a))].kind != SideKind::open) ||
               (p == settings.mesh.box.cells[at(a)] && settings.side[at(high_side(a))].kind != SideKind::open);
    }
    /// Weight and surface tension, as far as the pressure does not balance them [N/m^3].
    double body_force(std::int64_t f, const std::array<int, 3>& place, double density) const {
        const double low = state.fraction[at(f - settings.mesh.box.stride[at(a)])], high = state.fraction[at(f)];
        if (!settings.has_surface) {
            return density * g[a];
        }
        if (low == high) {
            return 0;
        }
        const double rise = (high - low) / settings.mesh.d(a, place[at(a)]);
        double force = -surface_potential(settings, state, s, g, a, f, place) *
                       (settings.water.density - settings.air.density) * rise;
        if (settings.surface_tension > 0) {
            const double below = s.stress.curvature[at(f - settings.mesh.box.stride[at(a)])],
                         above = s.stress.curvature[at(f)];
            const double curvature = below != 0 && above != 0 ? 0.5 * (below + above) : below + above;
            force += settings.surface_tension * curvature * rise;
        }
        return force;
    }
    /// @param moved  velocity after the transport alone [m/s]
    /// @param shear  force of viscosity [N/m^3]
    void find(std::int64_t f, const std::array<int, 3>& place, double moved, double shear) const {
        const Mesh& mesh = settings.mesh;
        const std::int64_t sa = mesh.box.stride[at(a)];
        const int p = place[at(a)];
        double& predicted = s.projection.predicted[at(a)][at(f)];
        double& conductance = s.projection.conductance.face[at(a)][at(f)];
        if (is_given(p) || s.room.area[at(a)][at(f)] == 0) {
            predicted = is_given(p) ? state.velocity[at(a)][at(f)] : s.open.body_velocity[at(a)][at(f)];
            conductance = 0;
            return;
        }
        const double share_low = 0.5 * mesh.h(a, p - 1) / mesh.d(a, p), share_high = 1 - share_low;
        const double density = share_low * density_of(settings, state.fraction[at(f - sa)]) +
                               share_high * density_of(settings, state.fraction[at(f)]);
        const double fraction = share_low * state.fraction[at(f - sa)] + share_high * state.fraction[at(f)];
        const FaceMedium medium =
            face_medium(settings, s, f, sa, share_low, density, drag_viscosity(settings, fraction));
        const double force = shear / medium.porosity + body_force(f, place, density);
        const double start = s.start.velocity(a)[at(f)];
        const double carried = start + (moved - start) / (1 + medium.added_mass);
        const double inertia = (1 + medium.added_mass) * density;
        const double slowed = inertia * (1 + dt * sponge_rate(settings, a, place));
        const double speed = medium.quadratic > 0 ? filter_speed(settings, s, a, f) : 0;
        const double resistance = medium.porosity * (medium.linear + medium.quadratic * speed);
        const double wall = s.open.has_bodies ? wall_drag(settings, s, a, f, place) : 0;
        const double wall_velocity = s.open.has_bodies ? s.open.body_velocity[at(a)][at(f)] : 0;
        const double factor = medium.porosity / (slowed + dt * (resistance + wall));
        predicted = factor * (inertia * carried + dt * (force + wall * wall_velocity));
        // half a cell to a pressure on a side
        const int n = mesh.box.cells[at(a)];
        const double distance = p == 0 ? 0.5 * mesh.h(a, 0) : p == n ? 0.5 * mesh.h(a, n - 1) : mesh.d(a, p);
        conductance = dt * factor * s.room.area[at(a)][at(f)] / distance;
    }
};

}  // namespace

void predict_velocity(const GridSettings& settings, const GridState& state, GridScratch& s,
                      const std::array<std::vector<double>, 3>& advected, bool is_midpoint, double dt) {
    const CellBox& box = settings.mesh.box;
    for (int a = 0; a < box.axes; ++a) {
        const Prediction prediction{settings, state, s, body_force(settings, state.time + dt), a, dt};
        for_face_rows(box, a, [&](std::int64_t row, int faces, const std::array<int, 3>& first) {
            std::array<double, most_in_row> moved, shear;
            for (int done = 0; done < faces; done += most_in_row) {
                const int n = std::min(most_in_row, faces - done);
                std::array<int, 3> place = first;
                place[0] += done;
                carry_row(settings, s, advected[at(a)], a, is_midpoint, row + done, n, place, moved.data());
                viscous_row(settings, s, a, row + done, n, place, shear.data());
                for (int i = 0; i < n; ++i, ++place[0]) {
                    prediction.find(row + done + i, place, moved[at(i)], shear[at(i)]);
                }
            }
        });
    }
}

}  // namespace riprap::fluid::grid
