// SPDX-License-Identifier: Apache-2.0
// Each kind of bad input is refused with its place, what was read and what is allowed.
#include <chrono>

#include "case_fixture.hpp"

namespace riprap::scene {
namespace {

using namespace test;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;

TEST(BadInput, an_unknown_key_is_named_with_place_and_nearest_key) {
    EXPECT_THAT(problems_of(with(minimal_case, "density =", "densty =")),
                ElementsAre("case.toml:4:1: unknown key 'densty' in [material.NAME]; did you mean 'density'?"));
    EXPECT_THAT(problems_of(with(minimal_case, "end =", "End =")),
                ElementsAre("case.toml:2:1: unknown key 'End' in (top of the file); did you mean 'end'?"));
    EXPECT_THAT(problems_of(with(minimal_case, "box =", "bxo =")), ElementsAre(HasSubstr("did you mean 'box'?")));
}

TEST(BadInput, an_unknown_key_that_belongs_elsewhere_says_where) {
    EXPECT_THAT(problems_of(minimal_case + "friction_mixing = \"mean\"\n"),
                ElementsAre("case.toml:10:1: unknown key 'friction_mixing' in [[body]]; it is a key of [contact]"));
}

TEST(BadInput, an_unknown_key_like_no_other_gets_the_list) {
    EXPECT_THAT(
        problems_of(minimal_case + "zzzzzz = 1\n"),
        ElementsAre(AllOf(HasSubstr("unknown key 'zzzzzz' in [[body]]"), HasSubstr("known keys: name, shape"))));
}

TEST(BadInput, a_missing_key_is_named) {
    EXPECT_THAT(
        problems_of(with(minimal_case, "density = 2500.0\n", "")),
        ElementsAre(StartsWith("case.toml:3:1: [material.NAME] lacks 'density'; a density [kg/m^3], 0 < value: ")));
}

TEST(BadInput, a_wrong_unit_is_refused) {
    EXPECT_THAT(problems_of(with(minimal_case, "2500.0", "\"2500 kg\"")),
                ElementsAre("case.toml:4:11: density of [material.NAME] = \"2500 kg\": 'kg' is a mass, not a density; "
                            "a density [kg/m^3], 0 < value"));
    EXPECT_THAT(problems_of(minimal_case + "position_kg = [1, 2, 3]\n"),
                ElementsAre(HasSubstr("unknown key 'position_kg'")));
    EXPECT_THAT(problems_of(minimal_case + "position_mm = [\"1 m\", 2, 3]\n"),
                ElementsAre(HasSubstr("the unit is already in the name of the key")));
    EXPECT_THAT(
        problems_of(minimal_case + "position = [1, 2, 3]\nposition_mm = [1, 2, 3]\n"),
        ElementsAre("case.toml:11:1: 'position' is given twice in [[body]]; once, with or without a unit in its name"));
}

TEST(BadInput, a_step_above_the_stability_limit_is_refused_where_it_stands) {
    const std::string text = with(minimal_case, "end =", "time_step = 0.5\nend =");
    EXPECT_THAT(problems_of(text),
                ElementsAre(AllOf(StartsWith("case.toml:2:13: time_step = 0.5 s is above the stability limit "),
                                  HasSubstr("use \"auto\", a smaller step, or force_time_step = true"))));
    EXPECT_THAT(problems_of(with(text, "end =", "force_time_step = true\nend =")), IsEmpty());
}

TEST(BadInput, a_wrong_type_is_refused) {
    EXPECT_THAT(problems_of(with(minimal_case, "2500.0", "true")),
                ElementsAre(HasSubstr("density of [material.NAME] is true or false; a density [kg/m^3]")));
    EXPECT_THAT(problems_of(with(minimal_case, "2500.0", "[1.0]")), ElementsAre(HasSubstr("is an array; a density")));
    EXPECT_THAT(problems_of(minimal_case + "fixed = 1\n"),
                ElementsAre(HasSubstr("fixed of [[body]] is an integer; true or false")));
    EXPECT_THAT(problems_of(minimal_case + "position = [1, 2]\n"),
                ElementsAre(HasSubstr("has 2 components; 3 components")));
    EXPECT_THAT(problems_of(minimal_case + "position = [1, 2, true]\n"),
                ElementsAre(HasSubstr("a component of position")));
    EXPECT_THAT(problems_of(minimal_case, {"max_steps=1.5"}), ElementsAre(HasSubstr("max_steps")));
    EXPECT_THAT(problems_of(with(minimal_case, "[[body]]", "[body]")),
                Contains(HasSubstr("body of (top of the file) is a table")));
    EXPECT_THAT(problems_of(with(minimal_case, "end = 1.0", "end = 1979-05-27")),
                ElementsAre(HasSubstr("a date or time")));
}

TEST(BadInput, zero_and_negative_density_are_refused) {
    EXPECT_THAT(problems_of(with(minimal_case, "2500.0", "0.0")),
                ElementsAre("case.toml:4:11: density of [material.NAME] = 0.0; a density [kg/m^3], 0 < value"));
    EXPECT_THAT(problems_of(with(minimal_case, "2500.0", "-1")),
                ElementsAre(HasSubstr("density of [material.NAME] = -1;")));
    EXPECT_THAT(problems_of(minimal_case + "density = 0\n"), ElementsAre(HasSubstr("density of [[body]] = 0;")));
}

TEST(BadInput, numbers_that_are_not_finite_or_overflow_are_refused) {
    EXPECT_THAT(problems_of(with(minimal_case, "2500.0", "inf")), ElementsAre(HasSubstr("is not a finite number")));
    EXPECT_THAT(problems_of(minimal_case + "position = [nan, 0, 0]\n"),
                ElementsAre(HasSubstr("is not a finite number")));
    EXPECT_THAT(problems_of(minimal_case + "position_km = [1e307, 0, 0]\n"),
                ElementsAre(HasSubstr("is not a finite number")));
    EXPECT_THAT(problems_of(minimal_case + "position = [\"1e999 m\", 0, 0]\n"), ElementsAre(HasSubstr("out of range")));
    EXPECT_THAT(problems_of(with(minimal_case, "end = 1.0", "end = 1.0\nseed = 99999999999999999999")), SizeIs(1));
}

TEST(BadInput, all_problems_are_reported_in_one_run_from_top_to_bottom) {
    const std::string text = R"(gravty = [0, 0, -9.81]
end = "1 m"
[material.rock]
density = -5
normal_stiffness = 1e7
[[body]]
name = "block 1"
material = "rok"
shape = { box = [1, 1], cube = 2 }
fixed = "yes"
)";
    EXPECT_THAT(problems_of(text),
                ElementsAre(StartsWith("case.toml:1:1: unknown key 'gravty'"), StartsWith("case.toml:2:7: end of"),
                            StartsWith("case.toml:4:11: density"), StartsWith("case.toml:7:8: name of [[body]]"),
                            StartsWith("case.toml:9:17: box of"),
                            StartsWith("case.toml:9:25: shape = { ... } gives both 'box' and 'cube'"),
                            StartsWith("case.toml:10:9: fixed of [[body]]")));
}

// The name of a body that there is not was answered by the quantity without it: "did you mean 'displacement'?".
TEST(BadInput, an_expected_answer_of_a_body_that_is_not_there_is_told_the_bodies) {
    const auto asked = [](const std::string& text, const std::string& quantity) {
        return problems_of(text + "[[expect]]\nname = \"a\"\nquantity = \"" + quantity +
                           "\"\nlow = 0\nhigh = 1\ncitation = \"by hand\"\n");
    };
    const std::string row = with(minimal_case, "material = \"rock\"\n",
                                 "material = \"rock\"\nrepeat = { counts = [3, 1, 1], pitch = [2, 2, 2] }\n");
    EXPECT_THAT(asked(minimal_case, "blok.displacement.x"),
                ElementsAre(HasSubstr("there is no body 'blok' of 'blok.displacement.x'; did you mean 'block'?")));
    EXPECT_THAT(asked(minimal_case, "zz.speed"), ElementsAre(HasSubstr("there is no body 'zz' of 'zz.speed'")));
    EXPECT_THAT(asked(row, "block.displacement.x"),
                ElementsAre(HasSubstr("there are many bodies 'block' of 'block.displacement.x'; 'block[0]' to "
                                      "'block[2]'")));
    EXPECT_THAT(asked(row, "block[3].speed"),
                ElementsAre(HasSubstr("there is no body 'block[3]' of 'block[3].speed'; 'block[0]' to 'block[2]'")));
    EXPECT_THAT(asked(minimal_case, "block[0].speed"), ElementsAre(HasSubstr("did you mean 'block'?")));
    EXPECT_THAT(problems_of(row + "[[output.probe]]\nbody = \"block[3]\"\nquantity = \"speed\"\n"),
                ElementsAre(HasSubstr("there is no body 'block[3]'; 'block[0]' to 'block[2]'")));
}

// Without water the mass of water was 0 and met its band, and forces of water had no value after the whole run.
TEST(BadInput, quantities_of_water_are_refused_in_a_case_without_water) {
    for (const std::string quantity : {"water_mass", "max_water_speed", "block.fluid_force.x", "block.fluid_torque.z",
                                       "solver_iterations", "water_momentum.x", "coupling_gap"}) {
        EXPECT_THAT(problems_of(minimal_case + "[[expect]]\nname = \"a\"\nquantity = \"" + quantity +
                                "\"\nlow = 0\nhigh = 1\ncitation = \"by hand\"\n"),
                    ElementsAre(HasSubstr("'" + quantity + "' in a case without water; a [fluid]")));
    }
    EXPECT_THAT(problems_of(minimal_case + "[[output.probe]]\nbody = \"block\"\nquantity = \"fluid_force\"\n"),
                ElementsAre(HasSubstr("'fluid_force' in a case without water")));
}

TEST(BadInput, names_that_point_nowhere_are_refused) {
    EXPECT_THAT(problems_of(with(minimal_case, "material = \"rock\"", "material = \"rok\"")),
                ElementsAre("case.toml:8:12: there is no material 'rok'; did you mean 'rock'?"));
    EXPECT_THAT(problems_of(minimal_case + "[[output.probe]]\nbody = \"blok\"\nquantity = \"position\"\n"),
                ElementsAre("case.toml:11:8: there is no body 'blok'; did you mean 'block'?"));
    EXPECT_THAT(problems_of(minimal_case + "[[output.probe]]\nbody = \"block\"\nquantity = \"positon\"\n"),
                ElementsAre(HasSubstr("did you mean \"position\"?")));
    EXPECT_THAT(problems_of(minimal_case + "[[body]]\nname = \"block\"\nmaterial = \"rock\"\nshape = { cube = 1 }\n"
                                           "position = [9.0, 0.0, 0.0]\n"),
                ElementsAre(HasSubstr("the name 'block' is taken")));
}

TEST(BadInput, a_method_that_does_not_exist_is_refused_with_those_that_do) {
    EXPECT_THAT(problems_of(minimal_case + "[solid]\nmethod = \"alchemy\"\n"),
                ElementsAre(AllOf(HasSubstr("is not known"), HasSubstr("\"distance_potential_dem\""))));
}

TEST(BadInput, different_friction_needs_a_mixing_rule) {
    const std::string two = minimal_case + R"([[body]]
name = "ground"
material = "steel"
fixed = true
shape = { half_space = { normal = [0, 0, 1], offset = -0.25 } }
[material.steel]
density = 7800
normal_stiffness = 1e9
friction_coefficient = 0.3
)";
    EXPECT_THAT(problems_of(two),
                ElementsAre(HasSubstr("materials 'rock' and 'steel' differ, and [contact] lacks 'friction_mixing'")));
    EXPECT_THAT(problems_of(two + "[contact]\nfriction_mixing = \"minimum\"\n"), IsEmpty());
}

