// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "riprap/geometry/planar/convex_pieces.hpp"

namespace riprap::geometry {
namespace {

double total_area(const std::vector<Polygon>& pieces) {
    double area = 0;
    for (const Polygon& piece : pieces) {
        area += moments_of(piece).area;
    }
    return area;
}

bool is_convex(const Polygon& p) {
    for (std::size_t k = 0; k < p.size(); ++k) {
        if (cross(p[(k + 1) % p.size()] - p[k], p[(k + 2) % p.size()] - p[(k + 1) % p.size()]) <= 0) {
            return false;
        }
    }
    return true;
}

TEST(ConvexPieces, AConvexPolygonIsItsOnlyPiece) {
    const Polygon hexagon{{2, 0}, {1, 1.7}, {-1, 1.7}, {-2, 0}, {-1, -1.7}, {1, -1.7}};
    const auto pieces = convex_pieces(hexagon);
    ASSERT_EQ(pieces.size(), 1u);
    EXPECT_EQ(pieces[0].size(), 6u);
}

TEST(ConvexPieces, PiecesAreConvexAndFillThePolygonWithoutNewCorners) {
    const Polygon comb{{0, 0}, {7, 0}, {7, 3}, {6, 3}, {6, 1}, {5, 1}, {5, 3}, {3, 3}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};
    Polygon star;
    for (int k = 0; k < 10; ++k) {
        const double r = k % 2 == 0 ? 2 : 0.7, angle = 0.3 + k * M_PI / 5;
        star.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
    for (const Polygon& polygon : {comb, star}) {
        const auto pieces = convex_pieces(polygon);
        EXPECT_LT(pieces.size(), polygon.size() - 2);  // fewer than triangles
        EXPECT_NEAR(total_area(pieces), moments_of(polygon).area, 1e-13);
        for (const Polygon& piece : pieces) {
            EXPECT_TRUE(is_convex(piece));
            for (const Vec2& x : piece) {
                EXPECT_NE(std::find(polygon.begin(), polygon.end(), x), polygon.end());
            }
        }
    }
}

TEST(ConvexPieces, APolygonThatRunsClockwiseHasNone) {
    EXPECT_TRUE(convex_pieces({{0, 0}, {0, 1}, {1, 1}, {1, 0}}).empty());
}

}  // namespace
}  // namespace riprap::geometry
