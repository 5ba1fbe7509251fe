// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <numeric>

#include "case_fixture.hpp"
#include "riprap/scene/warnings/initial_overlaps.hpp"

namespace riprap::scene {
namespace {

using namespace test;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

const std::string head = R"(gravity = [0.0, -9.81]
dimension = 2
end = 1.0
[material.rock]
density = 2000.0
normal_stiffness = 1.0e7
[solid]
method = "planar_dda"
)";

double total_mass(const sim::Model& model) {
    return std::accumulate(model.bodies.mass.begin(), model.bodies.mass.end(), 0.0);
}

TEST(Sections, lines_and_joint_sets_cut_a_concave_slope_and_keep_its_mass) {
    const LoadedCase loaded = read(head + R"([[section]]
name = "slope"
material = "rock"
outline = [[0, 0], [30, 0], [30, 20], [12, 20], [6, 5], [0, 5]]
lines = [[[6.5, 2.0], [20.0, 12.0], [31.0, 12.0]]]     # its first end dangles
sliver = 1e-9
fixed_below = 1.5
joint_set = [
  { angle_deg = 34.0, spacing = 2.3, spacing_scatter = 0.3 },
  { angle_deg = 115.0, spacing = 2.9, length = 6.0, bridge = 1.0, origin = [0.0, 0.3] },
]
)");
    EXPECT_GT(loaded.model.bodies.size(), 40);
    EXPECT_GT(loaded.model.bodies.part_count(), loaded.model.bodies.size());  // some are concave
    double area = 0;
    const std::vector<std::array<double, 2>> p{{0, 0}, {30, 0}, {30, 20}, {12, 20}, {6, 5}, {0, 5}};
    for (std::size_t k = 0; k < p.size(); ++k) {
        const auto &a = p[k], &b = p[(k + 1) % p.size()];
        area += 0.5 * (a[0] * b[1] - b[0] * a[1]);
    }
    EXPECT_NEAR(total_mass(loaded.model), 2000 * area, 1e-6);
    EXPECT_TRUE(find_initial_overlaps(loaded.model, loaded.state, 1e-9).empty());
    for (std::size_t i = 0; i < loaded.model.bodies.mass.size(); ++i) {
        EXPECT_EQ(loaded.model.bodies.drive[i] == body::Drive::fixed, loaded.state.bodies.position[i].y < 1.5);
    }
    EXPECT_THAT(loaded.notes, Contains(AllOf(HasSubstr("section 'slope'"), HasSubstr("ends that cut nothing"))));
}

TEST(Sections, a_hole_point_leaves_a_tunnel_and_a_fixed_point_holds_its_block) {
    const LoadedCase loaded = read(head + R"([[section]]
name = "rock"
material = "rock"
outline = [[0, 0], [4, 0], [4, 3], [0, 3]]
lines = [[[0, 1], [4, 1]], [[0, 2], [4, 2]], [[1, 0], [1, 3]], [[3, 0], [3, 3]]]
holes = [[2.0, 1.5]]
fixed_points = [[0.5, 0.5], [3.5, 0.5]]
)");
    ASSERT_EQ(loaded.model.bodies.size(), 8);
    EXPECT_NEAR(total_mass(loaded.model), 2000 * 10, 1e-9);
    for (std::size_t i = 0; i < 8; ++i) {
        const Vec3& x = loaded.state.bodies.position[i];
        EXPECT_FALSE(x.x > 1 && x.x < 3 && x.y > 1 && x.y < 2);
        EXPECT_EQ(loaded.model.bodies.drive[i] == body::Drive::fixed, x.y < 1 && (x.x < 1 || x.x > 3));
    }
}

TEST(Sections, a_geometry_file_gives_its_blocks_and_says_what_was_read) {
    const TemporaryFolder folder;
    folder.write("bar.geo",
                 "0.01\n5 4 0 0 1 1 1 0\n0 0 4 0 1\n4 0 4 1 1\n4 1 0 1 1\n0 1 0 0 1\n2 -1 2 2 1\n1 0.5 1 0.5\n3 0.5\n"
                 "3.5 0.5\n");
    folder.write("bar.ana", "1\n20\n1\n1\n0.006\n0.01\n2000 19620 1000000 0.25\n0 0 0\n0 0 0\n0 0 0\n30.0 10.0 4.0\n");
    const std::string text = head + R"([[section]]
name = "bar"
material = "rock"
geometry = "bar.geo"
analysis = "bar.ana"
)";
    const LoadedCase loaded = read(text, {}, folder.path());
    ASSERT_EQ(loaded.model.bodies.size(), 2);
    EXPECT_EQ(loaded.inputs.size(), 2u);
    EXPECT_THAT(loaded.notes, Contains(HasSubstr("bar.geo: 5 joints, 1 fixed, 1 load, 1 measured")));
    EXPECT_THAT(loaded.notes, Contains(HasSubstr("0 bolts; x 0 to 4, y -1 to 2 m")));
    EXPECT_THAT(loaded.notes, Contains(HasSubstr("measured point (3.5, 0.5) lies in 'bar[")));
    EXPECT_THAT(loaded.warnings, Contains(HasSubstr("friction angle is 30 degrees, the case has 0")));
    EXPECT_THAT(loaded.warnings, Contains(HasSubstr("Young's modulus is 1e+06 Pa")));
    EXPECT_THAT(loaded.warnings, testing::Not(Contains(HasSubstr("unit mass"))));
    // Blocks with a fixed point in them are held, the other one is free.
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(loaded.model.bodies.drive[i] == body::Drive::fixed, loaded.state.bodies.position[i].x < 2);
    }
}

