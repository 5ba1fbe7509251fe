// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/surface/surface_audit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "geometry/sample_surfaces.hpp"
#include "riprap/geometry/polyhedra/clip.hpp"
#include "riprap/geometry/surface/obj.hpp"
#include "riprap/geometry/surface/stl.hpp"

namespace riprap::geometry {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::vector<std::string> texts(const std::vector<Diagnostic>& list) {
    std::vector<std::string> result;
    for (const Diagnostic& entry : list) {
        result.push_back(to_string(entry));
    }
    return result;
}

const Polyhedron cube = sample_box({0, 0, 0}, {1, 1, 1});

/// The surface without one of its faces.
Surface without_face(const Surface& surface, std::size_t left_out) {
    Surface result = surface;
    result.face_start = {0};
    result.face_vertex.clear();
    result.face_body.clear();
    result.face_place.clear();
    for (std::size_t f = 0; f < surface.face_count(); ++f) {
        if (f != left_out) {
            result.add_face(surface.face(f), surface.face_body[f], surface.face_place[f]);
        }
    }
    return result;
}

void turn_face(Surface& surface, std::size_t f) {
    std::reverse(surface.face_vertex.begin() + surface.face_start[f],
                 surface.face_vertex.begin() + surface.face_start[f + 1]);
}

TEST(SurfaceAudit, ACubeOfTwelveTrianglesBecomesSixSquares) {
    const SurfaceAudit audit = audit_surface(sample_surface({cube}));
    EXPECT_THAT(texts(audit.problems), IsEmpty());
    ASSERT_EQ(audit.parts.size(), 1u);
    EXPECT_EQ(audit.parts[0].polyhedron.faces.size(), 6u);
    EXPECT_EQ(audit.parts[0].polyhedron.vertices.size(), 8u);
    EXPECT_DOUBLE_EQ(audit.parts[0].volume, 1.0);
    for (const auto& face : audit.parts[0].polyhedron.faces) {
        EXPECT_EQ(face.size(), 4u);
    }
}

TEST(SurfaceAudit, ASinglePrecisionTurnedBoxFarFromTheOriginIsStillABox) {
    Polyhedron box = sample_box({0, 0, 0}, {3, 2, 1});
    const Quat turn{0.5, 0.5, -0.1, std::sqrt(0.49)};
    box = moved(box, {{5, -7, 3}, turn});
    const SurfaceAudit audit = audit_surface(read_stl(binary_stl(sample_surface({box})), "box.stl", 1.0));
    EXPECT_THAT(texts(audit.problems), IsEmpty());
    ASSERT_EQ(audit.parts.size(), 1u);
    EXPECT_EQ(audit.parts[0].polyhedron.faces.size(), 6u);
    EXPECT_NEAR(audit.parts[0].volume, 6.0, 1e-5);
}

TEST(SurfaceAudit, ExtraVerticesInsideFacesAndEdgesDisappear) {
    // A cube with its top split into four triangles around the centre and one edge split in two.
    Polyhedron fine = cube;
    fine.vertices.push_back({0.5, 0.5, 1.0});
    fine.vertices.push_back({0.5, 0.0, 1.0});
    fine.faces = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 9, 4}, {2, 6, 7, 3}, {0, 2, 3, 1},
                  {4, 9, 8},    {9, 5, 8},    {5, 7, 8},       {7, 6, 8},    {6, 4, 8}};
    const SurfaceAudit audit = audit_surface(sample_surface({fine}, false));
    EXPECT_THAT(texts(audit.problems), IsEmpty());
    ASSERT_EQ(audit.parts.size(), 1u);
    EXPECT_EQ(audit.parts[0].polyhedron.faces.size(), 6u);
    EXPECT_EQ(audit.parts[0].polyhedron.vertices.size(), 8u);
}

TEST(SurfaceAudit, AnOpenSurfaceNamesTheEdgesOfTheHole) {
    const SurfaceAudit audit = audit_surface(without_face(sample_surface({cube}), 11));
    EXPECT_THAT(audit.parts, IsEmpty());
    EXPECT_THAT(texts(audit.problems),
                ElementsAre(HasSubstr("sample.stl:1:1: open edge from (0, 0, 1) m to (0, 1, 1) m, at face 1;"),
                            HasSubstr("sample.stl:11:1: open edge from (0, 0, 1) m to (1, 1, 1) m, at face 11;"),
                            HasSubstr("sample.stl:7:1: open edge from (0, 1, 1) m to (1, 1, 1) m, at face 7;")));
}

