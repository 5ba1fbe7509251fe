// SPDX-License-Identifier: Apache-2.0
// Headings that say something else than the reader takes: of another quantity, unit or width.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "riprap/geometry/text/number_table.hpp"

namespace riprap::geometry {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Seconds and metres, and millimetres and feet that are known but not read.
UnitAnswer unit_of(std::size_t column, std::string_view unit) {
    const bool is_time = unit == "s" || unit == "ms", is_length = unit == "m" || unit == "mm" || unit == "ft";
    if (!is_time && !is_length) {
        return {false, false, "numbers in SI"};
    }
    const bool is_its_kind = is_time == (column == 0);
    return {true, is_its_kind, unit == "s" || unit == "m" ? "" : "numbers in SI"};
}

TableForm motion() {
    return {{{"t", {"t", "time"}}, {"x", {"x", "dx", "ux"}}, {"y", {"y", "dy", "uy"}}, {"z", {"z", "dz", "uz"}}},
            false,
            1000,
            unit_of};
}
TableForm spectrum() { return {{{"f", {"f", "frequency"}}, {"S", {"s", "density", "spectrum"}}}, false, 1000, {}}; }
TableForm spheres() {
    TableForm form = table_of_places(1000);
    form.columns.push_back({"radius", {"radius", "r"}});
    return form;
}

std::string problem(const std::string& text, const TableForm& form) {
    try {
        read_number_table(text, "a.csv", form);
    } catch (const CaseError& error) {
        return to_string(error.problems().front());
    }
    return "";
}

TEST(TableHeadings, another_quantity_in_a_heading_is_refused_at_its_cell) {
    EXPECT_THAT(problem("x,y,z,diameter\n0,0,0,1\n", spheres()),
                HasSubstr("a.csv:1:7: \"diameter\" heads column 4, where radius is read; a heading for every column"));
    EXPECT_THAT(problem("x y z d\n0 0 0 1\n", spheres()), HasSubstr("a.csv:1:7: \"d\" heads column 4"));
    EXPECT_THAT(problem("X;Y;Z;D50\n0;0;0;1\n", spheres()), HasSubstr("a.csv:1:7: \"D50\" heads column 4"));
    EXPECT_THAT(problem("# x y z diameter\n0 0 0 1\n", spheres()), HasSubstr("a.csv:1:9: \"diameter\""));
    for (const std::string name : {"omega", "w", "T", "k", "angular frequency", "frequency_step", "period [s]"}) {
        EXPECT_THAT(problem(name + ",S\n0.3,1\n0.4,2\n", spectrum()), HasSubstr("a.csv:1:1: ")) << name;
    }
    EXPECT_THAT(problem("# w S\n0.3 1\n0.4 2\n", spectrum()), HasSubstr("a.csv:1:3: \"w\" heads column 1"));
    for (const std::string names :
         {"t,vx,vy,vz", "t,v_x,v_y,v_z", "t,x velocity,y velocity,z velocity", "t,x_dot,y_dot,z_dot", "t,u,v,w",
          "step,x,y,z", "frame,x,y,z", "time step,x,y,z", "f,x,y,z", "t,ax [m/s^2],ay [m/s^2],az [m/s^2]",
          "t,x,y,depth", "t,roll,pitch,yaw", "step,vx,vy,vz", "t vx vy vz", "t,x,y,theta"}) {
        EXPECT_THAT(problem(names + "\n0,0,0,0\n1,1,1,1\n", motion()), HasSubstr("a.csv:1:")) << names;
    }
    EXPECT_THAT(problem("x,y,depth\n0,0,1\n1,0,1\n", table_of_places(10)),
                HasSubstr("a.csv:1:5: \"depth\" heads column 3, where z is read"));
}

TEST(TableHeadings, usual_names_and_titles_are_read) {
    for (const std::string names :
         {"Time [s],Displacement x [m],Displacement y [m],Displacement z [m]", "t,d_x,d_y,d_z", "t_s,x_m,y_m,z_m",
          "t [s];ux(t);uy(t);uz(t)", "Shake table,run 7\nt,x,y,z", "Run of the third day", "A,B,C,D", "# t x y z",
          "# written on Monday", "t (s),x (m),y (m),z (m) ", "time.s,x.m,y.m,z.m", "t in s,x in m,y in m,z in m",
          "# lengths in mm, as read\nt [s],x [m],y [m],z [m]", "t,x [east],y [north],z [up]"}) {
        EXPECT_EQ(problem(names + "\n0,0,0,0\n1,1,1,1\n", motion()), "") << names;
    }
    EXPECT_EQ(problem("S(f);f\n1;0.3\n", spectrum()), "");
    const std::string turned = "Hochwert;Rechtswert;H\xC3\xB6he\n1;0;5\n2;0;6\n";
    EXPECT_THAT(read_number_table(turned, "a.csv", table_of_places(9)).values, ElementsAre(0, 1, 5, 0, 2, 6));
    EXPECT_THAT(read_number_table("POINT_Y,POINT_X,grid_code\n1,0,5\n", "a.csv", table_of_places(9)).values,
                ElementsAre(0, 1, 5));
}

TEST(TableHeadings, a_heading_of_more_columns_than_the_first_row_is_used_or_refused) {
    TableForm places = table_of_places(10);
    places.may_have_more = true;
    EXPECT_THAT(read_number_table("z,y,x,remark\n3,2,1,\n6,5,4,high\n", "a.csv", places).values,
                ElementsAre(1, 2, 3, 4, 5, 6));
    EXPECT_THAT(problem("y,x,z\n1,2,3,4\n5,6,7,8\n", places),
                HasSubstr("a.csv:1:1: a heading of 3 columns above rows of 4"));
}

TEST(TableHeadings, a_title_of_another_quantity_is_refused_where_no_heading_names_the_columns) {
    for (const std::string title :
         {"Velocity of the table in m/s", "# velocity (m/s)", "ACCELERATION TIME SERIES, UNITS OF G",
          "# Beschleunigung [m/s2]", "Pressure at the wall (Pa)"}) {
        EXPECT_THAT(problem(title + "\n0 0 0 0\n1 1 1 1\n", motion()),
                    HasSubstr("speaks of another quantity than t,x,y,z"))
            << title;
        EXPECT_EQ(problem(title + "\nt x y z\n0 0 0 0\n1 1 1 1\n", motion()), "") << title;
    }
}

TEST(TableHeadings, what_multiplies_or_divides_a_name_must_be_a_unit) {
    for (const std::string heading :
         {"t,x*1000,y,z", "t,x/L,y/L,z/L", "t,x / D,y / D,z / D", "t,x [\"],y [\"],z [\"]"}) {
        EXPECT_THAT(problem(heading + "\n0,0,0,0\n1,1,1,1\n", motion()), HasSubstr("a.csv:1:3: the unit in \"x"))
            << heading;
    }
    EXPECT_EQ(problem("t/s,x/m,y/m,z/m\n0,0,0,0\n1,1,1,1\n", motion()), "");
    EXPECT_EQ(problem("\"t\",\"x\",\"y\",\"z\"\n\"0\",\"0\",\"0\",\"0\"\n1,1,1,1\n", motion()), "");
}

TEST(TableHeadings, a_unit_that_is_not_read_is_refused_wherever_it_stands) {
    for (const std::string heading :
         {"t,x [ell],y,z", "t,x [m],y (cubit),z", "t,x [ft],y,z", "t,x_ft,y,z", "t,x.mm,y.mm,z.mm",
          "t;x, mm;y, mm;z, mm", "t,x in mm,y,z", "# x in mm", "Displacement of the table in mm\nt,x,y,z",
          "# units: mm", "# units=ft\nt,x,y,z", "# Lengths (mm)", "t,x,y,z\n(s),(ell),(m),(m)", "# t in ms, x in m",
          "t ms,x m,y m,z m", "t,Weg x [mm],y,z"}) {
        EXPECT_THAT(problem(heading + "\n0;0;0;0\n1;1;1;1\n", motion()), HasSubstr("numbers in SI")) << heading;
    }
    EXPECT_THAT(problem("t,x [ell],y,z\n0,1,2,3\n", motion()),
                HasSubstr("a.csv:1:3: the unit in \"x [ell]\" is not known; numbers in SI"));
}

TEST(TableHeadings, a_first_row_that_counts_the_others_is_no_point) {
    const std::string cube = "0 0 0\n0 0 3\n0 2 0\n0 2 3\n1 0 0\n1 0 3\n1 2 0\n1 2 3\n";
    EXPECT_THAT(problem("OFF\n8 0 0\n" + cube, table_of_places(99)),
                HasSubstr("a.csv:2:1: 8 rows follow: does the first one count them?"));
    EXPECT_THAT(problem("2 4 1\n" + cube, table_of_places(99)), HasSubstr("a.csv:1:1: 8 rows follow"));  // 2 by 4
    EXPECT_THAT(problem("8,6,12\n0,0,0\n0,0,3\n0,2,0\n0,2,3\n1,0,0\n1,0,3\n1,2,0\n1,2,3\n", table_of_places(99)),
                HasSubstr("8 rows follow"));
    EXPECT_EQ(problem("x y z\n8 0 0\n" + cube, table_of_places(99)), "");  // named: a point
    EXPECT_EQ(problem("8.0 0 0\n" + cube, table_of_places(99)), "");
    EXPECT_EQ(problem("4 0 0\n4 4 0\n0 0 0\n0 4 0\n2 2 3\n", table_of_places(99)), "");  // a pyramid
    EXPECT_EQ(problem("3 0.1\n4 0.2\n5 0.1\n6 0\n", spectrum()), "");
}

TEST(TableHeadings, a_table_without_rows_names_its_file) {
    for (const std::string text : {"", "\xEF\xBB\xBF", "t,x,y,z\n", "# nothing\n"}) {
        EXPECT_THAT(problem(text, motion()),
                    HasSubstr("a.csv:1:1: there is no row of numbers; rows of 4 numbers: t, x"));
    }
}

}  // namespace
}  // namespace riprap::geometry
