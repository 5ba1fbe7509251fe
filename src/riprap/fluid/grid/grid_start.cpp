// SPDX-License-Identifier: Apache-2.0
// Makes what a grid fluid starts from: its State, and Scratch of the medium and of solids.
#include "riprap/fluid/grid/boundary.hpp"
#include "riprap/fluid/grid/fresh_cells.hpp"
#include "riprap/fluid/grid/grid_step.hpp"
#include "riprap/fluid/grid/k_epsilon.hpp"
#include "riprap/fluid/grid/pockets.hpp"
#include "riprap/fluid/grid/porous.hpp"
#include "riprap/fluid/grid/surface.hpp"

namespace riprap::fluid::grid {

namespace {

/// Capacities and open areas from the medium and the shares that solids leave open.
void find_capacities(const GridSettings& settings, GridScratch& s) {
    const Mesh& mesh = settings.mesh;
    const CellBox& box = mesh.box;
    std::array<int, 3> first{}, last = box.cells;
    for (int a = 0; a < box.axes; ++a) {
        first[at(a)] = -Mesh::ghosts;
        last[at(a)] += Mesh::ghosts;
    }
    for_box(box, first, last, [&](std::int64_t c, int i, int j, int k) {
        const double porosity = s.medium.has_stones ? s.medium.porosity[at(c)] : 1;
        const double open = s.open.has_bodies ? s.open.volume[at(c)] : 1;
        s.room.capacity[at(c)] = porosity * open * mesh.volume(i, j, k);
        for (int a = 0; a < box.axes; ++a) {
            s.room.area[at(a)][at(c)] =
                mesh.face_area(a, i, j, k) * (s.open.has_bodies ? s.open.area[at(a)][at(c)] : 1);
        }
    });
}

void open_books(const GridSettings& settings, GridState& state, const GridScratch& s) {
    const double volume = water_volume(settings, state, s);
    state.water = {volume, volume, 0};
}

}  // namespace

GridState make_state(const GridSettings& settings, const std::function<double(const Vec3&)>& fraction,
                     const std::function<Vec3(const Vec3&)>& velocity) {
    const Mesh& mesh = settings.mesh;
    GridState state;
    state.fraction.assign(at(mesh.box.size), 0.0);
    state.pressure.assign(at(mesh.box.size), 0.0);
    for_cells(mesh.box,
              [&](std::int64_t c, int i, int j, int k) { state.fraction[at(c)] = fraction(mesh.centre(i, j, k)); });
    for (int a = 0; a < mesh.box.axes; ++a) {
        state.velocity[at(a)].assign(at(mesh.box.size), 0.0);
        for_faces(mesh.box, a, [&](std::int64_t f, int i, int j, int k) {
            Vec3 place{};
            const std::array<int, 3> index{i, j, k};
            for (int b = 0; b < 3; ++b) {
                place[b] = b == a ? mesh.edge[at(b)][at(index[at(b)])] : mesh.centre(b, index[at(b)]);
            }
            state.velocity[at(a)][at(f)] = velocity(place)[a];
        });
    }
    start_turbulence(settings, state);
    return state;
}

GridState make_state(const GridSettings& settings, const std::function<bool(const Vec3&)>& is_water) {
    const Mesh& mesh = settings.mesh;
    GridState state = make_state(
        settings, [](const Vec3&) { return 0.0; }, [](const Vec3&) { return Vec3{}; });
    const int axes = mesh.box.axes;
    for_cells(mesh.box, [&](std::int64_t c, int i, int j, int k) {
        const Vec3 centre = mesh.centre(i, j, k);
        const Vec3 h{mesh.h(0, i), mesh.h(1, j), mesh.h(2, k)};
        const auto wet_share = [&](int points, double reach) {  // the lattice spans the cell times `reach`
            const int deep = axes == 3 ? points : 1, all = points * points * deep;
            int wet = 0;
            for (int q = 0; q < all; ++q) {
                const std::array<int, 3> p{q % points, q / points % points, q / points / points};
                Vec3 place = centre;
                for (int a = 0; a < axes; ++a) {
                    place[a] += reach * ((p[at(a)] + 0.5) / points - 0.5) * h[a];
                }
                wet += is_water(place) ? 1 : 0;
            }
            return static_cast<double>(wet) / all;
        };
        const double coarse = wet_share(5, 1.25);  // corners included
        state.fraction[at(c)] = coarse > 0 && coarse < 1 ? wet_share(axes == 3 ? 20 : 128, 1) : coarse;
    });
    return state;
}

void prepare(const GridSettings& settings, GridState& state, GridScratch& s) {
    if (s.is_ready) {
        return;
    }
    const Mesh& mesh = settings.mesh;
    const auto size = at(mesh.box.size);
    for (auto* field : {&s.room.capacity, &s.inertia.mass, &s.inertia.mass_before, &s.stress.viscosity}) {
        field->assign(size, 0.0);
    }
    s.moved.colour.assign(size, 0);
    if (settings.surface_tension > 0) {
        s.stress.curvature.assign(size, 0.0);
    }
    for (int a = 0; a < mesh.box.axes; ++a) {
        for (auto* fields : {&s.room.area, &s.start.carrier, &s.moved.water_flux, &s.moved.flux}) {
            (*fields)[at(a)].assign(size, 0.0);
        }
    }
    s.projection.conductance = linear::FaceConductance(mesh.box);
    s.medium = medium_fields(settings);
    find_capacities(settings, s);
    if (settings.turbulence != Turbulence::laminar) {
        s.stress.eddy_viscosity.assign(size, 0.0);
        find_eddy_viscosity(settings, state, s);
    }
    s.is_ready = true;
    fill_velocity_ghosts(settings, state.time, state.fraction, state.velocity);
    if (state.step == 0) {
        open_books(settings, state, s);
    }
}

void set_open_shares(const GridSettings& settings, GridState& state, GridScratch& s, OpenShares shares) {
    prepare(settings, state, s);
    const bool is_first = !s.open.has_bodies;
    const std::vector<std::int64_t> turned =
        is_first ? std::vector<std::int64_t>{} : find_turned_cells(settings, s, shares);
    s.open = std::move(shares);
    if (!is_first) {
        s.room.capacity_before = s.room.capacity;
    }
    find_capacities(settings, s);
    s.open.area = {};
    s.pockets = find_pockets(settings, s);
    if (is_first) {
        if (state.step == 0) {
            open_books(settings, state, s);
        }
    } else {
        for (const std::int64_t c : turned) {
            s.room.capacity_before[at(c)] = 0;
        }
        fill_fresh_cells(settings, state, s);
    }
}

}  // namespace riprap::fluid::grid
