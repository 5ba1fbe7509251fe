// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "io/temporary_folder.hpp"
#include "riprap/io/csv.hpp"

namespace riprap::io {
namespace {

const std::array columns{CsvColumn{"time", "s"}, CsvColumn{"block.position.z", "m"}};

std::string text_of(const std::filesystem::path& path) { return read_file(path, 1U << 20U); }

TEST(Csv, AHeadingNamesEveryColumnWithItsUnit) {
    EXPECT_EQ(csv_heading(columns), "time [s],block.position.z [m]");
    EXPECT_EQ(csv_heading(std::array{CsvColumn{"a,\"b\"", "-"}}), "\"a,\"\"b\"\" [-]\"");
}

TEST(Csv, ANumberReadsBackAsTheSameDoubleAndAMissingOneIsEmpty) {
    EXPECT_EQ(csv_row(std::array<double, 3>{0.1, NAN, -1e-300}), "0.1,,-1e-300");
    const double third = 1.0 / 3;
    EXPECT_EQ(std::stod(csv_row(std::array{third})), third);
}

TEST(GrowingCsv, AContinuedFileIsCutBackToTheRecordedLength) {
    const TemporaryFolder folder;
    std::uint64_t at_checkpoint = 0;
    {
        GrowingCsv csv(folder / "p.csv", columns);
        csv.add_row(std::array{0.0, 1.0});
        at_checkpoint = csv.bytes();
        csv.add_row(std::array{1.0, 2.0});
        csv.flush(true);
    }
    GrowingCsv csv(folder / "p.csv", columns, at_checkpoint);
    csv.add_row(std::array{1.0, 3.0});
    csv.flush(false);
    EXPECT_EQ(text_of(folder / "p.csv"), "time [s],block.position.z [m]\n0,1\n1,3\n");
    EXPECT_EQ(csv.bytes(), text_of(folder / "p.csv").size());
}

TEST(GrowingCsv, AShortenedOrForeignFileIsNotContinued) {
    const TemporaryFolder folder;
    { GrowingCsv csv(folder / "p.csv", columns); }
    EXPECT_THROW(GrowingCsv(folder / "p.csv", columns, 1000), FileError);
    EXPECT_THROW(GrowingCsv(folder / "missing.csv", columns, 30), FileError);
    write_file(folder / "other.csv", std::string(200, 'x'));
    EXPECT_THROW(GrowingCsv(folder / "other.csv", columns, 100), FileError);
    EXPECT_EQ(text_of(folder / "other.csv").size(), 200U);
}

}  // namespace
}  // namespace riprap::io
