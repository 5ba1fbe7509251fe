// SPDX-License-Identifier: Apache-2.0
// Spheres that a case gives a body.
#include <cmath>

#include "case_fixture.hpp"

namespace riprap::scene {
namespace {

using namespace test;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string sphere_case = minimal_case + "SPHERES\n[solid]\nmethod = \"sphere_dem\"\n";
const std::string planar_case = with(with("dimension = 2\n" + sphere_case, "[0.0, 0.0, -9.81]", "[0.0, -9.81]"),
                                     "{ box = [1.0, 1.0, 0.5] }", "{ sphere = 0.5 }");

std::string spheres(const std::string& text) { return with(sphere_case, "SPHERES", "spheres = { " + text + " }"); }

TEST(Spheres, a_list_is_read_about_the_centre_of_mass_in_its_unit) {
    const TemporaryFolder folder;
    folder.write("block.txt", "# x y z radius\n300, 0, 0, 240  # low\n\n700 0 0 240\n");
    const std::string text = with(spheres("file = \"block.txt\", units = \"mm\""), "{ box = [1.0, 1.0, 0.5] }",
                                  "{ union = [{ shape = { box = [1.0, 1.0, 0.5] }, position = [0.5, 0, 0] }] }");
    const LoadedCase loaded = read(text, {}, folder.path().string());
    ASSERT_EQ(loaded.model.spheres.size(), 1U);
    const auto& list = loaded.model.spheres[0].spheres;
    ASSERT_EQ(list.size(), 2U);
    EXPECT_NEAR(list[0].centre.x, -0.2, 1e-12);
    EXPECT_NEAR(list[1].centre.x, 0.2, 1e-12);
    EXPECT_NEAR(list[0].radius, 0.24, 1e-12);
    EXPECT_NEAR(loaded.model.bodies.mass[0], 1250, 1e-9);
}

TEST(Spheres, a_body_weighs_as_its_spheres_where_it_says_so) {
    const TemporaryFolder folder;
    folder.write("ball.txt", "0.1 0 0 0.2\n");
    const std::string text = spheres("file = \"ball.txt\", mass_of = \"spheres\"");
    const LoadedCase loaded = read(text, {}, folder.path().string());
    const double mass = 2500 * 4 / 3.0 * M_PI * std::pow(0.2, 3);
    EXPECT_NEAR(loaded.model.bodies.mass[0], mass, 1e-3 * mass);
    EXPECT_NEAR(loaded.model.bodies.principal_moments[0].x, 0.4 * mass * 0.04, 2e-3 * 0.4 * mass * 0.04);
    EXPECT_NEAR(loaded.state.bodies.position[0].x, 0.1, 1e-9);
    EXPECT_NEAR(loaded.model.bodies.parts[0].local.position.x, -0.1, 1e-9);
    EXPECT_NEAR(norm(loaded.model.spheres[0].spheres[0].centre), 0, 1e-9);
    EXPECT_THAT(loaded.warnings, testing::Contains(HasSubstr("7 % of the volume")));
    const LoadedCase given = read(with(text, "spheres = {", "mass = 3.0\nspheres = {"), {}, folder.path().string());
    EXPECT_NEAR(given.model.bodies.mass[0], 3, 1e-12);
    EXPECT_THAT(given.warnings, testing::Contains(HasSubstr("it weighs what is given, turns as they do")));
}

// A disc of twice the radius weighed eight times as much: its length was scaled, too.
TEST(Spheres, discs_of_other_scales_keep_their_length_of_a_metre) {
    const LoadedCase loaded =
        read(with(planar_case, "SPHERES", "repeat = { counts = [2, 1], pitch = [5, 0], scales = [1.0, 2.0] }"));
    EXPECT_NEAR(loaded.model.bodies.mass[1], 4 * loaded.model.bodies.mass[0], 1e-9);
    EXPECT_NEAR(loaded.model.bodies.principal_moments[1].z, 16 * loaded.model.bodies.principal_moments[0].z, 1e-9);
}

TEST(Spheres, a_list_that_leaves_a_face_bare_is_warned_of) {
    const TemporaryFolder folder;
    folder.write("low.txt", "0.3 0.3 0 0.2\n-0.3 0.3 0 0.2\n0.3 -0.3 0 0.2\n-0.3 -0.3 0 0.2\n");
    const LoadedCase bare = read(spheres("file = \"low.txt\""), {}, folder.path().string());
    EXPECT_THAT(bare.warnings, testing::Contains(HasSubstr("stay 0.05 m behind a face of its shape")));
    EXPECT_THAT(read(spheres("shell = 2")).warnings, testing::Not(testing::Contains(HasSubstr("behind a face"))));
}

TEST(Spheres, shells_lattices_and_rings_are_made_of_the_shape) {
    EXPECT_EQ(read(spheres("shell = 2")).model.spheres[0].spheres.size(), 4U * 4 * 2);
    const auto filled = read(spheres("fill = 0.1")).model.spheres[0].spheres;
    EXPECT_EQ(filled.size(), 10U * 10 * 5 - 8 * 8 * 3);
    const std::string ring = with(planar_case, "SPHERES", "spheres = { ring = 59, ring_radius = 0.02 }");
    const auto around = read(ring).model.spheres[0].spheres;
    ASSERT_EQ(around.size(), 59U);
    EXPECT_NEAR(norm(around[7].centre), 0.48, 1e-12);
    EXPECT_NEAR(norm(around[7].face_normal), 1, 1e-12);
}

TEST(Spheres, copies_have_them_at_their_size) {
    const LoadedCase loaded =
        read(with(sphere_case, "SPHERES",
                  "spheres = { shell = 2 }\nrepeat = { counts = [2, 1, 1], pitch = [5, 0, 0], scales = [1.0, 2.0] }"));
    ASSERT_EQ(loaded.model.spheres.size(), 2U);
    EXPECT_NEAR(loaded.model.spheres[1].spheres[3].radius, 0.25, 1e-12);
    EXPECT_EQ(loaded.model.spheres[1].body, BodyId{1});
}

TEST(Spheres, every_bad_list_is_told_of_at_its_place) {
    const TemporaryFolder folder;
    const auto list = [&](const std::string& text) {
        folder.write("list.txt", text);
        return problems_of(spheres("file = \"list.txt\""), {}, folder.path().string());
    };
    EXPECT_THAT(list("0 0 0 0.2\n0 0 x 0.2\n"),
                ElementsAre(HasSubstr("list.txt:2:5: \"x\" in column 3 is not a finite number")));
    EXPECT_THAT(list("# none\n"),
                ElementsAre(HasSubstr("list.txt:1:1: there is no row of numbers (file of case.toml:10:20)")));
    EXPECT_THAT(list("0 0 0 -0.2\n"), ElementsAre(HasSubstr("sphere 1 has radius -0.2 m")));
    EXPECT_THAT(list("0 0 0 0.2\n0 0 0.05 0.1\n"),
                ElementsAre(HasSubstr("are equal, or one lies inside the other; each sphere once")));
    EXPECT_THAT(list("0 0 0.3 0.2\n"), ElementsAre(HasSubstr("sphere 1 of 'block' has its centre 0.05 m outside")));
    EXPECT_THAT(problems_of(spheres("file = \"none.txt\""), {}, folder.path().string()),
                ElementsAre(HasSubstr("case.toml:10:20")));
    EXPECT_THAT(problems_of(spheres("fill = 0.001")), ElementsAre(HasSubstr("lattice points")));
    EXPECT_THAT(problems_of(spheres("shell = 2, ring_radius = 0.1")),
                ElementsAre(HasSubstr("case.toml:10:38: 'ring_radius' is of a 'ring'")));
    EXPECT_THAT(problems_of(spheres("ring = 5")), ElementsAre(HasSubstr("a ring of spheres is for discs")));
    EXPECT_THAT(problems_of(with(planar_case, "SPHERES", "spheres = { shell = 2 }")),
                ElementsAre(HasSubstr("a shell of spheres is for boxes")));
    EXPECT_THAT(problems_of(with(planar_case, "SPHERES", "spheres = { ring = 9, mass_of = \"spheres\" }")),
                ElementsAre(HasSubstr("no mass per metre of width")));
    EXPECT_THAT(problems_of(spheres("shell = 2"), {"solid.method=\"distance_potential_dem\""}),
                ElementsAre(AllOf(
                    HasSubstr("'block' meets others by its spheres, and this method has no physics for spheres on"),
                    HasSubstr("solid.method = \"sphere_dem\""))));
}

TEST(Spheres, one_that_sticks_out_is_warned_of) {
    const TemporaryFolder folder;
    folder.write("list.txt", "0 0 0.2 0.1\n");
    EXPECT_THAT(read(spheres("file = \"list.txt\""), {}, folder.path().string()).warnings,
                testing::Contains(HasSubstr("sticks out of its shape by 50 % of its radius")));
    EXPECT_THAT(read(spheres("shell = 3")).warnings, IsEmpty());
}

TEST(Spheres, samples_too_many_to_wait_for_are_refused_before_they_are_made) {
    const std::string text = with(sphere_case, "SPHERES", "");
    EXPECT_THAT(
        problems_of(text, {"solid.sphere_radius=0.0001"}),
        ElementsAre(AllOf(HasSubstr("case.toml:7:8: spheres of 0.0001 m for the surface of 'block': a shell of"),
                          HasSubstr("at most 8 million"), HasSubstr("another solid.sphere_radius"))));
    const std::string stone = with(text, "{ box = [1.0, 1.0, 0.5] }", "{ tetrahedron = 1.0 }");
    EXPECT_THAT(problems_of(stone, {"solid.sphere_radius=0.0001"}),
                ElementsAre(AllOf(HasSubstr("samples of radius 0.0001 m"), HasSubstr("at most 8 million"))));
    EXPECT_THAT(
        problems_of(with(sphere_case, "SPHERES", "spheres = { shell = 200 }"), {"body.block.shape.box=[9,9,0.01]"}),
        ElementsAre(HasSubstr("case.toml:10:21: a shell of")));
}

TEST(Spheres, balls_that_start_too_deep_in_each_other_are_refused) {
    const auto apart = [](double distance) {
        const std::string ball =
            with(with(sphere_case, "SPHERES", ""), "{ box = [1.0, 1.0, 0.5] }", "{ sphere = 0.5 }");
        return problems_of(ball + "[[body]]\nname = \"other\"\nmaterial = \"rock\"\nshape = { sphere = 0.5 }\n" +
                           "position = [" + std::to_string(distance) + ", 0, 0]\n");
    };
    EXPECT_THAT(apart(0.85), ElementsAre(AllOf(HasSubstr("block"), HasSubstr("other"))));
    EXPECT_THAT(apart(0.97), IsEmpty());
    EXPECT_THAT(problems_of(with(planar_case, "SPHERES", "") +
                            "[[body]]\nname = \"other\"\nmaterial = \"rock\"\nshape = { sphere = 0.5 }\n"
                            "position = [0.85, 0]\n"),
                ElementsAre(HasSubstr("other")));
}

TEST(Spheres, moduli_that_take_too_many_steps_are_refused) {
    const std::string text = with(sphere_case, "SPHERES", "");
    EXPECT_THAT(problems_of(text, {"solid.youngs_modulus=2e11"}), IsEmpty());
    EXPECT_THAT(problems_of(text, {"solid.youngs_modulus=2e25"}),
                ElementsAre(AllOf(HasSubstr("case.toml:7:8: steps of"), HasSubstr("a lower youngs_modulus"))));
    EXPECT_THAT(problems_of(text, {"solid.normal_law=\"linear\"", "solid.spring_stiffness=1e25"}),
                ElementsAre(HasSubstr("a lower spring_stiffness")));
}

}  // namespace
}  // namespace riprap::scene
