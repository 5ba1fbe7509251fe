// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/grid/pressure.hpp"

#include <cmath>

#include "riprap/fluid/grid/boundary.hpp"
#include "riprap/fluid/grid/datum.hpp"
#include "riprap/fluid/grid/momentum.hpp"
#include "riprap/fluid/grid/pockets.hpp"

namespace riprap::fluid::grid {

namespace {

/// Tolerance of the first solve of a run [-].
constexpr double first_tolerance = 1e-14;
/// Tolerance of a pressure whose velocity enters the explicit momentum alone: what it misses is left to the next [-].
constexpr double rough_tolerance = 1e-2;

/// P = p - rho g.(x - datum) on an open side, beyond which lies what the ghost cell holds [Pa].
double side_pressure(const GridSettings& settings, const GridState& state, int side, std::int64_t ghost,
                     const std::array<int, 3>& place, const Vec3& g) {
    const Mesh& mesh = settings.mesh;
    const int a = side / 2;
    Vec3 x{};
    for (int b = 0; b < 3; ++b) {
        x[b] = b == a ? (side % 2 == 0 ? mesh.edge[at(b)].front() : mesh.edge[at(b)].back())
                      : mesh.centre(b, place[at(b)]);
    }
    const double density = density_of(settings, state.fraction[at(ghost)]);
    const Side& s = settings.side[at(side)];
    if (s.still_level) {  // P of water at rest is one up to its surface
        x[s.up] = *s.still_level;
    }
    const double u = state.velocity[at(a)][at(side % 2 == 1 ? ghost : ghost + mesh.box.stride[at(a)])];
    const double head = s.is_from_rest && comes_in(side, u) ? 0.5 * density * u * u : 0;
    const double weight = settings.has_surface ? density * dot(g, x - datum_of(mesh)) : 0;
    return s.pressure - head - weight;
}

/// Adds what the pressures on open sides bring to the right side.
void add_open_sides(const GridSettings& settings, const GridState& state, GridScratch& s, double dt) {
    const CellBox& box = settings.mesh.box;
    const Vec3 g = body_force(settings, state.time + dt);
    for (int side = 0; side < 2 * box.axes; ++side) {
        if (settings.side[at(side)].kind != SideKind::open) {
            continue;
        }
        const int a = side / 2;
        for_ghosts(box, side, [&](std::int64_t ghost, std::int64_t inside, int layer, int i, int j, int k) {
            const std::array<int, 3> place{i, j, k};
            for (int b = 0; b < a; ++b) {
                if (place[at(b)] < 0 || place[at(b)] >= box.cells[at(b)]) {
                    return;
                }
            }
            if (layer == 0) {
                const double p = side_pressure(settings, state, side, ghost, place, g);
                s.projection.right()[at(inside)] +=
                    s.projection.conductance.face[at(a)][at(side % 2 == 0 ? inside : ghost)] * p;
            }
        });
    }
}

/// Takes the mean off the right side of a domain that nothing leaves: its sum is what solves cannot take away.
void balance(const GridSettings& settings, GridScratch& s) {
    const CellBox& box = settings.mesh.box;
    for (int side = 0; side < 2 * box.axes; ++side) {
        if (settings.side[at(side)].kind == SideKind::open) {
            return;
        }
    }
    double sum = sum_cells(box, [&](std::int64_t c, int, int, int) { return s.projection.right()[at(c)]; });
    double volume = sum_cells(box, [&](std::int64_t c, int, int, int) { return s.room.capacity[at(c)]; });
    for (const Pocket& pocket : s.pockets) {
        for (const std::int64_t c : pocket.cells) {
            sum -= s.projection.right()[at(c)];
            volume -= s.room.capacity[at(c)];
        }
    }
    for_cells(box, [&](std::int64_t c, int, int, int) {
        s.projection.right()[at(c)] -= sum * s.room.capacity[at(c)] / volume;
    });
}

double net_outflow(const CellBox& box, const std::array<std::vector<double>, 3>& u, const GridScratch& s,
                   std::int64_t c) {
    double sum = s.open.displacement.empty() ? 0 : s.open.displacement[at(c)];
    for (int a = 0; a < box.axes; ++a) {
        const std::int64_t t = box.stride[at(a)];
        sum += s.room.area[at(a)][at(c + t)] * u[at(a)][at(c + t)] - s.room.area[at(a)][at(c)] * u[at(a)][at(c)];
    }
    return sum;
}

/// Lends the solver memory that nothing reads from the prediction on until it is filled anew.
class LentMemory {
 public:
    explicit LentMemory(GridScratch& scratch) : s_(scratch) { exchange(); }
    LentMemory(const LentMemory&) = delete;
    LentMemory& operator=(const LentMemory&) = delete;
    ~LentMemory() { exchange(); }

