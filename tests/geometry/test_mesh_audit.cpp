// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "riprap/geometry/surface/mesh_audit.hpp"
#include "riprap/geometry/surface/mesh_facts.hpp"
#include "riprap/geometry/surface/obj.hpp"

namespace riprap::geometry {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* corners =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n";  // lines 1 to 8
const std::vector<std::string> quads{"4 3 2 1", "5 6 7 8", "1 2 6 5", "2 3 7 6", "3 4 8 7", "4 1 5 8"};

std::string faces(const std::vector<std::string>& list = quads) {
    std::string text;
    for (const std::string& face : list) {
        text += "f " + face + '\n';
    }
    return text;
}

struct Looked {
    TriangleMesh mesh;
    MeshAudit audit;
    MeshFacts facts;
};

Looked look_at(const std::string& obj) {
    const Surface surface = read_obj(obj, "m.obj", 1);
    Looked looked{mesh_of(surface), {}, {}};
    looked.audit = audit_mesh(looked.mesh, surface);
    looked.facts = facts_of(looked.mesh, {0, 0, 1});
    return looked;
}

TEST(MeshAudit, AFaceThatWindsAgainstItsNeighboursIsNamedWithItsLine) {
    EXPECT_THAT(look_at(corners + faces()).audit.problems, IsEmpty());
    for (std::size_t k = 0; k < quads.size(); ++k) {
        std::vector<std::string> turned = quads;
        turned[k] = {quads[k].rbegin(), quads[k].rend()};
        const auto problems = look_at(corners + faces(turned)).audit.problems;
        ASSERT_EQ(problems.size(), 4U) << k;  // at its four edges
        EXPECT_THAT(problems[0].message, HasSubstr(fmt::format("face {}", k + 1)));
        EXPECT_THAT(problems[0].message, HasSubstr("wind opposite ways"));
        EXPECT_TRUE(problems[0].place.file == "m.obj" && problems[0].place.line >= 9U);
    }
}

TEST(MeshAudit, WallsThatMeetInAJunctionAreNoError) {
    EXPECT_THAT(
        look_at(std::string("v 0 0 0\nv 0 0 1\nv 1 0 0\nv -1 0 0\nv 0 1 0\n") + faces({"1 3 2", "1 2 4", "1 2 5"}))
            .audit.problems,
        IsEmpty());
}

TEST(MeshAudit, FacesThatRepeatOthersAreLeftOutAndThoseBackToBackRefused) {
    std::vector<std::string> twice = quads;
    twice.insert(twice.end(), quads.begin(), quads.end());
    const Looked doubled = look_at(corners + faces(twice));
    EXPECT_THAT(doubled.audit.problems, IsEmpty());
    EXPECT_THAT(doubled.audit.warnings,
                ElementsAre(HasSubstr("12 of 24 triangles, the first of face 7, repeat others and are left out")));
    EXPECT_EQ(doubled.mesh.size(), 12);
    EXPECT_EQ(doubled.mesh.corners, look_at(corners + faces()).mesh.corners);
    const auto problems = look_at(corners + faces({"1 2 3", "3 2 1"})).audit.problems;
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_THAT(problems[0].message, HasSubstr("face 2 lies on face 1 back to back"));
    EXPECT_EQ(problems[0].place.line, 10U);
}

TEST(MeshAudit, APolygonThatIsNotConvexIsFilledAndOneThatCrossesItselfRefused) {
    // The fan of an L from the corner where it was begun had a triangle outside of it, upside down.
    const std::string ell = "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\n";
    for (const std::string face : {"1 2 3 4 5 6", "6 1 2 3 4 5", "3 4 5 6 1 2", "2 3 4 5 6 1"}) {
        const Looked looked = look_at(ell + "f " + face + "\n");
        EXPECT_THAT(looked.audit.problems, IsEmpty());
        ASSERT_EQ(looked.mesh.size(), 4) << face;
        double area = 0;
        for (std::int32_t t = 0; t < 4; ++t) {
            EXPECT_GT(looked.mesh.area_normal(t).z, 0) << face;
            area += looked.mesh.area_normal(t).z / 2;
        }
        EXPECT_NEAR(area, 3, 1e-12) << face;
    }
    const auto problems = look_at("v 0 0 0\nv 2 2 0\nv 2 0 0\nv 0 1 0\nf 1 2 3 4\n").audit.problems;
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_THAT(problems[0].message, HasSubstr("face 1 is no polygon"));
}

TEST(MeshAudit, CracksAreToldAndRimsAreNot) {
    const std::string sheet = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    EXPECT_THAT(look_at(sheet + faces({"1 2 3", "1 3 4"})).audit.warnings, IsEmpty());
    // The second triangle has points of its own, a ten millionth beside those of the first, then a hundredth.
    for (const std::string off : {"1e-7", "0.01"}) {
        EXPECT_THAT(
            look_at(sheet + "v " + off + " 0 0\nv 1 1 " + off + "\n" + faces({"1 2 3", "5 6 4"})).audit.warnings,
            ElementsAre(HasSubstr("2 of its 6 rims lie within 0.1 m of others")));
    }
    EXPECT_THAT(look_at(sheet + "v 0.3 0 0\nv 1 1 0.3\n" + faces({"1 2 3", "5 6 4"})).audit.warnings, IsEmpty());
}

TEST(MeshFacts, SayWhereTheSolidIsAndLeaveOutPointsThatNoFaceUses) {
    EXPECT_THAT(text_of(look_at(std::string(corners) + "v 55 -55 55\n" + faces()).facts),
                AllOf(HasSubstr("x 0 to 1, y 0 to 1, z 0 to 1 m; 12 triangles in 1 part, closed, solid inside;")));
    std::vector<std::string> inwards;
    for (const std::string& quad : quads) {
        inwards.emplace_back(quad.rbegin(), quad.rend());
    }
    EXPECT_THAT(text_of(look_at(corners + faces(inwards)).facts), HasSubstr("closed, solid outside;"));
    const std::vector<std::string> tank(quads.begin() + 2, quads.end());  // four upright walls
    EXPECT_THAT(text_of(look_at(corners + faces(tank)).facts), HasSubstr("1 hole, rims 8 m long;"));
    EXPECT_THAT(text_of(look_at(corners + faces({"5 6 7 8"})).facts), HasSubstr("no holes, rim 4 m long, facing +z;"));
    EXPECT_THAT(text_of(look_at(corners + faces({"8 7 6 5"})).facts), HasSubstr("no holes, rim 4 m long, facing -z;"));
}

}  // namespace
}  // namespace riprap::geometry
