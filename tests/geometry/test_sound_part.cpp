// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "riprap/geometry/polyhedra/convex_hull.hpp"
#include "riprap/geometry/polyhedra/round_shapes.hpp"
#include "riprap/geometry/polyhedra/shape_set.hpp"
#include "riprap/geometry/polyhedra/shapes.hpp"
#include "riprap/geometry/polyhedra/sound_part.hpp"

namespace riprap::geometry {
namespace {

using Maker = std::function<Polyhedron(double)>;

const std::vector<Maker>& solids() {
    static const std::vector<Maker> makers{
        [](double s) { return cube(s); },
        [](double s) { return sphere(s); },
        [](double s) { return icosahedron(s); },
        [](double s) { return regular_tetrahedron(s); },
        [](double s) {
            return wedge({s, 2 * s, 0.5 * s});
        },
        [](double s) { return cylinder(s, s, 24).value(); },
        [](double s) { return random_hull(7, 12, s).value(); },
    };
    return makers;
}

Outcome<Polyhedron> disc(double a, double b) {
    std::vector<Point2> corners;
    for (int k = 0; k < 64; ++k) {
        const double angle = 2 * 3.14159265358979 * k / 64;
        corners.push_back({a * std::cos(angle), b * std::sin(angle)});
    }
    return planar_prism(corners);
}

TEST(SoundParts, SolidsOfEveryExtentInRangeAreHeldAndNoOthers) {
    for (const Maker& make : solids()) {
        for (const double size : {1e-59, 1e-30, 1e-3, 1.0, 1e7, 1e30, 2e59}) {
            const Polyhedron part = make(size);
            ASSERT_FALSE(part_problem(part, false)) << size << ' ' << part_problem(part, false)->message;
            ShapeSet shapes;
            const ShapeId id = shapes.add_convex(part);  // asserts a volume and convexity
            EXPECT_TRUE(std::isnormal(shapes.volume(id)) && std::isnormal(trace(shapes.second_moment(id)))) << size;
        }
        for (const double size : {1e-300, 1e-110, 1e-61, 1e62, 1e100, 1e300}) {
            EXPECT_TRUE(part_problem(make(size), false)) << size;
        }
    }
}

TEST(SoundParts, PlatesAreHeldAtAMillionthOfTheirLengthAndRefusedWhereTheirFacesMerge) {
    const std::vector<Maker> plates{[](double t) {
                                        return box({1, 1, t});
                                    },
                                    [](double t) {
                                        return box({t, 1, 3});
                                    },
                                    [](double t) {
                                        return box({1, t, t});
                                    },
                                    [](double t) { return cylinder(1, t, 16).value(); },
                                    [](double t) {
                                        return ellipsoid({1, 2, t});
                                    }};
    for (const Maker& make : plates) {
        for (const double scale : {1e-40, 1.0, 1e40}) {
            const auto scaled = [&](double thickness) {
                Polyhedron part = make(thickness);
                for (Vec3& x : part.vertices) {
                    x = scale * x;
                }
                return part;
            };
            for (const double thin : {1e-2, 1e-4, 4 * safe_slenderness}) {
                EXPECT_FALSE(part_problem(scaled(thin), false)) << thin;
                ShapeSet().add_convex(scaled(thin));
            }
            for (const double thin : {1e-10, 1e-20, 1e-200, 1e-300}) {
                EXPECT_TRUE(part_problem(scaled(thin), false)) << thin;
            }
        }
    }
}

TEST(SoundParts, PlanarPartsAreMeasuredBesideTheirMetreOfWidth) {
    for (const double size : {1e-6, 1e-3, 1.0, 1e6}) {
        EXPECT_FALSE(part_problem(disc(size, size).value(), true)) << size;
        ShapeSet().add_convex(disc(size, size).value(), true);
    }
    EXPECT_FALSE(part_problem(disc(1, 1e-5).value(), true));
    for (const double size : {1e-300, 1e-110, 1e-10, 1e100, 1e300}) {
        EXPECT_TRUE(part_problem(disc(size, size).value(), true)) << size;
        const Outcome<Polyhedron> flat = disc(1, size);  // a polygon whose corners lie on a line is none
        EXPECT_TRUE(!flat || part_problem(flat.value(), true)) << size;
    }
}

TEST(SoundParts, AWedgeAndAHullTooThinOrTooSmallAreRefusedForThat) {
    for (const Vec3& size : {Vec3{1, 1, 1e-9}, Vec3{1, 1, 1e20}, Vec3{1e-12, 3, 1}, Vec3{1e-300, 1e-300, 1e-300}}) {
        const Outcome<Polyhedron> made = wedge(size, 0, 0);
        const auto problem = made ? part_problem(made.value(), false) : made.problems().front();
        ASSERT_TRUE(problem);
        EXPECT_NE(problem->message.find("out of the range of double precision"), std::string::npos) << problem->message;
    }
    for (const double s : {1e-300, 1e-100, 1e100}) {
        const Outcome<Polyhedron> four = tetrahedron({0, 0, 0}, {s, 0, 0}, {0, s, 0}, {0, 0, s});
        const Outcome<Polyhedron> hull = convex_hull(std::vector<Vec3>{{0, 0, 0}, {s, 0, 0}, {0, s, 0}, {0, 0, s}});
        ASSERT_FALSE(four || hull);
        EXPECT_EQ(four.problems(), hull.problems());
        EXPECT_NE(hull.problems().front().allowed.find("extents from 1e-60 to 1e+60 m"), std::string::npos);
    }
}

}  // namespace
}  // namespace riprap::geometry
