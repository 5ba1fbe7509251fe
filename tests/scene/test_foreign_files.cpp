// SPDX-License-Identifier: Apache-2.0
// Tables, heights and surfaces of other programs in a case: read right, or refused or told with their place.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstring>

#include "case_fixture.hpp"

namespace riprap::scene {
namespace {

using namespace test;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

std::string with_shape(const std::string& shape) { return with(minimal_case, "{ box = [1.0, 1.0, 0.5] }", shape); }

/// Problems of a table as a motion or a load of the block, in space or in a plane.
std::vector<std::string> problems_of_table(const std::string& table, bool is_load, bool is_planar) {
    const TemporaryFolder folder;
    folder.write("t.csv", table);
    const std::string entry =
        is_load ? "[[body.load]]\ntable = { file = \"t.csv\" }\n" : "motion = { table = { file = \"t.csv\" } }\n";
    const std::string text = is_planar
                                 ? "dimension = 2\n" + with(with(minimal_case, "[0.0, 0.0, -9.81]", "[0.0, -9.81]"),
                                                            "{ box = [1.0, 1.0, 0.5] }", "{ box = [1.0, 1.0] }")
                                 : minimal_case;
    return problems_of(text + entry, {}, folder.path());
}

// A turn beside displacements, a couple beside forces and what leaves a plane were left out without a word.
TEST(ForeignTables, turns_couples_and_what_leaves_the_plane_are_not_left_out_in_silence) {
    for (const std::string name : {"theta", "rz", "rot_z [rad]", "roll", "phi [deg]", "yaw", "angle (deg)", "qw"}) {
        EXPECT_THAT(problems_of_table("t,x,y,z," + name + "\n0,0,0,0,0\n1,0.1,0,0,0.5\n", false, false),
                    ElementsAre(AllOf(StartsWith("t.csv:3:11: \"0.5\" in the column \"" + name + "\""),
                                      HasSubstr("motion = { rotation = { ... } }"))))
            << name;
        EXPECT_THAT(problems_of_table("t,x,y,z," + name + "\n0,0,0,0,0\n1,0.1,0,0,0.0\n", false, false), IsEmpty());
    }
    for (const std::string name : {"M", "Mz [Nm]", "moment", "Torque", "couple z"}) {
        EXPECT_THAT(problems_of_table("t,Fx,Fy,Fz," + name + "\n0,100,0,0,7\n1,100,0,0,7\n", true, false),
                    ElementsAre(AllOf(StartsWith("t.csv:2:11: \"7\" in the column"), HasSubstr("two forces"))))
            << name;
    }
    EXPECT_THAT(problems_of_table("t,x,y,rot_z\n0,0,0,0\n1,0.1,0,0.5\n", false, false),
                ElementsAre(StartsWith("t.csv:1:7: \"rot_z\" heads column 4, where z is read")));
    EXPECT_THAT(problems_of_table("t,x,y,theta\n0,0,0,0\n1,0.1,0,0.5\n", false, true),
                ElementsAre(StartsWith("t.csv:3:9: \"0.5\" in the column \"theta\"")));
    EXPECT_THAT(problems_of_table("t,Fx,Fy,M\n0,100,0,0\n1,100,0,7\n", true, true),
                ElementsAre(StartsWith("t.csv:3:9: \"7\" in the column \"M\"")));
    EXPECT_THAT(problems_of_table("t;x;y;z\n0;0;0;0\n1;0,1;0;0,2\n", false, true),
                ElementsAre(AllOf(StartsWith("t.csv:3:9: \"0,2\" in the column \"z\""), HasSubstr("no z"))));
    EXPECT_THAT(problems_of_table("t,x,y,z\n0,0,0,0\n1,0.1,0,0\n", false, true), IsEmpty());
    EXPECT_THAT(problems_of_table("i,t,x,y,z,quality\n1,0,0,0,0,9\n2,1,0.1,0,0,9\n", false, false), IsEmpty());
}

TEST(ForeignTables, every_reader_takes_a_table_with_and_without_heading) {
    const TemporaryFolder folder;
    const auto motion = [&](const std::string& table) {
        folder.write("t.csv", table);
        return std::get<body::TableMotion>(
            read(minimal_case + "motion = { table = { file = \"t.csv\" } }\n", {}, folder.path())
                .model.bodies.motions.at(0)
                .law);
    };
    for (const std::string table : {"t,x,y,z\n0,0,0,0\n0.5,0.1,0,0\n", "0,0,0,0\n0.5,0.1,0,0\n",
                                    "0;0;0;0\n0,5;0,1;0;0\n", "0 0 0 0\n0.5 0.1 0 0\n"}) {
        EXPECT_THAT(motion(table).time, ElementsAre(0, 0.5)) << table;
        EXPECT_EQ(motion(table).displacement[1].x, 0.1) << table;
    }
    for (const std::string table :
         {"0,2500,0,0\n1,2500,0,0\n", "t [s],Fx [N],Fy [N],Fz [N]\n0,2500,0,0\n1,2500,0,0\n"}) {
        folder.write("t.csv", table);
        const LoadedCase loaded =
            read(minimal_case + "[[body.load]]\ntable = { file = \"t.csv\" }\n", {}, folder.path());
        EXPECT_EQ(loaded.model.loads.at(0).at(0.5).x, 2500) << table;
        EXPECT_EQ(loaded.model.loads.at(0).at(0).x, 2500) << table;
    }
    for (const std::string table : {"0,0,0\n1,0,0\n0,1,0\n0,0,1\n", "x,y,z\n0,0,0\n1,0,0\n0,1,0\n0,0,1\n"}) {
        folder.write("t.csv", table);
        const LoadedCase loaded = read(with_shape("{ hull = { file = \"t.csv\", units = \"m\" } }"), {}, folder.path());
        EXPECT_NEAR(loaded.model.bodies.mass[0], 2500.0 / 6, 1e-9) << table;
    }
    std::vector<double> strokes;
    for (const std::string table : {"f,S\n0.4,0\n0.6,1e-3\n0.8,2e-4\n1.2,0\n", "0.4,0\n0.6,1e-3\n0.8,2e-4\n1.2,0\n"}) {
        folder.write("t.csv", table);
        const LoadedCase loaded =
            read(minimal_case +
                     "motion = { wave_maker = { wave = \"irregular\", depth = 0.5, spectrum_file = \"t.csv\" } }\n",
                 {}, folder.path());
        strokes.push_back(std::get<body::SplineMotion>(loaded.model.bodies.motions.at(0).law).stroke.back());
    }
    EXPECT_EQ(strokes[0], strokes[1]);
}

TEST(ForeignTables, a_heading_in_other_units_or_orders_is_refused_at_its_cell) {
    const TemporaryFolder folder;
    const auto problem = [&](const std::string& table) {
        folder.write("t.csv", table);
        return problems_of(minimal_case + "motion = { table = { file = \"t.csv\" } }\n", {}, folder.path());
    };
    EXPECT_THAT(problem("t [s],x [mm],y [mm],z [mm]\n0,0,0,0\n"),
                ElementsAre(StartsWith("t.csv:1:7: \"x [mm]\" stands over column x (file of case.toml:")));
    EXPECT_THAT(problem("t [ms],x,y,z\n0,0,0,0\n"),
                ElementsAre(StartsWith("t.csv:1:1: \"t [ms]\" stands over column t")));
    EXPECT_THAT(problem("t [m],x,y,z\n0,0,0,0\n"), ElementsAre(HasSubstr("numbers in s")));
    EXPECT_THAT(problem("x,y,z,t\n0,0,0,0\n"), IsEmpty());  // by their names
    EXPECT_THAT(problem("0,0,0,0\n0,1,0,0\n"), ElementsAre(StartsWith("t.csv:2:1: time 0 does not follow 0")));
    folder.write("t.csv", "x [mm],y [mm],z [mm]\n0,0,0\n1000,0,0\n0,1000,0\n0,0,1000\n");
    EXPECT_THAT(problems_of(with_shape("{ hull = { file = \"t.csv\", units = \"mm\" } }"), {}, folder.path()),
                IsEmpty());
    EXPECT_THAT(problems_of(with_shape("{ hull = { file = \"t.csv\", units = \"m\" } }"), {}, folder.path()),
                ElementsAre(StartsWith("t.csv:1:1:")));
}

TEST(ForeignTables, units_and_quantities_that_are_not_read_are_refused_by_every_reader) {
    const TemporaryFolder folder;
    const auto motion = [&](const std::string& heading) {
        folder.write("t.csv", heading + "\n0,0,0,0\n1,1,1,1\n");
        return problems_of(minimal_case + "motion = { table = { file = \"t.csv\" } }\n", {}, folder.path());
    };
    EXPECT_THAT(motion("t [s],x [ft],y [ft],z [ft]"),
                ElementsAre(AllOf(StartsWith("t.csv:1:7: \"x [ft]\" stands over column x"),
                                  HasSubstr("numbers in m: those in ft times 0.3048"))));
    for (const std::string heading :
         {"t,x [in],y,z", "t,x [inches],y,z", "t,x_yd,y,z", "t,x [mi],y,z", "t,x [furlong],y,z", "t [min],x,y,z",
          "t [d],x,y,z", "# x in mm", "Displacement in feet", "t [s],x [m/s],y,z", "t,x_m/s,y_m/s,z_m/s",
          "t,x [MM],y,z", "t,x [\xC2\xB5m],y,z", "t,vx,vy,vz"}) {
        EXPECT_THAT(motion(heading), ElementsAre(HasSubstr("t.csv:1:"))) << heading;
    }
    for (const std::string heading :
         {"t [sec],x [metres],y [M],z [meter]", "Time (seconds),x (m),y (m),z (m a.s.l.)", "T [S],X [M],Y [M],Z [M]",
          "t [s],x [-],y [-],z [-]", "Zeit [s],Weg x [m],Weg y [m],Weg z [m]"}) {
        EXPECT_THAT(motion(heading), IsEmpty()) << heading;
    }
    const auto force = [&](const std::string& heading) {
        folder.write("t.csv", heading + "\n0,1,1,1\n1,1,1,1\n");
        return problems_of(minimal_case + "[[body.load]]\ntable = { file = \"t.csv\" }\n", {}, folder.path());
    };
    EXPECT_THAT(force("t,Fx [kip],Fy [kip],Fz [kip]"), ElementsAre(HasSubstr("those in kip times 4448.221615")));
    EXPECT_THAT(force("t,Fx [lbf],Fy [lbf],Fz [lbf]"), ElementsAre(HasSubstr("those in lbf times 4.448221615")));
    EXPECT_THAT(force("t,Fx [kgf],Fy [kgf],Fz [kgf]"), ElementsAre(HasSubstr("those in kgf times 9.80665")));
    for (const std::string heading : {"t,Fx_t,Fy_t,Fz_t", "t,Fx_kg,Fy_kg,Fz_kg", "t,Fx [lb],Fy,Fz", "t,Mx,My,Mz",
                                      "# Forces in kN", "t,Fx [daN],Fy,Fz", "t,Fx,Fy"}) {
        EXPECT_THAT(force(heading), testing::SizeIs(1)) << heading;
    }
    EXPECT_THAT(force("t,Fx [newtons],Fy [N],Fz (N)"), IsEmpty());
    const auto sea = [&](const std::string& heading) {
        folder.write("t.csv", heading + "\n0.4,0\n0.6,1e-3\n0.8,2e-4\n1.2,0\n");
        return problems_of(
            minimal_case +
                "motion = { wave_maker = { wave = \"irregular\", depth = 0.5, spectrum_file = \"t.csv\" } }\n",
            {}, folder.path());
    };
    for (const std::string heading : {"f [Hz],S [m\xC2\xB2/Hz]", "f [1/s],S [m2s]", "freq (Hz),PSD (m^2/Hz)",
                                      "f [s-1],S [m^2 s]", "frequency,E(f)"}) {
        EXPECT_THAT(sea(heading), IsEmpty()) << heading;
    }
    for (const std::string heading :
         {"omega,S", "w,S", "T,S", "f [rad/s],S", "f,S [ft^2/Hz]", "f [Hz],S [cm2/Hz]", "k [1/m],S", "f [rpm],S"}) {
        EXPECT_THAT(sea(heading), ElementsAre(HasSubstr("t.csv:1:"))) << heading;
    }
}

/// A case with ground from a file under a cube.
std::string on_ground(const std::string& shape) {
    return R"(gravity = [0, 0, -9.81]
end = 0.3
[material.rock]
density = 2500
normal_stiffness = 1e7
[[body]]
name = "ground"
material = "rock"
fixed = true
shape = )" +
           shape + "\n";
}

TEST(ForeignHeights, are_told_with_extent_holes_and_precision) {
    const TemporaryFolder folder;
    std::string text;
    for (int j = 0; j < 5; ++j) {
        for (int i = 0; i < 5; ++i) {
            text += i == 2 && j == 2 ? "" : fmt::format("{};{};{},5\n", 432150 + i, 5103420 + j, 10 + i);
        }
    }
    folder.write("h.csv", text);
    const LoadedCase loaded =
        read(on_ground("{ terrain = { file = \"h.csv\", origin = [432150, 5103420, 0] } }"), {}, folder.path());
    EXPECT_THAT(
        loaded.warnings,  // what bodies fall through is said by a run too
        Contains(HasSubstr("h.csv: 5 by 5 points 1 by 1 m apart, 1 without height, the first at (432152, 5103422)")));
    EXPECT_THAT(loaded.notes, Contains(HasSubstr("x 0 to 4, y 0 to 4, z 10.5 to 14.5 m; 28 triangles in 1 part, 1 "
                                                 "hole, rims 26.24 m long, facing +z; steepest 45 deg")));
    EXPECT_THAT(loaded.notes, Contains(HasSubstr("up to 14.5 m from the origin, where double precision resolves")));
}

TEST(ForeignHeights, a_cut_to_nothing_says_why_and_nodata_makes_holes) {
    const TemporaryFolder folder;
    std::string text;
    for (int j = 0; j < 6; ++j) {
        for (int i = 0; i < 6; ++i) {
            text += fmt::format("{} {} {}\n", 10 * i, 10 * j, i == 2 && j == 3 ? 0 : 400 + 30 * i + 15 * j);
        }
    }
    folder.write("h.xyz", text);
    const auto problem = [&](const std::string& more) {
        return problems_of(on_ground("{ terrain = { file = \"h.xyz\"" + more + " } }"), {}, folder.path());
    };
    EXPECT_THAT(problem(""), ElementsAre(AllOf(StartsWith("h.xyz:21:7: a height of 0 m"), HasSubstr("nodata = 0"))));
    EXPECT_THAT(problem(", nodata = \"none\""), IsEmpty());
    EXPECT_THAT(read(on_ground("{ terrain = { file = \"h.xyz\", nodata = 0 } }"), {}, folder.path()).warnings,
                Contains(HasSubstr("1 without height, the first at (20, 30): no ground in the cells around them")));
    EXPECT_THAT(problem(", nodata = 0, resolution = 1e-6"),
                ElementsAre(HasSubstr("a resolution of 1e-06 m makes 2.5e+15 heights of 50 by 50 m; at most 4000000")));
    EXPECT_THAT(problem(", nodata = 0, region = [[60, 60], [70, 70]]"),
                ElementsAre(HasSubstr("the region holds no ground: heights go from (0, 0) to (50, 50)")));
}

TEST(ForeignHeights, ground_at_map_coordinates_is_the_ground_at_the_origin) {
    const TemporaryFolder folder;
    const auto heights = [](double x, double y) {
        std::string text;
        for (int j = 0; j < 6; ++j) {
            for (int i = 0; i < 6; ++i) {
                text += fmt::format("{} {} {}\n", x + 0.5 * i, y + 0.5 * j, 0.1 * ((3 * i + 5 * j) % 4));
            }
        }
        return text;
    };
    folder.write("near.xyz", heights(0, 0));
    folder.write("far.xyz", heights(432150, 5103420));
    const LoadedCase near = read(on_ground("{ terrain = { file = \"near.xyz\" } }"), {}, folder.path());
    const LoadedCase far =
        read(on_ground("{ terrain = { file = \"far.xyz\" } }\nposition = [-432150, -5103420, 0]"), {}, folder.path());
    ASSERT_EQ(near.model.bodies.part_count(), far.model.bodies.part_count());
    for (std::size_t p = 0; p < near.model.bodies.parts.size(); ++p) {
        const body::Part &a = near.model.bodies.parts[p], &b = far.model.bodies.parts[p];
        const Vec3 at_a = near.state.bodies.position[0] + a.local.position,
                   at_b = far.state.bodies.position[0] + b.local.position;
        EXPECT_LT(norm(at_a - at_b), 1e-8);
        EXPECT_NEAR(near.model.shapes.volume(a.shape), far.model.shapes.volume(b.shape), 1e-12);
    }
}

/// The triangles of a wavy square of n by n cells as text, with corners counted from (x, y).
std::string wavy_stl(int n, double x, double y) {
    std::string text = "solid ground\n";
    const auto corner = [&](int i, int j) {
        return fmt::format("vertex {:.6f} {:.6f} {:.6f}\n", x + i, y + j,
                           0.2 * std::sin(1.3 * i) + 0.1 * std::cos(1.9 * j));
    };
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            for (const auto& [a, b] :
                 {std::pair(corner(i + 1, j), corner(i + 1, j + 1)), {corner(i + 1, j + 1), corner(i, j + 1)}}) {
                text += "facet normal 0 0 1\nouter loop\n" + corner(i, j) + a + b + "endloop\nendfacet\n";
            }
        }
    }
    return text + "endsolid\n";
}