TEST(BadInput, a_flat_hull_is_refused_at_its_place) {
    EXPECT_THAT(problems_of(with(minimal_case, "{ box = [1.0, 1.0, 0.5] }",
                                 "{ hull = { points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]] } }")),
                ElementsAre(AllOf(StartsWith("case.toml:9:18:"), HasSubstr("one plane"))));
}

TEST(BadInput, what_cannot_move_by_itself_has_no_velocity_and_no_second_driver) {
    EXPECT_THAT(problems_of(minimal_case + "fixed = true\nvelocity = [1, 0, 0]\n"),
                ElementsAre(HasSubstr("does not follow forces")));
    EXPECT_THAT(problems_of(minimal_case + "fixed = true\nmotion = { linear = { velocity = [1, 0, 0] } }\n"),
                ElementsAre(HasSubstr("is fixed and has a motion")));
    EXPECT_THAT(problems_of(minimal_case + "fixed = true\nload = [{ force = [1, 0, 0] }]\n"),
                ElementsAre(AllOf(HasSubstr("case.toml:11:8: body 'block' has a load and does not follow forces"),
                                  HasSubstr("release_time"))));
    EXPECT_THAT(problems_of(minimal_case + "load = [{ force = [1, 0, 0], start = 2, stop = 1 }]\n"),
                ElementsAre(HasSubstr("a load from 2 s to 1 s")));
    EXPECT_THAT(problems_of(minimal_case + "load = [{ force = [1, 0, 0] }, { force = [0, 1, 0] }]\n" +
                            "repeat = { counts = [1100, 1000, 1], pitch = [2, 2, 2] }\n"),
                ElementsAre(HasSubstr("at most 2000000 loads in a scene")));
    EXPECT_THAT(problems_of(minimal_case + "release_time = 1\n"), ElementsAre(HasSubstr("is free from the start")));
    EXPECT_THAT(problems_of(with(minimal_case, "box = [1.0, 1.0, 0.5]", "half_space = { normal = [0, 0, 1] }")),
                ElementsAre(HasSubstr("is a half-space, which has no mass")));
}

