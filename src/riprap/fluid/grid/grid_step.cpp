// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/grid/grid_step.hpp"

#include <cmath>

#include "riprap/core/bytes.hpp"
#include "riprap/fluid/grid/boundary.hpp"
#include "riprap/fluid/grid/fresh_cells.hpp"
#include "riprap/fluid/grid/k_epsilon.hpp"
#include "riprap/fluid/grid/momentum.hpp"
#include "riprap/fluid/grid/pockets.hpp"
#include "riprap/fluid/grid/porous.hpp"
#include "riprap/fluid/grid/pressure.hpp"
#include "riprap/fluid/grid/surface.hpp"
#include "riprap/fluid/grid/surface_tension.hpp"
#include "riprap/fluid/grid/transport.hpp"
#include "riprap/fluid/grid/viscous.hpp"

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

/// Velocity in the pores, n = 1 outside of stones.
void to_pore_velocity(const GridSettings& settings, const GridScratch& s, std::array<std::vector<double>, 3>& u) {
    if (!s.medium.has_stones) {
        return;
    }
    const Mesh& mesh = settings.mesh;
    for (int a = 0; a < mesh.box.axes; ++a) {
        const std::int64_t sa = mesh.box.stride[at(a)];
        std::array<int, 3> first{}, last = mesh.box.cells;
        for (int b = 0; b < mesh.box.axes; ++b) {
            first[at(b)] = b == a ? -1 : -2;
            last[at(b)] += 2;
        }
        for_box(mesh.box, first, last, [&](std::int64_t f, int, int, int) {
            u[at(a)][at(f)] /= 0.5 * (s.medium.porosity[at(f - sa)] + s.medium.porosity[at(f)]);
        });
    }
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

double stable_step(const GridSettings& settings, GridState& state, GridScratch& s) {
    prepare(settings, state, s);
    const Mesh& mesh = settings.mesh;
    const CellBox& box = mesh.box;
    const double fastest = reduce_cells(
        box, 0.0,
        [&](std::int64_t c, int i, int j, int k) {
            const std::array<int, 3> place{i, j, k};
            double rate = 0;
            for (int a = 0; a < box.axes; ++a) {
                const auto& u = state.velocity[at(a)];
                const double size = std::max(
                    s.room.area[at(a)][at(c)] > 0 ? std::abs(u[at(c)]) : 0,
                    s.room.area[at(a)][at(c + box.stride[at(a)])] > 0 ? std::abs(u[at(c + box.stride[at(a)])]) : 0);
                rate += size / mesh.h(a, place[at(a)]);
            }
            return rate / (s.medium.has_stones ? s.medium.porosity[at(c)] : 1);
        },
        max_of);
    const double h = mesh.smallest_width();
    double dt = settings.longest_step;
    const double g = norm(body_force(settings, state.time));
    if (settings.has_surface && g > 0) {
        // the velocity grows by g dt within the step: C = (u + g dt) dt/h
        const double u = fastest * h;
        dt = std::min(dt, (std::sqrt(u * u + 4 * settings.courant * g * h) - u) / (2 * g));
    } else if (fastest > 0) {
        dt = std::min(dt, settings.courant / fastest);
    }
    if (settings.surface_tension > 0) {
        const double density = settings.water.density + settings.air.density;
        dt = std::min(dt, std::sqrt(density * h * h * h / (4 * M_PI * settings.surface_tension)));
    }
    const double molecular =
        std::max(settings.water.kinematic_viscosity, settings.has_surface ? settings.air.kinematic_viscosity : 0.0);
    const double eddy =
        s.stress.eddy_viscosity.empty()
            ? 0
            : reduce_cells(
                  box, 0.0, [&](std::int64_t c, int, int, int) { return s.stress.eddy_viscosity[at(c)]; }, max_of);
    if (molecular + eddy > 0) {
        dt = std::min(dt, 0.4 * h * h / (2 * box.axes * (molecular + eddy)));
    }
    return dt;
}

namespace {

using FaceFields = std::array<std::vector<double>, 3>;

/// Water with the carrier, and the masses and stresses that follow from where it is.
void carry_water(const GridSettings& settings, GridState& state, GridScratch& s, double dt) {
    move_water(settings, state, s, dt);
    find_masses(settings, state, s);
    find_viscosity(settings, state, s);
    find_mass_fluxes(settings, s);
    find_curvature(settings, state, s);
    s.projection.has_operator = false;
}

/// Sets the carrier to the mean velocity of both ends of the step.
/// @param start  velocity at the start of the step [m/s]
void find_middle(const GridSettings& settings, GridState& state, GridScratch& s, const FaceFields& start, double dt) {
    fill_velocity_ghosts(settings, state.time + dt, state.fraction, state.velocity);
    for (int a = 0; a < settings.mesh.box.axes; ++a) {
        const auto &u = start[at(a)], &v = state.velocity[at(a)];
        auto& middle = s.start.carrier[at(a)];
        parallel::for_each(settings.mesh.box.size,
                           [&](std::int64_t i) { middle[at(i)] = 0.5 * (u[at(i)] + v[at(i)]); });
    }
    fill_velocity_ghosts(settings, state.time + 0.5 * dt, state.fraction, s.start.carrier);
}

/// Momentum once more with the carrier; the transport of water and masses stays as it is.
void correct_momentum(const GridSettings& settings, GridState& state, GridScratch& s, double dt) {
    if (!s.medium.has_stones) {
        predict_velocity(settings, state, s, s.start.carrier, true, dt);
        return;
    }
    FaceFields middle = s.start.carrier;
    to_pore_velocity(settings, s, middle);
    predict_velocity(settings, state, s, middle, true, dt);
    s.projection.has_operator = false;  // the resistance of stones grows with the speed
}

}  // namespace

int begin_step(const GridSettings& settings, GridState& state, GridScratch& s, double dt) {
    prepare(settings, state, s);
    s.projection.first_residual = 0;
    fill_velocity_ghosts(settings, state.time, state.fraction, state.velocity);
    s.start.carrier = state.velocity;
    fill_fraction_ghosts(settings, s.start.carrier, state.time, state.fraction);
    find_masses_before(settings, state, s);
    if (settings.outer_corrections > 1) {
        s.start.fraction = state.fraction;
    }
    const WaterBooks books_before = state.water;
    carry_water(settings, state, s, dt);
    const int pressures = settings.outer_corrections * settings.pressure_corrections;
    const bool has_stones = s.medium.has_stones;
    if (has_stones || pressures > 1) {
        s.start.pore_velocity = s.start.carrier;
        to_pore_velocity(settings, s, s.start.pore_velocity);
    }
    const FaceFields kept = has_stones && pressures > 1 ? s.start.carrier : FaceFields{};
    const FaceFields& start = has_stones ? kept : s.start.pore_velocity;
    // what sides give at the end of the step
    fill_velocity_ghosts(settings, state.time + dt, state.fraction, state.velocity);
    predict_velocity(settings, state, s, s.start.pore_velocity[0].empty() ? s.start.carrier : s.start.pore_velocity,
                     pressures > 1, dt);
    int iterations = 0;
    for (int next = 1; next < pressures; ++next) {
        const bool is_inner = next % settings.pressure_corrections != 0;
        iterations += project_velocity(settings, state, s, dt, is_inner).iterations;
        find_middle(settings, state, s, start, dt);
        if (!is_inner) {
            state.fraction = s.start.fraction;
            state.water = books_before;
            carry_water(settings, state, s, dt);
        }
        correct_momentum(settings, state, s, dt);
    }
    return iterations;
}

void end_step(const GridSettings& settings, GridState& state, GridScratch& s, double dt) {
    fill_velocity_ghosts(settings, state.time + dt, state.fraction, state.velocity);
    if (settings.turbulence != Turbulence::laminar) {
        advance_turbulence(settings, state, s, dt);
    }
    s.room.capacity_before.clear();
    state.time += dt;
    state.step += 1;
    state.last_step = dt;
}

GridReport advance(const GridSettings& settings, GridState& state, GridScratch& s, double dt) {
    begin_step(settings, state, s, dt);
    const linear::PoissonReport report = project_velocity(settings, state, s, dt);
    end_step(settings, state, s, dt);
    return {report.iterations, report.residual, report.converged};
}

namespace {
template <class T>
std::size_t bytes_of_faces(const std::array<std::vector<T>, 3>& faces) {
    return bytes_of(faces[0], faces[1], faces[2]);
}
}  // namespace

std::size_t Room::bytes() const { return bytes_of(capacity, capacity_before) + bytes_of_faces(area); }
std::size_t StepStart::bytes() const {
    return bytes_of(fraction) + bytes_of_faces(carrier) + bytes_of_faces(pore_velocity);
}
std::size_t Transport::bytes() const {
    return bytes_of(colour, plane.number, plane.row_begin, plane.plane) + bytes_of_faces(flux) +
           bytes_of_faces(water_flux);
}
std::size_t Inertia::bytes() const { return bytes_of(mass, mass_before) + bytes_of_faces(mass_flux); }
std::size_t Stress::bytes() const { return bytes_of(viscosity, eddy_viscosity, curvature); }
std::size_t Projection::bytes() const {
    return bytes_of_faces(predicted) + bytes_of_faces(conductance.face) + solver.bytes();
}

std::size_t GridScratch::bytes() const {
    return bytes_of(medium.porosity, medium.linear, medium.quadratic, medium.added_mass, medium.grain_size, open.volume,
                    open.displacement) +
           bytes_of_faces(open.area) + bytes_of_faces(open.body_velocity) + bytes_of_faces(open.wall_distance) +
           room.bytes() + start.bytes() + moved.bytes() + inertia.bytes() + stress.bytes() + projection.bytes();
}

}  // namespace riprap::fluid::grid