TEST(ForeignSurfaces, a_mesh_at_map_coordinates_is_the_mesh_at_the_origin) {
    const TemporaryFolder folder;
    folder.write("near.stl", wavy_stl(6, 0, 0));
    folder.write("far.stl", wavy_stl(6, 432150.25, 5103420.5));
    const std::string mesh = "{ mesh = { file = \"near.stl\", units = \"m\", thickness = 1 } }";
    const LoadedCase near = read(on_ground(mesh), {}, folder.path());
    const LoadedCase far =
        read(on_ground(with(mesh, "near", "far")) + "position = [-432150.25, -5103420.5, 0]\n", {}, folder.path());
    EXPECT_THAT(near.notes, Contains(HasSubstr("72 triangles in 1 part, no holes")));
    EXPECT_THAT(
        far.notes,
        Contains(HasSubstr("far.stl: up to 5.103e+06 m from the origin, where double precision resolves 1.1e-09 m")));
    EXPECT_THAT(far.warnings, Not(Contains(HasSubstr("nothing of the solid"))));
    ASSERT_EQ(near.model.bodies.part_count(), 72);
    ASSERT_EQ(far.model.bodies.part_count(), 72);
    for (std::size_t p = 0; p < 72; ++p) {
        const body::Part &a = near.model.bodies.parts[p], &b = far.model.bodies.parts[p];
        const Vec3 at_a = near.state.bodies.position[0] + a.local.position,
                   at_b = far.state.bodies.position[0] + b.local.position;
        EXPECT_LT(norm(at_a - at_b), 2e-8);
        EXPECT_NEAR(near.model.shapes.volume(a.shape), far.model.shapes.volume(b.shape), 1e-7);
    }
}