TEST(BadInput, an_expectation_without_tolerance_citation_or_quantity_is_refused) {
    const std::string expect = minimal_case + "[[expect]]\nname = \"x\"\nquantity = \"solid.kinetic\"\nvalue = 1\n";
    EXPECT_THAT(problems_of(expect + "tolerance = 0.1\n"), ElementsAre(HasSubstr("[[expect]] lacks 'citation'")));
    EXPECT_THAT(problems_of(expect + "citation = \"theory\"\n"), ElementsAre(HasSubstr("lacks a tolerance")));
    EXPECT_THAT(problems_of(with(expect, "solid.kinetic", "solid.kinetc") + "citation = \"t\"\ntolerance = 1\n"),
                ElementsAre(HasSubstr("did you mean 'solid.kinetic'?")));
    // Was told a quantity that is about as long as the whole text.
    EXPECT_THAT(
        problems_of(with(expect, "solid.kinetic", "block,blok[mean].position.x") + "citation = \"t\"\ntolerance = 1\n"),
        ElementsAre(HasSubstr("there is no body 'blok' of 'block,blok[mean].position.x'; did you mean 'block'?")));
    EXPECT_THAT(problems_of(expect + "citation = \"t\"\ntolerance = 1\nreduce = \"at\"\n"),
                ElementsAre(HasSubstr("'at' goes with")));
    EXPECT_THAT(problems_of(expect + "citation = \"t\"\ntolerance = 1\nfrom = 0.6\nto = 0.5\n"),
                ElementsAre(HasSubstr("no step lies between from = 0.6 s and to = 0.5 s")));
    EXPECT_THAT(problems_of(expect + "citation = \"t\"\ntolerance = 1\nfrom = 0.5\nto = 0.5\n"),
                ElementsAre(HasSubstr("no step lies between")));
    EXPECT_THAT(problems_of(expect + "citation = \"t\"\ntolerance = 1\nreduce = \"at\"\nat = 0.5\nto = 0.7\n"),
                ElementsAre(HasSubstr("'from' and 'to' say nothing beside 'at'")));
    EXPECT_THAT(problems_of(with(expect, "value = 1", "value = 0") + "citation = \"t\"\nrelative_tolerance = 1\n"),
                ElementsAre(HasSubstr("is no band")));
    EXPECT_THAT(problems_of(expect + "citation = \"t\"\ntolerance = 1\n"), IsEmpty());
    for (const char* const late : {"from = 1.5\n", "to = 1.5\n", "reduce = \"at\"\nat = 1.5\n"}) {
        EXPECT_THAT(read(expect + "citation = \"t\"\ntolerance = 1\n" + late).warnings,
                    ElementsAre(HasSubstr("is not judged: the run ends at 1 s")));
    }
}

