// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/fill_solids.hpp"

#include <gtest/gtest.h>

#include <random>

#include "coupling/tank_scenes.hpp"
#include "riprap/geometry/ground/ground_cells.hpp"
#include "riprap/geometry/polyhedra/convex_query.hpp"

namespace riprap::coupling {
namespace {

constexpr double farthest = 0.05;

/// Small blocks of three sizes all over the place, turned at random, a wall that is as large as all of them and a floor
/// without end.
test::Scene rubble(std::mt19937& random) {
    std::uniform_real_distribution<double> place(-1, 1), size(0.05, 0.15);
    test::Scene scene;
    for (int k = 0; k < 200; ++k) {
        const Vec3 turn{3 * place(random), 3 * place(random), 3 * place(random)};
        scene.add(geometry::cube(size(random)),
                  {{place(random), place(random), place(random)}, from_rotation_vector(turn)});
    }
    scene.add(geometry::box({0.1, 3, 3}), {{1, 0, 0}, {}});
    scene.add_half_space({0, 0, 1}, -0.9);
    return scene;
}

/// Every part asked, one after the other.
struct Plain {
    const test::Scene& scene;

    bool contain(const Vec3& x, double distance) const {
        for (const body::Part& part : scene.bodies.parts) {
            const auto b = static_cast<std::size_t>(part.body.value);
            const Pose body{scene.state.position[b], scene.state.orientation[b]};
            const Pose pose{to_world(body, part.local.position), body.orientation * part.local.orientation};
            const geometry::ConvexView shape = scene.shapes.view(part.shape);
            const Vec3 local = to_body(pose, x);
            if (geometry::contains(shape, local) ||
                (distance > 0 && geometry::closest_surface_point(shape, local).distance < distance)) {
                return true;
            }
        }
        return false;
    }
};

TEST(FillSolids, in_cells_contain_and_are_near_the_same_as_asked_one_by_one) {
    std::mt19937 random(7);
    const test::Scene scene = rubble(random);
    const FillSolids solids(scene.shapes, scene.bodies, scene.state, {}, farthest);
    const Plain plain{scene};
    std::uniform_real_distribution<double> place(-1.5, 1.5);
    int inside = 0, near = 0;
    for (int k = 0; k < 5000; ++k) {
        const Vec3 x{place(random), place(random), place(random)};
        ASSERT_EQ(solids.contain(x), plain.contain(x, 0));
        for (const double distance : {0.2 * farthest, farthest}) {
            ASSERT_EQ(solids.are_near(x, distance), plain.contain(x, distance));
        }
        inside += solids.contain(x) ? 1 : 0;
        near += solids.are_near(x, farthest) ? 1 : 0;
    }
    EXPECT_GT(inside, 1000);
    EXPECT_GT(near, inside + 200);
    EXPECT_LT(near, 4000);
}

/// Blocks turned at random that lie across the sides of a domain, its edges and corners, and farther out than a period,
/// over a floor without end.
test::Scene across_sides(std::mt19937& random) {
    std::uniform_real_distribution<double> turn(-3, 3);
    test::Scene scene;
    const auto put = [&](const Vec3& x, double size) {
        scene.add(geometry::cube(size), {x, from_rotation_vector({turn(random), turn(random), turn(random)})});
    };
    put({0.02, 0.5, 0.3}, 0.2);
    put({0.98, 0.01, 0.5}, 0.3);
    put({0.5, 2.35, 0.7}, 0.3);
    put({-1.4, -0.95, 0.4}, 0.25);
    scene.add_half_space({0, 0, 1}, 0.1);
    return scene;
}

TEST(FillSolids, repeat_across_periodic_sides) {
    std::mt19937 random(11);
    const test::Scene scene = across_sides(random);
    const fluid::Domain domain{{0, 0, 0}, {1, 1, 1}, {true, true, false}, 3};
    const FillSolids solids(scene.shapes, scene.bodies, scene.state, domain, farthest);
    const Plain plain{scene};
    std::uniform_real_distribution<double> place(0, 1);
    int inside = 0, of_images = 0;
    for (int k = 0; k < 5000; ++k) {
        const Vec3 x{place(random), place(random), place(random)};
        for (const double distance : {0.0, farthest}) {
            bool expected = false;
            for (int i = -3; i <= 3; ++i) {
                for (int j = -3; j <= 3; ++j) {
                    expected = expected || plain.contain(x + Vec3{1.0 * i, 1.0 * j, 0}, distance);
                }
            }
            ASSERT_EQ(distance > 0 ? solids.are_near(x, distance) : solids.contain(x), expected);
            inside += distance == 0 && expected ? 1 : 0;
            of_images += distance == 0 && expected && !plain.contain(x, 0) ? 1 : 0;
        }
    }
    EXPECT_GT(inside, of_images + 500);
    EXPECT_GT(of_images, 100);
}

// Looks along the way, sixty to a spacing, find all but corners that it grazes.
TEST(FillSolids, lie_between_places_where_looks_along_the_way_find_them) {
    std::mt19937 random(13);
    const test::Scene scene = rubble(random);
    const FillSolids solids(scene.shapes, scene.bodies, scene.state, {}, farthest);
    std::uniform_real_distribution<double> place(-1.2, 1.2), step(-3 * farthest, 3 * farthest);
    int between = 0, open = 0;
    while (between < 100 || open < 100) {
        const Vec3 a{place(random), place(random), place(random)};
        const Vec3 b = a + Vec3{step(random), step(random), step(random)};
        if (solids.contain(a) || solids.contain(b)) {
            continue;
        }
        bool expected = false;
        for (int n = 1; n < 200; ++n) {
            expected = expected || solids.contain(a + (n / 200.0) * (b - a));
        }
        const bool found = solids.lie_between(a, b);
        ASSERT_TRUE(found || !expected);
        EXPECT_EQ(found, solids.lie_between(b, a));
        between += expected ? 1 : 0;
        open += found ? 0 : 1;
    }
}

TEST(FillSolids, lie_between_places_however_thin_they_are) {
    for (const double thickness : {1e-5, 1e-2}) {
        test::Scene scene;
        scene.add(geometry::box({thickness, 0.4, 0.4}), {{0.3, 0, 0}, from_rotation_vector({0, 0, 0.4})});
        const FillSolids solids(scene.shapes, scene.bodies, scene.state, {}, farthest);
        EXPECT_TRUE(solids.lie_between({0.28, 0.01, 0}, {0.32, 0, 0}));
        EXPECT_TRUE(solids.lie_between({0, 0.01, 0}, {0.7, 0, 0}));  // far longer than any distance asked for
        EXPECT_FALSE(solids.lie_between({0.28, 0.01, 0}, {0.28, -0.1, 0.1}));
        EXPECT_FALSE(solids.lie_between({0.28, 0, 0.21}, {0.32, 0, 0.21}));  // beside it
        EXPECT_FALSE(solids.lie_between({0.2, 0, 0}, {0.27, 0, 0}));         // it begins behind
    }
}

TEST(FillSolids, ground_lies_between_the_sides_of_its_ridge) {
    test::Scene scene;
    scene.bodies.is_planar = true;
    std::vector<body::Part> parts;
    for (const geometry::Polyhedron& cell :
         geometry::cells_under_line({{-1, 0, 0}, {-1e-3, 0, 0}, {0, 0.3, 0}, {1e-3, 0, 0}, {1, 0, 0}}, 0.2)) {
        Vec3 place;
        const ShapeId shape = scene.shapes.add_convex(cell, true, &place);
        parts.push_back({BodyId{}, shape, {place, {}}});
    }
    scene.add_parts(parts, {}, body::Drive::fixed);
    ASSERT_EQ(body::find_grounds(scene.bodies, scene.shapes).size(), 1U);
    const fluid::Domain domain{{-1, -1, 0}, {1, 1, 0}, {}, 2};
    const FillSolids solids(scene.shapes, scene.bodies, scene.state, domain, farthest);
    EXPECT_TRUE(solids.lie_between({-0.02, 0.1, 0}, {0.02, 0.1, 0}));
    EXPECT_TRUE(solids.lie_between({0.02, 0.25, 0}, {-0.02, 0.2, 0}));
    EXPECT_TRUE(solids.lie_between({-0.2, 0.01, 0}, {0.2, 0.1, 0}));
    EXPECT_FALSE(solids.lie_between({-0.02, 0.31, 0}, {0.02, 0.31, 0}));
    EXPECT_FALSE(solids.lie_between({-0.02, 0.1, 0}, {-0.01, 0.2, 0}));
    EXPECT_FALSE(solids.lie_between({-0.2, 0.01, 0}, {-0.05, 0.01, 0}));
}

}  // namespace
}  // namespace riprap::coupling
