// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <string>

#include "geometry/sample_surfaces.hpp"
#include "riprap/geometry/surface/obj.hpp"
#include "riprap/geometry/surface/stl.hpp"
#include "riprap/geometry/text/text_reader.hpp"

namespace riprap::geometry {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

template <class Read>
std::vector<std::string> problems_of(const Read& read) {
    std::vector<std::string> list;
    try {
        read();
    } catch (const CaseError& error) {
        for (const Diagnostic& problem : error.problems()) {
            list.push_back(to_string(problem));
        }
    }
    return list;
}

std::vector<std::string> stl_problems(const std::string& bytes) {
    return problems_of([&] { read_stl(bytes, "f.stl", 1.0); });
}
std::vector<std::string> obj_problems(const std::string& bytes) {
    return problems_of([&] { read_obj(bytes, "f.obj", 1.0); });
}

TEST(SurfaceReaders, AByteOrderMarkAndBareCarriageReturnsChangeNothing) {
    std::string stl =
        "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
        "endfacet\nendsolid a\n";
    std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\n# a comment\nf 1 2 3\n";
    for (const std::string mark : {"", "\xEF\xBB\xBF"}) {
        for (const char end : {'\n', '\r'}) {
            std::replace(stl.begin(), stl.end(), '\n', end);
            std::replace(obj.begin(), obj.end(), '\n', end);
            EXPECT_EQ(read_stl(mark + stl, "a.stl", 1).face_count(), 1U);
            EXPECT_EQ(read_obj(mark + obj, "a.obj", 1).face_count(), 1U);
        }
        std::replace(stl.begin(), stl.end(), '\r', '\n');
        std::replace(obj.begin(), obj.end(), '\r', '\n');
    }
}

TEST(NumberParsing, TakesCNotationWhateverTheLocale) {
    std::setlocale(LC_ALL, "de_DE.UTF-8");
    EXPECT_EQ(parse_number("1.5"), 1.5);
    EXPECT_EQ(parse_number("+2e-3"), 0.002);
    EXPECT_EQ(parse_number("-.5"), -0.5);
    for (const char* bad : {"", "1,5", "1.5x", "+-1", "++1", "0x10", "1e999", "e5", "--1"}) {
        EXPECT_FALSE(parse_number(bad)) << bad;
    }
    std::setlocale(LC_ALL, "C");
}

TEST(Quote, ShowsHostileBytesHarmlessly) {
    EXPECT_EQ(quote("a\x1b[2J\"\n\xff"), R"("a\x1b[2J\x22\x0a\xff")");
    EXPECT_EQ(quote(std::string(1000, 'a')).size(), 45u);
}

TEST(Stl, AsciiFacetsAreReadInTheUnitsAskedFor) {
    const Surface surface = read_stl(sample_bytes("tetrahedron.stl"), "t.stl", 0.001);
    EXPECT_EQ(surface.face_count(), 4u);
    EXPECT_FALSE(surface.is_binary);
    EXPECT_EQ(surface.vertices[1], (Vec3{0.0, 0.01, 0.0}));
    EXPECT_THAT(surface.body_names, ElementsAre("\"tetrahedron of 10 mm edges\""));
    EXPECT_THAT(surface.face_place, ElementsAre(2u, 9u, 16u, 23u));
    EXPECT_TRUE(surface.notes.empty());
}

TEST(Stl, EverySolidOfAnAsciiFileIsABody) {
    std::string text = sample_bytes("tetrahedron.stl");
    text +=
        "SOLID second\nFACET NORMAL 0 0 0 OUTER LOOP VERTEX 0 0 0 VERTEX 1 0 0\r\nVERTEX 0 1 0 ENDLOOP ENDFACET "
        "ENDSOLID";
    const Surface surface = read_stl(text, "t.stl", 1.0);
    EXPECT_EQ(surface.face_count(), 5u);
    EXPECT_EQ(surface.face_body.back(), 1);
    EXPECT_EQ(surface.body_names[1], "\"second\"");
}

TEST(Stl, ABinaryFileThatBeginsWithSolidIsStillBinary) {
    const std::string bytes =
        binary_stl(sample_surface({sample_box({0, 0, 0}, {1, 2, 3})}), "solid written by a CAD program");
    ASSERT_TRUE(is_binary_stl(bytes));
    const Surface surface = read_stl(bytes, "box.stl", 0.5);
    EXPECT_TRUE(surface.is_binary);
    EXPECT_EQ(surface.face_count(), 12u);
    EXPECT_EQ(surface.vertices[35], (Vec3{0.0, 1.0, 1.5}));
    EXPECT_EQ(surface.face_place[1], 84u + 50u);
}

TEST(Stl, AnAsciiFileIsNeverTakenForBinary) {
    EXPECT_FALSE(is_binary_stl(sample_bytes("tetrahedron.stl")));
    EXPECT_FALSE(is_binary_stl("\n\n  solid x\nendsolid"));
}

TEST(Stl, ATruncatedBinaryFileSaysHowLongItShouldBe) {
    std::string bytes = binary_stl(sample_surface({sample_box({0, 0, 0}, {1, 1, 1})}), std::string("\x01", 1));
    bytes.resize(bytes.size() - 7);
    EXPECT_THAT(stl_problems(bytes),
                ElementsAre(HasSubstr("12 facets stated, which takes 684 bytes, but the file has 677")));
    EXPECT_THAT(stl_problems(std::string("\0\0", 2)), ElementsAre(HasSubstr("2 bytes that are no ASCII STL")));
}

TEST(Stl, ACountOfFourBillionFacetsIsRefusedWithoutAllocating) {
    std::string bytes(84, '\0');
    bytes.replace(80, 4, "\xff\xff\xff\xff");
    EXPECT_THAT(stl_problems(bytes), ElementsAre(HasSubstr("4294967295 facets stated; 1 to 2000000"),
                                                 HasSubstr("takes 214748364834 bytes, but the file has 84")));
}

TEST(Stl, ANonFiniteCoordinateOfABinaryFileIsNamedByItsByte) {
    std::string bytes = binary_stl(sample_surface({sample_box({0, 0, 0}, {1, 1, 1})}));
    bytes.replace(84 + 50 + 12, 4, std::string("\x00\x00\xc0\x7f", 4));      // not a number
    bytes.replace(84 + 2 * 50 + 16, 4, std::string("\x00\x00\x80\xff", 4));  // minus infinity
    EXPECT_THAT(stl_problems(bytes),
                ElementsAre("f.stl: byte 146: nan in facet 2; finite numbers of at most 1e+09 m",
                            "f.stl: byte 200: -inf in facet 3; finite numbers of at most 1e+09 m"));
}

TEST(Stl, AllProblemsOfATextAreReportedAtOnceWithLineAndColumn) {
    EXPECT_THAT(stl_problems(sample_bytes("bad_numbers.stl")),
                ElementsAre(HasSubstr("f.stl:4:18: \"nan\""),                       //
                            HasSubstr("f.stl:5:16: \"1,5\" is no number"),          //
                            HasSubstr("f.stl:12:14: \"inf\""),                      //
                            HasSubstr("f.stl:14:5: \"endloop\" is no number"),      //
                            HasSubstr("f.stl:16:3: \"face\" inside a solid"),       //
                            HasSubstr("f.stl:21:18: \"1e300\" scaled by 1"),        //
                            HasSubstr("f.stl:23:1: the file ends inside a facet"),  //
                            HasSubstr("f.stl:23:1: the file ends inside a solid")));
}

TEST(Stl, AListOfProblemsIsCapped) {
    std::string text = "solid\n";
    for (int i = 0; i < 1000; ++i) {
        text += "rubbish facet\n";
    }
    const auto problems = stl_problems(text);
    EXPECT_EQ(problems.size(), ProblemList::cap + 1);
    EXPECT_THAT(problems.back(), HasSubstr("more problems not listed"));
}

TEST(Stl, AStatedNormalAgainstTheWindingIsANote) {
    std::string text = sample_bytes("tetrahedron.stl");
    text.replace(text.find("0 0 -1"), 6, "0 0 +1");
    const Surface surface = read_stl(text, "t.stl", 1.0);
    ASSERT_EQ(surface.notes.size(), 1u);
    EXPECT_THAT(to_string(surface.notes[0]), HasSubstr("t.stl:2:1: the stated normal of 1 facets, first of face 1"));
}

TEST(Stl, AnEmptyFileAndABadScaleAreRefused) {
    EXPECT_THAT(stl_problems("solid nothing\nendsolid\n"), ElementsAre(HasSubstr("no facets")));
    EXPECT_THAT(stl_problems(""), ElementsAre(HasSubstr("0 bytes")));
    for (const double scale : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
        EXPECT_THROW(read_stl(sample_bytes("tetrahedron.stl"), "t.stl", scale), CaseError);
    }
}

TEST(Obj, PolygonsIndicesAndBodiesAreRead) {
    const Surface surface = read_obj(sample_bytes("two_bodies.obj"), "two.obj", 0.01);
    EXPECT_EQ(surface.vertices.size(), 14u);
    EXPECT_EQ(surface.vertices[9], (Vec3{0.04, 0.0, 0.0}));
    EXPECT_EQ(surface.face_count(), 11u);
    EXPECT_THAT(surface.body_names, ElementsAre("\"cube\"", "\"wedge\""));
    EXPECT_THAT(surface.face(4), ElementsAre(2, 3, 7, 6)) << "a backslash continues the line";
    EXPECT_THAT(surface.face(7), ElementsAre(8, 9, 12)) << "negative indices count back";
    EXPECT_EQ(surface.face_body[6], 1);
    EXPECT_EQ(surface.face_place[6], 30u);
}

TEST(Obj, AllProblemsAreReportedAtOnceWithLineAndColumn) {
    EXPECT_THAT(obj_problems(sample_bytes("bad_faces.obj")),
                ElementsAre(HasSubstr("f.obj:3:7: \"zero\" is no finite number"),           //
                            HasSubstr("f.obj:4:1: a face of 2 corners"),                    //
                            HasSubstr("f.obj:5:7: vertex index \"9\""),                     //
                            HasSubstr("f.obj:6:7: vertex index \"0\""),                     //
                            HasSubstr("f.obj:7:5: texture index \"5\" in corner \"2/5\""),  //
                            HasSubstr("f.obj:8:7: corner \"3/1/1/1\"; v, v/vt, v//vn"),     //
                            HasSubstr("f.obj:9:7: vertex index \"-4\" in corner \"-4\"; 1 to 3 or -3 to -1"),
                            HasSubstr("f.obj:10:1: \"curv\" belongs to free-form curves"),  //
                            HasSubstr("f.obj:11:1: unknown statement \"frobnicate\"")));
}

TEST(Obj, PointsAndLinesAreReportedNotDroppedInSilence) {
    const Surface surface = read_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\np 1\nl 1 2\nf 1 2 3\n", "f.obj", 1.0);
    ASSERT_EQ(surface.notes.size(), 1u);
    EXPECT_THAT(to_string(surface.notes[0]), HasSubstr("f.obj:4:1: 2 points and lines"));
}

TEST(Obj, ABodyNamedAgainGoesOn) {
    const Surface surface =
        read_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\ng a\nf 1 2 3\ng b # comment\nf 1 2 3\ng a\nf 3 2 1", "f.obj", 1.0);
    EXPECT_THAT(surface.face_body, ElementsAre(0, 1, 0));
}

}  // namespace
}  // namespace riprap::geometry