TEST(BadInput, a_body_that_double_precision_cannot_hold_is_refused) {
    for (const char* size : {"1e-120", "1e-90", "1e120"}) {
        EXPECT_THAT(problems_of(with(minimal_case, "box = [1.0, 1.0, 0.5]", std::string("cube = ") + size)),
                    ElementsAre(AllOf(StartsWith("case.toml:9:"), HasSubstr("out of the range of double precision"))))
            << size;
    }
    EXPECT_THAT(problems_of(minimal_case + "position = [0, 1e13, 0]\n"),
                ElementsAre(AllOf(HasSubstr("lies 1e+13 m from the origin"), HasSubstr("at most 1.13e+09 m"))));
    EXPECT_THAT(problems_of(minimal_case + "position = [0, 1e9, 0]\n"), IsEmpty());
}

TEST(BadInput, a_billion_blocks_from_a_small_file_are_refused_at_once_naming_the_limit) {
    const auto start = std::chrono::steady_clock::now();
    EXPECT_THAT(problems_of(minimal_case + "repeat = { counts = [1000, 1000, 1000], pitch = [2, 2, 2] }\n"),
                ElementsAre("case.toml:10:10: 1000000000 bodies asked for here, 1000000000 so far; a scene has at most "
                            "2000000 bodies"));
    EXPECT_THAT(problems_of(minimal_case + "repeat = { counts = [2000000, 2000000, 2000000], pitch = [2, 2, 2] }\n"),
                ElementsAre(HasSubstr("a scene has at most 2000000 bodies")));
    EXPECT_THAT(problems_of(minimal_case + "repeat = { counts = [9000000000000000000, 1, 1], pitch = [2, 2, 2] }\n"),
                SizeIs(1));
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::milliseconds(500));
}