TEST(SurfaceAudit, AnInvertedFaceIsNamed) {
    Surface surface = sample_surface({cube});
    turn_face(surface, 7);
    const SurfaceAudit audit = audit_surface(surface);
    EXPECT_THAT(texts(audit.problems),
                ElementsAre(HasSubstr("sample.stl:8:1: face 8 at (1, 1, 0) m winds the wrong way")));
}

TEST(SurfaceAudit, AnInsideOutShellIsNamedAndTurnedOnlyWhenAsked) {
    Surface surface = sample_surface({cube});
    for (std::size_t f = 0; f < 12; ++f) {
        turn_face(surface, f);
    }
    EXPECT_THAT(texts(audit_surface(surface).problems),
                ElementsAre(HasSubstr("shell of 12 faces that begins with face 1 is inside out (volume -1 m^3)")));
    turn_face(surface, 3);
    const SurfaceAudit fixed = audit_surface(surface, {.fix_orientation = true});
    EXPECT_THAT(texts(fixed.problems), IsEmpty());
    EXPECT_THAT(texts(fixed.notes), Contains(HasSubstr("11 faces that wound inwards were turned round")));
    ASSERT_EQ(fixed.parts.size(), 1u);
    EXPECT_DOUBLE_EQ(fixed.parts[0].volume, 1.0);
}

TEST(SurfaceAudit, AZeroAreaFaceIsNamed) {
    Surface surface = sample_surface({cube}, false);
    surface.vertices.push_back({0.5, 0.0, 0.0});
    surface.add_face(std::array{0, 1, 8}, 0, 99);
    surface.add_face(std::array{3, 3, 3}, 0, 100);
    EXPECT_THAT(texts(audit_surface(surface).problems),
                ElementsAre(HasSubstr("sample.stl:99:1: face 7 has zero area (0 m^2) at (0, 0, 0) m"),
                            HasSubstr("sample.stl:100:1: face 8 has zero area: its corners coincide at (1, 1, 0) m")));
}

TEST(SurfaceAudit, ACollapsedFaceIsLeftOutOnlyWhenAsked) {
    Surface surface = sample_surface({cube});
    surface.add_face(std::array{0, 0, 1}, 0, 50);
    EXPECT_THAT(audit_surface(surface).parts, IsEmpty());
    const SurfaceAudit audit = audit_surface(surface, {.drop_collapsed = true});
    EXPECT_EQ(audit.parts.size(), 1u);
    EXPECT_THAT(texts(audit.notes), Contains(HasSubstr("1 faces of zero area, the first face 13, were left out")));
}

TEST(SurfaceAudit, ASurfaceOfWhichNothingIsLeftIsRefused) {
    // Found by fuzzing: one vertex far away makes the weld tolerance larger than every face; with all faces left out
    // as asked, there were neither parts nor problems.
    const Surface surface = read_obj(sample_bytes("one_far_vertex.obj"), "far.obj", 1.0);
    EXPECT_THAT(texts(audit_surface(surface, {.drop_collapsed = true}).problems),
                ElementsAre(HasSubstr("far.obj: no face with an area is left")));
}

TEST(SurfaceAudit, AFlatSurfaceHasNoVolume) {
    Polyhedron sheet;
    sheet.vertices = {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    sheet.faces = {{0, 1, 2, 3}, {3, 2, 1, 0}};
    EXPECT_THAT(texts(audit_surface(sample_surface({sheet})).problems),
                ElementsAre(HasSubstr("all vertices lie in one plane, that of face 1; the surface has no volume")));
}

TEST(SurfaceAudit, RepeatedFacesAreJoinedAndReported) {
    Surface surface = sample_surface({cube});
    surface.add_face(std::array{1, 2, 0}, 0, 60);
    const SurfaceAudit audit = audit_surface(surface);
    EXPECT_EQ(audit.parts.size(), 1u);
    EXPECT_THAT(texts(audit.notes), Contains(HasSubstr("sample.stl:60:1: 1 faces, the first face 13, repeat others")));
}

TEST(SurfaceAudit, VerticesWithinTheToleranceAreWeldedAndCounted) {
    Surface surface = sample_surface({cube});
    surface.vertices[4] += Vec3{5e-7, 0, 0};
    const SurfaceAudit audit = audit_surface(surface);
    EXPECT_EQ(audit.parts.size(), 1u);
    EXPECT_THAT(texts(audit.notes), Contains(HasSubstr("1 vertices were welded to others within 1.73e-06 m")));
    surface.vertices[4] += Vec3{1e-4, 0, 0};
    EXPECT_THAT(texts(audit_surface(surface).problems), Contains(HasSubstr("open edge")));
}

TEST(SurfaceAudit, AConcaveShellNamesItsWorstEdge) {
    Polyhedron ell;  // an L of unit height
    ell.vertices = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0},
                    {0, 0, 1}, {2, 0, 1}, {2, 1, 1}, {1, 1, 1}, {1, 2, 1}, {0, 2, 1}};
    ell.faces = {{5, 4, 3, 2, 1, 0}, {6, 7, 8, 9, 10, 11}, {0, 1, 7, 6},   {1, 2, 8, 7},
                 {2, 3, 9, 8},       {3, 4, 10, 9},        {4, 5, 11, 10}, {5, 0, 6, 11}};
    const SurfaceAudit audit = audit_surface(sample_surface({ell}, false));
    EXPECT_THAT(texts(audit.problems),
                ElementsAre(AllOf(HasSubstr("is not convex: at the edge from (1, 1, "),
                                  HasSubstr("folds inwards by 90 degrees"), HasSubstr("rises 1 m above it"),
                                  HasSubstr("several closed convex shells"))));
}

