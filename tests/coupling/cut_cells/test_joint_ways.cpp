// SPDX-License-Identifier: Apache-2.0
// Ways of water into joints: along them, and not through the bodies that they lie between.
#include <fmt/format.h>
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

constexpr double spacing = 0.05;

GridBody box_of(const Vec3& low, const Vec3& high) {
    GridBody body;
    body.centre = (low + high) * 0.5;
    body.parts.push_back(geometry::moved(geometry::box(high - low), Pose{body.centre, Quat{}}));
    return body;
}

/// Forces of still water, filled where `is_wet` says, on bodies in a domain of 1 m whose top is open, and its bottom
/// where air is there.
std::vector<Vec3> forces_on(const std::vector<GridBody>& bodies, int axes, bool (*is_wet)(const Vec3&)) {
    GridSettings settings;
    const std::vector<double> edges = uniform_edges(0, 1, 20);
    const std::vector<double> across = axes == 3 ? uniform_edges(-0.5, 0.5, 20) : std::vector<double>{-0.5, 0.5};
    settings.mesh = Mesh({edges, edges, across}, axes);
    settings.side[3].kind = SideKind::open;
    settings.side[2].kind = is_wet({0.01, 0.01, 0}) ? SideKind::slip : SideKind::open;
    GridState state = make_state(settings, is_wet);
    GridScratch scratch;
    const CutBodies cut = cut_bodies(settings.mesh, bodies);
    set_open_shares(settings, state, scratch, cut.open);
    advance(settings, state, scratch, 1e-3);
    std::vector<Vec3> forces;
    for (const GridLoad& load : cut_loads(settings, state, scratch, bodies, cut)) {
        forces.push_back(load.force());
    }
    return forces;
}

// Story: of a block on a bed of triangles two cells thick, hollow below, a fifth of the base felt the air under the
// bed: its uplift was 36 N where 57 N are right.
TEST(JointWays, lead_to_the_water_about_a_block_and_not_through_the_plate_that_it_stands_on) {
    const double width = 0.3, height = 0.2;
    for (const int axes : {2, 3}) {
        const double depth = axes == 3 ? width : 1;
        for (const int cells : {1, 2, 3}) {
            // of the block; the last, of it and the plate
            for (const double up : axes == 3 ? std::vector{0.02} : std::vector{0.0, -1e-4, 1e-4, 0.02}) {
                for (const double side : axes == 3 ? std::vector{0.0} : std::vector{0.0, 0.013}) {
                    const double top = up == 0.02 ? 0.32 : 0.3, foot = up == 0.02 ? top : top + up;
                    const std::vector<GridBody> bodies{
                        box_of({-0.2, top - cells * spacing, -0.7}, {1.2, top, 0.7}),
                        box_of({0.35 + side, foot, -depth / 2}, {0.35 + side + width, foot + height, depth / 2})};
                    const double lift = 1000 * 9.81 * width * height * depth;
                    const Vec3 force = forces_on(bodies, axes, [](const Vec3& x) { return x.y > 0.3 && x.y < 0.8; })[1];
                    EXPECT_NEAR(force.y / lift, 1, 0.03)
                        << axes << " axes, a plate of " << cells << " cells, block up by " << up << ", aside " << side;
                }
            }
        }
    }
}

TEST(JointWays, lead_past_a_block_at_a_thin_wall_with_air_behind_it) {
    for (const int cells : {1, 2}) {
        const double face = 0.5, height = 0.3, width = 0.2, low = 0.35;
        const std::vector<GridBody> bodies{box_of({face, -0.2, -0.7}, {face + cells * spacing, 1.2, 0.7}),
                                           box_of({face - width, low, -0.5}, {face, low + height, 0.5})};
        const Vec3 force = forces_on(bodies, 2, [](const Vec3& x) { return x.x < 0.5 && x.y < 0.8; })[1];
        const double push = 1000 * 9.81 * (0.8 - low - height / 2) * height;  // on the other side of the block
        EXPECT_NEAR(force.x / push, 0, 0.03) << cells;
        EXPECT_NEAR(force.y / (1000 * 9.81 * width * height), 1, 0.03) << cells;
    }
}

TEST(JointWays, lead_to_a_block_under_a_thin_lid_with_air_above_it) {
    for (const int cells : {1, 2}) {
        const double under = 0.6, width = 0.3, height = 0.2;
        const std::vector<GridBody> bodies{box_of({0.2, under, -0.7}, {0.8, under + cells * spacing, 0.7}),
                                           box_of({0.2, under + cells * spacing, -0.7}, {0.25, 1.2, 0.7}),
                                           box_of({0.75, under + cells * spacing, -0.7}, {0.8, 1.2, 0.7}),
                                           box_of({0.35, under - height, -0.5}, {0.35 + width, under, 0.5})};
        const Vec3 force =
            forces_on(bodies, 2, [](const Vec3& x) { return x.y < 0.8 && (x.y < 0.6 || x.x < 0.2 || x.x > 0.8); })[3];
        EXPECT_NEAR(force.y / (1000 * 9.81 * width * height), 1, 0.03) << cells;
        EXPECT_NEAR(force.x, 0, 1) << cells;
    }
}

}  // namespace
}  // namespace riprap::coupling