/// The corners of a cube as a binary STL, in single precision.
std::string binary_cube(double edge, const Vec3& low) {
    const std::array<std::array<int, 3>, 12> faces{{{0, 2, 3},
                                                    {0, 3, 1},
                                                    {4, 5, 7},
                                                    {4, 7, 6},
                                                    {0, 1, 5},
                                                    {0, 5, 4},
                                                    {2, 6, 7},
                                                    {2, 7, 3},
                                                    {0, 4, 6},
                                                    {0, 6, 2},
                                                    {1, 3, 7},
                                                    {1, 7, 5}}};
    std::string bytes(84, '\0');
    bytes[80] = 12;
    for (const auto& face : faces) {
        std::array<float, 12> numbers{};
        for (std::size_t k = 0; k < 3; ++k) {
            const int c = face[k];
            const Vec3 x = low + edge * Vec3{static_cast<double>(c & 1), static_cast<double>(c >> 1 & 1),
                                             static_cast<double>(c >> 2)};
            for (int axis = 0; axis < 3; ++axis) {
                numbers[3 + 3 * k + static_cast<std::size_t>(axis)] = static_cast<float>(x[axis]);
            }
        }
        bytes.append(reinterpret_cast<const char*>(numbers.data()), 48);
        bytes.append(2, '\0');
    }
    return bytes;
}

