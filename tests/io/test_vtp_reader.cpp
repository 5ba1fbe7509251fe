// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>

#include "io/temporary_folder.hpp"
#include "riprap/io/csv_reader.hpp"
#include "riprap/io/vtk_data.hpp"
#include "riprap/io/vtp.hpp"
#include "riprap/io/vtp_reader.hpp"

namespace riprap::io {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

PolyData square_and_triangle() {
    PolyData data;
    data.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.1, 0.5, 1}};
    data.connectivity = {0, 1, 2, 3, 0, 1, 4};
    data.offsets = {4, 7};
    data.add_cell_array("speed", std::array{1.0F, 2.0F});
    data.add_point_array("tag", std::array<std::int32_t, 5>{1, 2, 3, 4, 5});
    data.add_field_array("body_position", std::array{0.1, 0.2, 0.3}, 3);
    return data;
}

std::string text() { return encode_vtp(square_and_triangle(), 0.1); }

TEST(VtpReader, WhatWasWrittenComesBackToTheLastBit) {
    const VtpFile file(text(), "a.vtp");
    EXPECT_EQ(file.time(), 0.1);
    EXPECT_EQ(file.point_count(), 5U);
    EXPECT_EQ(file.polygon_count(), 2U);
    EXPECT_EQ(file.points()[4], (Vec3{0.1, 0.5, 1}));
    EXPECT_THAT(file.integers(VtpSection::polygons, "connectivity", std::nullopt), ElementsAre(0, 1, 2, 3, 0, 1, 4));
    EXPECT_THAT(file.floats(VtpSection::cell_data, "speed", 2), ElementsAre(1.0F, 2.0F));
    EXPECT_THAT(file.integers(VtpSection::point_data, "tag", 5), ElementsAre(1, 2, 3, 4, 5));
    EXPECT_THAT(file.numbers(VtpSection::field, "body_position", 3), ElementsAre(0.1, 0.2, 0.3));
    EXPECT_FALSE(file.has(VtpSection::point_data, "speed"));
}

TEST(VtpReader, AFileCutAnywhereIsRefusedAndSaysSo) {
    const std::string whole = text();
    for (std::size_t length = 0; length + 2 < whole.size(); length += 7) {
        EXPECT_THROW(VtpFile(whole.substr(0, length), "a.vtp"), FileError) << length;
    }
    EXPECT_THAT([&] { VtpFile(whole.substr(0, whole.size() / 2), "a.vtp"); },
                ThrowsMessage<FileError>(HasSubstr("ends in the middle")));
}

TEST(VtpReader, DamageWithinAnArrayIsRefusedWhenTheArrayIsAskedFor) {
    std::string damaged = text();
    const std::size_t at = damaged.find("Name=\"tag\"");
    const std::size_t content = damaged.find('>', at) + 1;
    for (std::size_t i = content; damaged[i] != '<'; ++i) {
        std::string one = damaged;
        one[i] = one[i] == 'A' ? 'Q' : 'A';
        const VtpFile file(one, "a.vtp");
        try {
            EXPECT_EQ(file.integers(VtpSection::point_data, "tag", 5).size(), 5U);
        } catch (const FileError& error) {
            EXPECT_THAT(error.what(), HasSubstr("a.vtp"));
        }
    }
    EXPECT_THAT([&] { VtpFile(text(), "a.vtp").floats(VtpSection::cell_data, "speed", 3); },
                ThrowsMessage<FileError>(HasSubstr("2 values where 3 are needed")));
    EXPECT_THROW(VtpFile(text(), "a.vtp").floats(VtpSection::cell_data, "heat", 2), FileError);
}

TEST(VtpReader, AHeaderThatPaddingCutsShortIsRefused) {
    EXPECT_THROW(decode_vtk_array("AAAAAAAAAA=="), FileError);  // 7 bytes where the count of blocks takes 8
    std::vector<unsigned char> head(31, 0);                     // 31 where the header of one block takes 32
    head[0] = 1;
    ASSERT_EQ(encode_base64(head).size(), 44U);
    EXPECT_THROW(decode_vtk_array(encode_base64(head)), FileError);
    EXPECT_THROW(decode_vtk_array(""), FileError);
}

TEST(VtpReader, AnArrayThatUnpacksToMoreThanIsExpectedIsRefused) {
    const std::vector<unsigned char> zeros(std::size_t{1} << 20U, 0);
    const std::string packed = encode_vtk_array(zeros);
    ASSERT_LT(packed.size(), zeros.size() / 50);
    EXPECT_EQ(decode_vtk_array(packed, zeros.size()).size(), zeros.size());
    EXPECT_THAT([&] { decode_vtk_array(packed, zeros.size() - 1); },
                ThrowsMessage<FileError>(HasSubstr("unpacks to more than")));
}

