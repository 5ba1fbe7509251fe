// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <utility>

#include "riprap/fluid/grid/boundary.hpp"
#include "riprap/fluid/grid/pockets.hpp"
#include "riprap/fluid/grid/surface.hpp"

namespace riprap::fluid::grid {

namespace {

/// A cell of which a step replaces more than this share of the volume lets out the mixture of the end of the step [-].
constexpr double most_flushed = 0.5;
/// Sweeps over such cells; each carries water through one more of them in a row [-].
constexpr int flush_sweeps = 4;

/// Arrays of the transport, in memory that find_masses and find_viscosity fill again after it.
struct Buffers {
    std::vector<double>& water;         ///< in cells, between two directions [m^3]
    std::vector<double>& end_fraction;  ///< of slivers beside solids, at the end of the step [-]
};
Buffers buffers_of(GridScratch& s) { return {s.stress.viscosity, s.inertia.mass}; }

/// Volume that leaves a cell in the step through all its faces [m^3].
double outflow(const CellBox& box, const GridScratch& s, std::int64_t c) {
    double out = 0;
    for (int a = 0; a < box.axes; ++a) {
        out +=
            std::max(0.0, -s.moved.flux[at(a)][at(c)]) + std::max(0.0, s.moved.flux[at(a)][at(c + box.stride[at(a)])]);
    }
    return out;
}

bool is_sliver(const CellBox& box, const GridScratch& s, std::int64_t c, double volume) {
    const double capacity = std::min(s.room.capacity[at(c)], s.room.before()[at(c)]);
    return capacity < 0.999 * volume && capacity < outflow(box, s, c) / most_flushed;
}

/// Water fraction of the fluid that leaves a cell through a face: of the slab next to the face that the step sweeps.
double donated(const Mesh& mesh, const GridState& state, const GridScratch& s, int a, std::int64_t face, int place,
               double dt) {
    const double u = s.start.carrier[at(a)][at(face)];
    const std::int64_t stride = mesh.box.stride[at(a)];
    const std::int64_t donor = u > 0 ? face - stride : face;
    const double f = state.fraction[at(donor)];
    if (!is_mixed(f)) {
        return f;
    }
    const double porosity = s.medium.has_stones ? s.medium.porosity[at(donor)] : 1;
    const double swept = std::min(1.0, std::abs(u) * dt / (mesh.h(a, u > 0 ? place - 1 : place) * porosity));
    if (swept < 1e-12) {
        return f;
    }
    return u > 0 ? slab_fraction(s.moved.plane[at(donor)], a, 0.5 - swept, 0.5)
                 : slab_fraction(s.moved.plane[at(donor)], a, -0.5, -0.5 + swept);
}

/// Fractions of slivers at the end of the step, which replaces their content: (alpha C + inflow of water)/(C + inflow).
void flush_slivers(const GridSettings& settings, const GridState& state, GridScratch& s) {
    const CellBox& box = settings.mesh.box;
    const Buffers buffers = buffers_of(s);
    std::vector<double>& end_fraction = buffers.end_fraction;
    std::vector<double>& flushed = buffers.water;  // the same, one sweep further [-]
    std::array<int, 3> first{}, last = box.cells;  // masses stay zero in the second layer of ghosts
    for (int a = 0; a < box.axes; ++a) {
        first[at(a)] = -1;
        last[at(a)] += 1;
    }
    for_box(box, first, last, [&](std::int64_t c, int, int, int) { end_fraction[at(c)] = state.fraction[at(c)]; });
    for (int sweep = 0; sweep < flush_sweeps; ++sweep) {
        for_cells(box, [&](std::int64_t c, int i, int j, int k) {
            if (!is_sliver(box, s, c, settings.mesh.volume(i, j, k))) {
                return;
            }
            double water = state.fraction[at(c)] * s.room.before()[at(c)], volume = s.room.before()[at(c)];
            for (int a = 0; a < box.axes; ++a) {
                const std::int64_t stride = box.stride[at(a)];
                const double low = std::max(0.0, s.moved.flux[at(a)][at(c)]);
                const double high = std::max(0.0, -s.moved.flux[at(a)][at(c + stride)]);
                water += low * end_fraction[at(c - stride)] + high * end_fraction[at(c + stride)];
                volume += low + high;
            }
            flushed[at(c)] = volume > 0 ? water / volume : state.fraction[at(c)];
        });
        for_cells(box, [&](std::int64_t c, int i, int j, int k) {
            if (is_sliver(box, s, c, settings.mesh.volume(i, j, k))) {
                end_fraction[at(c)] = flushed[at(c)];
            }
        });
    }
}

void find_fluxes(const GridSettings& settings, GridScratch& s, double dt) {
    for (int a = 0; a < settings.mesh.box.axes; ++a) {
        if (s.moved.flux[at(a)].empty()) {
            s.moved.flux[at(a)] = std::move(s.inertia.mass_flux[at(a)]);
        }
        if (s.moved.water_flux[at(a)].empty()) {
            s.moved.water_flux[at(a)] = std::move(s.projection.predicted[at(a)]);
        }
        for_faces(settings.mesh.box, a, [&](std::int64_t f, int, int, int) {
            s.moved.flux[at(a)][at(f)] = s.start.carrier[at(a)][at(f)] * s.room.area[at(a)][at(f)] * dt;
        });
    }
}

/// Books water that crosses the sides.
void book_sides(const GridSettings& settings, const GridScratch& s, WaterBooks& books) {
    double all = 0;
    const CellBox& box = settings.mesh.box;
    for (int side = 0; side < 2 * box.axes; ++side) {
        if (is_wall(settings.side[at(side)].kind)) {
            continue;
        }
        const int a = side / 2;
        std::array<int, 3> first{}, last = box.cells;
        first[at(a)] = side % 2 == 0 ? 0 : box.cells[at(a)];
        last[at(a)] = first[at(a)] + 1;
        double in = 0, out = 0;
        for (int k = first[2]; k < last[2]; ++k) {
            for (int j = first[1]; j < last[1]; ++j) {
                for (int i = first[0]; i < last[0]; ++i) {
                    const double inward = (side % 2 == 0 ? 1 : -1) * s.moved.water_flux[at(a)][at(box.index(i, j, k))];
                    all += inward;
                    in += std::max(0.0, inward);
                    out += std::max(0.0, -inward);
                }
            }
        }
        books.ever += in;
        books.let_go += settings.side[at(side)].is_for_air ? out : 0;
    }
    books.held += all;
}

/// One direction of the split transport.
void move_along(const GridSettings& settings, GridState& state, GridScratch& s, int a, double dt) {
    const Mesh& mesh = settings.mesh;
    const CellBox& box = mesh.box;
    const std::int64_t stride = box.stride[at(a)];
    const Buffers buffers = buffers_of(s);
    fill_fraction_ghosts(settings, s.start.carrier, state.time, state.fraction);
    reconstruct_surface(mesh, state.fraction, s.moved.plane);
    for_faces(box, a, [&](std::int64_t f, int i, int j, int k) {
        const double volume = s.moved.flux[at(a)][at(f)];
        if (volume == 0) {
            s.moved.water_flux[at(a)][at(f)] = 0;
            return;
        }
        const std::array<int, 3> place{i, j, k};
        const bool forward = volume > 0;
        const std::int64_t donor = forward ? f - stride : f;
        const int p = place[at(a)] - (forward ? 1 : 0);
        bool flushed = false;
        if (s.open.has_bodies && p >= 0 && p < box.cells[at(a)]) {
            std::array<int, 3> d = place;
            d[at(a)] = p;
            flushed = is_sliver(box, s, donor, mesh.volume(d[0], d[1], d[2]));
        }
        s.moved.water_flux[at(a)][at(f)] =
            volume * (flushed ? buffers.end_fraction[at(donor)] : donated(mesh, state, s, a, f, place[at(a)], dt));
    });
    for_cells(box, [&](std::int64_t c, int, int, int) {
        const double out = s.moved.flux[at(a)][at(c + stride)] - s.moved.flux[at(a)][at(c)];
        const double water_out = s.moved.water_flux[at(a)][at(c + stride)] - s.moved.water_flux[at(a)][at(c)];
        buffers.water[at(c)] += (s.moved.colour[at(c)] != 0 ? out : 0) - water_out;
        const double capacity = s.room.before()[at(c)];
        // between directions a fraction may leave 0..1 only where solids move or leave slivers
        state.fraction[at(c)] =
            capacity > 0 ? std::clamp(buffers.water[at(c)] / capacity, 0.0, 1.0) : state.fraction[at(c)];
    });
}

}  // namespace

void move_water(const GridSettings& settings, GridState& state, GridScratch& s, double dt) {
    const CellBox& box = settings.mesh.box;
    find_fluxes(settings, s, dt);
    const std::vector<double> in_pockets = water_of_pockets(settings, state, s);
    if (!settings.has_surface) {
        for (int a = 0; a < box.axes; ++a) {
            s.moved.water_flux[at(a)] = s.moved.flux[at(a)];
        }
        return;
    }
    if (settings.vof == VofScheme::compressive) {
        move_water_compressive(settings, state, s, dt);
    } else {
        for_cells(box,
                  [&](std::int64_t c, int, int, int) { s.moved.colour[at(c)] = state.fraction[at(c)] > 0.5 ? 1 : 0; });
        if (s.open.has_bodies) {
            flush_slivers(settings, state, s);
        }
        std::vector<double>& water = buffers_of(s).water;
        for_cells(
            box, [&](std::int64_t c, int, int, int) { water[at(c)] = state.fraction[at(c)] * s.room.before()[at(c)]; });
        for (int turn = 0; turn < box.axes; ++turn) {
            const int a = static_cast<int>((turn + state.step) % box.axes);
            move_along(settings, state, s, a, dt);
        }
        for_cells(box, [&](std::int64_t c, int, int, int) {
            const double capacity = s.room.capacity[at(c)];
            if (capacity > 0) {
                const double grown = capacity - s.room.before()[at(c)];
                state.fraction[at(c)] = (water[at(c)] + (s.moved.colour[at(c)] != 0 ? grown : 0)) / capacity;
            }
        });
    }
    book_sides(settings, s, state.water);
    settle_volume(settings, state, s, in_pockets);
    fill_fraction_ghosts(settings, s.start.carrier, state.time + dt, state.fraction);
}

}  // namespace riprap::fluid::grid