TEST(SurfaceAudit, ADentBelowTheToleranceIsForgivenAndOneAboveIsNot) {
    for (const double dent : {1e-7, 1e-4}) {
        Polyhedron dented = cube;
        dented.vertices.push_back({0.5, 0.5, 1.0 - dent});
        dented.faces.pop_back();
        for (const auto& [a, b] : {std::pair{4, 5}, {5, 7}, {7, 6}, {6, 4}}) {
            dented.faces.push_back({a, b, 8});
        }
        EXPECT_EQ(audit_surface(sample_surface({dented})).parts.size(), dent < 1e-6 ? 1u : 0u) << dent;
    }
}

TEST(SurfaceAudit, SeveralClosedConvexShellsAreTheStatedDecomposition) {
    // An L of three cubes as one soup without bodies: shells are told apart although they share faces and edges.
    const std::vector<Polyhedron> cubes{cube, sample_box({1, 0, 0}, {2, 1, 1}), sample_box({0, 1, 0}, {1, 2, 1})};
    Surface surface = sample_surface(cubes);
    std::fill(surface.face_body.begin(), surface.face_body.end(), 0);
    const SurfaceAudit audit = audit_surface(surface);
    EXPECT_THAT(texts(audit.problems), IsEmpty());
    ASSERT_EQ(audit.parts.size(), 3u);
    int internal = 0;
    for (const SurfacePart& part : audit.parts) {
        EXPECT_DOUBLE_EQ(part.volume, 1.0);
        for (std::size_t f = 0; f < part.polyhedron.faces.size(); ++f) {
            internal += part.polyhedron.is_internal[f];
            if (part.polyhedron.is_internal[f] != 0) {
                const Plane plane = face_plane(part.polyhedron.vertices, part.polyhedron.faces[f]);
                EXPECT_EQ(plane.normal.z, 0.0);
            }
        }
    }
    EXPECT_EQ(internal, 4) << "two shared faces, each on both of its parts";
}

TEST(SurfaceAudit, SharedFacesMayBeTriangulatedDifferently) {
    Polyhedron left = cube, right = sample_box({1, 0, 0}, {2, 1, 1});
    left.faces[1] = {3, 7, 5, 1};  // the fan of this face begins at another corner: the other diagonal
    Surface surface = sample_surface({left, right});
    std::fill(surface.face_body.begin(), surface.face_body.end(), 0);
    const SurfaceAudit audit = audit_surface(surface);
    EXPECT_THAT(texts(audit.problems), IsEmpty());
    EXPECT_EQ(audit.parts.size(), 2u);
}

TEST(SurfaceAudit, SeparateBodiesThatTouchAreNotFlagged) {
    const SurfaceAudit audit =
        audit_surface(sample_surface({cube, sample_box({1, 0, 0}, {2, 1, 1})}), {.is_one_body = false});
    ASSERT_EQ(audit.parts.size(), 2u);
    EXPECT_THAT(audit.parts[0].polyhedron.is_internal, IsEmpty());
}

TEST(SurfaceAudit, HalfASharedFaceIsRefusedInOneBodyOnly) {
    const Surface surface = sample_surface({cube, sample_box({1, 0.5, 0}, {2, 1.5, 1})});
    EXPECT_THAT(texts(audit_surface(surface).problems),
                ElementsAre(HasSubstr("part 1 and part 2 share a part of a face around (1, 0.75")));
    EXPECT_EQ(audit_surface(surface, {.is_one_body = false}).parts.size(), 2u);
}