TEST(ForeignSurfaces, a_block_of_single_precision_that_stands_askew_is_read) {
    // It was refused as out of the range of double precision: its faces are plane to single precision only.
    const TemporaryFolder folder;
    const std::string shape = with_shape("{ stl = { file = \"cube.stl\", units = \"m\" } }");
    const std::string straight = binary_cube(1.3, {0.1, 0.2, 0.3});
    for (const double angle : {0.3, 0.7, 1.1}) {
        std::string turned = straight;
        for (std::size_t corner = 96; corner < turned.size(); corner += (corner - 84) % 50 == 36 ? 26 : 12) {
            std::array<float, 3> x{};
            std::memcpy(x.data(), turned.data() + corner, 12);
            const double c = std::cos(angle), s = std::sin(angle), u = x[0], v = x[1], w = x[2];
            const double y = s * u + c * v;
            x = {static_cast<float>(c * u - s * v), static_cast<float>(c * y - s * w),
                 static_cast<float>(s * y + c * w)};
            std::memcpy(turned.data() + corner, x.data(), 12);
        }
        folder.write("cube.stl", turned);
        const LoadedCase loaded = read(shape, {}, folder.path());
        EXPECT_NEAR(loaded.model.bodies.mass[0], 2500 * 1.3 * 1.3 * 1.3, 1e-2) << angle;
        EXPECT_THAT(loaded.notes, Contains(HasSubstr("beside the planes of their faces, and are put into them")));
    }
    folder.write("cube.stl", straight);
    EXPECT_THAT(read(shape, {}, folder.path()).notes, Not(Contains(HasSubstr("put into them"))));
}

