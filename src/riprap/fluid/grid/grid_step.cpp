// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/grid/grid_step.hpp"

#include <cmath>

#include "riprap/fluid/grid/boundary.hpp"
#include "riprap/fluid/grid/k_epsilon.hpp"
#include "riprap/fluid/grid/momentum.hpp"
#include "riprap/fluid/grid/porous.hpp"
#include "riprap/fluid/grid/pressure.hpp"
#include "riprap/fluid/grid/surface.hpp"
#include "riprap/fluid/grid/surface_tension.hpp"
#include "riprap/fluid/grid/transport.hpp"
#include "riprap/fluid/grid/viscous.hpp"

namespace riprap::fluid::grid {

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
    const double g = std::max(norm(body_force(settings, state.time)), settings.full_gravity);
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

}  // namespace riprap::fluid::grid
