// SPDX-License-Identifier: Apache-2.0
// Bodies whose faces lie on faces of cells, but for rounding.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "riprap/coupling/cut_cells/cut_bodies.hpp"
#include "riprap/coupling/cut_cells/cut_loads.hpp"
#include "riprap/fluid/grid/grid_step.hpp"
#include "riprap/geometry/polyhedra/shapes.hpp"

namespace riprap::coupling {
namespace {

using namespace fluid::grid;

GridSettings tank(int axes) {
    GridSettings settings;
    const std::vector<double> edges = uniform_edges(0, 0.8, axes == 3 ? 10 : 20);
    settings.mesh = Mesh({edges, edges, axes == 3 ? edges : std::vector<double>{-0.5, 0.5}}, axes);
    settings.side[3].kind = SideKind::open;
    return settings;
}

GridBody body_of(const std::vector<std::pair<Vec3, Vec3>>& boxes, const Vec3& shift) {
    GridBody body;
    for (const auto& [low, high] : boxes) {
        const Vec3 centre = (low + high) * 0.5 + shift;
        body.parts.push_back(geometry::moved(geometry::box(high - low), Pose{centre, Quat{}}));
    }
    body.centre = (boxes.front().first + boxes.back().second) * 0.5 + shift;
    return body;
}

/// Force of still water, 0.7 m deep along y, on a body.
Vec3 force_on(const GridBody& body, int axes) {
    const GridSettings settings = tank(axes);
    const std::vector<GridBody> bodies{body};
    GridState state = make_state(settings, [](const Vec3& x) { return x.y < 0.7; });
    GridScratch scratch;
    const CutBodies cut = cut_bodies(settings.mesh, bodies);
    set_open_shares(settings, state, scratch, cut.open);
    advance(settings, state, scratch, 1e-3);
    return cut_loads(settings, state, scratch, bodies, cut)[0].force();
}

struct Aligned {
    const char* name;
    int axes;
    std::vector<std::pair<Vec3, Vec3>> boxes;  ///< their low and high corners [m]
    double volume;                             ///< [m^3]
};

const std::vector<Aligned> aligned{
    {"box", 2, {{{0.24, 0.2, -0.5}, {0.56, 0.44, 0.5}}}, 0.32 * 0.24},
    {"plate of one cell", 2, {{{0.24, 0.2, -0.5}, {0.56, 0.24, 0.5}}}, 0.32 * 0.04},
    {"plate thinner than a cell, one face on it", 2, {{{0.24, 0.2, -0.5}, {0.56, 0.22, 0.5}}}, 0.32 * 0.02},
    {"step of two boxes",
     2,
     {{{0.24, 0.2, -0.5}, {0.4, 0.44, 0.5}}, {{0.4, 0.2, -0.5}, {0.56, 0.32, 0.5}}},
     0.16 * 0.24 + 0.16 * 0.12},
    {"box in space", 3, {{{0.24, 0.24, 0.24}, {0.56, 0.48, 0.48}}}, 0.32 * 0.24 * 0.24}};

// Story: a box as heavy as water, its faces on those of cells, fell at 24 mm/s. It had moved by 1e-12 m, and the flat
// piece of it in the next cells had both of its faces on one side of them: the pressure on the bottom pushed it down.
TEST(AlignedBodies, move_by_rounding_and_still_are_lifted_by_what_they_displace) {
    for (const Aligned& tried : aligned) {
        const double lift = 1000 * 9.81 * tried.volume;
        for (const double by : {0.0, 1e-13, 3e-11, 1e-8}) {
            for (const Vec3& way : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{1, 1, 0}, Vec3{0.5, -1, 0.5}}) {
                for (const double sign : {1.0, -1.0}) {
                    const Vec3 shift = sign * by * 0.04 * way;
                    const Vec3 force = force_on(body_of(tried.boxes, shift), tried.axes);
                    EXPECT_NEAR(force.y, lift, 1e-4 * lift) << tried.name << " moved by " << sign * by << " of a cell";
                    EXPECT_NEAR(std::hypot(force.x, force.z), 0, 1e-4 * lift) << tried.name << " moved by " << by;
                }
            }
        }
    }
}

}  // namespace
}  // namespace riprap::coupling
