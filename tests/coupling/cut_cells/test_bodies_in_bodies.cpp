// SPDX-License-Identifier: Apache-2.0
// Bodies that reach into others: a wall through a floor.
#include <gtest/gtest.h>

#include <vector>

#include "riprap/coupling/cut_cells/cut_bodies.hpp"
#include "riprap/coupling/cut_cells/cut_loads.hpp"
#include "riprap/fluid/grid/grid_step.hpp"
#include "riprap/geometry/polyhedra/shapes.hpp"

namespace riprap::coupling {
namespace {

using namespace fluid::grid;

GridBody block(const Vec3& size, const Vec3& centre) {
    GridBody body;
    body.parts.push_back(geometry::moved(geometry::box(size), Pose{centre, Quat{}}));
    body.centre = centre;
    return body;
}

/// Force of still water, 0.3 m deep, on an upright wall that goes through a floor and on below the domain.
Vec3 force_on_wall(double floor_top, double wall_face, bool is_wall_first) {
    GridSettings settings;
    settings.mesh = Mesh({uniform_edges(-0.12, 0.6, 36), uniform_edges(-0.12, 0.6, 36), {-0.5, 0.5}}, 2);
    settings.side[3].kind = SideKind::open;
    const GridBody floor = block({1, 0.4, 1}, {0.24, floor_top - 0.2, 0}),
                   wall = block({0.08, 4, 1}, {wall_face + 0.04, -0.3, 0});
    const std::vector<GridBody> bodies = is_wall_first ? std::vector{wall, floor} : std::vector{floor, wall};
    GridState state =
        make_state(settings, [&](const Vec3& x) { return x.x < wall_face + 0.04 && x.y < floor_top + 0.3; });
    GridScratch scratch;
    const CutBodies cut = cut_bodies(settings.mesh, bodies);
    set_open_shares(settings, state, scratch, cut.open);
    advance(settings, state, scratch, 1e-3);
    return cut_loads(settings, state, scratch, bodies, cut)[is_wall_first ? 0 : 1].force();
}

// Story: a wall that slid through a floor was lifted with 126 N/m, by the water at a section through itself where the
// cells that both fill began, and pushed with 501 N/m for 441, by water at what of it was in the floor.
TEST(BodiesInBodies, a_wall_through_a_floor_feels_the_water_above_the_floor_alone) {
    const double push = 0.5 * 1000 * 9.81 * 0.3 * 0.3;
    for (const bool is_wall_first : {false, true}) {
        for (const double face : {0.4, 0.405}) {
            const Vec3 force = force_on_wall(0, face, is_wall_first);
            EXPECT_NEAR(force.x / push, 1, 0.01) << face << " " << is_wall_first;
            EXPECT_NEAR(force.y / push, 0, 1e-6) << face << " " << is_wall_first;
        }
        // the cells at a floor that cuts them count in halves
        for (const double top : {0.004, 0.01, 0.013}) {
            const Vec3 force = force_on_wall(top, 0.4, is_wall_first);
            EXPECT_NEAR(force.x / push, 1, 0.05) << top << " " << is_wall_first;
            EXPECT_NEAR(force.y / push, 0, 1e-6) << top << " " << is_wall_first;
        }
    }
}

TEST(BodiesInBodies, a_block_pressed_a_little_into_a_bed_still_has_the_uplift_of_an_open_joint) {
    GridSettings settings;
    settings.mesh = Mesh({uniform_edges(0, 1, 20), uniform_edges(0, 1, 20), {-0.5, 0.5}}, 2);
    settings.side[3].kind = SideKind::open;
    for (const double overlap : {0.0, 1e-5, 5e-3}) {
        const std::vector<GridBody> bodies{block({1.2, 0.2, 1}, {0.5, 0, 0}),
                                           block({0.3, 0.2, 1}, {0.5, 0.2 - overlap, 0})};
        GridState state = make_state(settings, [](const Vec3& x) { return x.y < 0.75; });
        GridScratch scratch;
        const CutBodies cut = cut_bodies(settings.mesh, bodies);
        set_open_shares(settings, state, scratch, cut.open);
        advance(settings, state, scratch, 1e-3);
        const double lift = cut_loads(settings, state, scratch, bodies, cut)[1].force().y;
        EXPECT_NEAR(lift / (9810 * 0.3 * 0.2), 1, 0.01) << overlap;
    }
}

}  // namespace
}  // namespace riprap::coupling
