// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <array>
#include <cmath>
#include <utility>

#include "io/temporary_folder.hpp"
#include "riprap/io/csv.hpp"
#include "riprap/io/csv_reader.hpp"

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

std::string problem_of(const std::filesystem::path& path) {
    try {
        read_record(path);
    } catch (const FileError& error) {
        return error.what();
    }
    return "none";
}

TEST(CsvReader, AFieldThatIsNoNumberIsNamedWithItsLineAndColumn) {
    const TemporaryFolder folder;
    const auto problem = [&](const std::string& rows) {
        write_file(folder / "p.csv", "time [s],x [m]\n" + rows);
        return problem_of(folder / "p.csv");
    };
    EXPECT_EQ(problem("0,1\n1,\n2,nan\n"), "none");
    EXPECT_EQ(problem("0,1\n1,2"), "none");  // a run may be writing it
    EXPECT_THAT(problem("0,1\n1,x2\n"), testing::HasSubstr("line 3, column 2 is \"x2\", where a number should be"));
    EXPECT_THAT(problem("0,1\n1,2 \n"), testing::HasSubstr("line 3, column 2"));
    EXPECT_THAT(problem("0,1\n-1,2\n"), testing::HasSubstr("the time in line 3 is -1, which does not follow"));
    EXPECT_THAT(problem("0,1\n,2\n"), testing::HasSubstr("the time in line 3"));
    write_file(folder / "b.csv", "time [s],name [-],mass [kg]\n0,stone,1\n0,wall,2\n");
    EXPECT_THAT(read_csv(folder / "b.csv", "name").texts, testing::ElementsAre("stone", "wall"));
    EXPECT_THROW(read_csv(folder / "b.csv"), FileError);
}

TEST(CsvReader, ATableThatIsShorterThanItsCheckpointKnowsIsDamaged) {
    const TemporaryFolder folder;
    write_file(folder / "p.csv", csv_heading(columns) + "\n0,1\n1,2\n");
    const std::uint64_t bytes = text_of(folder / "p.csv").size();
    EXPECT_NO_THROW(require_table(folder / "p.csv", columns, bytes));
    EXPECT_THROW(require_table(folder / "p.csv", columns, bytes + 1), FileError);
    EXPECT_THROW(require_table(folder / "p.csv", std::array{columns[1], columns[0]}, bytes), FileError);
    EXPECT_THROW(require_table(folder / "q.csv", columns, bytes), FileError);
    EXPECT_THROW(require_table(folder.path(), columns, 0), FileError);
    ASSERT_EQ(::mkfifo((folder / "f").c_str(), 0600), 0);
    EXPECT_THROW(require_table(folder / "f", columns, 0), FileError);  // and does not wait for a writer
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
    std::filesystem::create_directory(folder / "folder.csv");
    for (const auto& [name, why] :
         {std::pair{"missing.csv", "missing"}, std::pair{"folder.csv", "not a regular file"}}) {
        try {
            GrowingCsv(folder / name, columns, 30);
            ADD_FAILURE() << name << " is continued";
        } catch (const FileError& error) {
            EXPECT_THAT(error.what(), testing::HasSubstr(std::string("it is ") + why +
                                                         "; put the file back or start again with --force"));
        }
    }
    write_file(folder / "other.csv", std::string(200, 'x'));
    EXPECT_THROW(GrowingCsv(folder / "other.csv", columns, 100), FileError);
    EXPECT_EQ(text_of(folder / "other.csv").size(), 200U);
}

}  // namespace
}  // namespace riprap::io