TEST(Sections, loads_of_an_analysis_file_may_vary_in_time) {
    const TemporaryFolder folder;
    folder.write("bar.geo",
                 "0.01\n5 4 0 0 1 1 0 0\n0 0 4 0 1\n4 0 4 1 1\n4 1 0 1 1\n0 1 0 0 1\n2 -1 2 2 1\n1 0.5 1 0.5\n3 0.5\n");
    const auto write = [&](const std::string& records) {
        folder.write("bar.ana", "<DDA><Analysis><Loadpointlist><Loadpoint numpoints=\"3\"> " + records +
                                    " </Loadpoint></Loadpointlist></Analysis></DDA>");
    };
    const std::string text =
        head + "[[section]]\nname = \"bar\"\nmaterial = \"rock\"\ngeometry = \"bar.geo\"\nanalysis = \"bar.ana\"\n";
    write("0 100 -10; 2 300 -10; 4 0 0;");
    const LoadedCase loaded = read(text, {}, folder.path());
    ASSERT_EQ(loaded.model.loads.size(), 1U);
    const body::PointLoad& load = loaded.model.loads[0];
    EXPECT_LT(norm(load.at(1) - Vec3{200, -10, 0}), 1e-12);
    EXPECT_LT(norm(load.at(3) - Vec3{150, -5, 0}), 1e-12);
    EXPECT_EQ(load.at(9), Vec3{});
    EXPECT_THAT(loaded.notes, Contains(HasSubstr("load 0 of the analysis file, 3 rows from 0 s on, acts on 'bar[")));
    EXPECT_THAT(loaded.warnings, testing::Not(Contains(HasSubstr("have no load"))));
    folder.write("bar.ana", "<DDA><Analysis/></DDA>");
    EXPECT_THAT(read(text, {}, folder.path()).warnings,
                Contains(HasSubstr("1 of the 1 load points of the geometry file have no load")));
    write("0 100 -10; 2 300 -10; 1 0 0;");
    EXPECT_THAT(problems_of(text, {}, folder.path()), ElementsAre(HasSubstr("bar.ana:1:79: time 1 does not follow 2")));
}

