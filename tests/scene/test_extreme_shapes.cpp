// SPDX-License-Identifier: Apache-2.0
// Sizes that double precision cannot hold are refused at their place, and the size that the message allows is held.
#include "case_fixture.hpp"

namespace riprap::scene {
namespace {

using namespace test;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

std::string shaped(const std::string& shape) { return with(minimal_case, "{ box = [1.0, 1.0, 0.5] }", shape); }

std::string planar(const std::string& shape) {
    return "dimension = 2\n" + with(shaped(shape), "[0.0, 0.0, -9.81]", "[0.0, -9.81]");
}

std::string on(const std::string& ground) { return shaped(ground) + "fixed = true\n"; }

TEST(ExtremeShapes, sizes_out_of_the_range_of_double_precision_are_refused_where_they_stand) {
    for (const char* shape :
         {"{ sphere = 1e-300 }", "{ sphere = 1e100 }", "{ cube = 1e-110 }", "{ box = [1, 1, 1e300] }",
          "{ wedge = [1, 1, 1e-9] }", "{ wedge = [1, 1, 1e20] }", "{ ellipsoid = [1e-300, 1, 1] }",
          "{ cylinder = { radius = 1, height = 1e300 } }", "{ tetrahedron = 1e-200 }", "{ octahedron = 1e90 }",
          "{ prism = { points = [[0, 0], [1, 0], [0, 1]], height = 1e-30 } }",
          "{ hull = { points = [[0, 0, 0], [1e-99, 0, 0], [0, 1e-99, 0], [0, 0, 1e-99]] } }",
          "{ union = [{ shape = { cube = 1 } }, { shape = { box = [1, 1, 1e-14] }, position = [0, 0, 0.6] }] }"}) {
        EXPECT_THAT(problems_of(shaped(shape)),
                    ElementsAre(AllOf(StartsWith("case.toml:9:"), HasSubstr("out of the range of double precision"),
                                      HasSubstr("extents from 1e-60 to 1e+60 m, each at least 1e-06 of"))))
            << shape;
    }
    for (const char* shape :
         {"{ sphere = 1e-300 }", "{ box = [1, 1e-300] }", "{ cube = 1e200 }", "{ ellipse = [1e-40, 1] }",
          "{ polygon = [[0, 0], [1e300, 0], [0, 1e300]] }", "{ prism = { sides = 6, circumradius = 1e-30 } }"}) {
        EXPECT_THAT(problems_of(planar(shape)),
                    ElementsAre(AllOf(StartsWith("case.toml:10:"), HasSubstr("extents from 1e-6 to 1e6 m"))))
            << shape;
    }
    EXPECT_THAT(problems_of(shaped("{ armour = { unit = \"cube\", nominal_diameter = 1e-90 } }")),
                ElementsAre(AllOf(StartsWith("case.toml:9:"), HasSubstr("from 1e-06 to 1e+60 m"))));
}

TEST(ExtremeShapes, copies_of_scales_out_of_range_are_refused) {
    EXPECT_THAT(problems_of(minimal_case + "repeat = { counts = [2, 1, 1], pitch = [3, 3, 3], scales = [1, 1e-90] }\n"),
                ElementsAre(HasSubstr("out of the range of double precision")));
}

TEST(ExtremeShapes, the_extents_that_are_allowed_are_held) {
    for (const char* shape : {"{ box = [1, 1, 1e-6] }", "{ wedge = [1, 1, 1e-6] }", "{ sphere = 1e-20 }",
                              "{ cylinder = { radius = 1, height = 1e5 } }", "{ tetrahedron = 1e-10 }"}) {
        EXPECT_THAT(problems_of(shaped(shape)), IsEmpty()) << shape;
    }
    for (const char* shape : {"{ sphere = 1e-6 }", "{ box = [1, 1e-6] }", "{ box = [1e6, 1] }"}) {
        EXPECT_THAT(problems_of(planar(shape)), IsEmpty()) << shape;
    }
}

TEST(ExtremeShapes, a_direction_may_have_any_length_but_none) {
    const auto side = [](const std::string& normal) {
        const LoadedCase loaded = read(on("{ half_space = { normal = " + normal + ", offset = 0.5 } }"));
        const geometry::ConvexView view = loaded.model.shapes.view({0});
        return Vec3{view.normal_x[0], view.normal_y[0], view.normal_z[0]};
    };
    const Vec3 plain = side("[0, 3, 4]");
    for (const char* normal : {"[0, 3e-300, 4e-300]", "[0, 3e200, 4e200]", "[0, 3e-160, 4e-160]"}) {
        EXPECT_LT(norm(side(normal) - plain), 1e-15) << normal;
    }
    const LoadedCase turned =
        read(minimal_case + "orientation = { axis_angle = { axis = [1e-300, 0, 0], angle_deg = 90 } }\n");
    EXPECT_NEAR(turned.state.bodies.orientation[0].x, std::sqrt(0.5), 1e-12);
}

TEST(ExtremeShapes, speeds_and_displacements_whose_energy_is_no_number_are_refused_where_they_stand) {
    EXPECT_THAT(problems_of(minimal_case + "velocity = [0, 0, 1e300]\n"),
                ElementsAre(AllOf(StartsWith("case.toml:10:"), HasSubstr("'block' has velocity = (0, 0, 1e+300)"),
                                  HasSubstr("at most 1e+100"))));
    EXPECT_THAT(problems_of(minimal_case + "angular_velocity = [-1e200, 0, 0]\n"),
                ElementsAre(HasSubstr("has angular_velocity = (-1e+200, 0, 0)")));
    EXPECT_THAT(problems_of(minimal_case + "velocity = [0, 0, 1e9]\n"), IsEmpty());
    EXPECT_THAT(
        problems_of(minimal_case +
                    "motion = { table = { time = [0, 1], displacement = [[0, 0, 0], [1e308, 0, 0]] } }\n"),
        ElementsAre(AllOf(StartsWith("case.toml:10:"), HasSubstr("row 2 of the motion is displaced by (1e+308"))));
}

TEST(ExtremeShapes, ground_whose_thickness_leaves_no_volume_is_refused_with_one_that_does) {
    const TemporaryFolder folder;
    folder.write("h.xyz", "0 0 0\n1 0 0.2\n2 0 0\n0 1 0\n1 1 0.1\n2 1 0\n0 2 0\n1 2 0\n2 2 0.3\n");
    folder.write("m.obj", "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 1 1 0.5\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n");
    const auto problems = [&](const std::string& kind, const std::string& thickness) {
        return problems_of(on("{ " + kind + ", thickness = " + thickness + " } }"), {}, folder.path());
    };
    for (const std::string kind : {"terrain = { file = \"h.xyz\"", "mesh = { file = \"m.obj\", units = \"m\""}) {
        for (const char* thickness : {"1e-300", "1e-30", "1e-12"}) {
            EXPECT_THAT(
                problems(kind, thickness),
                ElementsAre(AllOf(StartsWith("case.toml:9:"), HasSubstr("thick under"), HasSubstr("a thickness "))))
                << kind << thickness;
        }
        for (const char* thickness : {"2e-3", "1e-5", "1", "100"}) {
            EXPECT_THAT(problems(kind, thickness), IsEmpty()) << kind << thickness;
        }
    }
    EXPECT_THAT(problems("terrain = { file = \"h.xyz\"", "1e20"), ElementsAre(HasSubstr("a thickness from")));
}

TEST(ExtremeShapes, heights_on_cells_of_no_size_are_refused) {
    const TemporaryFolder folder;
    folder.write("h.asc", "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1e-300\n1 2 3\n1 2 4\n");
    EXPECT_THAT(problems_of(on("{ terrain = { file = \"h.asc\" } }"), {}, folder.path()),
                ElementsAre(StartsWith("case.toml:9:")));
}

TEST(ExtremeShapes, a_step_of_a_profile_of_no_width_is_refused_at_its_point_with_a_width_that_is_held) {
    const auto problems = [](const std::string& step, const std::string& more = "") {
        return problems_of("dimension = 2\n" + with(on("{ terrain = { profile = [[0, 0], [1, 0], [" + step +
                                                       "], [2, 0.5]]" + more + " } }"),
                                                    "[0.0, 0.0, -9.81]", "[0.0, -9.81]"));
    };
    for (const char* step : {"1.0000000001, 0.5", "1.0000000000000002, 0.5", "1.000000000001, -3"}) {
        EXPECT_THAT(problems(step),
                    ElementsAre(AllOf(StartsWith("case.toml:10:"), HasSubstr(": the profile goes from (1, 0) to (1"),
                                      HasSubstr("points at least "))))
            << step;
    }
    EXPECT_THAT(problems("1.000002, 0.5"), IsEmpty());
    EXPECT_THAT(problems("1.5, 0.5", ", thickness = 1e-9"), ElementsAre(HasSubstr("a thickness from 1e-06 to 1 m")));
    EXPECT_THAT(problems("1.5, 0.5", ", thickness = 1e20"), ElementsAre(HasSubstr("a thickness from 1e-06 to 1 m")));
    EXPECT_THAT(problems("1.5, 1e300"), ElementsAre(HasSubstr("steps of at most 1e+06 m")));
    EXPECT_THAT(problems("1.5, 0.5", ", thickness = 2e-6"), IsEmpty());
}

}  // namespace
}  // namespace riprap::scene
