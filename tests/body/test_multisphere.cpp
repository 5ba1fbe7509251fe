// SPDX-License-Identifier: Apache-2.0
#include "riprap/body/multisphere.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "riprap/geometry/polyhedra/shapes.hpp"

namespace riprap::body {
namespace {

TEST(Multisphere, TheUnionOfOverlappingSpheresHasTheVolumeCentreAndInertiaOfMonteCarlo) {
    const std::vector<ShapeSphere> clump{{{0, 0, 0}, 1, {}}, {{0.8, 0.1, 0}, 0.7, {}}, {{0.2, -0.6, 0.5}, 0.8, {}}};
    const geometry::MassProperties exact = union_of_spheres(clump);
    std::mt19937_64 bits(7);
    std::uniform_real_distribution<double> unit(-1.6, 1.6);
    double count = 0;
    Vec3 first{};
    Vec3 square{};
    const int samples = 1'000'000;
    for (int k = 0; k < samples; ++k) {
        const Vec3 x{unit(bits), unit(bits), unit(bits)};
        if (std::ranges::any_of(clump, [&](const ShapeSphere& s) { return norm(x - s.centre) < s.radius; })) {
            count += 1;
            first += x;
            const Vec3 d = x - exact.centroid;
            square += Vec3{d.x * d.x, d.y * d.y, d.z * d.z};
        }
    }
    const double cell = std::pow(3.2, 3) / samples;
    // Deviations of a million samples: 0.2 % of the volume, 0.001 of the centre.
    EXPECT_NEAR(exact.volume, count * cell, 5e-3 * exact.volume);
    EXPECT_NEAR(norm(exact.centroid - first / count), 0, 4e-3);
    EXPECT_NEAR(exact.second_moment(0, 0), square.x * cell, 8e-3 * square.x * cell);
    EXPECT_NEAR(exact.second_moment(2, 2), square.z * cell, 8e-3 * square.z * cell);
}

TEST(Multisphere, TwoSpheresThatOverlapHaveTheVolumeOfTheLensFormula) {
    const double d = 1.2, lens = M_PI * (4 + d) * (2 - d) * (2 - d) / 12;  // two unit spheres
    const geometry::MassProperties clump = union_of_spheres({{{0, 0, 0}, 1, {}}, {{d, 0, 0}, 1, {}}});
    EXPECT_NEAR(clump.volume, 8 * M_PI / 3 - lens, 1e-4 * clump.volume);
    EXPECT_NEAR(clump.centroid.x, 0.5 * d, 1e-6);
}

TEST(Multisphere, ABoxShellIsFlushWithItsFacesAndKnowsThem) {
    const Multisphere shell = box_shell({0.4, 0.4, 0.4}, 4).value();
    EXPECT_EQ(shell.spheres.size(), 4U * 4 * 4 - 2 * 2 * 2);
    EXPECT_NEAR(shell.shape.volume, 0.064, 1e-15);
    std::size_t faces = 0;
    for (const ShapeSphere& s : shell.spheres) {
        const double reach = std::max({std::abs(s.centre.x), std::abs(s.centre.y), std::abs(s.centre.z)}) + s.radius;
        EXPECT_NEAR(reach, 0.2, 1e-12);
        faces += norm(s.face_normal) > 0 ? 1 : 0;
    }
    EXPECT_EQ(faces, 6U * 4);
    EXPECT_EQ(box_shell({1, 1, 1}, 8).value().spheres.size(), 512U - 216);
    EXPECT_FALSE(box_shell({1, 1, 0.1}, 0.06).has_value());
    EXPECT_EQ(box_shell({0.0725, 0.0725, 0.0195}, 0.0195 / 12).value().spheres.size(), 2U * 23 * 23 + 4 * (4 * 22));
}

TEST(Multisphere, ARingStandsForItsCylinder) {
    const Multisphere shape = ring(0.005, 0.00025, 59, 0.099).value();
    EXPECT_NEAR(2700 * shape.shape.volume, 0.02099369, 1e-8);
    const Mat3 inertia = geometry::inertia_from_second_moment(shape.shape.second_moment);
    EXPECT_NEAR(2700 * inertia(2, 2), 2.62421e-7, 1e-12);
    EXPECT_FALSE(ring(0.005, 0.006, 59, 1).has_value());
}

TEST(Multisphere, AFilledCubeIsTheLatticeInItLessItsInside) {
    const Multisphere shape = fill_surface(geometry::cube(1), 0.25).value();
    EXPECT_EQ(shape.spheres.size(), 64U - 8);
    EXPECT_NEAR(shape.shape.volume, 1, 1e-12);
    geometry::Polyhedron flipped = geometry::cube(1);
    for (auto& face : flipped.faces) {
        std::ranges::reverse(face);
    }
    EXPECT_FALSE(fill_surface(flipped, 0.25).has_value());
    const Multisphere ball = fill_surface(geometry::icosahedron(1), 0.1).value();
    for (const ShapeSphere& s : ball.spheres) {
        EXPECT_LT(norm(s.centre), 0.9511);
    }
}

TEST(Multisphere, MoreSpheresThanAnybodyWaitsForAreRefused) {
    EXPECT_FALSE(box_shell({0.4, 0.4, 0.2}, 1e-4));
    EXPECT_FALSE(box_shell({1, 1, 1e-9}, 0.5e-9));
    EXPECT_FALSE(fill_surface(geometry::box({1, 1, 1}), 1e-9));
}

TEST(Multisphere, AListOfSpheresIsReadAndItsMistakesAreNamed) {
    const auto list = read_sphere_list("# two\n0 0 0 0.5\n 1, 0, 0, 0.5 # touching\n\n", "pair.txt");
    ASSERT_TRUE(list.has_value());
    EXPECT_EQ(list.value().spheres.size(), 2U);
    const auto bad = [](const char* text) { return read_sphere_list(text, "bad.txt").problems().at(0).message; };
    EXPECT_EQ(bad("0 0 0\n1 0 0 1\n"), "bad.txt:1:5: 3 columns instead of 4");
    EXPECT_EQ(bad("0 0 0 1\n1 0 0 x\n"), "bad.txt:2:7: \"x\" in column 4 is not a finite number");
    EXPECT_NE(bad("0 0 0 1\n1 0 0 1e-300\n").find("sphere 2 has radius 1e-300 m in a body of 1 m"), std::string::npos);
    EXPECT_FALSE(read_sphere_list("", "empty.txt").has_value());
    EXPECT_FALSE(read_sphere_list("0 0 0 1\n0.2 0 0 0.5\n", "inside.txt").has_value());
    EXPECT_FALSE(read_sphere_list("0 0 0 -1\n", "negative.txt").has_value());
}

}  // namespace
}  // namespace riprap::body
