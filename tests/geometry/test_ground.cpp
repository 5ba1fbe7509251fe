// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "riprap/core/error.hpp"
#include "riprap/geometry/ground/ground_cells.hpp"
#include "riprap/geometry/ground/height_grid.hpp"
#include "riprap/geometry/ground/triangle_field.hpp"
#include "riprap/geometry/polyhedra/convex_query.hpp"
#include "riprap/geometry/polyhedra/shape_set.hpp"
#include "riprap/geometry/surface/triangle.hpp"

namespace riprap::geometry {
namespace {

TriangleMesh bumpy(std::int64_t n) {
    HeightGrid grid{n, n, 0, 0, 0.5, 0.5, {}};
    for (std::int64_t j = 0; j < n; ++j) {
        for (std::int64_t i = 0; i < n; ++i) {
            grid.z.push_back(0.3 * std::sin(1.7 * static_cast<double>(i)) +
                             0.2 * std::cos(2.3 * static_cast<double>(j)));
        }
    }
    return mesh_of(grid, {});
}

/// Unit cube as twelve triangles, wound outward.
TriangleMesh cube() {
    TriangleMesh mesh;
    for (int k = 0; k < 8; ++k) {
        mesh.points.push_back(
            {static_cast<double>(k & 1), static_cast<double>(k >> 1 & 1), static_cast<double>(k >> 2)});
    }
    const std::array<std::array<std::int32_t, 4>, 6> faces{
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
    for (const auto& f : faces) {
        mesh.corners.push_back({f[0], f[1], f[2]});
        mesh.corners.push_back({f[0], f[2], f[3]});
    }
    return mesh;
}

double potential(const ShapeSet& shapes, ShapeId id, const Vec3& centroid, const Vec3& x) {
    const ConvexView view = shapes.view(id);
    for (int f = 0; f < view.face_count; ++f) {
        if (view.is_internal[f] == 0) {
            return (view.offset[f] - dot(view.normal(f), x - centroid)) / view.inscribed_radius;
        }
    }
    return -1;
}

TEST(GroundCells, fill_the_layer_under_the_heights_without_gap_or_overlap) {
    const TriangleMesh mesh = bumpy(7);
    double volume = 0;
    for (const Polyhedron& cell : cells_under(mesh, 0.8, Vec3{0, 0, -1})) {
        volume += mass_properties(cell).volume;
    }
    EXPECT_NEAR(volume, 3.0 * 3.0 * 0.8, 1e-12);
}

TEST(GroundCells, have_a_potential_that_is_the_depth_over_the_thickness_in_every_cell) {
    const TriangleMesh mesh = bumpy(5);
    const auto cells = cells_under(mesh, 0.8, Vec3{0, 0, -1});
    ShapeSet shapes;
    for (std::size_t t = 0; t < cells.size(); ++t) {
        Vec3 centroid{};
        const ShapeId id = shapes.add_convex(cells[t], false, &centroid);
        const Vec3 corner = mesh.corner(static_cast<std::int32_t>(t), 1);
        EXPECT_NEAR(potential(shapes, id, centroid, corner - Vec3{0, 0, 0.2}), 0.25, 1e-9);
    }
}

TEST(GroundCells, between_bisectors_have_equal_depth_on_both_sides_of_a_wall) {
    const auto cells = cells_under(cube(), 0.1, std::nullopt);
    ASSERT_EQ(cells.size(), 12U);
    ShapeSet shapes;
    double volume = 0;
    for (const Polyhedron& cell : cells) {
        volume += mass_properties(cell).volume;
        Vec3 centroid{};
        const ShapeId id = shapes.add_convex(cell, false, &centroid);
        EXPECT_NEAR(shapes.view(id).inscribed_radius, 0.1, 1e-9);
        // The middle of an edge of the cube, a little inside along the bisector, is as deep below either face.
        const Vec3 below{0.5, 0.03, 0.03};
        if (contains(shapes.view(id), below - centroid, 1e-12)) {
            EXPECT_NEAR(potential(shapes, id, centroid, below), 0.3, 1e-9);
        }
    }
    EXPECT_NEAR(volume, 1 - 0.8 * 0.8 * 0.8, 1e-9);  // the skin of a cube has no gaps and no overlaps
}

TEST(HeightGrid, reads_what_an_esri_file_says_from_north_to_south) {
    const HeightGrid grid = read_esri_ascii(
        "ncols 3\nnrows 2\nxllcorner 10\nyllcorner 20\ncellsize 2\nNODATA_value -9999\n1 2 3\n4 5 -9999\n", "a.asc", 1);
    EXPECT_EQ(grid.columns, 3);
    EXPECT_DOUBLE_EQ(grid.x0, 11);
    EXPECT_DOUBLE_EQ(grid.y0, 21);
    EXPECT_DOUBLE_EQ(grid.at(0, 0), 4);
    EXPECT_DOUBLE_EQ(grid.at(2, 1), 3);
    EXPECT_TRUE(std::isnan(grid.at(2, 0)));
    EXPECT_EQ(mesh_of(grid, {}).size(), 3);  // one triangle is without its corner
}

TEST(HeightGrid, refuses_what_is_not_a_grid_and_says_where) {
    try {
        read_esri_ascii("ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2\n3 x\n", "b.asc", 1);
        FAIL();
    } catch (const CaseError& error) {
        EXPECT_EQ(error.problems()[0].place.line, 7U);
        EXPECT_EQ(error.problems()[0].place.column, 3U);
    }
    EXPECT_THROW(read_esri_ascii("ncols 2\nnrows 2\n1 2 3 4", "c.asc", 1), CaseError);
    EXPECT_THROW(read_xyz("0 0 1\n1 0 1\n0.3 1 1\n1 1 1\n", "d.xyz", 1), CaseError);
}

TEST(HeightGrid, of_points_in_any_order_is_that_of_the_same_heights) {
    const HeightGrid grid = read_xyz("x,y,z\n1,0,2\n0,0,1\n0,2,3\n1,2,4\n", "e.csv", 0.5);
    EXPECT_DOUBLE_EQ(grid.dy, 1);
    EXPECT_DOUBLE_EQ(grid.at(1, 0), 1);
    EXPECT_DOUBLE_EQ(grid.height(0.25, 0.5), 0.5 * (0.5 * (1 + 2) + 0.5 * (3 + 4)) / 2);
}

TEST(HeightGrid, cut_to_a_region_and_finer_lies_on_the_same_bilinear_surface) {
    const HeightGrid grid = read_xyz("0 0 0\n4 0 8\n0 4 4\n4 4 12\n", "f.xyz", 1);  // z = 2 x + y
    const HeightGrid cut = cut_grid(grid, {1, 0.5, 3, 2}, 0.5);
    EXPECT_EQ(cut.columns, 5);
    EXPECT_EQ(cut.rows, 4);
    EXPECT_DOUBLE_EQ(cut.at(4, 3), 2 * 3 + 2);
    EXPECT_TRUE(cut_grid(grid, {10, 10, 12, 12}, 0).z.empty());
}

TEST(TriangleField, knows_inside_from_outside_of_open_and_of_closed_surfaces) {
    const TriangleField bed(bumpy(9), {0, 0, 1});
    EXPECT_TRUE(bed.is_inside({1.3, 2.2, -5}));
    EXPECT_FALSE(bed.is_inside({1.3, 2.2, 5}));
    EXPECT_FALSE(bed.is_inside({-1, 2, -5}));
    const TriangleField box(cube(), {0, 0, 1});
    EXPECT_TRUE(box.is_inside({0.5, 0.5, 0.5}));
    EXPECT_FALSE(box.is_inside({0.5, 0.5, -0.5}));
    EXPECT_FALSE(box.is_inside({0.5, 0.5, 1.5}));
    const auto near = box.nearest({0.5, 0.4, 0.9}, 0.3);
    ASSERT_TRUE(near);
    EXPECT_NEAR(near->distance, -0.1, 1e-12);
    EXPECT_NEAR(near->normal.z, 1, 1e-12);
    EXPECT_FALSE(box.nearest({0.5, 0.5, 1.5}, 0.3));
}

TEST(TriangleField, finds_the_nearest_of_all_triangles) {
    const TriangleMesh mesh = bumpy(9);
    const TriangleField field(mesh, {0, 0, 1});
    for (int i = 0; i < 200; ++i) {
        const Vec3 x{std::fmod(0.37 * i, 4.0), std::fmod(0.59 * i, 4.0), std::fmod(0.11 * i, 1.0) - 0.5};
        double least = std::numeric_limits<double>::infinity();
        for (std::int32_t t = 0; t < mesh.size(); ++t) {
            least = std::min(
                least, norm(nearest_on_triangle(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2), x).point - x));
        }
        const auto near = field.nearest(x, 2);
        ASSERT_TRUE(near);
        EXPECT_DOUBLE_EQ(std::abs(near->distance), least);
    }
}

}  // namespace
}  // namespace riprap::geometry