TEST(ForeignSurfaces, a_mesh_whose_faces_wind_opposite_ways_is_refused_with_its_place) {
    const TemporaryFolder folder;
    const std::string scene = on_ground("{ mesh = { file = \"m.obj\", units = \"m\", thickness = 0.5 } }");
    const std::string corners = "v 0 0 0\nv 9 0 0\nv 9 9 0\nv 0 9 0\n";
    folder.write("m.obj", corners + "f 1 2 3\nf 1 4 3\n");
    EXPECT_THAT(problems_of(scene, {}, folder.path()),
                ElementsAre(AllOf(StartsWith("m.obj:6:1: face 1 and face 2, which share the edge"),
                                  HasSubstr("wind opposite ways"))));
    folder.write("m.obj", corners + "f 1 2 3\nf 1 3 4\nf 1 3 4\n");
    EXPECT_THAT(read(scene, {}, folder.path()).warnings, Contains(HasSubstr("1 of 3 triangles, the first of face 3")));
}

TEST(ForeignTables, files_of_other_kinds_are_named) {
    const TemporaryFolder folder;
    using namespace std::string_literals;
    for (const auto& [bytes, what] : {std::pair("\x1F\x8B\x08\0\0"s, "is compressed (gzip); the file unpacked"),
                                      {"PK\x03\x04"s, "is an archive (zip)"},
                                      {"\xFF\xFE"
                                       "0\0"s,
                                       "is text in UTF-16; UTF-8 or plain ASCII"},
                                      {"0\0,\0"
                                       "0\0,\0"s,
                                       "is text in UTF-16"},
                                      {"II*\0\x08"s, "is an image (TIFF)"},
                                      {"\xD0\xCF\x11\xE0"s, "is a workbook (.xls)"}}) {
        folder.write("t.csv", bytes);
        folder.write("t.stl", bytes);
        EXPECT_THAT(problems_of(minimal_case + "motion = { table = { file = \"t.csv\" } }\n", {}, folder.path()),
                    ElementsAre(HasSubstr("file \"t.csv\" "s + what)));
        EXPECT_THAT(problems_of(with_shape("{ stl = { file = \"t.stl\", units = \"m\" } }"), {}, folder.path()),
                    ElementsAre(HasSubstr("file \"t.stl\" "s + what)));
    }
    // Whatever the head of a binary STL says, its length tells it.
    std::string bytes = binary_cube(1.3, {0.1, 0.2, 0.3});
    bytes.replace(0, 4, "PK\x03\x04");
    folder.write("t.stl", bytes);
    EXPECT_THAT(problems_of(with_shape("{ stl = { file = \"t.stl\", units = \"m\" } }"), {}, folder.path()), IsEmpty());
}

