// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/grid/boundary.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace riprap::fluid::grid {

namespace {

/// Centre of the face of component c at (i, j, k), or of the cell for c < 0.
Vec3 place_of(const Mesh& mesh, int c, int i, int j, int k) {
    Vec3 place{};
    const std::array<int, 3> index{i, j, k};
    for (int a = 0; a < 3; ++a) {
        const int p = index[at(a)], n = mesh.box.cells[at(a)];
        place[a] = a == c ? (p < 0 ? mesh.edge[at(a)][0] : mesh.edge[at(a)][at(std::min(p, n))]) : mesh.centre(a, p);
    }
    return place;
}

double ghost_beside_wall(const GridSettings& settings, SideKind kind, double wall, double inside, double distance) {
    switch (kind) {
        case SideKind::no_slip:
            return 2 * wall - inside;
        case SideKind::wall_function: {
            // the ghost that gives the wall's shear with the molecular viscosity
            const double nu = settings.water.kinematic_viscosity, relative = inside - wall;
            const double u_tau = shear_velocity(std::abs(relative), distance, nu);
            return inside - std::copysign(2 * distance * u_tau * u_tau / nu, relative);
        }
        default:
            return inside;
    }
}

/// Share of a cell below a level along an axis [-].
double wet_share(const Mesh& mesh, int axis, int cell, double level) {
    const int p = std::clamp(cell, 0, mesh.box.cells[at(axis)] - 1);
    return std::clamp((level - mesh.edge[at(axis)][at(p)]) / mesh.h(axis, p), 0.0, 1.0);
}

/// Water in the column of cells beside a side less that of what comes in [m].
double level_excess(const GridSettings& settings, int side, std::array<int, 3> cell, double time,
                    const std::vector<double>& fraction) {
    const Mesh& mesh = settings.mesh;
    const Side& s = settings.side[at(side)];
    const int up = s.absorber.up;
    double sum = 0;
    for (int i = 0; i < mesh.box.cells[at(up)]; ++i) {
        cell[at(up)] = i;
        const double wanted = s.inflow(place_of(mesh, -1, cell[0], cell[1], cell[2]), time).fraction;
        sum += (fraction[at(mesh.box.index(cell[0], cell[1], cell[2]))] - wanted) * mesh.h(up, i);
    }
    return sum;
}

void set_normal(const GridSettings& settings, int side, double time, const std::vector<double>& fraction,
                std::vector<double>& u) {
    const Mesh& mesh = settings.mesh;
    const CellBox& box = mesh.box;
    const int a = side / 2, n = box.cells[at(a)];
    const bool is_high = side % 2 == 1;
    const Side& s = settings.side[at(side)];
    const std::int64_t stride = box.stride[at(a)];
    const int beside = 3 - a - s.absorber.up;  // axis that columns of the side lie along
    std::vector<std::optional<double>> excess(s.absorber.is_on ? at(box.cells[at(beside)] + 2 * Mesh::ghosts) : 0);
    for_ghosts(box, side, [&](std::int64_t ghost, std::int64_t, int layer, int i, int j, int k) {
        if (layer > 0) {
            return;
        }
        const std::int64_t face = is_high ? ghost : ghost + stride;
        const std::int64_t inner = is_high ? face - stride : face + stride;
        std::array<int, 3> place{i, j, k};
        place[at(a)] = is_high ? n : 0;
        if (is_wall(s.kind)) {
            u[at(face)] = 0;
        } else if (s.kind == SideKind::inflow) {
            u[at(face)] = s.inflow(place_of(mesh, a, place[0], place[1], place[2]), time).velocity[a];
            if (s.absorber.is_on) {
                place[at(a)] = is_high ? n - 1 : 0;
                auto& over = excess[at(place[at(beside)] + Mesh::ghosts)];
                over = over ? over : level_excess(settings, side, place, time, fraction);
                const double speed = std::sqrt(norm(settings.gravity) / s.absorber.depth) * *over;
                u[at(face)] += (is_high ? 1 : -1) * speed * fraction[at(is_high ? face - stride : face)];
            }
        }
        // beyond the side: odd about a wall, without gradient elsewhere
        const double beyond = is_wall(s.kind) ? 2 * u[at(face)] - u[at(inner)] : u[at(face)];
        u[at(is_high ? face + stride : face - stride)] = beyond;
        if (!is_high) {
            u[at(face - 2 * stride)] = beyond;
        }
    });
}

/// Whether fluid comes in from rest at a place beyond a side, on a face of component c along the side. Only faces of
/// the side itself are asked: those beyond its rims may not be up to date.
bool comes_from_rest(const GridSettings& settings, int side, int c, std::array<int, 3> place,
                     const std::vector<double>& normal) {
    const Side& s = settings.side[at(side)];
    if (s.kind != SideKind::open || !s.is_from_rest) {
        return false;
    }
    const CellBox& box = settings.mesh.box;
    const int a = side / 2, other = 3 - a - c;
    const auto inside = [&](int axis, int p) { return std::clamp(p, 0, box.cells[at(axis)] - 1); };
    place[at(a)] = side % 2 == 1 ? box.cells[at(a)] : 0;
    place[at(other)] = inside(other, place[at(other)]);
    double u = 0;
    for (const int p : {place[at(c)] - 1, place[at(c)]}) {
        place[at(c)] = inside(c, p);
        u += normal[at(box.index(place[0], place[1], place[2]))];
    }
    return comes_in(side, u);
}

}  // namespace