TEST(Sections, a_load_acts_on_the_block_that_its_point_lies_in_or_on) {
    const std::string section = head + R"([[section]]
name = "rock"
material = "rock"
outline = [[0, 0], [4, 0], [3, 3], [0, 2]]
lines = [[[2, 0], [2, 3]]]
fixed_points = [[3.0, 1.0]]
[[section.load]]
at = [1.0, 2.3333333333333335]        # on the slope of the top
force = [100.0, -2000.0]
start = 0.5
ramp = 2.0
)";
    const LoadedCase loaded = read(section);
    ASSERT_EQ(loaded.model.loads.size(), 1U);
    const body::PointLoad& load = loaded.model.loads[0];
    const auto b = static_cast<std::size_t>(load.body.value);
    EXPECT_LT(loaded.state.bodies.position[b].x, 2);
    EXPECT_LT(norm(loaded.state.bodies.position[b] + load.point - Vec3{1, 7.0 / 3, 0}), 1e-12);
    EXPECT_EQ(load.force, (Vec3{100, -2000, 0}));
    EXPECT_EQ(load.start, 0.5);
    EXPECT_EQ(load.ramp, 2);
    EXPECT_THAT(loaded.notes, Contains(HasSubstr(fmt::format("acts on 'rock[{}]'", b))));
    EXPECT_THAT(problems_of(with(section, "[1.0, 2.3333333333333335]", "[1.0, 2.4]")),
                ElementsAre(AllOf(StartsWith("case.toml:16:6:"), HasSubstr("the load acts on no block"))));
    EXPECT_THAT(problems_of(with(section, "[1.0, 2.3333333333333335]", "[3.0, 1.0]")),
                ElementsAre(HasSubstr("which does not follow forces")));
    EXPECT_THAT(problems_of(section + "stop = 0.25\n"), ElementsAre(HasSubstr("a load from 0.5 s to 0.25 s")));
}

TEST(Sections, bad_input_is_refused_with_its_place) {
    const std::string plain = head + "[[section]]\nname = \"s\"\nmaterial = \"rock\"\n";
    EXPECT_THAT(problems_of(plain + "outline = [[0, 0], [1, 1], [1, 0], [0, 1]]\n"),
                ElementsAre(AllOf(StartsWith("case.toml:12:"), HasSubstr("meet"))));
    EXPECT_THAT(problems_of(plain + "outline = [[0, 0], [1, 0], [1, 1], [0, 1]]\nholes = [[2, 2]]\n"),
                ElementsAre(HasSubstr("the hole at (2, 2) lies in no block")));
    EXPECT_THAT(problems_of(plain + "outline = [[0, 0], [1, 0], [1, 1], [0, 1]]\nfixed_points = [[0.5, -1]]\n"),
                ElementsAre(AllOf(StartsWith("case.toml:9:"), HasSubstr("the fixed point at (0.5, -1) lies in no"))));
    EXPECT_THAT(problems_of(plain + "outline = [[0, 0], [1, 0], [1, 1], [0, 1]]\n"
                                    "lines = [[[0, 0.5], [1, 0.5]], [[0, 0.50001], [1, 0.50001]]]\n"),
                ElementsAre(HasSubstr("sliver")));
    const TemporaryFolder folder;
    folder.write("bad.geo", "0.01\n1 0 0 0 0 0 0 0\n0 0 x 0 1\n");
    EXPECT_THAT(problems_of(plain + "geometry = \"bad.geo\"\n", {}, folder.path()),
                ElementsAre(StartsWith("bad.geo:3:5:")));
    folder.write("open.geo", "0.01\n2 0 0 0 0 0 0 0\n0 0 1 0 1\n1 0 1 1 1\n");
    EXPECT_THAT(problems_of(plain + "geometry = \"open.geo\"\n", {}, folder.path()),
                ElementsAre(HasSubstr("enclose no region")));
    std::string solid = plain + "outline = [[0, 0], [1, 0], [1, 1], [0, 1]]\n";
    solid = with(with(with(solid, "[0.0, -9.81]\ndimension = 2", "[0.0, 0.0, -9.81]"), "[solid]\n", ""),
                 "method = \"planar_dda\"\n", "");
    EXPECT_THAT(problems_of(solid), ElementsAre(HasSubstr("a section in a scene of three dimensions")));
}

}  // namespace
}  // namespace riprap::scene
