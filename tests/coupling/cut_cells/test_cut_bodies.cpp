// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "riprap/coupling/cut_cells/cut_bodies.hpp"
#include "riprap/coupling/cut_cells/cut_loads.hpp"
#include "riprap/coupling/cut_cells/side_facets.hpp"
#include "riprap/fluid/grid/grid_step.hpp"
#include "riprap/fluid/grid/pockets.hpp"
#include "riprap/fluid/grid/surface.hpp"
#include "riprap/geometry/polyhedra/shapes.hpp"

namespace riprap::coupling {
namespace {

using namespace fluid::grid;

GridSettings tank(const Vec3& size, const std::array<int, 3>& cells) {
    GridSettings settings;
    settings.mesh = Mesh(
        {uniform_edges(0, size.x, cells[0]), uniform_edges(0, size.y, cells[1]), uniform_edges(0, size.z, cells[2])},
        cells[2] > 1 ? 3 : 2);
    return settings;
}

Quat turned(double angle, const Vec3& axis) {
    const Vec3 n = normalized(axis);
    return {std::cos(angle / 2), n.x * std::sin(angle / 2), n.y * std::sin(angle / 2), n.z * std::sin(angle / 2)};
}

GridBody block(const Vec3& size, const Vec3& centre, const Quat& orientation = {}) {
    GridBody body;
    body.parts.push_back(geometry::moved(geometry::box(size), Pose{centre, orientation}));
    body.centre = centre;
    return body;
}

double closed_volume(const Mesh& mesh, const CutBodies& cut) {
    double sum = 0;
    for_cells(mesh.box,
              [&](std::int64_t c, int i, int j, int k) { sum += (1 - cut.open.volume[at(c)]) * mesh.volume(i, j, k); });
    return sum;
}

double largest_speed(const GridSettings& settings, const GridState& state, const GridScratch& scratch) {
    double largest = 0;
    for (int a = 0; a < settings.mesh.box.axes; ++a) {
        for_faces(settings.mesh.box, a, [&](std::int64_t f, int, int, int) {
            largest =
                std::max(largest, scratch.room.area[at(a)][at(f)] > 0 ? std::abs(state.velocity[at(a)][at(f)]) : 0);
        });
    }
    return largest;
}

TEST(CutBodies, volume_of_a_turned_block_is_cut_out_exactly) {
    const GridSettings settings = tank({1, 1, 1}, {13, 17, 11});
    const CutBodies cut =
        cut_bodies(settings.mesh, {block({0.41, 0.33, 0.27}, {0.52, 0.47, 0.51}, turned(0.7, {1, 2, 3}))});
    EXPECT_NEAR(closed_volume(settings.mesh, cut), 0.41 * 0.33 * 0.27, 1e-12);
}

TEST(CutBodies, a_block_thinner_than_the_plane_leaves_no_slits_beside_it) {
    const GridSettings settings = tank({1, 1, 1}, {10, 10, 1});
    const CutBodies cut =
        cut_bodies(settings.mesh, {block({0.41, 0.33, 1 - 1e-6}, {0.52, 0.47, 0.5}, turned(0.7, {0, 0, 1}))});
    EXPECT_NEAR(closed_volume(settings.mesh, cut), 0.41 * 0.33, 1e-12);
    for (int a = 0; a < 2; ++a) {
        for_faces(settings.mesh.box, a, [&](std::int64_t f, int, int, int) {
            const double open = cut.open.area[at(a)][at(f)];
            EXPECT_TRUE(open == 0 || open > 1e-3) << open;
        });
    }
}

TEST(CutBodies, closed_areas_and_facets_of_every_cell_add_up_to_nothing) {
    const GridSettings settings = tank({1, 1, 1}, {13, 17, 11});
    const CutBodies cut =
        cut_bodies(settings.mesh, {block({0.41, 0.33, 0.27}, {0.52, 0.47, 0.51}, turned(0.7, {1, 2, 3}))});
    const CellBox& box = settings.mesh.box;
    std::vector<Vec3> sum(at(box.size));
    for (const CutFacet& facet : cut.facets) {
        sum[at(facet.cell)] += facet.area;
    }
    for_cells(box, [&](std::int64_t c, int i, int j, int k) {
        for (int a = 0; a < 3; ++a) {
            const double whole = settings.mesh.face_area(a, i, j, k);
            const double step = cut.open.area[at(a)][at(c)] - cut.open.area[at(a)][at(c + box.stride[at(a)])];
            EXPECT_NEAR(step * whole + sum[at(c)][a], 0, 1e-11);
        }
    });
}

TEST(CutBodies, volume_of_a_ball_converges_at_second_order) {
    std::array<double, 2> errors{};
    for (const int doubling : {0, 1}) {
        const int n = 12 << doubling;
        GridBody ball;
        ball.spheres.push_back({{0.51, 0.48, 0.5}, 0.3});
        const GridSettings settings = tank({1, 1, 1}, {n, n, n});
        const double exact = 4 * M_PI / 3 * 0.027;
        errors[at(doubling)] = std::abs(closed_volume(settings.mesh, cut_bodies(settings.mesh, {ball})) / exact - 1);
    }
    EXPECT_LT(errors[1], 0.3 * errors[0]);
    EXPECT_LT(errors[1], 5e-3);
}

TEST(CutCells, still_water_around_a_turned_block_stays_still_and_lifts_it_with_its_weight) {
    GridSettings settings = tank({1, 1, 0.1}, {20, 24, 1});
    settings.side[3].kind = SideKind::open;
    const std::vector<GridBody> bodies{block({0.3, 0.2, 0.1}, {0.5, 0.4, 0.05}, turned(0.4, {0, 0, 1}))};
    const CutBodies cut = cut_bodies(settings.mesh, bodies);
    GridState state = make_state(settings, [](const Vec3& x) { return x.y < 0.75; });
    GridScratch scratch;
    for (int i = 0; i < 60; ++i) {
        set_open_shares(settings, state, scratch, cut.open);
        advance(settings, state, scratch, stable_step(settings, state, scratch));
    }
    EXPECT_LT(largest_speed(settings, state, scratch), 1e-10);
    const GridLoad load = cut_loads(settings, state, scratch, bodies, cut)[0];
    const double weight = 1000 * 9.81 * 0.3 * 0.2 * 0.1;
    EXPECT_NEAR(load.force().y / weight, 1, 1e-9);
    EXPECT_NEAR(load.force().x / weight, 0, 1e-9);
    EXPECT_NEAR(load.torque.z / weight, 0, 1e-9);
}

TEST(CutCells, a_block_whose_faces_lie_on_those_of_cells_is_lifted_by_still_water_too) {
    GridSettings settings = tank({1, 1, 0.1}, {20, 20, 1});
    settings.side[3].kind = SideKind::open;
    const std::vector<GridBody> bodies{block({0.3, 0.2, 0.1}, {0.5, 0.4, 0.05})};
    const CutBodies cut = cut_bodies(settings.mesh, bodies);
    GridState state = make_state(settings, [](const Vec3& x) { return x.y < 0.75; });
    GridScratch scratch;
    set_open_shares(settings, state, scratch, cut.open);
    advance(settings, state, scratch, stable_step(settings, state, scratch));
    const GridLoad load = cut_loads(settings, state, scratch, bodies, cut)[0];
    const double weight = 1000 * 9.81 * 0.3 * 0.2 * 0.1;
    EXPECT_NEAR(load.force().y / weight, 1, 1e-9);
    EXPECT_NEAR(load.torque.z / weight, 0, 1e-9);
}

TEST(CutCells, a_block_on_a_bed_feels_the_uplift_of_an_open_joint) {
    GridSettings settings = tank({1, 1, 0.1}, {20, 20, 1});
    settings.side[3].kind = SideKind::open;
    for (const double gap : {0.0, 1e-4}) {  // on the bed, and above it by less than a cell can tell
        const std::vector<GridBody> bodies{block({1.2, 0.2, 0.1}, {0.5, 0, 0.05}),
                                           block({0.3, 0.2, 0.1}, {0.5, 0.2 + gap, 0.05})};
        const CutBodies cut = cut_bodies(settings.mesh, bodies);
        GridState state = make_state(settings, [](const Vec3& x) { return x.y < 0.75; });
        GridScratch scratch;
        set_open_shares(settings, state, scratch, cut.open);
        advance(settings, state, scratch, stable_step(settings, state, scratch));
        const GridLoad load = cut_loads(settings, state, scratch, bodies, cut)[1];
        const double weight = 1000 * 9.81 * 0.3 * 0.2 * 0.1;
        EXPECT_NEAR(load.force().y / weight, 1, 1e-9);
        EXPECT_NEAR(load.torque.z / weight, 0, 1e-9);
    }
}

// Story: the sides of the domain are its floor and walls, and a block that stood on one was pressed on it by the water
// above, as if glued: it weighed what it and that water weigh.
TEST(CutCells, a_block_on_a_side_of_the_domain_feels_the_uplift_of_an_open_joint) {
    GridSettings settings = tank({1, 1, 0.1}, {20, 20, 1});
    settings.side[3].kind = SideKind::open;
    for (const double x : {0.5, 0.512, 0.15}) {  // on faces of cells, across them, against a wall
        for (const double overlap : {0.0, 1e-4, 0.02}) {
            const std::vector<GridBody> bodies{block({0.3, 0.2, 0.1}, {x, 0.1 - overlap, 0.05})};
            const CutBodies cut = cut_bodies(settings.mesh, bodies);
            GridState state = make_state(settings, [](const Vec3& p) { return p.y < 0.75; });
            GridScratch scratch;
            set_open_shares(settings, state, scratch, cut.open);
            advance(settings, state, scratch, stable_step(settings, state, scratch));
            const GridLoad load = cut_loads(settings, state, scratch, bodies, cut)[0];
            const double displaced = 1000 * 9.81 * 0.3 * (0.2 - overlap) * 0.1;
            EXPECT_NEAR(load.force().y / displaced, 1, 1e-9) << x << " " << overlap;
            EXPECT_NEAR(load.force().x / displaced, 0, 1e-9) << x << " " << overlap;
            EXPECT_LT(largest_speed(settings, state, scratch), 1e-10);
        }
    }
    const std::vector<GridBody> pile{block({0.3, 0.4, 0.1}, {0.5, 0.1, 0.05})};  // goes on below the domain
    const CutBodies cut = cut_bodies(settings.mesh, pile);
    EXPECT_TRUE(std::all_of(cut.facets.begin(), cut.facets.end(), moves_fluid));
}

TEST(CutBodies, what_a_moving_face_displaces_does_not_depend_on_where_it_lies_in_a_cell) {
    const GridSettings settings = tank({1, 1, 0.1}, {20, 20, 1});
    for (const double x : {0.5, 0.51, 0.525, 0.5499}) {
        GridBody body = block({0.3, 0.2, 0.1}, {x, 0.4, 0.05});
        body.velocity = {1, 0, 0};
        const CutBodies cut = cut_bodies(settings.mesh, {body});
        double ahead = 0, behind = 0;
        for (const double d : cut.open.displacement) {
            (d < 0 ? ahead : behind) += d;
        }
        EXPECT_NEAR(ahead, -0.2 * 0.1, 1e-12) << x;
        EXPECT_NEAR(behind, 0.2 * 0.1, 1e-12) << x;
    }
}

TEST(CutCells, a_block_that_drifts_with_the_flow_does_not_disturb_it) {
    GridSettings settings = tank({1, 1, 0.1}, {20, 20, 1});
    settings.has_surface = false;
    settings.gravity = {};
    settings.water.kinematic_viscosity = 1e-3;
    const Vec3 wind{0.5, 0.2, 0};
    for (int side = 0; side < 4; ++side) {
        settings.side[at(side)].kind = SideKind::inflow;
        settings.side[at(side)].inflow = [wind](const Vec3&, double) { return Inflow{wind, 1}; };
    }
    GridState state = make_state(
        settings, [](const Vec3&) { return 1.0; }, [wind](const Vec3&) { return wind; });
    GridScratch scratch;
    Vec3 centre{0.3, 0.4, 0.05};
    for (int i = 0; i < 30; ++i) {
        const double dt = 0.02;
        centre += wind * dt;
        GridBody body = block({0.23, 0.17, 0.1}, centre, turned(0.3, {0, 0, 1}));
        body.velocity = wind;
        set_open_shares(settings, state, scratch, cut_bodies(settings.mesh, {body}).open);
        advance(settings, state, scratch, dt);
    }
    double worst = 0;
    for_faces(settings.mesh.box, 0, [&](std::int64_t f, int, int, int) {
        worst = std::max(worst, std::abs(state.velocity[0][at(f)] - wind.x));
    });
    EXPECT_LT(worst, 1e-6);
}

TEST(CutCells, a_block_that_moves_through_the_surface_loses_no_water) {
    GridSettings settings = tank({1, 1, 0.1}, {24, 24, 1});
    settings.side[3].kind = SideKind::open;
    GridState state = make_state(settings, [](const Vec3& x) { return x.y < 0.5; });
    GridScratch scratch;
    double volume = 0;
    for (int i = 0; i < 120; ++i) {
        const double t = state.time, dt = 0.004;
        GridBody body =
            block({0.3, 0.2, 0.1}, {0.5, 0.55 + 0.1 * std::cos(5 * (t + dt)), 0.05}, turned(0.3, {0, 0, 1}));
        body.velocity = {0, -0.5 * std::sin(5 * (t + dt)), 0};
        set_open_shares(settings, state, scratch, cut_bodies(settings.mesh, {body}).open);
        if (i == 0) {
            volume = state.water.held;
        }
        advance(settings, state, scratch, dt);
        for_cells(settings.mesh.box, [&](std::int64_t c, int, int, int) {
            EXPECT_GE(state.fraction[at(c)], 0);
            EXPECT_LE(state.fraction[at(c)], 1);
        });
    }
    EXPECT_NEAR(water_volume(settings, state, scratch) / volume, 1, 1e-10);
    EXPECT_LT(largest_speed(settings, state, scratch), 5);
}

/// A cup of three walls, open above, and a lid that slides down into it with `gap` on either side, all under water.
std::vector<GridBody> cup_and_lid(double gap, double lid_height, double lid_speed) {
    std::vector<GridBody> bodies{block({0.1, 0.4, 0.1}, {0.26, 0.37, 0.05}), block({0.1, 0.4, 0.1}, {0.72, 0.37, 0.05}),
                                 block({0.56, 0.1, 0.1}, {0.49, 0.12, 0.05}),
                                 block({0.36 - 2 * gap, 0.1, 0.1}, {0.49, lid_height, 0.05})};
    bodies.back().velocity = {0, -lid_speed, 0};
    return bodies;
}

// Story: tetrapods that fell on each other closed a pocket of water. A fluid that keeps its volume cannot follow a
// pocket that gets smaller: its pressure has no solution, and conjugate gradients went to 1e150. A gap of a hundredth
// of a cell was as bad: all the water of the pocket had to come through.
TEST(CutCells, a_pocket_that_bodies_close_and_press_together_has_the_pressure_of_the_water_around) {
    for (const double gap : {0.0, 1e-4}) {
        GridSettings settings = tank({1, 1, 0.1}, {20, 20, 1});
        settings.side[3].kind = SideKind::open;
        GridState state = make_state(settings, [](const Vec3& x) { return x.y < 0.85; });
        GridScratch scratch;
        const double speed = 0.01, dt = 0.01, weight = 1000 * 9.81 * (0.36 - 2 * gap) * 0.1 * 0.1;
        for (int i = 1; i <= 8; ++i) {
            const auto bodies = cup_and_lid(gap, 0.5 - speed * dt * i, speed);
            const CutBodies cut = cut_bodies(settings.mesh, bodies);
            set_open_shares(settings, state, scratch, cut.open);
            EXPECT_EQ(find_pockets(settings, scratch).size(), 1U) << gap;
            EXPECT_TRUE(advance(settings, state, scratch, dt).converged) << gap;
            const GridLoad load = cut_loads(settings, state, scratch, bodies, cut)[3];
            if (i > 2) {  // the lid has started
                EXPECT_NEAR(load.force().y / weight, 1, 0.1) << gap << " step " << i;
            }
        }
        EXPECT_LT(largest_speed(settings, state, scratch), 10 * speed) << gap;
    }
}

/// Two wedges that fill cell (5, 5, 5) of a cube of ten cells by 1.05 of its volume, and leave 0.4 of its low face
/// open.
std::vector<GridBody> wedges_that_overlap() {
    std::vector<GridBody> bodies(2);
    for (const double sign : {1.0, -1.0}) {
        geometry::Polyhedron wedge = geometry::box({0.1, 0.1, 1});
        for (Vec3& x : wedge.vertices) {
            const bool is_tip = sign * x.z > 0;
            const double closed = x.x < 0 ? 0.03 : 0.075;
            x.z = 0.55 + sign * (is_tip ? closed - 0.05 : -0.05);
            x.x += 0.55;
            x.y += 0.55;
        }
        bodies[sign > 0 ? 0 : 1].parts.push_back(std::move(wedge));
    }
    return bodies;
}

// Story: two tetrapods pressed on each other filled a cell by more than its volume where they touched, and left some of
// a face of it open. It held the air that closed cells start with, had no equation, and the weight of its water drove
// the flow through the face at 70 m/s^2.
TEST(CutCells, a_cell_that_overlapping_bodies_fill_has_no_open_face_and_still_water_around_it_stays_still) {
    GridSettings settings = tank({1, 1, 1}, {10, 10, 10});
    settings.gravity = {0, 0, -9.81};
    settings.side[5].kind = SideKind::open;
    const CutBodies cut = cut_bodies(settings.mesh, wedges_that_overlap());
    const CellBox& box = settings.mesh.box;
    for_cells(box, [&](std::int64_t c, int i, int j, int k) {
        for (int a = 0; a < 3 && cut.open.volume[at(c)] == 0; ++a) {
            EXPECT_EQ(cut.open.area[at(a)][at(c)], 0) << i << j << k;
            EXPECT_EQ(cut.open.area[at(a)][at(c + box.stride[at(a)])], 0) << i << j << k;
        }
    });
    ASSERT_EQ(cut.open.volume[at(box.index(5, 5, 5))], 0);
    GridState state = make_state(settings, [](const Vec3& x) { return x.z < 0.85; });
    state.fraction[at(box.index(5, 5, 5))] = 0;  // nothing fills a closed cell
    GridScratch scratch;
    for (int i = 0; i < 10; ++i) {
        set_open_shares(settings, state, scratch, cut.open);
        advance(settings, state, scratch, 2e-3);
    }
    EXPECT_LT(largest_speed(settings, state, scratch), 1e-10);
}

TEST(CutCells, a_joint_that_opens_under_water_holds_water) {
    GridSettings settings = tank({1, 1, 0.1}, {20, 20, 1});
    settings.side[3].kind = SideKind::open;
    GridState state = make_state(settings, [](const Vec3& x) { return x.y < 0.85; });
    const double dt = 0.01, speed = 0.02;
    GridScratch scratch;
    for (int i = 0; i <= 60; ++i) {
        const std::vector<GridBody> bodies{block({0.3, 0.2, 0.1}, {0.5, 0.3, 0.05}),
                                           block({0.3, 0.2, 0.1}, {0.5, 0.5 + speed * dt * i, 0.05})};
        CutBodies cut = cut_bodies(settings.mesh, bodies);
        for (std::size_t c = 0; i == 0 && c < state.fraction.size(); ++c) {  // nothing fills a closed cell
            state.fraction[c] = cut.open.volume[c] > 0 ? state.fraction[c] : 0;
        }
        double least = 1;
        set_open_shares(settings, state, scratch, cut.open);
        advance(settings, state, scratch, dt);
        for_cells(settings.mesh.box, [&](std::int64_t c, int, int j, int) {
            least = std::min(least, j < 14 && cut.open.volume[at(c)] > 0 ? state.fraction[at(c)] : 1);
        });
        EXPECT_GT(least, 0.999) << "step " << i;
    }
}

}  // namespace
}  // namespace riprap::coupling