TEST(BadInput, a_path_out_of_the_folder_is_refused_however_it_is_written) {
    const TemporaryFolder outside, folder;
    outside.write("points.csv", "x,y,z\n0,0,0\n1,0,0\n0,1,0\n0,0,1\n");
    folder.write("points.csv", "x,y,z\n0,0,0\n1,0,0\n0,1,0\n0,0,1\n");
    std::filesystem::create_symlink(outside.path() / "points.csv", folder.path() / "link.csv");
    std::filesystem::create_directory_symlink(outside.path(), folder.path() / "door");
    const auto load = [&](const std::string& file) {
        return problems_of(with(minimal_case, "{ box = [1.0, 1.0, 0.5] }", "{ hull = { file = \"" + file + "\" } }"),
                           {}, folder.path());
    };
    EXPECT_THAT(load("points.csv"), IsEmpty());
    EXPECT_THAT(load((outside.path() / "points.csv").string()), ElementsAre(HasSubstr("is not a plain relative path")));
    EXPECT_THAT(load("../points.csv"), ElementsAre(HasSubstr("leaves the folder of the case")));
    EXPECT_THAT(load("a/../../points.csv"), ElementsAre(HasSubstr("leaves the folder of the case")));
    EXPECT_THAT(load("link.csv"), ElementsAre(HasSubstr("is a link that leaves the folder")));
    EXPECT_THAT(load("door/points.csv"), ElementsAre(HasSubstr("is a link that leaves the folder")));
    EXPECT_THAT(load("."), ElementsAre(HasSubstr("is not a regular file")));
    EXPECT_THAT(load(""), ElementsAre(HasSubstr("is empty")));
    EXPECT_THAT(load("a\\u0000b"), SizeIs(1));
}

