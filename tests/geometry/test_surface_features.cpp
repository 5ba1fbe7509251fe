// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "riprap/geometry/surface/surface_features.hpp"

namespace riprap::geometry {
namespace {

/// A sheet over [0, 2] x [0, 2] of eight triangles, its middle line lifted by `lift`.
TriangleMesh sheet(double lift) {
    TriangleMesh mesh;
    for (int j = 0; j < 3; ++j) {
        for (int i = 0; i < 3; ++i) {
            mesh.points.push_back({1.0 * i, 1.0 * j, i == 1 ? lift : 0});
        }
    }
    for (int j = 0; j < 2; ++j) {
        for (int i = 0; i < 2; ++i) {
            const int a = 3 * j + i;
            mesh.corners.push_back({a, a + 1, a + 4});
            mesh.corners.push_back({a, a + 4, a + 3});
        }
    }
    return mesh;
}

const SurfaceEdge& edge_between(const SurfaceFeatures& features, std::int32_t p, std::int32_t q) {
    for (const std::int32_t e : features.fan(p)) {
        const SurfaceEdge& edge = features.edge(e);
        if (edge.from == q || edge.to == q) {
            return edge;
        }
    }
    throw std::logic_error("no such edge");
}

TEST(SurfaceFeatures, KindsOfEdgesFollowTheTurnOfTheSurface) {
    for (const auto& [lift, kind] : {std::pair{0.3, EdgeKind::ridge}, std::pair{-0.3, EdgeKind::cleft},
                                     std::pair{-0.01, EdgeKind::valley}, std::pair{0.0, EdgeKind::flat}}) {
        const SurfaceFeatures features(sheet(lift));
        EXPECT_EQ(edge_between(features, 1, 4).kind, kind) << lift;
        EXPECT_EQ(edge_between(features, 0, 4).kind, EdgeKind::flat) << lift;
        EXPECT_EQ(edge_between(features, 0, 1).kind, EdgeKind::ridge) << lift;  // the rim
        EXPECT_EQ(features.is_sharp(4), lift > 0) << lift;
    }
}

TEST(SurfaceFeatures, CellsDivideThePlacesOverAPlaneAndOverARidge) {
    for (const double lift : {0.0, 0.3}) {
        const TriangleMesh mesh = sheet(lift);
        const SurfaceFeatures features(mesh);
        for (int i = 0; i < 400; ++i) {  // through many places, walls among them
            const double along = 0.05 * (i % 20) + 0.5;
            const Vec3 x{along, 0.05 * (i / 20) + 0.5, lift * (1 - std::abs(along - 1)) - 1e-3};  // a little below
            int cells = 0;
            for (std::int32_t t = 0; t < features.triangle_count(); ++t) {
                cells += features.is_in_cell(mesh, t, x) ? 1 : 0;
            }
            const bool is_on_point = std::abs(x.x - 1) < 1e-9 && std::abs(x.y - 1) < 1e-9;
            EXPECT_TRUE(cells == 1 || is_on_point) << x.x << ' ' << x.y << ' ' << cells;
        }
    }
}

TEST(SurfaceFeatures, BelowARidgeAPlaceBelongsToTheTriangleThatIsLessDeep) {
    const TriangleMesh mesh = sheet(0.3);
    const SurfaceFeatures features(mesh);
    const Vec3 x{0.97, 0.4, 0.2};
    for (std::int32_t t = 0; t < features.triangle_count(); ++t) {
        if (features.is_in_cell(mesh, t, x)) {
            EXPECT_LT(features.normal(t).x, 0);  // the left slope
        }
    }
}

}  // namespace
}  // namespace riprap::geometry
