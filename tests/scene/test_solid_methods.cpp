// SPDX-License-Identifier: Apache-2.0
#include "case_fixture.hpp"
#include "riprap/body/locks.hpp"

namespace riprap::scene {
namespace {

using namespace test;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(SolidMethods, planar_dda_refuses_a_scene_in_space_at_its_word) {
    EXPECT_THAT(problems_of(minimal_case + "[solid]\nmethod = \"planar_dda\"\n"),
                ElementsAre("case.toml:11:10: planar DDA moves polygons in the x-y plane, and this scene has three "
                            "dimensions; dimension = 2"));
}

TEST(SolidMethods, three_dimensional_dda_refuses_bodies_of_several_parts_at_their_name) {
    const std::string two =
        "{ union = [{ shape = { cube = 1.0 } }, { shape = { cube = 1.0 }, position = [1, 0, 0] }] }";
    const std::string text = with(minimal_case, "{ box = [1.0, 1.0, 0.5] }", two);
    EXPECT_THAT(problems_of(text), IsEmpty());
    for (const std::string method : {"explicit_dda", "implicit_dda"}) {
        EXPECT_THAT(problems_of(text, {"solid.method=" + method}),
                    ElementsAre(HasSubstr("case.toml:7:8: 'block' has several parts")));
    }
}

TEST(SolidMethods, degrees_of_freedom_are_locked_of_free_rigid_bodies_alone) {
    const std::string text = minimal_case + "locked = [\"x\", \"rotation\"]\n";
    EXPECT_THAT(problems_of(text), IsEmpty());
    EXPECT_EQ(locks_of(read(text).model.bodies, 0).bits, 0x39);
    for (const std::string method : {"explicit_dda", "implicit_dda"}) {
        EXPECT_THAT(problems_of(text, {"solid.method=" + method}),
                    ElementsAre(HasSubstr("case.toml:7:8: this method locks no degrees of freedom of a body; leave out "
                                          "'locked', or solid.method = \"distance_potential_dem\"")));
    }
    EXPECT_THAT(problems_of(text + "velocity = [1, 0, 0]\n"),
                ElementsAre(HasSubstr("case.toml:10:10: body 'block' starts with a velocity that is locked")));
    EXPECT_THAT(problems_of(text + "motion = { linear = { velocity = [0, 1, 0] } }\n"),
                ElementsAre(HasSubstr("body 'block' has a motion, which says all of its freedoms")));
    EXPECT_THAT(problems_of(minimal_case + "locked = [\"x\", \"y\", \"z\", \"rotation\"]\n"),
                ElementsAre(HasSubstr("body 'block' cannot move at all; fixed = true")));
}

const std::string planar_case = R"(dimension = 2
gravity = [0.0, -9.81]
end = 1.0
[material.rock]
density = 2500.0
normal_stiffness = 1.0e7
[solid]
method = "planar_dda"
[[body]]
name = "block"
material = "rock"
shape = { box = [1.0, 1.0] }
[[body]]
name = "roof"
material = "rock"
shape = { box = [1.0, 1.0] }
position = [0.0, 2.0]
fixed = true
)";
TEST(SolidMethods, a_planar_body_has_three_degrees_of_freedom_to_lock) {
    const std::string rigid = with(planar_case, "planar_dda", "distance_potential_dem");
    EXPECT_THAT(
        problems_of(with(rigid, "name = \"roof\"", "locked = [\"rotation_x\"]\nname = \"roof\"")),
        ElementsAre(HasSubstr("case.toml:14:10: nothing moves along 'rotation_x' in a scene with dimension = 2; x, "
                              "y, rotation_z")));
}

const std::string bolt_lines = R"([[bolt]]
bodies = ["block", "roof"]
ends = [[0.0, 0.5], [0.0, 1.5]]
stiffness = 1e6
)";

