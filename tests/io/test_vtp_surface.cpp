// SPDX-License-Identifier: Apache-2.0
// Surfaces in the files of other programs: tests/data/vtk holds the same two faces as VTK writes them in its layouts.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "riprap/io/atomic_file.hpp"
#include "riprap/io/vtp.hpp"
#include "riprap/io/vtp_surface.hpp"

namespace riprap::io {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

const std::filesystem::path layouts = std::filesystem::path(RIPRAP_SOURCE_DIR) / "tests/data/vtk";

std::string refusal(std::string_view bytes) {
    try {
        read_vtp_surface(bytes, "a.vtp", 1);
    } catch (const CaseError& error) {
        return error.problems().at(0).message;
    }
    return "";
}

std::string with(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

void expect_square_and_triangle(const geometry::Surface& surface) {
    ASSERT_THAT(surface.vertices, SizeIs(5));
    ASSERT_EQ(surface.face_count(), 2U);
    EXPECT_THAT(surface.face(0), ElementsAre(0, 1, 2, 3));
    EXPECT_THAT(surface.face(1), ElementsAre(0, 1, 4));
    EXPECT_NEAR(surface.vertices[4].x, 0.1, 1e-8);  // some files have floats
    EXPECT_EQ(surface.vertices[4].z, 1);
}

TEST(VtpSurface, EveryLayoutOfVtkHoldsTheSameFaces) {
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(layouts)) {
        if (entry.path().extension() == ".vtp") {
            SCOPED_TRACE(entry.path().filename().string());
            expect_square_and_triangle(read_vtp_surface(read_file(entry.path(), 1 << 20), "a.vtp", 1));
            ++files;
        }
    }
    EXPECT_EQ(files, 6);
}

TEST(VtpSurface, WhatRiprapWritesIsOneAndTheScaleCounts) {
    PolyData data;
    data.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
    data.connectivity = {0, 1, 2};
    data.offsets = {3};
    const geometry::Surface surface = read_vtp_surface(encode_vtp(data, 0.1), "a.vtp", 0.01);
    EXPECT_EQ(surface.vertices.at(2), (Vec3{0.01, 0.01, 0}));
    EXPECT_THAT(surface.face(0), ElementsAre(0, 1, 2));
}

TEST(VtpSurface, EveryTruncationAndDamageIsRefusedOrReadWithoutHarm) {
    for (const auto& entry : std::filesystem::directory_iterator(layouts)) {
        const std::string whole = read_file(entry.path(), 1 << 20);
        const std::size_t end = std::min(whole.find("</Polys>"), whole.size());
        for (std::size_t size = 0; size < end; size += 7) {
            EXPECT_NE(refusal(std::string_view(whole).substr(0, size)), "") << entry.path() << " cut at " << size;
        }
        for (std::size_t at = 0; at < whole.size(); at += 5) {
            std::string damaged = whole;
            damaged[at] = static_cast<char>(damaged[at] ^ 0x15);
            refusal(damaged);
        }
    }
}

TEST(VtpSurface, WhatIsNoSurfaceIsNamed) {
    const std::string text = read_file(layouts / "ascii.vtp", 1 << 20);
    EXPECT_THAT(refusal("solid cube"), HasSubstr("no VTK file with polygons"));
    EXPECT_THAT(refusal(with(text, "\"PolyData\"", "\"ImageData\"")), HasSubstr("no VTK file with polygons"));
    EXPECT_THAT(refusal(with(text, "LittleEndian", "BigEndian")), HasSubstr("BigEndian"));
    EXPECT_THAT(refusal(with(text, "NumberOfPolys=\"2\"", "NumberOfPolys=\"3\"")), HasSubstr("promises"));
    EXPECT_THAT(refusal(with(text, "NumberOfPoints=\"5\"", "NumberOfPoints=\"4\"")), HasSubstr("more values"));
    EXPECT_THAT(refusal(with(text, "NumberOfStrips=\"0\"", "NumberOfStrips=\"1\"")), HasSubstr("Triangulate"));
    EXPECT_THAT(refusal(with(text, "NumberOfPoints=\"5\"", "NumberOfPoints=\"99999999999\"")), HasSubstr("at most"));
}

TEST(VtpSurface, ProblemsNameTheLineAndColumnOfTheirElement) {
    const std::string text = read_file(layouts / "ascii.vtp", 1 << 20);
    const auto place = [](const std::string& damaged) {
        try {
            read_vtp_surface(damaged, "a.vtp", 1);
        } catch (const CaseError& error) {
            const SourcePlace at = error.problems().at(0).place;
            return at.file + ":" + std::to_string(at.line) + ":" + std::to_string(at.column);
        }
        return std::string();
    };
    EXPECT_EQ(place(with(text, "NumberOfPolys=\"2\"", "NumberOfPolys=\"3\"")), "a.vtp:4:5");
    EXPECT_EQ(place(with(text, "1 1 0 0 1 0", "1 1 0 0 x 0")), "a.vtp:12:7");
    EXPECT_EQ(place("solid cube"), "a.vtp:1:1");
    std::string unnamed = text;  // the polygons have no offsets
    unnamed.replace(unnamed.rfind("Name=\"offsets\""), 14, "Name=\"ends\"");
    EXPECT_EQ(place(unnamed), "a.vtp:45:7");
}

}  // namespace
}  // namespace riprap::io
