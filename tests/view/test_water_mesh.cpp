// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "riprap/core/error.hpp"
#include "riprap/view/glb.hpp"
#include "riprap/view/water_mesh.hpp"

namespace riprap::view {
namespace {

constexpr double spacing = 0.05;

/// The particles of a box of water, off the lattice of the mesh.
std::vector<Vec3> box_of_water(int nx, int ny, int nz) {
    std::vector<Vec3> particles;
    for (int k = 0; k < nz; ++k) {
        for (int j = 0; j < ny; ++j) {
            for (int i = 0; i < nx; ++i) {
                particles.push_back(Vec3{0.0123, -0.4, 7.01} +
                                    spacing * Vec3{i + 0.5, j + 0.5, nz > 1 ? k + 0.5 : 0.0});
            }
        }
    }
    return particles;
}

/// The volume that the triangles enclose [m^3].
double volume_of(const WaterMesh& mesh) {
    const Vec3 middle = mesh.points.front();
    double volume = 0;
    for (const auto& t : mesh.triangles) {
        const auto at = [&](std::size_t k) { return mesh.points[static_cast<std::size_t>(t[k])] - middle; };
        volume += dot(at(0), cross(at(1), at(2))) / 6;
    }
    return volume;
}

TEST(WaterMesh, OfABoxIsClosedAndHasTheVolumeOfTheBox) {
    const auto particles = box_of_water(20, 16, 12);
    const WaterMesh mesh = mesh_water(particles, std::vector<float>(particles.size(), 1.5F), spacing, false);
    std::map<std::pair<int, int>, int> edges;  // each is met once in either direction
    for (const auto& t : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            ++edges[{t[k], t[(k + 1) % 3]}];
        }
    }
    for (const auto& [edge, count] : edges) {
        EXPECT_EQ(count, 1);
        EXPECT_EQ((edges.count({edge.second, edge.first})), 1U);
    }
    const double exact = 20 * 16 * 12 * spacing * spacing * spacing;
    EXPECT_NEAR(volume_of(mesh), exact, 0.04 * exact);  // corners are rounded
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
        EXPECT_NEAR(norm(mesh.normals[i]), 1, 1e-12);
        EXPECT_NEAR(mesh.speed[i], 1.5F, 1e-5F);
    }
}

TEST(WaterMesh, LiesOnTheFlatSurfaceHalfASpacingBeyondTheLastParticles) {
    const auto particles = box_of_water(20, 20, 12);
    const WaterMesh mesh = mesh_water(particles, {}, spacing, false);
    const double top = 7.01 + 12 * spacing, x = 0.0123 + 10 * spacing, y = -0.4 + 10 * spacing;
    int seen = 0;
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
        const Vec3& p = mesh.points[i];
        if (std::fabs(p.x - x) < 4 * spacing && std::fabs(p.y - y) < 4 * spacing && p.z > top - 6 * spacing) {
            ++seen;
            EXPECT_NEAR(p.z, top, 0.05 * spacing);
            EXPECT_GT(mesh.normals[i].z, 0.99);
        }
    }
    EXPECT_GT(seen, 40);
}

TEST(WaterMesh, OfAPlanarSceneFillsTheAreaOfTheWater) {
    const auto particles = box_of_water(30, 14, 1);
    const WaterMesh mesh = mesh_water(particles, {}, spacing, true);
    double area = 0;
    for (const auto& t : mesh.triangles) {
        const auto at = [&](std::size_t k) { return mesh.points[static_cast<std::size_t>(t[k])]; };
        const Vec3 twice = cross(at(1) - at(0), at(2) - at(0));
        EXPECT_GE(twice.z, 0);
        area += twice.z / 2;
    }
    const double exact = 30 * 14 * spacing * spacing;
    EXPECT_NEAR(area, exact, 0.02 * exact);
}

TEST(WaterMesh, OfParticlesFarApartIsRefusedBeforeTheMemoryIsTaken) {
    const std::vector<Vec3> particles{{0, 0, 0}, {1000, 1000, 1000}};
    EXPECT_THROW(mesh_water(particles, {}, spacing, false), FileError);
    EXPECT_TRUE(mesh_water({}, {}, spacing, false).triangles.empty());
}

TEST(Glb, HasANodeForEveryBodyAndAsManyBytesAsItSays) {
    DrawnShape shape;
    shape.corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    shape.faces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    std::vector<PlacedBody> bodies;
    for (const char* name : {"low", "high"}) {
        bodies.push_back({name, 0, &shape, 0, {1, 2, 3}, {1, 0, 0, 0}, true});
    }
    const auto particles = box_of_water(4, 4, 4);
    const std::string glb = glb_of(mesh_water(particles, {}, spacing, false), bodies, {0, 0, -9.81});
    const auto word = [&](std::size_t at) {
        std::uint32_t value = 0;
        std::memcpy(&value, glb.data() + at, sizeof value);
        return value;
    };
    ASSERT_EQ(glb.substr(0, 4), "glTF");
    EXPECT_EQ(word(8), glb.size());
    const auto json = nlohmann::json::parse(glb.substr(20, word(12)));
    ASSERT_EQ(json["nodes"].size(), 4U);  // water, two bodies, the scene
    EXPECT_EQ(json["nodes"][1]["name"], "low");
    EXPECT_EQ(json["nodes"][1]["mesh"], json["nodes"][2]["mesh"]);
    EXPECT_EQ(json["buffers"][0]["byteLength"], word(20 + word(12)));
    EXPECT_EQ(json["accessors"].back()["count"], 12);  // four triangles
}

}  // namespace
}  // namespace riprap::view