 private:
    void exchange() {
        linear::PoissonSolver::Work& work = s_.projection.solver.work();
        work.r.swap(s_.stress.viscosity);
        work.d.swap(s_.start.carrier[1]);
        work.q.swap(s_.start.carrier[2]);
    }
    GridScratch& s_;
};

linear::PoissonReport solve_and_correct(const GridSettings& settings, GridState& state, GridScratch& s, double dt,
                                        bool is_rough) {
    const CellBox& box = settings.mesh.box;
    const Vec3 g = body_force(settings, state.time + dt);
    const LentMemory lent(s);
    s.projection.right().resize(at(box.size));
    // net_outflow sums in the same order for a fluid at rest as for one that moves: exact zeros stay zero
    for_cells(box, [&](std::int64_t c, int, int, int) {
        s.projection.right()[at(c)] = s.room.capacity[at(c)] > 0 ? -net_outflow(box, s.projection.predicted, s, c) : 0;
    });
    add_open_sides(settings, state, s, dt);
    balance(settings, s);
    balance_pockets(s.pockets, s);
    for_cells(box, [&](std::int64_t c, int, int, int) {
        double open = 0;
        for (int a = 0; a < box.axes; ++a) {
            open += s.projection.conductance.face[at(a)][at(c)] +
                    s.projection.conductance.face[at(a)][at(c + box.stride[at(a)])];
        }
        if (open == 0) {
            s.projection.right()[at(c)] = 0;
            state.pressure[at(c)] = 0;
        }
    });
    for (int side = 0; side < 2 * box.axes; ++side) {
        for_ghosts(box, side,
                   [&](std::int64_t ghost, std::int64_t, int, int, int, int) { state.pressure[at(ghost)] = 0; });
    }
    if (!s.projection.has_operator) {
        s.projection.solver.set_operator(s.projection.conductance);
        s.projection.has_operator = true;
    }
    // The first solve has no pressure to start from: an error there would leave waves for good.
    const double tolerance = state.step == 0 ? first_tolerance
                             : is_rough      ? std::max(rough_tolerance, settings.tolerance)
                                             : settings.tolerance;
    const double enough =
        state.step == 0 || settings.pressure_corrections == 1 ? 0 : settings.tolerance * s.projection.first_residual;
    const linear::PoissonReport report = s.projection.solver.solve(
        s.projection.conductance, s.projection.right(), state.pressure, tolerance, settings.longest_solve, enough);
    if (s.projection.first_residual == 0) {
        s.projection.first_residual = report.first;
    }
    level_pockets(settings, state, s, s.pockets, state.time + dt);
    for (int side = 0; side < 2 * box.axes; ++side) {
        const bool is_open = settings.side[at(side)].kind == SideKind::open;
        for_ghosts(box, side, [&](std::int64_t ghost, std::int64_t inside, int layer, int i, int j, int k) {
            state.pressure[at(ghost)] = is_open && layer == 0
                                            ? side_pressure(settings, state, side, ghost, {i, j, k}, g)
                                            : state.pressure[at(inside)];
        });
    }
    for (int a = 0; a < box.axes; ++a) {
        const std::int64_t sa = box.stride[at(a)];
        for_faces(box, a, [&](std::int64_t f, int, int, int) {
            const double area = s.room.area[at(a)][at(f)];
            const double driven =
                s.projection.conductance.face[at(a)][at(f)] * (state.pressure[at(f)] - state.pressure[at(f - sa)]);
            state.velocity[at(a)][at(f)] = s.projection.predicted[at(a)][at(f)] - (area > 0 ? driven / area : 0);
        });
    }
    return report;
}

}  // namespace

linear::PoissonReport project_velocity(const GridSettings& settings, GridState& state, GridScratch& s, double dt,
                                       bool is_rough) {
    const linear::PoissonReport report = solve_and_correct(settings, state, s, dt, is_rough);
    find_viscosity(settings, state, s);  // the solver has had its memory
    return report;
}

double largest_divergence(const GridSettings& settings, const GridState& state, const GridScratch& s) {
    return reduce_cells(
        settings.mesh.box, 0.0,
        [&](std::int64_t c, int i, int j, int k) {
            return std::abs(net_outflow(settings.mesh.box, state.velocity, s, c)) / settings.mesh.volume(i, j, k);
        },
        max_of);
}

}  // namespace riprap::fluid::grid