TEST(SurfaceAudit, OverlappingAndNestedPartsAreRefused) {
    EXPECT_THAT(texts(audit_surface(sample_surface({cube, sample_box({0.9, 0.2, 0.2}, {2, 0.8, 0.8})})).problems),
                ElementsAre(HasSubstr("part 1 and part 2 overlap by 0.036 m^3 around (0.95")));
    EXPECT_THAT(texts(audit_surface(sample_surface({cube, sample_box({0.2, 0.2, 0.2}, {0.4, 0.4, 0.4})})).problems),
                ElementsAre(HasSubstr("overlap by 0.008 m^3")));
}

TEST(SurfaceAudit, ACavityIsRefused) {
    Polyhedron hole = sample_box({0.2, 0.2, 0.2}, {0.4, 0.4, 0.4});
    for (auto& face : hole.faces) {
        std::reverse(face.begin(), face.end());
    }
    EXPECT_THAT(texts(audit_surface(sample_surface({cube, hole})).problems),
                ElementsAre(AllOf(HasSubstr("is inside out"), HasSubstr("hollow bodies"))));
}

TEST(SurfaceAudit, ABentPolygonIsRefused) {
    Polyhedron bent = cube;
    bent.vertices[7].z = 1.2;
    EXPECT_THAT(texts(audit_surface(sample_surface({bent}, false)).problems),
                Contains(HasSubstr("is not flat: the corner at")));
}

TEST(SurfaceAudit, AnEdgeOfThreeFacesIsNonManifold) {
    Polyhedron winged = cube;
    winged.vertices.push_back({2, 2, 0.5});
    winged.faces.push_back({3, 7, 8});
    EXPECT_THAT(texts(audit_surface(sample_surface({winged}, false)).problems),
                Contains(HasSubstr("non-manifold edge of 3 faces from (1, 1, 0) m to (1, 1, 1) m")));
}

TEST(SurfaceAudit, AMoebiusBandHasOneSide) {
    Polyhedron band;
    constexpr int count = 12;
    for (int i = 0; i < count; ++i) {
        const double a = 2.0 * M_PI * i / count, half = 0.5 * a;
        const Vec3 out{std::cos(a), std::sin(a), 0};
        band.vertices.push_back((1.0 + 0.3 * std::cos(half)) * out + Vec3{0, 0, 0.3 * std::sin(half)});
        band.vertices.push_back((1.0 - 0.3 * std::cos(half)) * out - Vec3{0, 0, 0.3 * std::sin(half)});
    }
    for (int i = 0; i < count; ++i) {
        const int a = 2 * i, b = 2 * i + 1;
        const int c = i + 1 < count ? a + 2 : 1, d = i + 1 < count ? a + 3 : 0;
        band.faces.push_back({a, c, b});
        band.faces.push_back({b, c, d});
    }
    EXPECT_THAT(texts(audit_surface(sample_surface({band}, false)).problems), Contains(HasSubstr("has only one side")));
}

TEST(SurfaceAudit, AStarThatWindsRoundTwiceIsNotConvex) {
    // A pentagram prism is locally convex at every edge of its sides, but its ends are not polygons without crossings.
    Polyhedron star;
    for (int i = 0; i < 10; ++i) {
        const double a = 4.0 * M_PI * (i % 5) / 5.0;
        star.vertices.push_back({std::cos(a), std::sin(a), i < 5 ? 0.0 : 1.0});
    }
    star.faces = {{4, 3, 2, 1, 0}, {5, 6, 7, 8, 9}};
    for (int i = 0; i < 5; ++i) {
        const int j = (i + 1) % 5;
        star.faces.push_back({i, j, j + 5, i + 5});
    }
    EXPECT_THAT(texts(audit_surface(sample_surface({star}, false)).problems), ElementsAre(HasSubstr("is not convex")));
}

TEST(SurfaceAudit, ARealFileGivesNamedPartsInMetres) {
    const SurfaceAudit audit = audit_surface(read_obj(sample_bytes("two_bodies.obj"), "two.obj", 0.1));
    EXPECT_THAT(texts(audit.problems), IsEmpty());
    ASSERT_EQ(audit.parts.size(), 2u);
    EXPECT_EQ(audit.parts[1].name, "\"wedge\"");
    EXPECT_NEAR(audit.parts[0].volume, 1e-3, 1e-15);
    EXPECT_NEAR(audit.parts[1].volume, 0.5e-3, 1e-15);
    const SurfaceAudit small = audit_surface(read_stl(sample_bytes("tetrahedron.stl"), "t.stl", 0.001));
    ASSERT_EQ(small.parts.size(), 1u);
    EXPECT_NEAR(small.parts[0].volume, 1e-6 / 6.0, 1e-18);
}

}  // namespace
}  // namespace riprap::geometry
