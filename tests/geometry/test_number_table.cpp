// SPDX-License-Identifier: Apache-2.0
// Tables as spreadsheets, programs and people write them: read right, or refused with line and column.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "riprap/geometry/text/number_table.hpp"

namespace riprap::geometry {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TableForm motion() {
    return {{{"t", {"t", "time"}}, {"x", {"x", "dx"}}, {"y", {"y", "dy"}}, {"z", {"z", "dz"}}}, false, 1000, {}};
}

NumberTable read(const std::string& text, const TableForm& form = motion()) {
    return read_number_table(text, "a.csv", form);
}

/// The problem with a table as "file:line:column: ...", empty where it is read.
std::string problem(const std::string& text, const TableForm& form = motion()) {
    try {
        read(text, form);
    } catch (const CaseError& error) {
        return to_string(error.problems().front());
    }
    return "";
}

TEST(NumberTable, a_table_without_heading_begins_with_its_first_row) {
    const NumberTable table = read("0,0,0,0\n0.5,0.1,0,0\n1,0.5,0,0\n");
    ASSERT_EQ(table.row_count(), 3U);
    EXPECT_EQ(table.at(1, 1), 0.1);
    EXPECT_EQ(table.place(1, 1).line, 2U);
    EXPECT_EQ(table.place(1, 1).column, 5U);
    EXPECT_EQ(read("+1e-3,-.5,1E+2,2.\n").at(0, 0), 1e-3);
    EXPECT_EQ(read("\"0\",\"1\",\"2\",\"3\"\n").at(0, 3), 3);
}

TEST(NumberTable, headings_marks_and_line_ends_of_other_programs_change_nothing) {
    for (const std::string text :
         {"t,x,y,z\n0,1,2,3\n1,4,5,6\n", "time [s];x [m];y [m];z [m]\r\n0;1;2;3\r\n1;4;5;6\r\n",
          "\xEF\xBB\xBFt\tx\ty\tz\n0\t1\t2\t3\n1\t4\t5\t6", "# a comment\n0 1 2 3\n\n  1   4 5 6  # the last\n",
          "t, x, y, z,\n0, 1, 2, 3,\n1, 4, 5, 6,\n", "0,1,2,3\r1,4,5,6\r",
          "Shake table, run 7\nt,x,y,z\ns,m,m,m\n0,1,2,3\n1,4,5,6\n", "\"t\",\"x\",\"y\",\"z\"\n0,1,2,3\n1,4,5,6\n",
          "T;X;Y;Z\n0,0;1,0;2,0;3,0\n1,0;4,0;5,0;6,0\n"}) {
        const NumberTable table = read(text);
        EXPECT_THAT(table.values, ElementsAre(0, 1, 2, 3, 1, 4, 5, 6)) << text;
    }
}

TEST(NumberTable, a_comma_is_a_decimal_comma_only_where_it_can_be_nothing_else) {
    EXPECT_EQ(read("0;0,1;0;0\n").at(0, 1), 0.1);
    EXPECT_EQ(read("0 0,1 0 0\n").at(0, 1), 0.1);
    EXPECT_EQ(read("0\t-12,75\t1,5e2\t0\n").at(0, 2), 150);
    EXPECT_THAT(problem("0,5,0,1,0,0\n"), HasSubstr("a.csv:1:9: 6 columns instead of 4"));
    EXPECT_THAT(problem("0;1,234;5,678;0\n"), HasSubstr("a.csv:1:3: \"1,234\" may be a decimal fraction or thousands"));
    EXPECT_EQ(read("0;1,234;0,5;0\n").at(0, 1), 1.234);
    EXPECT_THAT(problem("0;0,5;0;0\n1;0.5;0;0\n"), HasSubstr("a.csv:1:3: \"0,5\" has a comma, and line 2 a point"));
    EXPECT_THAT(problem("0;1.234,5;0;0\n"), HasSubstr("a.csv:1:3: \"1.234,5\" in column 2 is not a finite number"));
}

TEST(NumberTable, columns_are_taken_by_their_names_or_refused) {
    EXPECT_THAT(read("z,y,x,t\n3,2,1,0\n").values, ElementsAre(0, 1, 2, 3));
    const NumberTable table = read("id,t,x,y,z,remark\n7,0,1,2,3,calm\n8,1,4,5,6,\n");
    EXPECT_THAT(table.values, ElementsAre(0, 1, 2, 3, 1, 4, 5, 6));
    EXPECT_THAT(table.notes, ElementsAre(HasSubstr("of 6 columns t,x,y,z are read, by their names")));
    EXPECT_THAT(problem("x,y,z,r\n1,2,3,4\n"), HasSubstr("a.csv:1:1: \"x\" heads column 1"));
    EXPECT_THAT(problem("t,x,x,z\n0,1,2,3\n"), HasSubstr("a.csv:1:5: \"x\" is the second heading of x"));
    EXPECT_EQ(read("A,B,C,D\n0,1,2,3\n").at(0, 1), 1);  // words that say nothing
    EXPECT_THAT(problem("step,north,east,up\n0,1,2,3\n"), HasSubstr("a.csv:1:1: \"step\" heads column 1, where t is"));
}

TEST(NumberTable, what_is_no_number_is_refused_with_line_and_column) {
    EXPECT_THAT(problem("t,x,y,z\n0,0,0,0\n1,1,abc,0\n"), HasSubstr("a.csv:3:5: \"abc\" in column 3"));
    EXPECT_THAT(problem("0,0,0,0\n1,,0,0\n"), HasSubstr("a.csv:2:3: column 2 is empty"));
    EXPECT_THAT(problem("0,0,0,0\n1,0,0\n"), HasSubstr("a.csv:2:5: 3 columns instead of 4"));
    EXPECT_THAT(problem("0,0,0,0\n1,0,0,\n"), HasSubstr("3 columns instead of 4"));
    EXPECT_THAT(problem("0,0,0,0\nend\n"), HasSubstr("a.csv:2:1: \"end\" stands among the rows"));
    EXPECT_THAT(problem("nan,0,0,0\n"), HasSubstr("a.csv:1:1: \"nan\""));
    EXPECT_THAT(problem("0,inf,0,0\n"), HasSubstr("a.csv:1:3: \"inf\""));
    EXPECT_THAT(problem("0,1e999,0,0\n"), HasSubstr("a.csv:1:3:"));
    EXPECT_THAT(problem("0,1D3,0,0\n"), HasSubstr("a.csv:1:3: \"1D3\""));
    EXPECT_THAT(problem("0,0x1F,0,0\n"), HasSubstr("a.csv:1:3:"));
    EXPECT_THAT(problem("0,1 000,0,0\n"), HasSubstr("a.csv:1:"));
    EXPECT_THAT(problem(std::string("\xFF\xFE"
                                    "0\0,\0",
                                    6)),
                HasSubstr("UTF-16"));
    EXPECT_THAT(problem(std::string("0,0,0,\0000\n", 9)), HasSubstr("a.csv:1:7:"));
    TableForm two = motion();
    two.most_rows = 1;
    EXPECT_THAT(problem("0,0,0,0\n1,0,0,0\n", two), HasSubstr("a.csv:2:1: more rows"));
}

TEST(NumberTable, a_file_that_ends_within_its_last_row_is_refused_where_the_rows_above_tell) {
    const std::string rows = "0.00 0.10 0.00 0.15\n1.00 0.20 0.00 0.25\n2.00 0.40 0.00 0.75\n";
    // "12.25" cut to "12.2", "12." and "1": read as another force or way.
    for (const char* cut : {"3.00 0.80 0.00 12.2", "3.00 0.80 0.00 12.", "3.00 0.80 0.00 1", "3.00 0.80 0.00 12.2 "}) {
        EXPECT_THAT(problem(rows + cut), HasSubstr("a.csv:4:16: the last number has fewer digits")) << cut;
    }
    EXPECT_EQ(problem(rows + "3.00 0.80 0.00 12.2\n"), "");
    EXPECT_EQ(problem(rows + "3.00 0.80 0.00 12.25"), "");
    EXPECT_EQ(problem("0 0 0 0.5\n1 1 0 0.75\n2 2 0 0.25\n3 3 0 1"), "");  // written by hand: not alike
    EXPECT_EQ(problem("0 0 0 0.5\n1 1 0 0.5\n2 2 0 1"), "");               // too few to tell

    const std::string named = "t,x,y,z,phase\n0,0,0,1,5\n1,1,0,1,7\n";
    EXPECT_THAT(problem(named + "2,2.5,0,1"), HasSubstr("a.csv:4:9: the last row is shorter than all others"));
    EXPECT_EQ(problem(named + "2,2.5,0,1\n"), "");
    EXPECT_EQ(problem("t,x,y,z,phase\n0,0,0,1\n1,1,0,1,7\n2,2.5,0,1"), "");  // another is as short
}

TEST(NumberTable, units_in_headings_are_given_to_the_reader) {
    TableForm form = motion();
    std::vector<std::string> asked;
    form.unit = [&asked](std::size_t column, std::string_view unit) {
        asked.push_back(std::to_string(column) + std::string(unit));
        return UnitAnswer{unit == "m" || unit == "s" || unit == "mm", true, unit == "mm" ? "numbers in m" : ""};
    };
    read("t [s],x_m,y (m),z/m\n0,1,2,3\n", form);
    EXPECT_THAT(asked, testing::IsSupersetOf({"0s", "1m", "2m", "3m"}));
    for (const std::string heading :
         {"t,x [mm],y,z\n", "t,x_mm,y,z\n", "t,x,y,z\ns,mm,m,m\n", "# t [s], x [mm], y, z\n"}) {
        EXPECT_THAT(problem(heading + "0,1,2,3\n", form), HasSubstr("stands over column x; numbers in m")) << heading;
    }
    EXPECT_THAT(problem("t,x [ell],y,z\n0,1,2,3\n", form),
                HasSubstr("a.csv:1:3: the unit in \"x [ell]\" is not known"));
}

TEST(NumberTable, columns_beyond_those_read_must_not_be_the_first) {
    TableForm places = table_of_places(100);
    places.may_have_more = true;
    EXPECT_THAT(read("0 0 1 9\n1 0 2 9\n0 1 3 9\n", places).values, ElementsAre(0, 0, 1, 1, 0, 2, 0, 1, 3));
    EXPECT_THAT(read("id,x,y,z\n1,0,5,1\n2,1,5,2\n", places).values, ElementsAre(0, 5, 1, 1, 5, 2));
    EXPECT_THAT(problem("1,0,5,1\n2,1,5,2\n", places), HasSubstr("a.csv:1:1: the first of 4 columns counts the rows"));
    EXPECT_THAT(problem("0,5,1,5,14,75\n0,5,2,5,15,75\n", places), HasSubstr("decimal commas?"));
    EXPECT_THAT(problem("0,0,12\n1,0,12,75\n", places), HasSubstr("a.csv:2:8: 4 columns instead of 3"));
    EXPECT_THAT(problem("lon,lat,h\n14.5,46.1,300\n", places),
                HasSubstr("a.csv:1:1: \"lon\" is an angle on the globe"));
}

}  // namespace
}  // namespace riprap::geometry
