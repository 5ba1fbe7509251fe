// SPDX-License-Identifier: Apache-2.0
// Lists and grids of heights from other programs: read right, or refused with line and column.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "riprap/geometry/ground/height_grid.hpp"
#include "riprap/geometry/surface/mesh_facts.hpp"

namespace riprap::geometry {
namespace {

using testing::AllOf;
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

TEST(HeightFiles, a_grid_that_ends_within_its_last_height_is_refused) {
    const std::string grid = "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n1.25 2.50 3.75\n4.25 5.50 ";
    const auto problem = [](const std::string& text) {
        try {
            read_esri_ascii(text, "a.asc", 1);
        } catch (const CaseError& error) {
            return to_string(error.problems()[0]);
        }
        return std::string();
    };
    EXPECT_THAT(problem(grid + "6.7"), HasSubstr("a.asc:7:11: the last height has fewer digits"));  // of 6.75
    EXPECT_EQ(problem(grid + "6.7\n"), "");
    EXPECT_EQ(problem(grid + "6.75"), "");
}

TEST(HeightFiles, marks_for_no_height_are_refused_where_they_stand) {
    for (const std::string mark :
         {"-9999", "-9999.0", "-32768", "-3.40282e+38", "1e+30", "1.70141E+38", "9999", "-99999"}) {
        EXPECT_THAT(problem(plane(5, " ", mark)),
                    testing::AllOf(testing::StartsWith("a.xyz:7:5: a height of "), HasSubstr("a mark for no height?")))
            << mark;
    }
    EXPECT_EQ(problem(plane(5, " ", "2")), "");  // a pit of four times the relief
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

/// Heights of n by n points `step` apart that rise by `rise` along x and half of it along y; `odd` stands at (2, 3).
std::string hill(int n, double step, double low, double rise, const std::string& odd) {
    std::string text;
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            const bool is_odd = i == 2 && j == 3;
            text += fmt::format("{} {} {}\n", step * i, step * j,
                                is_odd ? odd : fmt::format("{:.2f}", low + rise * i + 0.5 * rise * j));
        }
    }
    return text;
}

std::string problem_in(const std::string& text, double scale, const NoHeight& no_height = {}) {
    try {
        read_xyz(text, "a.xyz", scale, nullptr, no_height);
    } catch (const CaseError& error) {
        return to_string(error.problems().front());
    }
    return "";
}

TEST(HeightFiles, marks_for_no_height_are_found_in_relief_and_in_other_units) {
    // Gaps smaller than the relief, in metres, centimetres and millimetres.
    EXPECT_THAT(problem_in(hill(6, 10, 100, 200, "-999"), 1), HasSubstr("a.xyz:21:7: a height of -999 m"));
    EXPECT_THAT(problem_in(hill(6, 1000, 100000, 25000, "-9999"), 0.01),
                HasSubstr("a.xyz:21:11: a height of -99.99 m"));
    EXPECT_THAT(problem_in(hill(6, 1000, 100000, 25000, "-9999"), 0.001), HasSubstr("a height of -9.999 m"));
    EXPECT_THAT(problem_in(hill(6, 1, 2, 0.5, "-999.25"), 1), HasSubstr("a height of -999.25 m"));
    EXPECT_THAT(problem_in(hill(6, 30, 300, 80, "-99"), 1), HasSubstr("a height of -99 m"));
    // 0 and -1 among heights of hundreds of metres, and above a sea floor.
    EXPECT_THAT(problem_in(hill(6, 10, 400, 30, "0"), 1), AllOf(HasSubstr("a height of 0 m, 400 m below all others"),
                                                                HasSubstr("nodata = 0; nodata = \"none\"")));
    EXPECT_THAT(problem_in(hill(6, 10, 400, 30, "-1"), 1), HasSubstr("a height of -1 m"));
    EXPECT_THAT(problem_in(hill(6, 10, -600, 30, "0"), 1), HasSubstr("a height of 0 m, 375 m above all others"));
    // The mark above all others is told, not the ground that is below it.
    for (const std::string mark : {"1e30", "9999", "65535"}) {
        EXPECT_THAT(problem_in(hill(5, 1, 0.1, 0, mark), 1), HasSubstr("a.xyz:18:5:")) << mark;
    }
}

TEST(HeightFiles, pits_and_needles_of_one_point_are_refused_whatever_their_number) {
    for (const std::string number : {"0", "-1", "-5", "-10", "-20", "-100", "1", "300"}) {
        EXPECT_THAT(problem_in(hill(6, 1, 100, 0.5, number), 1), HasSubstr("a.xyz:21:5: a height of " + number + " m"));
        EXPECT_THAT(problem_in(hill(6, 1, 100, 0, number), 1), HasSubstr("a mark for no height?")) << number;
        EXPECT_EQ(problem_in(hill(6, 1, 100, 0.5, number), 1, {{}, true}), "") << number;
    }
    EXPECT_EQ(problem_in(hill(6, 1, 100, 0.5, "91"), 1), "");  // a well of less than ten intervals
    EXPECT_EQ(problem_in(hill(6, 1, 100, 20, "-50"), 1), "");  // in steep relief
    std::string trench;  // a bed of equal heights is no mark: its points are neighbours
    for (int j = 0; j < 6; ++j) {
        for (int i = 0; i < 6; ++i) {
            trench += fmt::format("{} {} {}\n", i, j, i == 2 ? -20 : 0.1 * i);
        }
    }
    EXPECT_EQ(problem_in(trench, 1), "");
}

TEST(HeightFiles, heights_that_look_like_marks_in_their_own_relief_are_read) {
    EXPECT_EQ(problem_in(hill(6, 1, 0.5, 0.5, "0"), 1), "");         // a lake or a shore
    EXPECT_EQ(problem_in(hill(6, 10, -40, 10, "0"), 1), "");         // from below the sea to above it
    EXPECT_EQ(problem_in(hill(6, 500, -1500, 100, "-999"), 1), "");  // a slope of the sea floor
    std::string quay;                                                // a bed at 0 and a quay of 5 m with a fall of 1 %
    for (int j = 0; j < 6; ++j) {
        for (int i = 0; i < 6; ++i) {
            quay += fmt::format("{} {} {}\n", 0.5 * i, 0.5 * j, i < 3 ? 0 : 5 + 0.005 * j);
        }
    }
    EXPECT_EQ(problem_in(quay, 1), "");
    EXPECT_EQ(problem_in(hill(6, 10, 400, 30, "0"), 1, {{}, true}), "");
    const HeightGrid grid = read_xyz(hill(6, 10, 400, 30, "0"), "a.xyz", 1, nullptr, {0, true});
    EXPECT_TRUE(std::isnan(grid.at(2, 3)));
}

TEST(HeightFiles, uneven_intervals_are_refused_and_scatter_of_coordinates_is_not) {
    const auto points = [](const std::vector<double>& x, const std::vector<double>& y, double scatter) {
        std::string text;
        for (std::size_t j = 0; j < y.size(); ++j) {
            for (std::size_t i = 0; i < x.size(); ++i) {
                text += fmt::format("{} {} 0.1\n", x[i] + scatter * static_cast<double>(i * j), y[j]);
            }
        }
        return text;
    };
    const std::vector<double> even{0, 1, 2, 3, 4};
    EXPECT_THAT(problem_in(points({0, 1, 4, 9, 16}, even, 0), 1),
                HasSubstr("a.xyz:3:1: no point between x = 1 and 4 m, where others are 1 m apart; even intervals"));
    EXPECT_THAT(problem_in(points(even, {0, 0.5, 1, 2, 3}, 0), 1),
                HasSubstr("a.xyz:16:3: no point between y = 1 and 2"));
    EXPECT_THAT(problem_in(points({0, 2, 4, 5, 6, 7}, even, 0), 1), HasSubstr("no point between x = 0 and 2"));
    for (const double scatter : {1e-4, -3e-4, 5e-4}) {  // rounding, up to 0.8 % of an interval
        const HeightGrid grid = read_xyz(points(even, even, scatter), "a.xyz", 1);
        EXPECT_EQ(grid.columns, 5) << scatter;
        EXPECT_EQ(std::count_if(grid.z.begin(), grid.z.end(), [](double z) { return std::isnan(z); }), 0);
    }
    const HeightGrid holes =
        read_xyz("0 0 1\n1 0 1\n2 0 -5\n0 1 1\n1 1 1\n2 1 -5\n0 2 1\n1 2 1\n2 2 1\n", "a.xyz", 1, nullptr, {-5, true});
    EXPECT_EQ(holes.columns, 3);
}

TEST(HeightFiles, a_grid_whose_lines_contradict_its_head_is_refused) {
    const auto grid = [](int columns, int rows, const std::string& more, const std::vector<int>& lines) {
        std::string text =
            fmt::format("ncols {}\nnrows {}\nxllcorner 0\nyllcorner 0\ncellsize 1\n{}", columns, rows, more);
        int value = 0;
        for (const int count : lines) {
            for (int k = 0; k < count; ++k) {
                text += fmt::format("{} ", 0.1 * (++value % 7));
            }
            text += "\n";
        }
        try {
            read_esri_ascii(text, "a.asc", 1);
        } catch (const CaseError& error) {
            return to_string(error.problems().front());
        }
        return std::string();
    };
    EXPECT_THAT(
        grid(6, 4, "", {4, 4, 4, 4, 4, 4}),
        HasSubstr("a.asc:6:1: a line of 4 heights, where ncols is 6 and nrows 4; a row in each line: ncols 4 and "
                  "nrows 6?"));
    EXPECT_THAT(grid(8, 4, "", {4, 4, 4, 4, 4, 4, 4, 4}), HasSubstr("ncols 4 and nrows 8?"));
    EXPECT_THAT(grid(4, 8, "", {8, 8, 8, 8}), HasSubstr("ncols 8 and nrows 4?"));
    EXPECT_THAT(grid(5, 5, "", {4, 6, 5, 5, 5}), HasSubstr("a.asc:6:1: a line of 4 heights"));
    EXPECT_THAT(grid(5, 3, "", {5, 5, 3, 2}), HasSubstr("a.asc:8:1: a line of 3 heights"));
    for (const std::vector<int>& lines :
         {std::vector<int>{6, 6, 6, 6}, {24}, std::vector<int>(24, 1), {4, 2, 4, 2, 4, 2, 4, 2}}) {
        EXPECT_EQ(grid(6, 4, "", lines), "") << lines.size();
    }
    EXPECT_THAT(grid(3, 2, "cellsize 2\n", {3, 3}),
                HasSubstr("a.asc:6:1: \"cellsize\" says otherwise than a line above"));
    EXPECT_THAT(grid(3, 2, "dx 2\n", {3, 3}), HasSubstr("\"dx\" says otherwise"));
    EXPECT_THAT(grid(3, 2, "xllcenter 0\n", {3, 3}), HasSubstr("\"xllcenter\" says otherwise"));
    EXPECT_EQ(grid(3, 2, "cellsize 1\nNODATA_value -9999\n", {3, 3}), "");
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

TEST(EsriGrids, NameTheNumberOfTheHeadThatMakesNoGridAndTakeNanAsAMark) {
    const auto problem = [](const std::string& text) {
        try {
            read_esri_ascii(text, "a.asc", 1);
        } catch (const CaseError& error) {
            return to_string(error.problems().front());
        }
        return std::string();
    };
    const std::string rest = "xllcorner 0\nyllcorner 0\n", heights = "1 2\n3 4\n";
    EXPECT_THAT(problem("ncols 2\nnrows -2\n" + rest + "cellsize 1\n" + heights),
                HasSubstr("a.asc:2:7: nrows is \"-2\""));
    EXPECT_THAT(problem("ncols 2\nnrows 2\n" + rest + "cellsize -1\n" + heights),
                HasSubstr("a.asc:5:10: cellsize is \"-1\"; a number above 0"));
    EXPECT_THAT(problem("ncols 2\nnrows 2\nyllcorner 0\n" + heights),
                HasSubstr("a.asc:4:1: the head of the grid ends without xllcorner, cellsize"));
    const std::string head = "ncols 2\nnrows 2\n" + rest + "cellsize 1\n";
    EXPECT_THAT(problem(head + "1 nan\n3 4\n"), HasSubstr("a.asc:6:3: a height is \"nan\""));
    const HeightGrid grid = read_esri_ascii(head + "NODATA_value nan\n1 NaN\n3 4\n", "a.asc", 1);
    EXPECT_TRUE(std::isnan(grid.at(1, 1)));
    EXPECT_EQ(grid.at(0, 1), 1);
}

}  // namespace
}  // namespace riprap::geometry