TEST(ForeignHeights, in_degrees_over_metres_are_warned_of) {
    const TemporaryFolder folder;
    std::string heights;
    for (int j = 0; j < 5; ++j) {
        for (int i = 0; i < 5; ++i) {
            heights += fmt::format("{} {} {}\n", 7.5 + 0.01 * i, 47.3 + 0.01 * j, 0.1 * i * j + 0.3 * i + 0.2 * j);
        }
    }
    folder.write("h.xyz", heights);
    const std::string terrain = "{ terrain = { file = \"h.xyz\", thickness = 0.5 } }";
    EXPECT_THAT(read(on_ground(terrain), {}, folder.path()).warnings,
                Contains(HasSubstr("of the ground is steeper than 80 degrees: are x and y in another unit than z")));
}

TEST(ForeignTables, what_was_read_is_told) {
    const TemporaryFolder folder;
    folder.write("t.csv", "0;0;1,5;0\n0,5;-0,25;1,5;2\n");
    EXPECT_THAT(read(minimal_case + "motion = { table = { file = \"t.csv\" } }\n", {}, folder.path()).notes,
                Contains("t.csv: 2 rows; t 0 to 0.5 s, x -0.25 to 0 m, y 1.5 m, z 0 to 2 m"));
    folder.write("t.csv", "0,0,0\n1000,0,0\n0,1000,0\n0,0,500\n");
    EXPECT_THAT(read(with_shape("{ hull = { file = \"t.csv\", units = \"mm\" } }"), {}, folder.path()).notes,
                Contains("t.csv: 4 rows; x 0 to 1 m, y 0 to 1 m, z 0 to 0.5 m"));
}

