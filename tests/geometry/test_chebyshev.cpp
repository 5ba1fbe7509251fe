// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/polyhedra/chebyshev.hpp"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <utility>

#include "geometry/random_shapes.hpp"
#include "riprap/geometry/polyhedra/merge_faces.hpp"
#include "riprap/geometry/polyhedra/shapes.hpp"

namespace riprap::geometry {
namespace {

std::vector<Plane> planes_of(const Polyhedron& shape) {
    std::vector<Plane> planes;
    for (const auto& loop : shape.faces) {
        planes.push_back(face_plane(shape.vertices, loop));
    }
    return planes;
}

InscribedSphere inscribed(const Polyhedron& shape) {
    return largest_inscribed_sphere(planes_of(shape), shape.is_internal, mass_properties(shape).centroid,
                                    2 * length_scale(shape.vertices));
}

/// Solves a 4x4 system by elimination with row pivots; false where singular.
bool solve4(std::array<std::array<double, 5>, 4> m, std::array<double, 4>& x) {
    for (std::size_t c = 0; c < 4; ++c) {
        std::size_t p = c;
        for (std::size_t r = c + 1; r < 4; ++r) {
            p = std::abs(m[r][c]) > std::abs(m[p][c]) ? r : p;
        }
        if (std::abs(m[p][c]) < 1e-9) {
            return false;
        }
        std::swap(m[c], m[p]);
        for (std::size_t r = c + 1; r < 4; ++r) {
            const double f = m[r][c] / m[c][c];
            for (std::size_t k = c; k < 5; ++k) {
                m[r][k] -= f * m[c][k];
            }
        }
    }
    for (std::size_t c = 4; c-- > 0;) {
        double sum = m[c][4];
        for (std::size_t k = c + 1; k < 4; ++k) {
            sum -= m[c][k] * x[k];
        }
        x[c] = sum / m[c][c];
    }
    return true;
}

/// The oracle: the best of all points where four constraints are tight and none is violated.
double brute_force_radius(const std::vector<Plane>& planes) {
    double best = -1;
    const std::size_t n = planes.size();
    const auto row = [&](std::size_t j) {
        return std::array<double, 5>{planes[j].normal.x, planes[j].normal.y, planes[j].normal.z, 1, planes[j].offset};
    };
    for (std::size_t a = 0; a < n; ++a) {
        for (std::size_t b = a + 1; b < n; ++b) {
            for (std::size_t c = b + 1; c < n; ++c) {
                for (std::size_t d = c + 1; d < n; ++d) {
                    std::array<double, 4> x{};
                    if (!solve4({row(a), row(b), row(c), row(d)}, x) || x[3] <= best) {
                        continue;
                    }
                    bool is_feasible = true;
                    for (std::size_t j = 0; j < n && is_feasible; ++j) {
                        is_feasible = dot(planes[j].normal, {x[0], x[1], x[2]}) + x[3] <= planes[j].offset + 1e-13;
                    }
                    best = is_feasible ? x[3] : best;
                }
            }
        }
    }
    return best;
}

TEST(LargestInscribedSphere, OfRegularSolidsHasTheClosedFormRadius) {
    const double l = 1.7;
    EXPECT_NEAR(inscribed(regular_tetrahedron(l)).radius, l / (2 * std::sqrt(6.0)), 2e-15);
    EXPECT_NEAR(inscribed(cube(l)).radius, l / 2, 2e-15);
    EXPECT_NEAR(inscribed(octahedron(l)).radius, l / std::sqrt(6.0), 2e-15);
    EXPECT_NEAR(inscribed(icosahedron(l)).radius, l * std::sqrt(3.0) * (3 + std::sqrt(5.0)) / 12, 4e-15);
    EXPECT_NEAR(inscribed(dodecahedron(l)).radius, l / 2 * std::sqrt(2.5 + 1.1 * std::sqrt(5.0)), 4e-15);
}

TEST(LargestInscribedSphere, OfATetrahedronIsThreeVolumesOverTheSurface) {
    std::mt19937_64 random(11);
    for (int trial = 0; trial < 500; ++trial) {
        const Polyhedron t = tetrahedron(testing::random_point(random), testing::random_point(random),
                                         testing::random_point(random), testing::random_point(random))
                                 .value();
        double surface = 0;
        Vec3 centre{};
        constexpr std::array opposite{3, 2, 0, 1};
        for (std::size_t j = 0; j < 4; ++j) {
            const double area = norm(vector_area(t.vertices, t.faces[j]));
            surface += area;
            centre += area * t.vertices[opposite[j]];
        }
        const InscribedSphere sphere = inscribed(t);
        const double exact = 3 * mass_properties(t).volume / surface;
        // Round-off of the planes alone moves the radius by about 1e-16 of the extent.
        EXPECT_NEAR(sphere.radius, exact, 1e-14);
        if (exact > 0.01) {
            EXPECT_NEAR(norm(sphere.centre - centre / surface), 0, 1e-11);
        }
    }
}

TEST(LargestInscribedSphere, AgreesWithAllTightSubsetsOfRandomHulls) {
    std::mt19937_64 random(12);
    double worst = 0;
    for (int trial = 0; trial < 1000; ++trial) {
        const Polyhedron block = testing::random_block(random, 5 + trial % 7);
        const double brute = brute_force_radius(planes_of(block));
        const double radius = inscribed(block).radius;
        ASSERT_GT(brute, 0);
        worst = std::max(worst, std::abs(radius - brute) / brute);
    }
    EXPECT_LT(worst, 1e-12);
}

TEST(LargestInscribedSphere, OfBoxesOfAnyShapeAndSizeIsHalfTheShortestSide) {
    for (const double size : {1e-6, 1.0, 1e6}) {
        for (const Vec3& ratio : {Vec3{1, 1, 1}, Vec3{2, 1, 1}, Vec3{3, 2, 1}, Vec3{1, 1, 1e-6}, Vec3{1, 1e-6, 1e-6},
                                  Vec3{1e-3, 1, 1e-4}}) {
            const Vec3 sides = size * ratio;
            const double exact = 0.5 * std::min({sides.x, sides.y, sides.z});
            EXPECT_NEAR(inscribed(box(sides)).radius, exact, 1e-14 * exact) << size << ' ' << ratio.x << ' ' << ratio.y;
        }
    }
}

TEST(LargestInscribedSphere, OfTurnedNeedlesAndPlatesIsAsGoodAsTheirPlanes) {
    std::mt19937_64 random(13);
    for (int trial = 0; trial < 300; ++trial) {
        const double thin = std::pow(10.0, testing::uniform(random, -6, -1));
        const Vec3 sides = trial % 2 == 0 ? Vec3{1, 0.7, thin} : Vec3{1, thin, 1.3 * thin};
        const double size = std::pow(10.0, testing::uniform(random, -6, 6));
        const Polyhedron block = moved(box(size * sides), {{}, testing::random_orientation(random)});
        // A corner is known to 1e-16 of the length; the width across is no better.
        EXPECT_NEAR(inscribed(block).radius, 0.5 * size * thin, 4e-15 * size);
    }
}

TEST(LargestInscribedSphere, OfASlenderPrismIsThatOfItsCrossSection) {
    for (const int sides : {3, 4, 5, 6, 12}) {
        const double apothem = std::cos(std::numbers::pi / sides);
        EXPECT_NEAR(inscribed(prism(sides, 1, 1000).value()).radius, apothem, 1e-12);
        EXPECT_NEAR(inscribed(prism(sides, 1, 0.01).value()).radius, 0.005, 1e-16);
    }
}

TEST(LargestInscribedSphere, OfAPlanarPrismIsTheInscribedCircleHoweverThin) {
    // Right triangle with legs 300 and 400: inscribed circle (a + b - c) / 2 = 100, far larger than the thickness 1.
    const std::vector<Point2> corners{{0, 0}, {300, 0}, {0, 400}};
    const InscribedSphere circle = inscribed(planar_prism(corners).value());
    EXPECT_NEAR(circle.radius, 100, 1e-12);
    EXPECT_NEAR(circle.centre.x, 100, 1e-12);
    EXPECT_NEAR(circle.centre.y, 100, 1e-12);
    EXPECT_LE(std::abs(circle.centre.z), 0.5);
}

TEST(LargestInscribedSphere, ScalesAndShiftsWithTheBody) {
    std::mt19937_64 random(14);
    for (const double size : {1e-6, 1e6}) {
        for (int trial = 0; trial < 100; ++trial) {
            Polyhedron block = testing::random_block(random, 10, {1, 0.8, 0.5});
            const double radius = inscribed(block).radius;
            for (Vec3& x : block.vertices) {
                x = size * (x + Vec3{3, -2, 1});
            }
            EXPECT_NEAR(inscribed(block).radius, size * radius, 1e-13 * size);
        }
    }
}

TEST(LargestInscribedSphere, TouchesEnoughFacesAndLeavesNone) {
    std::mt19937_64 random(15);
    for (int trial = 0; trial < 200; ++trial) {
        const Polyhedron block = testing::random_block(random, 30);
        const std::vector<Plane> planes = planes_of(block);
        const InscribedSphere sphere = inscribed(block);
        int touched = 0;
        for (const Plane& plane : planes) {
            const double gap = plane.offset - dot(plane.normal, sphere.centre) - sphere.radius;
            EXPECT_GE(gap, -1e-15);
            touched += gap < 1e-13 ? 1 : 0;
        }
        EXPECT_GE(touched, 4);
    }
}

TEST(LargestInscribedSphere, TimePerShapeIsPrinted) {
    std::mt19937_64 random(16);
    for (const int points : {8, 12, 50}) {
        const Polyhedron block = testing::random_block(random, points);
        const std::vector<Plane> planes = planes_of(block);
        constexpr int repeats = 2000;
        double sum = 0;
        const auto begin = std::chrono::steady_clock::now();
        for (int i = 0; i < repeats; ++i) {
            sum += largest_inscribed_sphere(planes, {}, {}, 2).radius;
        }
        const std::chrono::duration<double, std::micro> spent = std::chrono::steady_clock::now() - begin;
        std::printf("largest_inscribed_sphere, %zu faces: %.2f us\n", planes.size(), spent.count() / repeats);
        EXPECT_GT(sum, 0);
    }
}

}  // namespace
}  // namespace riprap::geometry