TEST(BadInput, a_missing_file_is_named) {
    const TemporaryFolder folder;
    EXPECT_THAT(problems_of(with(minimal_case, "{ box = [1.0, 1.0, 0.5] }", "{ hull = { file = \"none.csv\" } }"), {},
                            folder.path()),
                ElementsAre(AllOf(StartsWith("case.toml:9:"), HasSubstr("\"none.csv\" cannot be read: No such file"))));
    EXPECT_THROW(read_case(folder.path() / "none.toml"), FileError);
    EXPECT_THROW(read_case(folder.path()), FileError);
}

TEST(BadInput, broken_toml_is_reported_with_its_place) {
    EXPECT_THAT(problems_of("end = \n"), ElementsAre(StartsWith("case.toml:1:")));
    EXPECT_THAT(problems_of("end = 1\nend = 2\n"), ElementsAre(StartsWith("case.toml:2:7: ")));
    EXPECT_THAT(problems_of("[material.rock\n"), SizeIs(1));
    EXPECT_THAT(problems_of("title = \"open\n"), SizeIs(1));
}

TEST(BadInput, bytes_that_are_not_utf8_and_keys_outside_ascii_never_reach_the_parser) {
    EXPECT_THAT(problems_of("title = \"a\xff\"\n"),
                ElementsAre("case.toml:1:11: byte 0xff is not valid UTF-8; a case file is TOML 1.0 in UTF-8"));
    EXPECT_THAT(problems_of("# comment \xc0\xaf\n"), ElementsAre(HasSubstr("byte 0xc0 is not valid UTF-8")));
    EXPECT_THAT(problems_of("title = \"\xed\xa0\x80\"\n"), ElementsAre(HasSubstr("is not valid UTF-8")));
    EXPECT_THAT(problems_of("title = \"\xf4\x90\x80\x80\"\n"), ElementsAre(HasSubstr("is not valid UTF-8")));
    EXPECT_THAT(problems_of("title = \"cut \xe2\x82"), ElementsAre(HasSubstr("is not valid UTF-8")));
    EXPECT_THAT(problems_of("t\xc3\xaftle = 1\n"), ElementsAre(HasSubstr("a character outside ASCII in a key")));
    EXPECT_THAT(problems_of(std::string("title = \"a\0b\"\n", 14)), ElementsAre(HasSubstr("control character 0x00")));
    EXPECT_THAT(problems_of("title = \"caf\xc3\xa9\"\n" + minimal_case), IsEmpty());
}

TEST(BadInput, deep_nesting_long_keys_and_huge_files_are_refused_before_parsing) {
    EXPECT_THAT(problems_of("a = " + std::string(100000, '[')),
                ElementsAre(HasSubstr("brackets nested more than 32 deep")));
    std::string dotted = "a";
    for (int i = 0; i < 100000; ++i) {
        dotted += ".a";
    }
    EXPECT_THAT(problems_of(dotted + " = 1\n"), ElementsAre(HasSubstr("a key of more than 16 dotted parts")));
    EXPECT_THAT(problems_of("[" + dotted + "]\n"), ElementsAre(HasSubstr("a key of more than 16 dotted parts")));
    EXPECT_THAT(problems_of(std::string(5 << 20, '#')), ElementsAre(HasSubstr("the case file has 5242880 bytes")));
    std::string numbers = "a = [";
    for (int i = 0; i < 600000; ++i) {
        numbers += "1,";
    }
    EXPECT_THAT(problems_of(numbers + "]\n"), ElementsAre(HasSubstr("too many values")));
}

TEST(BadInput, a_flood_of_materials_or_unknown_keys_is_refused_quickly) {
    const auto start = std::chrono::steady_clock::now();
    std::string materials = minimal_case, keys = minimal_case;
    for (int i = 0; i < 20000; ++i) {
        materials += "[material.m";
        materials += std::to_string(i) + "]\ndensity = 1\nnormal_stiffness = 1\n";
        keys += "k";
        keys += std::to_string(i) + " = 1\n";
    }
    EXPECT_THAT(problems_of(materials), ElementsAre(HasSubstr("has 20001 entries; at most 1000 are accepted")));
    EXPECT_THAT(problems_of(keys), SizeIs(101));
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
}

