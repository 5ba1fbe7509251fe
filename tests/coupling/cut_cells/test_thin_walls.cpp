// SPDX-License-Identifier: Apache-2.0
// Walls thinner than a cell.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "riprap/coupling/cut_cells/cut_bodies.hpp"
#include "riprap/coupling/cut_cells/cut_loads.hpp"
#include "riprap/fluid/grid/grid_step.hpp"
#include "riprap/fluid/grid/pressure.hpp"
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

/// Cells that open faces join to the cell at a place.
std::vector<std::uint8_t> reached_from(const Mesh& mesh, const CutBodies& cut, const Vec3& from) {
    const CellBox& box = mesh.box;
    std::vector<std::uint8_t> is_reached(at(box.size));
    std::vector<std::int64_t> cells{
        box.index(mesh.cell_at(0, from.x), mesh.cell_at(1, from.y), mesh.cell_at(2, from.z))};
    is_reached[at(cells.front())] = 1;
    for (std::size_t next = 0; next < cells.size(); ++next) {
        for (int a = 0; a < box.axes; ++a) {
            const std::int64_t c = cells[next], t = box.stride[at(a)];
            for (const auto& [beside, face] : {std::pair{c - t, c}, std::pair{c + t, c + t}}) {
                if (cut.open.area[at(a)][at(face)] > 0 && box.has_cell(beside) && cut.open.volume[at(beside)] > 0 &&
                    is_reached[at(beside)] == 0) {
                    is_reached[at(beside)] = 1;
                    cells.push_back(beside);
                }
            }
        }
    }
    return is_reached;
}

bool leads(const Mesh& mesh, const CutBodies& cut, const Vec3& from, const Vec3& to) {
    const auto cell = mesh.box.index(mesh.cell_at(0, to.x), mesh.cell_at(1, to.y), mesh.cell_at(2, to.z));
    return reached_from(mesh, cut, from)[at(cell)] != 0;
}

/// Thickness of walls over the width of a cell: far thinner, as thick, and thicker than any way through a cell.
constexpr std::array<double, 7> thickness{1e-3, 0.1, 0.3, 0.49, 0.9, 1.3, 2.0};

// Story: a cell that an oblique wall thinner than half a cell cut in two held the water of both sides: 0.49 of 0.5 m^2
// went through.
TEST(ThinWalls, leave_no_way_through_at_any_angle_thickness_and_place) {
    const GridSettings settings = tank({1, 1, 1}, {10, 10, 1});
    for (const double share : thickness) {
        for (int i = 0; i < 40; ++i) {
            const double angle = 0.08 * i, shift = 0.1 * std::fmod(0.37 * i, 1.0);
            const Vec3 across{-std::sin(angle), std::cos(angle), 0}, centre = Vec3{0.5, 0.5, 0.5} + shift * across;
            const CutBodies cut =
                cut_bodies(settings.mesh, {block({4, 0.1 * share, 1}, centre, turned(angle, {0, 0, 1}))});
            EXPECT_FALSE(leads(settings.mesh, cut, centre - 0.35 * across, centre + 0.35 * across))
                << share << " cells, " << angle << " rad, " << shift << " m";
        }
    }
}

TEST(ThinWalls, leave_no_way_through_in_space) {
    const GridSettings settings = tank({1, 1, 1}, {8, 8, 8});
    for (const double share : thickness) {
        for (int i = 0; i < 12; ++i) {
            const Quat turn = turned(0.3 * i, {1.0, 2.0 - 0.3 * i, 0.2 * i});
            const Vec3 across = rotate(turn, {0, 0, 1}), centre = Vec3{0.5, 0.5, 0.5} + 0.01 * i * across;
            const CutBodies cut = cut_bodies(settings.mesh, {block({4, 4, 0.125 * share}, centre, turn)});
            EXPECT_FALSE(leads(settings.mesh, cut, centre - 0.35 * across, centre + 0.35 * across))
                << share << " cells, turn " << i;
        }
    }
}

/// A wall of two plates that meet under an angle at the middle of the domain, and end in each other.
GridBody bent_wall(double wall, double first, double second) {
    GridBody body =
        block({2, wall, 1}, {0.47 - std::cos(first), 0.52 - std::sin(first), 0.5}, turned(first, {0, 0, 1}));
    body.parts.push_back(
        block({2 + wall, wall, 1},
              {0.47 + (1 - 0.5 * wall) * std::cos(second), 0.52 + (1 - 0.5 * wall) * std::sin(second), 0.5},
              turned(second, {0, 0, 1}))
            .parts.front());
    return body;
}

TEST(ThinWalls, leave_no_way_through_where_two_plates_meet) {
    const GridSettings settings = tank({1, 1, 1}, {11, 11, 1});
    for (const double wall : {0.004, 0.02, 0.04}) {
        for (const double bend : {0.2, 0.6, 1.0, 1.5}) {
            const CutBodies cut = cut_bodies(settings.mesh, {bent_wall(wall, 0.1, 0.1 + bend)});
            EXPECT_FALSE(leads(settings.mesh, cut, {0.85, 0.1, 0.5}, {0.1, 0.9, 0.5})) << wall << " " << bend;
        }
    }
}

