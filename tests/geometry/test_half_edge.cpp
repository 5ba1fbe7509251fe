// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/polyhedra/half_edge.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <utility>

#include "geometry/random_shapes.hpp"
#include "riprap/geometry/polyhedra/merge_faces.hpp"
#include "riprap/geometry/polyhedra/shapes.hpp"

namespace riprap::geometry {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::Each;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::SizeIs;

auto says(const std::string& text) { return Contains(Field(&GeometryProblem::message, HasSubstr(text))); }

std::vector<std::pair<std::string, Polyhedron>> all_shapes() {
    std::vector<std::pair<std::string, Polyhedron>> shapes{{"box", box({1, 2, 3})},
                                                           {"cube", cube(1)},
                                                           {"regular tetrahedron", regular_tetrahedron(1)},
                                                           {"octahedron", octahedron(1)},
                                                           {"dodecahedron", dodecahedron(1)},
                                                           {"icosahedron", icosahedron(1)},
                                                           {"wedge", wedge({1, 2, 3})},
                                                           {"ridge", wedge({3, 2, 1}, 1, 1).value()},
                                                           {"trapezoid", wedge({3, 2, 1}, 1, 2).value()},
                                                           {"overhang", wedge({3, 2, 1}, 4, 5).value()}};
    shapes.emplace_back("tetrahedron", tetrahedron({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}).value());
    for (const int sides : {3, 4, 5, 17}) {
        shapes.emplace_back("prism", prism(sides, 1, 2).value());
        shapes.emplace_back("pyramid", pyramid(sides, 1, 2).value());
    }
    const std::vector<Point2> corners{{0, 0}, {2, 0}, {3, 1}, {1, 3}};
    shapes.emplace_back("extruded polygon", extruded_polygon(corners, -1, 4).value());
    shapes.emplace_back("planar prism", planar_prism(corners).value());
    std::mt19937_64 random(31);
    for (int i = 0; i < 20; ++i) {
        shapes.emplace_back("random block", testing::random_block(random, 6 + i));
    }
    return shapes;
}

Polyhedron triangulated_cube() {
    const Polyhedron solid = cube(1);
    Polyhedron result{solid.vertices, {}, {}};
    for (const auto& loop : solid.faces) {
        result.faces.push_back({loop[0], loop[1], loop[2]});
        result.faces.push_back({loop[0], loop[2], loop[3]});
    }
    return result;
}

TEST(HalfEdges, OfEveryBuilderSatisfyEulerAndPointOutwards) {
    for (const auto& [name, shape] : all_shapes()) {
        SCOPED_TRACE(name);
        const Outcome<HalfEdgeMesh> outcome = half_edges(shape);
        ASSERT_TRUE(outcome) << outcome.problems().front().message;
        const HalfEdgeMesh& mesh = outcome.value();
        EXPECT_EQ(mesh.vertex_count() - mesh.edge_count() + mesh.face_count(), 2);
        EXPECT_GT(mass_properties(shape).volume, 0);
        for (const auto& loop : shape.faces) {
            const Plane plane = face_plane(shape.vertices, loop);
            for (const Vec3& x : shape.vertices) {
                EXPECT_LE(dot(plane.normal, x), plane.offset + 1e-12);
            }
        }
    }
}

TEST(HalfEdges, ArePairedNextedAndTurnedConsistently) {
    for (const auto& [name, shape] : all_shapes()) {
        SCOPED_TRACE(name);
        const Outcome<HalfEdgeMesh> outcome = half_edges(shape);
        const HalfEdgeMesh& mesh = outcome.value();
        for (std::int32_t e = 0; e < mesh.half_edge_count(); ++e) {
            const auto i = static_cast<std::size_t>(e);
            const std::int32_t pair = mesh.pair[i];
            ASSERT_GE(pair, 0);
            EXPECT_NE(pair, e);
            EXPECT_EQ(mesh.pair[static_cast<std::size_t>(pair)], e);
            EXPECT_EQ(mesh.vertex[static_cast<std::size_t>(pair)], mesh.end(e));
            EXPECT_EQ(mesh.end(pair), mesh.vertex[i]);
            EXPECT_NE(mesh.face[static_cast<std::size_t>(pair)], mesh.face[i]);
            EXPECT_EQ(mesh.next[static_cast<std::size_t>(mesh.previous(e))], e);
            EXPECT_EQ(mesh.previous(mesh.next[i]), e);
            EXPECT_EQ(mesh.vertex[static_cast<std::size_t>(mesh.turn(e))], mesh.vertex[i]);
        }
    }
}

TEST(HalfEdges, CirculateThroughEveryNeighbourOfAVertex) {
    const Polyhedron shape = icosahedron(1);
    const HalfEdgeMesh mesh = half_edges(shape).value();
    for (std::int32_t v = 0; v < 12; ++v) {
        std::set<std::int32_t> reached;
        mesh.for_each_outgoing(v, [&](std::int32_t e) { reached.insert(mesh.end(e)); });
        EXPECT_EQ(reached.size(), 5U);
        for (const std::int32_t other : reached) {
            EXPECT_NEAR(
                norm(shape.vertices[static_cast<std::size_t>(v)] - shape.vertices[static_cast<std::size_t>(other)]), 1,
                1e-14);
        }
    }
}

TEST(HalfEdges, NameEveryOpenEdge) {
    Polyhedron shape = cube(1);
    shape.faces.pop_back();
    const auto problems = half_edges(shape).problems();
    EXPECT_THAT(problems, SizeIs(4));
    EXPECT_THAT(problems, Each(Field(&GeometryProblem::message, HasSubstr("the surface is open at the edge of face"))));
}

TEST(HalfEdges, NameFacesThatWindAgainstTheirNeighbours) {
    Polyhedron shape = cube(1);
    std::reverse(shape.faces[3].begin(), shape.faces[3].end());
    const auto problems = half_edges(shape).problems();
    EXPECT_THAT(problems, SizeIs(4));
    EXPECT_THAT(problems, says("faces 0 and 3 wind against each other"));
}

TEST(HalfEdges, RefuseLoopsThatAreNoFaces) {
    Polyhedron shape = cube(1);
    shape.faces[0] = {0, 1};
    shape.faces[1] = {4, 5, 6, 9};
    shape.faces[2] = {0, 1, 0, 5};
    shape.vertices[7].x = std::nan("");
    const auto problems = half_edges(shape).problems();
    EXPECT_THAT(problems, AllOf(says("face 0 has 2 corners"), says("face 1 names vertex 9"),
                                says("face 2 uses vertex 0 twice"), says("vertex 7 is not finite")));
}

TEST(HalfEdges, RefuseABentFaceAndAFaceWithoutArea) {
    Polyhedron bent = cube(1);
    bent.vertices[6].z += 1e-6;
    EXPECT_THAT(half_edges(bent).problems(), says("face 1 is not plane: vertex"));
    Polyhedron round_off = cube(1);
    round_off.vertices[6].z += 1e-10;
    EXPECT_TRUE(half_edges(round_off));
    Polyhedron flat = octahedron(1);
    flat.vertices[4] = flat.vertices[0];
    EXPECT_THAT(half_edges(flat).problems(), says("has no area"));
}

TEST(HalfEdges, RefuseTwoBodiesInOneSurface) {
    Polyhedron shape = cube(1);
    const Polyhedron second = moved(cube(1), {{5, 0, 0}, {}});
    shape.vertices.insert(shape.vertices.end(), second.vertices.begin(), second.vertices.end());
    for (auto loop : second.faces) {
        for (auto& v : loop) {
            v += 8;
        }
        shape.faces.push_back(loop);
    }
    EXPECT_THAT(half_edges(shape).problems(), says("in 2 separate pieces"));
    // Joined at one corner: vertex 8 of the second cube becomes vertex 6 of the first.
    for (auto& x : shape.vertices) {
        x = x.x > 2 ? x + Vec3{-4, 1, 1} : x;
    }
    for (auto& loop : shape.faces) {
        std::replace(loop.begin(), loop.end(), 8, 6);
        for (auto& v : loop) {
            v = v > 8 ? v - 1 : v;
        }
    }
    shape.vertices.erase(shape.vertices.begin() + 8);
    EXPECT_THAT(half_edges(shape).problems(), says("touch at vertex 6 only"));
}

TEST(HalfEdges, RefuseABodyWithAHoleThroughIt) {
    // A square ring: outer square 0-3 and inner square 4-7 below, 8-15 above; top and bottom as four trapezoids each.
    Polyhedron ring;
    for (const double z : {0.0, 1.0}) {
        for (const double half : {3.0, 1.0}) {
            ring.vertices.insert(ring.vertices.end(),
                                 {{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}});
        }
    }
    for (std::int32_t k = 0; k < 4; ++k) {
        const std::int32_t n = (k + 1) % 4;
        ring.faces.push_back({k, n, 8 + n, 8 + k});
        ring.faces.push_back({4 + n, 4 + k, 12 + k, 12 + n});
        ring.faces.push_back({8 + k, 8 + n, 12 + n, 12 + k});
        ring.faces.push_back({n, k, 4 + k, 4 + n});
    }
    EXPECT_NEAR(mass_properties(ring).volume, 32, 1e-12);
    EXPECT_THAT(half_edges(ring).problems(), says("1 holes through it (V - E + F = 0)"));
}

TEST(HalfEdges, RefuseMoreThanTwoFacesOnAnEdgeAndSpareVertices) {
    Polyhedron shape = regular_tetrahedron(1);
    shape.vertices.push_back({3, 3, 3});
    EXPECT_THAT(half_edges(shape).problems(), says("no face uses vertex 4"));
    shape.faces.push_back({0, 1, 4});
    EXPECT_THAT(half_edges(shape).problems(), says("3 faces share the edge between vertices 0 and 1"));
}

// Any list of loops ends in a valid mesh or in problems, never in a wild index or an endless walk.
TEST(HalfEdges, OfArbitraryLoopsAreValidOrRefused) {
    std::mt19937_64 random(32);
    const auto up_to = [&](std::uint64_t n) { return static_cast<std::int32_t>(random() % n); };
    int accepted = 0;
    for (int trial = 0; trial < 20000; ++trial) {
        Polyhedron shape = trial % 2 == 0 ? regular_tetrahedron(1) : triangulated_cube();
        const std::int32_t changes = up_to(4);
        for (std::int32_t change = 0; change < changes; ++change) {
            auto& loop = shape.faces[static_cast<std::size_t>(up_to(shape.faces.size()))];
            switch (up_to(5)) {
                case 0:
                    if (!loop.empty()) {
                        loop[static_cast<std::size_t>(up_to(loop.size()))] = up_to(10) - 1;
                    }
                    break;
                case 1:
                    std::reverse(loop.begin(), loop.end());
                    break;
                case 2:
                    shape.faces.push_back(loop);
                    break;
                case 3:
                    loop.resize(static_cast<std::size_t>(up_to(5)), up_to(8));
                    break;
                default:
                    std::swap(loop, shape.faces.front());
                    break;
            }
        }
        const Outcome<HalfEdgeMesh> outcome = half_edges(shape);
        if (outcome) {
            ++accepted;
            EXPECT_EQ(outcome.value().vertex_count() - outcome.value().edge_count() + outcome.value().face_count(), 2);
        } else {
            EXPECT_FALSE(outcome.problems().empty());
        }
    }
    EXPECT_GT(accepted, 4000);  // a quarter is left as it was
    EXPECT_LT(accepted, 16000);
}

TEST(HalfEdges, ListAtMostTwentyProblems) {
    Polyhedron shape = prism(100, 1, 1).value();
    shape.faces.erase(shape.faces.begin());
    const auto problems = half_edges(shape).problems();
    EXPECT_THAT(problems, SizeIs(problem_limit + 1));
    EXPECT_EQ(problems.back().message, "and 80 more problems of this surface");
}

}  // namespace
}  // namespace riprap::geometry