TEST(BadInput, a_flood_of_problems_is_cut_and_counted) {
    std::string text = minimal_case;
    for (int i = 0; i < 500; ++i) {
        text += "unknown" + std::to_string(i) + " = 1\n";
    }
    const auto problems = problems_of(text);
    EXPECT_THAT(problems, SizeIs(101));
    EXPECT_THAT(problems.back(), HasSubstr("400 more problems"));
}

TEST(BadInput, a_planar_scene_stays_in_its_plane) {
    const std::string planar =
        with(with(with(minimal_case, "gravity", "dimension = 2\ngravity"), "[0.0, 0.0, -9.81]", "[0.0, -9.81]"),
             "[1.0, 1.0, 0.5]", "[1.0, 0.5]");
    EXPECT_THAT(problems_of(planar), IsEmpty());
    EXPECT_THAT(problems_of(planar + "position = [0, 0, 1]\n"), ElementsAre(HasSubstr("leaves the plane")));
    EXPECT_THAT(problems_of(planar + "angular_velocity = [1, 0, 0]\n"), ElementsAre(HasSubstr("leaves the plane")));
    EXPECT_THAT(problems_of(planar + "orientation = { euler_deg = [10, 0, 0] }\n"),
                ElementsAre(HasSubstr("out of the plane")));
    EXPECT_THAT(problems_of(with(planar, "box = [1.0, 0.5]", "octahedron = 1.0")),
                ElementsAre(HasSubstr("is no shape of a planar scene")));
    EXPECT_THAT(problems_of(planar + "repeat = { counts = [2, 2, 2], pitch = [2, 2] }\n"),
                ElementsAre(HasSubstr("leave the plane")));
    EXPECT_THAT(
        problems_of(planar + "repeat = { counts = [2, 2], pitch = [2, 2], orientation = { euler_deg = [9, 0, 0] } }\n"),
        ElementsAre(HasSubstr("out of the plane")));
    EXPECT_THAT(problems_of(with(minimal_case, "box = [1.0, 1.0, 0.5]", "polygon = [[0, 0], [1, 0], [0, 1]]")),
                ElementsAre(HasSubstr("polygon is for dimension = 2; use prism")));
}

TEST(BadInput, entries_of_lists_are_told_at_their_own_place) {
    const std::string planar = R"(dimension = 2
gravity = [0, -9.81]
end = 1
[material.m]
density = 2500
[solid]
method = "planar_dda"
[[body]]
name = "g"
material = "m"
fixed = true
)";
    EXPECT_THAT(problems_of(planar + "shape = { terrain = { profile = [[0, -1],\n [1, -1],\n  [0.5, -1]] } }\n"),
                testing::ElementsAre(testing::StartsWith("case.toml:14:3: the points of the profile do not go")));
    EXPECT_THAT(
        problems_of(planar + "shape = { box = [1, 1] }\n[fluid]\nmethod = \"hydrostatic\"\nspacing = 0.1\n"
                             "density = 1000\ndomain = { low = [-5, -5], high = [5, 5] }\n"
                             "region = [{ level = 1.0 }]\nlevels = [[0, 1],\n  [2, 1.5],\n  [1, 2]]\n"),
        testing::ElementsAre(testing::StartsWith("case.toml:21:3: the time 1 s of the levels does not follow 2 s")));
}

TEST(BadInput, a_value_set_for_a_material_that_is_not_there_is_refused) {
    // It made a new material that nothing is of, and the run went on as before.
    const std::vector<std::string> misspelt{"material.rok.density=2600"}, right{"material.rock.density=2600"};
    EXPECT_THAT(problems_of(minimal_case, misspelt),
                ElementsAre(AllOf(HasSubstr("there is no material 'rok'"), HasSubstr("did you mean 'rock'?"))));
    EXPECT_THAT(problems_of(minimal_case, right), IsEmpty());
}