TEST(ForeignSurfaces, single_precision_far_from_the_origin_is_told_or_refused) {
    const TemporaryFolder folder;
    const std::string shape = with_shape("{ stl = { file = \"cube.stl\", units = \"m\" } }");
    folder.write("cube.stl", binary_cube(1.3, {0.1, 0.2, 0.3}));
    const LoadedCase near = read(shape, {}, folder.path());
    EXPECT_NEAR(near.model.bodies.mass[0], 2500 * 1.3 * 1.3 * 1.3, 1e-2);
    EXPECT_THAT(near.warnings, IsEmpty());
    folder.write("cube.stl", binary_cube(1.3, {4321.1, 8765.7, 0.3}));  // rounded to a millimetre
    EXPECT_THAT(read(shape, {}, folder.path()).warnings,
                Contains(HasSubstr("are rounded to 0.00098 m in the file, where edges are 1.3 m long")));
    folder.write("cube.stl", binary_cube(1.3, {432151.1, 5103421.7, 0.3}));  // to half a metre
    EXPECT_THAT(problems_of(shape, {}, folder.path()),
                ElementsAre(AllOf(StartsWith("cube.stl: coordinates up to 5.10342e+06 m are rounded to 0.5 m"),
                                  HasSubstr("(file of case.toml:"))));
    folder.write("cube.stl", binary_cube(8, {432152, 5103424, 0}));  // as exact as at the origin
    const LoadedCase exact = read(shape, {}, folder.path());
    EXPECT_NEAR(exact.model.bodies.mass[0], 2500 * 512, 1e-6);
    EXPECT_NEAR(exact.state.bodies.position[0].y, 5103428, 1e-8);
}

TEST(ForeignSurfaces, solids_that_do_not_touch_are_told_to_move_as_one) {
    const TemporaryFolder folder;
    const auto cubes = [](const std::vector<double>& places) {
        std::string text;
        int first = 1;
        for (const double x : places) {
            text += fmt::format("o at{}\n", first);
            for (int c = 0; c < 8; ++c) {
                text += fmt::format("v {} {} {}\n", x + (c & 1), c >> 1 & 1, c >> 2);
            }
            for (const std::array<int, 4> f :
                 {std::array{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
                text += fmt::format("f {} {} {} {}\n", first + f[0], first + f[1], first + f[2], first + f[3]);
            }
            first += 8;
        }
        return text;
    };
    const auto warnings = [&](const std::vector<double>& places) {
        folder.write("cubes.obj", cubes(places));
        return read(with_shape("{ obj = { file = \"cubes.obj\", units = \"m\" } }"), {}, folder.path()).warnings;
    };
    EXPECT_THAT(warnings({0, 2, 4, 6, 8, 10, 12, 14}),
                Contains(HasSubstr("the 8 closed solids of cubes.obj do not touch and move as one rigid body")));
    EXPECT_THAT(warnings({0, 1, 5, 6}), Contains(HasSubstr("the 2 closed solids")));
    EXPECT_THAT(warnings({0, 1, 2}), IsEmpty());
    EXPECT_THAT(warnings({0}), IsEmpty());
}

}  // namespace
}  // namespace riprap::scene