double shear_velocity(double speed, double distance, double viscosity) {
    constexpr double roughness = 9.8;
    double u_tau = std::sqrt(viscosity * speed / distance);
    if (u_tau * distance / viscosity < 11.53) {
        return u_tau;
    }
    for (int i = 0; i < 12; ++i) {
        u_tau = von_karman * speed / std::log(std::max(roughness * u_tau * distance / viscosity, 2.8));
    }
    return u_tau;
}

void mirror_ghosts(const Mesh& mesh, std::vector<double>& field) {
    for (int side = 0; side < 2 * mesh.box.axes; ++side) {
        for_ghosts(mesh.box, side, [&](std::int64_t ghost, std::int64_t inside, int, int, int, int) {
            field[at(ghost)] = field[at(inside)];
        });
    }
}

void fill_fraction_ghosts(const GridSettings& settings, const std::array<std::vector<double>, 3>& velocity, double time,
                          std::vector<double>& fraction) {
    const Mesh& mesh = settings.mesh;
    const CellBox& box = mesh.box;
    for (int side = 0; side < 2 * box.axes; ++side) {
        const Side& s = settings.side[at(side)];
        const int a = side / 2;
        const bool is_high = side % 2 == 1;
        const std::int64_t first = box.stride[at(a)];
        for_ghosts(box, side, [&](std::int64_t ghost, std::int64_t inside, int layer, int i, int j, int k) {
            fraction[at(ghost)] = fraction[at(inside)];
            if (s.kind == SideKind::inflow && s.inflow) {
                std::array<int, 3> place{i, j, k};
                place[at(a)] = is_high ? box.cells[at(a)] - 1 : 0;
                const Inflow in = s.inflow(place_of(mesh, -1, place[0], place[1], place[2]), time);
                fraction[at(ghost)] = in.is_closed || in.is_drawn ? fraction[at(inside)] : in.fraction;
            } else if (s.kind == SideKind::open) {
                const std::int64_t face = is_high ? ghost - layer * first : ghost + (layer + 1) * first;
                const double u = velocity[at(a)][at(face)];
                if (comes_in(side, u)) {
                    fraction[at(ghost)] = s.still_level
                                              ? wet_share(mesh, s.up, std::array{i, j, k}[at(s.up)], *s.still_level)
                                              : s.open_fraction;
                }
            }
        });
    }
}

void fill_velocity_ghosts(const GridSettings& settings, double time, const std::vector<double>& fraction,
                          std::array<std::vector<double>, 3>& velocity) {
    const Mesh& mesh = settings.mesh;
    const CellBox& box = mesh.box;
    for (int side = 0; side < 2 * box.axes; ++side) {
        const Side& s = settings.side[at(side)];
        const int a = side / 2;
        const double distance = 0.5 * mesh.h(a, side % 2 == 1 ? box.cells[at(a)] - 1 : 0);
        set_normal(settings, side, time, fraction, velocity[at(a)]);
        for (int c = 0; c < box.axes; ++c) {
            if (c == a) {
                continue;
            }
            for_ghosts(box, side, [&](std::int64_t ghost, std::int64_t inside, int, int i, int j, int k) {
                auto& u = velocity[at(c)];
                u[at(ghost)] = ghost_beside_wall(settings, s.kind, s.velocity[c], u[at(inside)], distance);
                if (s.kind == SideKind::inflow && s.inflow) {
                    std::array<int, 3> place{i, j, k};
                    place[at(a)] = side % 2 == 1 ? box.cells[at(a)] : -1;
                    const Inflow in = s.inflow(place_of(mesh, c, place[0], place[1], place[2]), time);
                    u[at(ghost)] = in.is_closed || in.is_drawn ? u[at(inside)] : in.velocity[c];
                } else if (comes_from_rest(settings, side, c, {i, j, k}, velocity[at(a)])) {
                    u[at(ghost)] = 0;
                }
            });
            // the face of component c on the high rim of axis c lies one beyond the cells: for_ghosts reaches it only
            // where that axis came before
            if (c > a) {
                const int n = box.cells[at(c)];
                for (int layer = 0; layer < Mesh::ghosts; ++layer) {
                    const int ghost = side % 2 == 1 ? box.cells[at(a)] + layer : -1 - layer;
                    const int inside = side % 2 == 1 ? std::max(box.cells[at(a)] - 1 - layer, 0)
                                                     : std::min(layer, box.cells[at(a)] - 1);
                    const int other = 3 - a - c;
                    for (int t = 0; t < box.cells[at(other)]; ++t) {
                        std::array<int, 3> place{};
                        place[at(c)] = n;
                        place[at(other)] = t;
                        place[at(a)] = ghost;
                        const auto to = at(box.index(place[0], place[1], place[2]));
                        place[at(a)] = inside;
                        auto& u = velocity[at(c)];
                        u[to] = ghost_beside_wall(settings, s.kind, s.velocity[c],
                                                  u[at(box.index(place[0], place[1], place[2]))], distance);
                        if (comes_from_rest(settings, side, c, place, velocity[at(a)])) {
                            u[to] = 0;
                        }
                    }
                }
            }
        }
    }
}

}  // namespace riprap::fluid::grid