// A start in milliseconds made a load that never acts, and the run ended with exit code 0.
TEST(BadInput, what_begins_when_the_run_is_over_is_warned_of) {
    const auto warnings = [](const std::string& more) { return read(minimal_case + more + "\n").warnings; };
    EXPECT_THAT(
        warnings("load = [{ force = [1.0, 0.0, 0.0], start = 200.0 }]"),
        ElementsAre(StartsWith("case.toml:10:44: the run ends at 1 s, before this load begins at 200 s; times")));
    EXPECT_THAT(warnings("load = [{ force = [1.0, 0.0, 0.0], start = 0.2 }]"), IsEmpty());
    EXPECT_THAT(warnings("load = [{ force = [1.0, 0.0, 0.0], ramp = 0.5, stop = 0.4 }]"),
                ElementsAre(HasSubstr("stops at 0.4 s, before it has grown to its full size")));
    EXPECT_THAT(warnings("load = [{ force = [1.0, 0.0, 0.0], start = 0.1, ramp = 0.3, stop = 0.4 }]"), IsEmpty());
    EXPECT_THAT(warnings("motion = { linear = { velocity = [1.0, 0.0, 0.0] }, start = 5.0 }"),
                ElementsAre(HasSubstr("before 'block' begins to move at 5 s")));
    const auto moved = [](const std::string& times) {
        return "motion = { table = { time = " + times + ", displacement = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]] } }";
    };
    EXPECT_THAT(warnings(moved("[4.0, 5.0]")), ElementsAre(HasSubstr("before this table begins at 4 s")));
    EXPECT_THAT(warnings(moved("[-2.0, -1.0]")), ElementsAre(HasSubstr("this table ends at -1 s, before the run")));
    EXPECT_THAT(warnings(moved("[0.5, 5.0]")), IsEmpty());
    const auto pushed = [](const std::string& start) {
        return "load = [{ table = { time = [0.5, 1.0], force = [[1.0, 0.0, 0.0], [1.0, 0.0, 0.0]] }, start = " + start +
               " }]";
    };
    EXPECT_THAT(warnings(pushed("0.5")), ElementsAre(HasSubstr("before this load begins at 1 s")));
    EXPECT_THAT(warnings(pushed("0.4")), IsEmpty());
    EXPECT_THAT(warnings("fixed = true\nrelease_time = 1.0"), ElementsAre(HasSubstr("'block' is released at 1 s")));
    const std::string turn =
        "gravity = { value = [0.0, 0.0, -9.81], rotation = { axis = [1.0, 0.0, 0.0], rate = 0.1, start = 3.0 } }";
    EXPECT_THAT(read(with(minimal_case, "gravity = [0.0, 0.0, -9.81]", turn)).warnings,
                ElementsAre(HasSubstr("before gravity begins to turn at 3 s")));
    const std::string by_table =
        "gravity = { value = [0.0, 0.0, -9.81], rotation = { axis = [1.0, 0.0, 0.0], "
        "time = [4.0, 5.0], angle = [0.0, 0.1] } }";
    EXPECT_THAT(read(with(minimal_case, "gravity = [0.0, 0.0, -9.81]", by_table)).warnings,
                ElementsAre(HasSubstr("before gravity begins to turn at 4 s")));
}

TEST(BadInput, a_friction_coefficient_that_is_an_angle_is_warned_of) {
    const auto with_friction = [](const std::string& value) {
        return read(with(minimal_case, "[[body]]", "friction_coefficient = " + value + "\n[[body]]")).warnings;
    };
    EXPECT_THAT(
        with_friction("30.0"),
        ElementsAre(StartsWith("case.toml:6:24: friction_coefficient = 30 is the tangent of 88.1 degrees; an")));
    EXPECT_THAT(with_friction("4.9"), IsEmpty());
    EXPECT_THAT(with_friction("9.9"), SizeIs(1));
}

}  // namespace
}  // namespace riprap::scene
