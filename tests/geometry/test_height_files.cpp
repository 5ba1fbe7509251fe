// SPDX-License-Identifier: Apache-2.0
// Lists and grids of heights from other programs: read right, or refused with line and column.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "riprap/geometry/height_grid.hpp"
#include "riprap/geometry/mesh_facts.hpp"

namespace riprap::geometry {
namespace {

using testing::HasSubstr;

/// The problem with a list of points, empty where it is read.
std::string problem(const std::string& text) {
    try {
        read_xyz(text, "a.xyz", 1);
    } catch (const CaseError& error) {
        return to_string(error.problems().front());
    }
    return "";
}

/// Heights 10 + x/2 of n by n points 1 m apart; `odd` stands at (1, 1).
std::string plane(int n, const std::string& separator, const std::string& odd = "10.5", bool has_comma = false) {
    std::string text;
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            std::string z = std::to_string(10 + i / 2) + (i % 2 != 0 ? ".5" : ".0");
            z = i == 1 && j == 1 ? odd : z;
            if (const std::size_t point = z.find('.'); has_comma && point != std::string::npos) {
                z[point] = ',';
            }
            text += std::to_string(i) + separator + std::to_string(j) + separator + z + "\n";
        }
    }
    return text;
}

TEST(HeightFiles, decimal_commas_are_read_where_they_can_be_nothing_else) {
    const HeightGrid points = read_xyz(plane(4, " "), "a.xyz", 1);
    for (const std::string separator : {";", " ", "\t", " ; "}) {
        EXPECT_EQ(read_xyz(plane(4, separator, "10.5", true), "a.xyz", 1).z, points.z) << separator;
    }
    EXPECT_EQ(points.at(1, 2), 10.5);
    EXPECT_THAT(problem(plane(4, ",", "10.5", true)), HasSubstr("decimal commas?"));
}

TEST(HeightFiles, marks_for_no_height_are_refused_where_they_stand) {
    for (const std::string mark :
         {"-9999", "-9999.0", "-32768", "-3.40282e+38", "1e+30", "1.70141E+38", "9999", "-99999"}) {
        EXPECT_THAT(problem(plane(5, " ", mark)),
                    testing::AllOf(testing::StartsWith("a.xyz:7:5: a height of "), HasSubstr("a mark for no height?")))
            << mark;
    }
    EXPECT_EQ(problem(plane(5, " ", "-90")), "");  // a pit of ten times the relief
    // Heights in millimetres may well be 9999.
    EXPECT_EQ(read_xyz("0 0 9990\n1000 0 9999\n0 1000 9995\n1000 1000 9998\n", "mm.xyz", 1e-3).at(1, 0), 9.999);
    const std::string head = "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n";
    EXPECT_TRUE(
        std::isnan(read_esri_ascii(head + "NODATA_value -3.4028234663852886e+38\n1 2 3\n4 5 -3.40282e+38\n", "a.asc", 1)
                       .at(2, 0)));
    try {
        read_esri_ascii(head + "NODATA_value -9999\n1 2 3\n4 -32768 5\n", "a.asc", 1);
        FAIL();
    } catch (const CaseError& error) {
        EXPECT_THAT(to_string(error.problems()[0]), testing::StartsWith("a.asc:8:3: a height of -32768 m"));
        EXPECT_THAT(to_string(error.problems()[0]), HasSubstr("NODATA_value -32768 in the head"));
    }
}

TEST(HeightFiles, two_heights_at_one_place_are_refused_and_one_given_twice_is_not) {
    EXPECT_THAT(problem(plane(3, " ") + "1 1 11\n"),
                HasSubstr("a.xyz:10:5: the height of (1, 1) is 11 m here and 10.5 m in line 5"));
    EXPECT_EQ(problem(plane(3, " ") + "1 1 10.5\n"), "");
    EXPECT_THAT(problem("0 0 1\n1 0 1\n0.3 1 1\n1 1 1\n"), HasSubstr("a.xyz:3:1: point 3"));
}

TEST(HeightFiles, a_missing_point_takes_no_more_than_the_cells_around_it) {
    std::string text;  // at map coordinates, where x0 + i dx is rounded
    for (int j = 0; j < 7; ++j) {
        for (int i = 0; i < 7; ++i) {
            if (i != 3 || j != 3) {
                text += std::to_string(432150.1 + 0.3 * i) + " " + std::to_string(5103420.7 + 0.3 * j) + " 2\n";
            }
        }
    }
    const HeightGrid grid = cut_grid(read_xyz(text, "a.xyz", 1), {}, 0);
    EXPECT_EQ(std::count_if(grid.z.begin(), grid.z.end(), [](double z) { return std::isnan(z); }), 1);
    const TriangleMesh mesh = mesh_of(grid, {});
    EXPECT_EQ(mesh.size(), 2 * 36 - 4);
    const MeshFacts facts = facts_of(mesh, {0, 0, 1});
    EXPECT_EQ(facts.parts, 1);
    EXPECT_EQ(facts.holes, 1);
    EXPECT_NEAR(facts.steepest, 0, 1e-9);
}

TEST(HeightFiles, the_head_of_a_grid_is_known_whatever_the_name_of_the_file) {
    EXPECT_TRUE(
        is_esri_ascii("\xEF\xBB\xBF"
                      "NCOLS 3\nNROWS 2\n"));
    EXPECT_FALSE(is_esri_ascii("x y z\n0 0 1\n"));
    EXPECT_EQ(read_esri_ascii("\xEF\xBB\xBF"
                              "ncols 2\r\nnrows 2\r\nxllcorner 0\r\nyllcorner 0\r\ncellsize 1\r\n1 2\r\n3 4\r\n",
                              "b.asc", 1)
                  .at(0, 0),
              3);
}

TEST(MeshFacts, count_what_belongs_together) {
    TriangleMesh mesh;  // two squares apart, the first with one half missing
    mesh.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {5, 0, 0}, {6, 0, 0}, {6, 1, 0}, {5, 1, 0}};
    mesh.corners = {{0, 1, 2}, {3, 4, 5}, {3, 5, 6}};
    const MeshFacts facts = facts_of(mesh, {0, 0, 1});
    EXPECT_EQ(facts.parts, 2);
    EXPECT_EQ(facts.open_parts, 2);
    EXPECT_EQ(facts.holes, 0);
    EXPECT_NEAR(facts.steepest, M_PI / 4, 1e-12);
    EXPECT_EQ(facts.high.x, 6);
    EXPECT_FALSE(is_far(facts.low, facts.high));
    EXPECT_TRUE(is_far({5e6, 0, 0}, {5e6 + 100, 100, 10}));
}

}  // namespace
}  // namespace riprap::geometry
