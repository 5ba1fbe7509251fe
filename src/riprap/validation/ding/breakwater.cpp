// SPDX-License-Identifier: Apache-2.0
#include "riprap/validation/ding/breakwater.hpp"

#include <cmath>

#include "riprap/coupling/cut_cells/cut_bodies.hpp"
#include "riprap/fluid/grid/wave_side.hpp"
#include "riprap/geometry/shapes.hpp"

namespace riprap::validation::ding {

using namespace grid;

namespace {

constexpr double gravity = 9.81;
constexpr double rear_height = 6;  ///< of the armour behind the caisson [m]

/// Depth of a place below the surface of the slope, normal to it [m]; negative outside.
double depth_in_slope(const Breakwater& breakwater, const Vec3& x) {
    const double toe = Breakwater::caisson_front - breakwater.slope * Breakwater::slope_height;
    if (x.x < toe || x.x > Breakwater::caisson_front) {
        return -1;
    }
    return ((x.x - toe) / breakwater.slope - x.y) * breakwater.slope / std::hypot(1, breakwater.slope);
}

}  // namespace

GridTrial make_breakwater(const Breakwater& breakwater) {
    const double length = Breakwater::length;
    GridSettings settings = make_tank({}, {length, Breakwater::ceiling, 1},
                                      {static_cast<int>(std::lround(length / breakwater.cell_x)),
                                       static_cast<int>(std::lround(Breakwater::ceiling / breakwater.cell_y)), 1});
    settings.turbulence = Turbulence::k_epsilon_stable;
    settings.side[3].kind = SideKind::open;
    settings.side[0] = wave_side(
        settings.mesh, 0, 1, 0, Breakwater::depth,
        waves_of(wave::solitary_wave(Breakwater::wave_height, Breakwater::depth, gravity), crest_at_inlet), true);
    settings.side[1] = absorbing_side(settings.mesh, 1, 1, 0, Breakwater::depth);
    settings.porous.push_back({{0.40, 0.3, 50, 2, 0.34, 72, PorousClosure::ding},
                               [=](const Vec3& x) { return depth_in_slope(breakwater, x) >= 0; }});
    settings.porous.push_back({{0.49, 1.0, 50, 2, 0.34, 72, PorousClosure::ding}, [=](const Vec3& x) {
                                   const double d = depth_in_slope(breakwater, x);
                                   return d >= 0 && d < breakwater.layer;
                               }});
    if (breakwater.has_rear_armour) {
        settings.porous.push_back({{0.40, 1.0, 50, 2, 0.34, 72, PorousClosure::ding}, [](const Vec3& x) {
                                       const double away = x.x - Breakwater::caisson_front - Breakwater::caisson_width;
                                       return away >= 0 && away + x.y <= rear_height + 2;
                                   }});
    }
    GridTrial trial(settings, make_state(settings, [](const Vec3& x) { return x.y < Breakwater::depth; }));
    const Vec3 size{Breakwater::caisson_width, Breakwater::caisson_height, 2};
    coupling::GridBody caisson;
    caisson.parts.push_back(geometry::moved(
        geometry::box(size), Pose{{Breakwater::caisson_front + 0.5 * size.x, 0.5 * size.y, 0.5}, Quat{}}));
    set_open_shares(trial.settings(), trial.state(), trial.scratch(),
                    coupling::cut_bodies(settings.mesh, {caisson}).open);
    return trial;
}

double height_at_front(const GridTrial& trial) {
    const Mesh& mesh = trial.settings().mesh;
    const int last = mesh.cell_at(0, Breakwater::caisson_front - 1e-6),
              first = mesh.cell_at(0, Breakwater::caisson_front - 2);
    double highest = 0;
    for (int i = first; i <= last; ++i) {
        for (int j = mesh.box.cells[1] - 1; j >= 0; --j) {
            const double fraction = trial.state().fraction[at(mesh.box.index(i, j, 0))];
            if (fraction >= 0.5) {
                const double above =
                    j + 1 < mesh.box.cells[1] ? trial.state().fraction[at(mesh.box.index(i, j + 1, 0))] : 0;
                highest = std::max(highest, mesh.edge[1][at(j + 1)] + above * mesh.h(1, j));
                break;
            }
        }
    }
    return highest;
}

}  // namespace riprap::validation::ding