TEST(SolidMethods, a_contact_stiffness_beyond_what_blocks_can_carry_is_refused_at_its_key) {
    for (const std::string method : {"explicit_dda", "implicit_dda"}) {
        const std::string text = minimal_case + "[solid]\nmethod = \"" + method + "\"\nyoungs_modulus = 1e9\n";
        EXPECT_THAT(problems_of(text + "contact_stiffness = 1e12\n"), IsEmpty());
        EXPECT_THAT(problems_of(text + "contact_stiffness = 1e18\n"),
                    ElementsAre(AllOf(HasSubstr("case.toml:13:21:"), HasSubstr("contact_stiffness is 1e+18 N/m"),
                                      HasSubstr("at most"))));
    }
    const std::string planar =
        with(planar_case, "[[body]]", "youngs_modulus = 1e9\ncontact_stiffness = 1e18\n[[body]]");
    EXPECT_THAT(problems_of(planar),
                testing::Contains(AllOf(HasSubstr("case.toml:10:21:"), HasSubstr("contact_stiffness is 1e+18 N/m"))));
}

// Story: a stiffness of 1 N/m was taken, and blocks sank through the ground without a word.
TEST(SolidMethods, a_contact_stiffness_that_carries_no_block_is_refused_at_its_key) {
    for (const std::string method : {"explicit_dda", "implicit_dda"}) {
        EXPECT_THAT(problems_of(minimal_case + "[solid]\nmethod = \"" + method + "\"\ncontact_stiffness = 1.0\n"),
                    ElementsAre(AllOf(HasSubstr("case.toml:12:21: contact_stiffness is 1 N/m"),
                                      HasSubstr("'block' sinks in by more than its radius"), HasSubstr("at least"))));
    }
    // 2500 kg a metre over the radius of the cube that stands for a square of 1 m
    const auto with_stiffness = [](const char* value) {
        return with(planar_case, "[[body]]", std::string("contact_stiffness = ") + value + "\n[[body]]");
    };
    EXPECT_THAT(problems_of(with_stiffness("28e3")), ElementsAre(HasSubstr("at least 2.83e+04 N/m")));
    EXPECT_THAT(problems_of(with_stiffness("29e3")), IsEmpty());
}

TEST(SolidMethods, contacts_have_a_stiffness_of_a_point_or_per_area) {
    for (const std::string method : {"explicit_dda", "implicit_dda"}) {
        const std::string text = minimal_case + "[solid]\nmethod = \"" + method + "\"\nyoungs_modulus = 1e9\n";
        EXPECT_THAT(problems_of(text + "contact_stiffness_per_area = \"1e9 Pa/m\"\n"), IsEmpty());
        EXPECT_THAT(problems_of(text + "contact_stiffness_per_area = 1e9\ncontact_stiffness = 1e7\n"),
                    ElementsAre(AllOf(HasSubstr("case.toml:13:30:"), HasSubstr("a stiffness of a point and one per"))));
        EXPECT_THAT(problems_of(text + "contact_stiffness_per_area = 1e5\n"),
                    ElementsAre(AllOf(HasSubstr("case.toml:13:30: contact_stiffness_per_area is 1e+05 Pa/m"),
                                      HasSubstr("'block' sinks in by more than its radius"))));
        EXPECT_THAT(problems_of(text + "contact_stiffness_per_area = 1e18\n"), ElementsAre(HasSubstr("1e6 E/r")));
        EXPECT_THAT(problems_of(with(text, "normal_stiffness", "shear_stiffness = 1e6\nnormal_stiffness") +
                                "contact_stiffness_per_area = 1e9\n"),
                    ElementsAre(HasSubstr("beside a shear stiffness of 1e+06 N/m of a point")));
    }
    EXPECT_THAT(problems_of(with(planar_case, "[[body]]", "contact_stiffness_per_area = 1e9\n[[body]]")),
                ElementsAre(HasSubstr("contact_stiffness_per_area")));
}

