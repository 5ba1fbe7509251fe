// SPDX-License-Identifier: Apache-2.0
// The pressure of full pockets that free bodies close: it carries them.
#include "riprap/coupling/grid_fluid/pocket_pressure.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "riprap/body/locks.hpp"
#include "riprap/coupling/cut_cells/side_facets.hpp"
#include "riprap/fluid/grid/pockets.hpp"
#include "riprap/fluid/open/leaving.hpp"

namespace riprap::coupling {

namespace {

using fluid::grid::at;
using fluid::grid::GridState;
using fluid::grid::Pocket;

/// Speed of sound in water: a pocket has the bulk modulus rho c^2 [m/s].
constexpr double sound_speed = 1480;

/// Returns the largest volume that one of the free bodies of a pocket takes as it goes on by a cell [m^3].
double skin_of(const FluidScene& scene, const fluid::grid::Mesh& mesh, const GridFluid::Scratch& scratch,
               const PressedPocket& pressed, double time) {
    std::vector<double> skin(scratch.bodies.size());
    for (const std::size_t f : pressed.facets) {
        const CutFacet& facet = scratch.cut.facets[f];
        for (int a = 0; a < mesh.box.axes && is_free(scene.bodies, BodyId{facet.body}, time); ++a) {
            skin[at(facet.body)] += std::abs(facet.area[a]) * mesh.h(a, mesh.cell_at(a, facet.place()[a]));
        }
    }
    return skin.empty() ? 0 : *std::max_element(skin.begin(), skin.end());
}

/// Returns the sides of free bodies in a pocket; none of a body that is in the pocket as a whole.
std::vector<PocketSide> sides_in(const FluidScene& scene, const GridFluid::Scratch& scratch,
                                 const PressedPocket& pressed, double time) {
    constexpr double round_off = 1e-9;
    std::vector<PocketSide> sides;
    double whole = 0;
    const auto drop_if_closed = [&] {
        if (!sides.empty() && !(norm(sides.back().area) > round_off * whole)) {
            sides.pop_back();
        }
    };
    for (const std::size_t f : pressed.facets) {  // body by body
        const CutFacet& facet = scratch.cut.facets[f];
        if (!is_free(scene.bodies, BodyId{facet.body}, time)) {
            continue;
        }
        if (sides.empty() || sides.back().body != facet.body) {
            drop_if_closed();
            sides.push_back({facet.body});
            whole = 0;
        }
        sides.back().area += facet.area;
        sides.back().moment += cross(facet.place() - scratch.bodies[at(facet.body)].centre, facet.area);
        whole += norm(facet.area);
    }
    drop_if_closed();
    return sides;
}

void raise(const GridFluid::Scratch& scratch, const PressedPocket& pressed, double pressure, GridState& water) {
    for (const std::int64_t c : scratch.grid.pockets[pressed.number].cells) {
        water.pressure[at(c)] += pressure;
    }
}

/// Finds what pressures of the pockets give their bodies: from the loads themselves, with joints that they lead to.
void find_pushes(const FluidScene& scene, const GridFluidSettings& settings, const GridFluid::Scratch& scratch,
                 double time, std::vector<PressedPocket>& pockets, GridState& water) {
    constexpr double trial = 1e5;  // [Pa]
    const auto loads = [&] { return cut_loads(settings.grid, water, scratch.grid, scratch.bodies, scratch.cut, time); };
    const std::vector<double> pressure = water.pressure;
    const std::vector<GridLoad> without = loads();
    for (PressedPocket& pressed : pockets) {
        raise(scratch, pressed, trial, water);
        const std::vector<GridLoad> with = loads();
        for (PocketSide& side : pressed.sides) {
            const auto b = at(side.body);
            Vec3 force = (with[b].pressure - without[b].pressure) / trial;
            force.z = scene.bodies.is_planar ? 0 : force.z;
            side.force = locks_of(scene.bodies, b).free_translation(force);
            side.torque = (with[b].torque - without[b].torque) / trial;
        }
        water.pressure = pressure;
    }
}

/// Solves a small dense system by elimination with pivots of rows.
std::vector<double> solve(std::vector<std::vector<double>> matrix, std::vector<double> right) {
    const std::size_t count = right.size();
    for (std::size_t k = 0; k < count; ++k) {
        std::size_t pivot = k;
        for (std::size_t i = k + 1; i < count; ++i) {
            pivot = std::abs(matrix[i][k]) > std::abs(matrix[pivot][k]) ? i : pivot;
        }
        std::swap(matrix[k], matrix[pivot]);
        std::swap(right[k], right[pivot]);
        for (std::size_t i = k + 1; i < count; ++i) {
            const double factor = matrix[i][k] / matrix[k][k];
            for (std::size_t j = k; j < count && factor != 0; ++j) {
                matrix[i][j] -= factor * matrix[k][j];
            }
            right[i] -= factor * right[k];
        }
    }
    for (std::size_t k = count; k-- > 0;) {
        for (std::size_t j = k + 1; j < count; ++j) {
            right[k] -= matrix[k][j] * right[j];
        }
        right[k] /= matrix[k][k];
    }
    return right;
}

}  // namespace

std::vector<PressedPocket> pressed_pockets(const FluidScene& scene, const GridFluidSettings& settings,
                                           const GridFluid::Scratch& scratch, GridState& water, double time) {
    std::vector<PressedPocket> found;
    const double least = fluid::share_let_go * water.water.ever;
    for (std::size_t p = 0; p < scratch.grid.pockets.size(); ++p) {
        const Pocket& pocket = scratch.grid.pockets[p];
        PressedPocket pressed{p, room_of(pocket, scratch.grid), mean_fraction(water, scratch.grid, pocket) - 1, {}, {}};
        if (!(pressed.room > least) || !(pressed.excess > -2 * fluid::grid::most_hollow)) {
            continue;  // air gives way
        }
        std::vector<std::int64_t> cells = pocket.cells;
        std::sort(cells.begin(), cells.end());
        for (std::size_t f = 0; f < scratch.cut.facets.size(); ++f) {
            const CutFacet& facet = scratch.cut.facets[f];
            if (moves_fluid(facet) && std::binary_search(cells.begin(), cells.end(), facet.cell)) {
                pressed.facets.push_back(f);
            }
        }
        pressed.sides = sides_in(scene, scratch, pressed, time);
        if (!pressed.sides.empty() &&
            pressed.room > least_cells * skin_of(scene, settings.grid.mesh, scratch, pressed, time)) {
            found.push_back(std::move(pressed));
        }
    }
    if (!found.empty()) {
        find_pushes(scene, settings, scratch, time, found, water);
    }
    return found;
}

void press_pockets(const FluidScene& scene, const GridFluidSettings& settings, const CouplingState& coupling,
                   const GridFluid::Scratch& scratch, const body::Motion& middle, const TimeSpan& span,
                   const std::vector<GridLoad>& loads, GridState& water) {
    const std::vector<PressedPocket>& pockets = scratch.pressed;
    const double modulus = settings.rest_density * sound_speed * sound_speed, dt = span.dt;
    const std::size_t count = pockets.size();
    std::vector<std::vector<double>> matrix(count, std::vector<double>(count));
    std::vector<double> right(count);
    for (std::size_t k = 0; k < count; ++k) {
        double taken = 0;  // in a second, at the accelerations that were guessed [m^3/s]
        for (const std::size_t f : pockets[k].facets) {
            const CutFacet& facet = scratch.cut.facets[f];
            taken += dot(scratch.bodies[at(facet.body)].velocity_at(facet.place()), facet.area);
        }
        for (const PocketSide& side : pockets[k].sides) {
            const auto b = at(side.body);
            if (!is_free(scene.bodies, BodyId{side.body}, span.middle())) {
                continue;
            }
            const body::Locks locks = locks_of(scene.bodies, b);
            const double lightness = 1 / scene.bodies.mass[b];
            const Sym3 inverse = inverse_inertia_of(scene.bodies, b, middle.pose[b].orientation);
            Vec3 force = loads[b].force();
            force.z = scene.bodies.is_planar ? 0 : force.z;
            const Vec3 linear = locks.free_translation(lightness * force + coupling.dry_acceleration[b]);
            const Vec3 angular = locks.free_rotation(inverse * loads[b].torque + coupling.dry_angular_acceleration[b]);
            taken += dt * (dot(side.area, linear - middle.acceleration[b]) +
                           dot(side.moment, angular - middle.angular_acceleration[b]));
            for (std::size_t l = 0; l < count; ++l) {
                for (const PocketSide& other : pockets[l].sides) {
                    if (other.body == side.body) {
                        matrix[k][l] -=
                            dt * dt *
                            (lightness * dot(side.area, other.force) + dot(side.moment, inverse * other.torque));
                    }
                }
            }
        }
        matrix[k][k] += pockets[k].room / modulus;
        right[k] = pockets[k].room * pockets[k].excess + dt * taken;
    }
    const std::vector<double> pressure = solve(std::move(matrix), std::move(right));
    for (std::size_t k = 0; k < count; ++k) {
        raise(scratch, pockets[k], pressure[k], water);
    }
}

}  // namespace riprap::coupling
