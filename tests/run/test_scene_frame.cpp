// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "io/temporary_folder.hpp"
#include "io/vtk_reader.hpp"
#include "riprap/io/atomic_file.hpp"
#include "riprap/io/scene_frame.hpp"
#include "riprap/sim/advance.hpp"
#include "run/falling_blocks.hpp"

namespace riprap::io {
namespace {

using ::testing::HasSubstr;

/// Volume inside the closed surface of one body as drawn, from its polygons: sum of tetrahedra from the origin.
double drawn_volume(const PolyData& data, const std::vector<std::int32_t>& body_of_cell, std::int32_t body) {
    double volume = 0;
    std::int32_t begin = 0;
    for (std::size_t cell = 0; cell < data.offsets.size(); ++cell) {
        const std::int32_t end = data.offsets[cell];
        const auto point = [&](std::int32_t k) {
            return data.points[static_cast<std::size_t>(data.connectivity[static_cast<std::size_t>(k)])];
        };
        for (std::int32_t k = begin + 1; body_of_cell[cell] == body && k + 1 < end; ++k) {
            volume += dot(point(begin), cross(point(k), point(k + 1))) / 6;
        }
        begin = end;
    }
    return volume;
}

TEST(SceneFrame, EveryBodyIsDrawnAsItsClosedOutwardSurface) {
    const scene::LoadedCase loaded = falling_blocks();
    const auto planes = draw_planes(loaded.model, loaded.state);
    const PolyData data = draw_bodies(loaded.model, loaded.state, loaded.state, planes, {});
    const auto body = vtk_reader::array<std::int32_t>(data.cell_arrays, "body");
    ASSERT_EQ(body.size(), data.offsets.size());
    EXPECT_EQ(body.size(), 1U + 3 * 6);
    EXPECT_NEAR(drawn_volume(data, body, 1), 0.5, 1e-12);
    EXPECT_NEAR(drawn_volume(data, body, 2), 0.6 * 0.7 * 0.5, 1e-12);
}

TEST(SceneFrame, AHalfSpaceIsDrawnAsASquareOfItsPlaneBelowTheWholeScene) {
    const scene::LoadedCase loaded = falling_blocks();
    const PolyData data =
        draw_bodies(loaded.model, loaded.state, loaded.state, draw_planes(loaded.model, loaded.state), {});
    double low = 1e9, high = -1e9;
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(data.points[i].z, 0, 1e-12);
        low = std::min(low, data.points[i].x);
        high = std::max(high, data.points[i].x);
    }
    EXPECT_LT(low, -2.5);  // the lone block sits at x = -2
    EXPECT_GT(high, 0.6);
    const Vec3 normal = cross(data.points[1] - data.points[0], data.points[2] - data.points[1]);
    EXPECT_GT(normal.z, 0);
}

TEST(SceneFrame, CellArraysSayWhatEachBodyDoes) {
    const scene::LoadedCase loaded = falling_blocks();
    sim::State moved = loaded.state;
    moved.bodies.position[2] = moved.bodies.position[2] + Vec3{3, 0, 4};
    const std::vector<Vec3> force(4, Vec3{0, 0, 7});
    const PolyData data =
        draw_bodies(loaded.model, loaded.state, moved, draw_planes(loaded.model, loaded.state), force);
    const auto distance = vtk_reader::array<float>(data.cell_arrays, "distance");
    const auto is_free = vtk_reader::array<std::int32_t>(data.cell_arrays, "is_free");
    const auto contact_force = vtk_reader::array<float>(data.cell_arrays, "contact_force");
    EXPECT_EQ(distance[1 + 6], 5.0F);
    EXPECT_EQ(distance[1], 0.0F);
    EXPECT_EQ(is_free[0], 0);
    EXPECT_EQ(is_free[1], 1);
    EXPECT_EQ(contact_force[3 * 4 + 2], 7.0F);
}

TEST(SceneFrame, TheBodiesTableNamesEveryBody) {
    const TemporaryFolder folder;
    const scene::LoadedCase loaded = falling_blocks();
    write_bodies_csv(folder / "bodies.csv", loaded.model, loaded.state, loaded.state, {});
    const std::string text = read_file(folder / "bodies.csv", 1U << 20U);
    EXPECT_THAT(text, HasSubstr("time [s],body [-],name [-],mass [kg],position.x [m]"));
    EXPECT_THAT(text, HasSubstr("\n0,2,high,"));
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 5);
    // As many fields in a row as in the heading.
    const std::string row = text.substr(text.rfind('\n', text.size() - 2) + 1);
    EXPECT_EQ(std::count(row.begin(), row.end(), ','), 26);
}

}  // namespace
}  // namespace riprap::io