TEST(VtpReader, ACountOfPointsBeyondWhatTheFileCanHoldIsRefused) {
    std::string many = text();
    const std::string count = "NumberOfPoints=\"5\"";
    ASSERT_NE(many.find(count), std::string::npos);
    many.replace(many.find(count), count.size(), "NumberOfPoints=\"6148914691236517210\"");  // times 3 is 14
    EXPECT_THAT([&] { VtpFile(many, "a.vtp"); }, ThrowsMessage<FileError>(HasSubstr("more points")));
}

TEST(VtpReader, AForeignFileIsRefused) {
    EXPECT_THROW(VtpFile("", "a.vtp"), FileError);
    EXPECT_THROW(VtpFile("solid cube\nendsolid\n", "a.vtp"), FileError);
    std::string appended = text();
    appended.replace(appended.find("UInt64"), 6, "UInt32");
    EXPECT_THROW(VtpFile(appended, "a.vtp"), FileError);
}

TEST(PvdReader, TheWholeEntriesOfAListThatIsCutAreKept) {
    const TemporaryFolder folder;
    write_pvd(folder / "out.pvd", std::array{PvdFrame{0, "frames/a.vtp"}, PvdFrame{0.25, "frames/b.vtp", 1}});
    ASSERT_EQ(read_pvd(folder / "out.pvd").size(), 2U);
    EXPECT_EQ(read_pvd(folder / "out.pvd")[1].time, 0.25);
    EXPECT_EQ(read_pvd(folder / "out.pvd")[1].file, "frames/b.vtp");
    const std::string whole = read_file(folder / "out.pvd", 1U << 20U);
    std::ofstream(folder / "cut.pvd") << whole.substr(0, whole.find("b.vtp"));
    EXPECT_EQ(read_pvd(folder / "cut.pvd").size(), 1U);
}

TEST(CsvReader, NumbersUnitsAndTextsComeBack) {
    const TemporaryFolder folder;
    std::ofstream(folder / "a.csv") << "time [s],name [-],force.x [N]\n0,\"a, \"\"b\"\"\",\n0.1,c,-2.5e-3\n";
    const CsvTable table = read_csv(folder / "a.csv", "name");
    ASSERT_EQ(table.columns.size(), 3U);
    EXPECT_EQ(table.columns[2].name, "force.x");
    EXPECT_EQ(table.columns[2].unit, "N");
    EXPECT_THAT(table.values[0], ElementsAre(0, 0.1));
    EXPECT_TRUE(std::isnan(table.values[2][0]));
    EXPECT_EQ(table.values[2][1], -2.5e-3);
    EXPECT_THAT(table.texts, ElementsAre("a, \"b\"", "c"));
    EXPECT_FALSE(table.is_cut);
}

TEST(CsvReader, ALastLineThatIsCutIsLeftOut) {
    const TemporaryFolder folder;
    for (const char* last : {"0.2,3", "0.2", "0.2,3,4\n", "\"0.2,3\n"}) {
        std::ofstream(folder / "a.csv") << "time [s],x [m]\n0,1\n0.1,2\n" << last;
        const CsvTable table = read_csv(folder / "a.csv");
        EXPECT_EQ(table.row_count(), 2U) << last;
        EXPECT_TRUE(table.is_cut) << last;
        EXPECT_EQ(table.lost_from, 0U) << last;
    }
}

TEST(CsvReader, ADamagedLineInTheMiddleIsNamedWithWhatFollowsIt) {
    const TemporaryFolder folder;
    std::ofstream(folder / "a.csv") << "time [s],x [m]\n0,1\n0.1\n0.2,3\n";
    const CsvTable table = read_csv(folder / "a.csv");
    EXPECT_EQ(table.row_count(), 1U);
    EXPECT_TRUE(table.is_cut);
    EXPECT_EQ(table.lost_from, 3U);
}

TEST(CsvReader, AForeignTableIsRefused) {
    const TemporaryFolder folder;
    for (const char* text : {"", "time [s]", "x,y\n1,2\n", "\n"}) {
        std::ofstream(folder / "a.csv") << text;
        EXPECT_THROW(read_csv(folder / "a.csv"), FileError) << text;
    }
    EXPECT_THROW(read_csv(folder / "none.csv"), FileError);
}

}  // namespace
}  // namespace riprap::io