TEST(ThinWalls, that_end_in_the_water_leave_the_way_around_their_end_open) {
    const GridSettings settings = tank({1, 1, 1}, {10, 10, 1});
    for (const double share : thickness) {
        const CutBodies cut =
            cut_bodies(settings.mesh, {block({1.0, 0.1 * share, 1}, {0.2, 0.43, 0.5}, turned(0.3, {0, 0, 1}))});
        EXPECT_TRUE(leads(settings.mesh, cut, {0.1, 0.9, 0.5}, {0.1, 0.05, 0.5})) << share;
    }
}

TEST(ThinWalls, are_lifted_by_still_water_with_its_weight_and_leave_it_still) {
    for (const double angle : {0.0, 0.4, 0.785, 1.3}) {
        GridSettings settings = tank({1, 1, 0.1}, {20, 20, 1});
        settings.side[3].kind = SideKind::open;
        const std::vector<GridBody> bodies{block({0.5, 0.01, 0.1}, {0.512, 0.4, 0.05}, turned(angle, {0, 0, 1}))};
        const CutBodies cut = cut_bodies(settings.mesh, bodies);
        GridState state = make_state(settings, [](const Vec3& x) { return x.y < 0.75; });
        GridScratch scratch;
        for (int i = 0; i < 20; ++i) {
            set_open_shares(settings, state, scratch, cut.open);
            advance(settings, state, scratch, stable_step(settings, state, scratch));
        }
        const GridLoad load = cut_loads(settings, state, scratch, bodies, cut)[0];
        const double weight = 1000 * 9.81 * 0.5 * 0.01 * 0.1;
        EXPECT_NEAR(load.force().y / weight, 1, 1e-6) << angle;
        EXPECT_NEAR(load.force().x / weight, 0, 1e-6) << angle;
        EXPECT_LT(largest_divergence(settings, state, scratch), 1e-9) << angle;
    }
}

/// Share of water left of an oblique wall that is right of it after half a second. At the start it is a cell away from
/// the wall: a cell that the wall splits belongs to one of its sides.
double share_through(double share, double angle) {
    GridSettings settings = tank({1, 1, 0.1}, {20, 20, 1});
    settings.side[3].kind = SideKind::open;
    const Vec3 across{std::cos(angle), std::sin(angle), 0};
    const auto ahead = [&](const Vec3& x) { return dot(x - Vec3{0.513, 0.3, 0.05}, across); };
    const std::vector<GridBody> bodies{block({0.05 * share, 4, 0.1}, {0.513, 0.3, 0.05}, turned(angle, {0, 0, 1}))};
    const CutBodies cut = cut_bodies(settings.mesh, bodies);
    GridState state = make_state(settings, [&](const Vec3& x) { return ahead(x) < -0.06 && x.y < 0.5; });
    GridScratch scratch;
    while (state.time < 0.5) {
        set_open_shares(settings, state, scratch, cut.open);
        advance(settings, state, scratch, stable_step(settings, state, scratch));
    }
    double through = 0;
    for_cells(settings.mesh.box, [&](std::int64_t c, int i, int j, int k) {
        through +=
            ahead(settings.mesh.centre(i, j, k)) > 0.05 ? state.fraction[at(c)] * scratch.room.capacity[at(c)] : 0;
    });
    return through / water_volume(settings, state, scratch);
}

TEST(ThinWalls, hold_the_water_on_one_of_their_sides) {
    for (const double share : {0.1, 0.49, 0.8}) {
        for (const double angle : {0.0, 0.3, 0.7, -0.5}) {
            EXPECT_LT(share_through(share, angle), 0.01) << share << " cells, " << angle << " rad";
        }
    }
}

TEST(ThinWalls, that_move_across_the_cells_take_the_water_along) {
    // A plate of a fifth of a cell pushes water that fills a tank left of it: the level rises as the room shrinks.
    GridSettings settings = tank({1, 0.8, 0.1}, {20, 16, 1});
    settings.side[3].kind = SideKind::open;
    GridState state = make_state(settings, [](const Vec3& x) { return x.x < 0.8 && x.y < 0.3; });
    GridScratch scratch;
    const double dt = 0.005, speed = 0.1;
    double x = 0.8, held = 0;
    for (int i = 0; i < 400; ++i) {
        x -= speed * dt;
        GridBody plate = block({0.01, 2, 0.1}, {x, 0.5, 0.05});
        plate.velocity = {-speed, 0, 0};
        set_open_shares(settings, state, scratch, cut_bodies(settings.mesh, {plate}).open);
        held = i == 0 ? state.water.held : held;
        advance(settings, state, scratch, dt);
    }
    double through = 0;
    for_cells(settings.mesh.box, [&](std::int64_t c, int i, int j, int k) {
        through +=
            settings.mesh.centre(i, j, k).x > x + 0.05 ? state.fraction[at(c)] * scratch.room.capacity[at(c)] : 0;
    });
    EXPECT_LT(through / held, 0.01);
    EXPECT_NEAR(water_volume(settings, state, scratch) / held, 1, 1e-9);
}

}  // namespace
}  // namespace riprap::coupling