TEST(SolidMethods, sliding_ends_by_reversal_or_by_a_slip_in_a_step) {
    const std::string text = minimal_case + "[solid]\nmethod = \"implicit_dda\"\n";
    EXPECT_THAT(problems_of(text + "slide_tolerance = \"0.1 mm\"\n"), IsEmpty());
    EXPECT_THAT(problems_of(text + "slide_tolerance = \"reversal\"\n"), IsEmpty());
    EXPECT_THAT(problems_of(text + "slide_tolerance = -1.0\n"), ElementsAre(HasSubstr("slide_tolerance")));
}

TEST(SolidMethods, a_bolt_is_tied_to_points_of_two_bodies_one_of_which_moves) {
    const LoadedCase loaded = read(planar_case + bolt_lines + "pretension = \"1 kN\"\n");
    ASSERT_EQ(loaded.model.bolts.size(), 1U);
    EXPECT_DOUBLE_EQ(loaded.model.bolts[0].rest_length, 1 - 1e-3);
    EXPECT_EQ(loaded.model.bolts[0].second_point, (Vec3{0, -0.5, 0}));
    EXPECT_THAT(problems_of(planar_case + with(bolt_lines, "\"block\", \"roof\"", "\"roof\", \"roof\"")),
                ElementsAre(HasSubstr("case.toml:20:10: a bolt that holds nothing")));
    EXPECT_THAT(problems_of(planar_case + with(bolt_lines, "[0.0, 0.5]", "[0.0, 0.7]")),
                ElementsAre(HasSubstr("case.toml:21:8: the point does not lie in 'block' but in no body")));
    EXPECT_THAT(problems_of(planar_case + with(bolt_lines, "[0.0, 0.5]", "[0.0, 1.6]")),
                ElementsAre(HasSubstr("case.toml:21:8: the point does not lie in 'block' but in 'roof'")));
    EXPECT_THAT(problems_of(planar_case + with(bolt_lines, "[0.0, 0.5]", "[0.0, 1.5]")),
                ElementsAre(HasSubstr("case.toml:21:8: a bolt without length")));
    EXPECT_THAT(problems_of(planar_case + bolt_lines + "pretension = 2e6\n"),
                ElementsAre(HasSubstr("case.toml:23:14: the pretension takes more than the whole length")));
    EXPECT_THAT(problems_of(planar_case + with(bolt_lines, "block", "blok")),
                ElementsAre(HasSubstr("there is no body 'blok'; did you mean 'block'?")));
    EXPECT_THAT(problems_of(planar_case + bolt_lines, {"solid.method=distance_potential_dem"}),
                ElementsAre(HasSubstr("case.toml:19:1: the solid method of this case knows no bolts")));
}

TEST(SolidMethods, a_fixed_point_lies_in_a_body_that_moves) {
    const std::string point = "[[fixed_point]]\nbody = \"block\"\nat = [0.0, 0.5]\n";
    EXPECT_EQ(read(planar_case + point).model.fixed_points.size(), 1U);
    EXPECT_THAT(problems_of(planar_case + with(point, "0.5", "0.6")),
                ElementsAre(HasSubstr("case.toml:21:6: the point does not lie in 'block'")));
    EXPECT_THAT(problems_of(planar_case + with(with(point, "block", "roof"), "0.5", "1.6")),
                ElementsAre(HasSubstr("case.toml:19:1: 'roof' does not follow forces")));
    EXPECT_THAT(problems_of(planar_case + point, {"solid.method=sphere_dem"}),
                ElementsAre(HasSubstr("the solid method of this case knows no fixed points")));
}

TEST(SolidMethods, a_measured_point_has_a_place_and_a_velocity_and_no_energy) {
    const std::string probe = "[[output.probe]]\nname = \"p\"\nbody = \"block\"\nat = [0.5, 0.5]\nquantity = ";
    EXPECT_EQ(read(planar_case + probe + "\"velocity\"\n").model.output.probes[0].point, (Vec3{0.5, 0.5, 0}));
    EXPECT_THAT(problems_of(planar_case + probe + "\"kinetic_energy\"\n"),
                ElementsAre(HasSubstr("case.toml:22:6: 'kinetic_energy' is no quantity of a point of a body")));
}

}  // namespace
}  // namespace riprap::scene
