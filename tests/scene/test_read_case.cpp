// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <numbers>

#include "case_fixture.hpp"
#include "riprap/core/fields.hpp"

namespace riprap::scene {
namespace {

using namespace test;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(ReadCase, the_example_of_the_style_guide_loads) {
    const LoadedCase loaded = read_case("cases/hello_block/case.toml");
    const sim::Model& model = loaded.model;
    EXPECT_EQ(model.title, "A block slides down a 30 degree plane");
    EXPECT_EQ(model.gravity.value, (Vec3{4.905, 0, -8.496}));
    ASSERT_EQ(model.bodies.size(), 2);
    EXPECT_EQ(model.bodies.drive[0], body::Drive::fixed);
    EXPECT_EQ(model.bodies.drive[1], body::Drive::free);
    EXPECT_DOUBLE_EQ(model.bodies.mass[1], 1250.0);
    EXPECT_DOUBLE_EQ(model.materials.materials[0].friction, std::tan(20 * std::numbers::pi / 180));
    EXPECT_TRUE(model.shapes.is_half_space(model.bodies.parts[0].shape));
    ASSERT_EQ(model.output.probes.size(), 1U);
    EXPECT_EQ(model.output.probes[0].name, "block.displacement");
    ASSERT_EQ(model.expects.size(), 1U);
    EXPECT_DOUBLE_EQ(model.expects[0].low, 0.99 * model.expects[0].value);
    EXPECT_TRUE(loaded.warnings.empty());
}

TEST(ReadCase, everything_not_given_has_its_documented_default) {
    const sim::Model model = read(minimal_case).model;
    EXPECT_EQ(model.time.time_step, 0);
    EXPECT_EQ(model.time.factor, 0.15);
    EXPECT_EQ(model.time.max_steps, -1);
    EXPECT_EQ(model.seed, 1U);
    EXPECT_EQ(model.materials.materials[0].shear_ratio, 0.8);
    EXPECT_EQ(model.materials.materials[0].friction, 0);
    EXPECT_EQ(model.dem()->contact.sides, contact::Sides::both);
    EXPECT_EQ(model.output.checkpoint_interval, 60);
    EXPECT_FALSE(model.bodies.is_planar);
}

TEST(ReadCase, units_in_texts_and_in_key_names_mean_the_same) {
    const std::string in_texts = with(minimal_case, "1.0e7\n", "\"10 MPa\"\nfriction_angle = \"26 deg\"\n");
    const std::string in_names =
        with(minimal_case, "normal_stiffness = 1.0e7\n", "normal_stiffness_MPa = 10\nfriction_angle_deg = 26\n");
    const LoadedCase a = read(in_texts), b = read(in_names);
    EXPECT_EQ(a.model.materials.materials[0].normal_stiffness, 1e7);
    EXPECT_EQ(a.model.materials.materials[0].friction, b.model.materials.materials[0].friction);
    EXPECT_EQ(a.model.case_hash, b.model.case_hash);
}

TEST(ReadCase, a_vector_takes_a_unit_per_component_or_in_its_name) {
    const LoadedCase a = read(minimal_case + "position = [\"2 cm\", 0, \"1 m\"]\n");
    EXPECT_EQ(a.state.bodies.position[0], (Vec3{0.02, 0, 1}));
    const LoadedCase b = read(minimal_case + "position_mm = [20, 0, 1000]\n");
    EXPECT_EQ(a.state.bodies.position[0], b.state.bodies.position[0]);
}

TEST(ReadCase, a_load_acts_on_a_point_of_the_shape_of_every_copy) {
    const LoadedCase loaded = read(with(minimal_case, "{ box = [1.0, 1.0, 0.5] }", "{ wedge = [0.3, 0.6, 0.9] }") + R"(
position = [10, 0, 0]
orientation = { axis_angle = { axis = [0, 0, 1], angle_deg = 90 } }
repeat = { counts = [2, 1, 1], pitch = [5, 0, 0], scales = [1, 2] }
[[body.load]]
force = ["2 kN", 0, 0]
at = [0, 0, 0.9]
ramp = "1 s"
[[body.load]]
force = [0, 0, -5]
start = 2
stop = 3
)");
    const std::vector<body::PointLoad>& loads = loaded.model.loads;
    ASSERT_EQ(loads.size(), 4U);
    EXPECT_EQ(loads[0].force, (Vec3{2000, 0, 0}));
    EXPECT_EQ(loads[0].ramp, 1);
    EXPECT_EQ(loads[1].point, Vec3{});  // the centre of mass
    EXPECT_EQ(loads[3].stop, 3);
    EXPECT_EQ(loads[2].body, BodyId{1});
    // Half a box: the centre of mass is a third of the way from the upright corner. Body axes, so that the turn drops
    // out.
    EXPECT_LT(norm(loads[0].point - Vec3{-0.1, -0.3, 0.6}), 1e-12);
    EXPECT_LT(norm(loads[2].point - Vec3{-0.2, -0.6, 1.2}), 1e-12);
}

TEST(ReadCase, a_load_varies_in_time_by_its_table) {
    const std::string text = minimal_case + R"(repeat = { counts = [2, 1, 1], pitch = [5, 0, 0] }
[[body.load]]
table = { time = [1, 2, 4], force = [[0, 0, 10], [0, 0, 20], [2, 0, 20]] }
start = 0.5
)";
    const LoadedCase loaded = read(text);
    ASSERT_EQ(loaded.model.loads.size(), 2U);
    for (const body::PointLoad& load : loaded.model.loads) {
        EXPECT_EQ(load.at(1.4), Vec3{});  // before the first row, counted from start
        EXPECT_LT(norm(load.at(2.25) - Vec3{0, 0, 17.5}), 1e-12);
        EXPECT_LT(norm(load.at(3.5) - Vec3{1, 0, 20}), 1e-12);
        EXPECT_EQ(load.at(90), (Vec3{2, 0, 20}));
    }
    const TemporaryFolder folder;
    folder.write("pull.csv", "t, x, y, z\n0, 1, 2, 3\n2, 3, 2, 3\n");
    const LoadedCase from_file =
        read(minimal_case + "[[body.load]]\ntable = { file = \"pull.csv\" }\n", {}, folder.path());
    EXPECT_EQ(from_file.model.loads.at(0).at(1), (Vec3{2, 2, 3}));
    EXPECT_THAT(problems_of(with(text, "[1, 2, 4]", "[1, 2, 2]")), ElementsAre(HasSubstr("does not follow 2")));
    EXPECT_THAT(problems_of(with(text, "start = 0.5", "force = [1, 0, 0]")), ElementsAre(HasSubstr("'table'")));
}

TEST(ReadCase, a_byte_order_mark_is_no_part_of_the_text) {
    EXPECT_EQ(read("\xEF\xBB\xBF" + minimal_case).model.case_hash, read(minimal_case).model.case_hash);
}

TEST(ReadCase, copies_lie_in_bond_along_a_slope) {
    const LoadedCase loaded = read(minimal_case + R"(
position = [10, 0, 0]
repeat = { counts = [2, 1, 3], pitch = [2, 9, 1], stagger = 0.5, orientation = { axis_angle = { axis = [0, -1, 0], angle_deg = 90 } } }
)");
    // Along the row is now up, across the rows is now back.
    const std::array<Vec3, 6> expected{{{10, 0, 0}, {10, 0, 2}, {9, 0, 0.5}, {9, 0, 2.5}, {8, 0, 0}, {8, 0, 2}}};
    ASSERT_EQ(loaded.state.bodies.position.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_LT(norm(loaded.state.bodies.position[i] - expected[i]), 1e-12) << i;
        EXPECT_EQ(loaded.state.bodies.orientation[i], loaded.state.bodies.orientation[0]);
    }
    EXPECT_EQ(rotate(loaded.state.bodies.orientation[0], Vec3{1, 0, 0}), (Vec3{1, 0, 0}));
}

TEST(ReadCase, the_resolved_case_reads_back_to_the_same_model) {
    const std::string text =
        with(minimal_case, "end = 1.0\n", "end = \"1 min\"\ntitle = \"quotes \\\" and \\\\ and \\u00e9\"\n") + R"(
orientation = { axis_angle = { axis = [1, 1, 0], angle_deg = 30 } }
repeat = { counts = [2, 3, 2], pitch_cm = [170, 170, 170], random_orientation = true, jitter = 0.01 }
load = [{ force_kN = [0, 0, 1], ramp = 0.5 }]
[solid]
local_damping = 0.1
[[output.probe]]
body = "block[3]"
quantity = "position"
)";
    const LoadedCase first = read(text);
    const LoadedCase second = read(first.resolved_toml);
    EXPECT_EQ(second.resolved_toml, first.resolved_toml);
    EXPECT_EQ(second.model.case_hash, first.model.case_hash);
    EXPECT_EQ(hash_fields(second.state), hash_fields(first.state));
    EXPECT_EQ(second.model.title, first.model.title);
}

TEST(ReadCase, the_hash_ignores_how_long_to_run_and_what_to_write_but_nothing_else) {
    const std::uint64_t hash = read(minimal_case).model.case_hash;
    EXPECT_EQ(
        read(minimal_case, {"end=7", "max_steps=3", "title=other", "source=other", "output.vtk=false"}).model.case_hash,
        hash);
    EXPECT_NE(read(minimal_case, {"gravity=[0, 0, -9.80]"}).model.case_hash, hash);
    EXPECT_NE(read(minimal_case, {"material.rock.density=2501"}).model.case_hash, hash);
    EXPECT_NE(read(minimal_case, {"seed=2"}).model.case_hash, hash);
}

TEST(ReadCase, overrides_reach_tables_list_entries_and_quantities) {
    const std::vector<std::string> overrides{"material.rock.density=3 t/m^3",
                                             "body.block.position=[0, 0, 2]",
                                             "body.0.velocity=[1, 0, 0]",
                                             "time_step=0.1 ms",
                                             "max_steps=5",
                                             "solid.sides=contactor"};
    const LoadedCase loaded = read(minimal_case, overrides);
    EXPECT_DOUBLE_EQ(loaded.model.bodies.mass[0], 1500);
    EXPECT_EQ(loaded.state.bodies.position[0], (Vec3{0, 0, 2}));
    EXPECT_EQ(loaded.state.bodies.velocity[0], (Vec3{1, 0, 0}));
    EXPECT_EQ(loaded.model.time.time_step, 1e-4);
    EXPECT_EQ(loaded.model.time.max_steps, 5);
    EXPECT_EQ(loaded.model.dem()->contact.sides, contact::Sides::contactor);
}

TEST(ReadCase, an_override_with_another_unit_replaces_the_key) {
    const LoadedCase loaded =
        read(with(minimal_case, "1.0e7\n", "1.0e7\nfriction_angle_deg = 20\n"), {"material.rock.friction_angle=0.5"});
    EXPECT_DOUBLE_EQ(loaded.model.materials.materials[0].friction, std::tan(0.5));
}

TEST(ReadCase, an_override_finds_bodies_whose_names_hold_dots) {
    const LoadedCase loaded = read(with(minimal_case, "\"block\"", "\"b.c\""), {"body.b.c.position=[0, 0, 3]"});
    EXPECT_EQ(loaded.state.bodies.position[0], (Vec3{0, 0, 3}));
}

TEST(ReadCase, a_wrong_override_is_named) {
    EXPECT_THAT(problems_of(minimal_case, {"body.7=3"}),
                ElementsAre(AllOf(HasSubstr("the list has no entry '7'"), HasSubstr("or name: block"))));
    EXPECT_THAT(problems_of(minimal_case, {"body.stone.position=[0,0,1]"}),
                ElementsAre(HasSubstr("--set body.stone.position=[0,0,1]: the list has no entry 'stone'")));
    EXPECT_THAT(problems_of(minimal_case, {"densty=1"}),
                ElementsAre(HasSubstr("--set densty=1: unknown key 'densty'")));
    EXPECT_THAT(problems_of(minimal_case, {"end"}), ElementsAre(HasSubstr("write --set path.to.key=value")));
    EXPECT_THAT(problems_of(minimal_case, {"end=[1"}), ElementsAre(HasSubstr("not a TOML value")));
    EXPECT_THAT(problems_of(minimal_case, {"end=1\nseed=5"}), ElementsAre(HasSubstr("not a TOML value")));
    EXPECT_THAT(problems_of(minimal_case, {"end.of=1"}), ElementsAre(HasSubstr("there is no key 'of'")));
}

TEST(ReadCase, one_entry_makes_735_cubes) {
    const LoadedCase loaded = read(with(minimal_case, "{ box = [1.0, 1.0, 0.5] }", R"({ cube = "1 mm" }
repeat = { counts = [7, 7, 15], pitch_mm = [1.8, 1.8, 1.8], random_orientation = true })"));
    ASSERT_EQ(loaded.model.bodies.size(), 735);
    EXPECT_EQ(loaded.model.shapes.size(), 1);
    EXPECT_EQ(loaded.model.bodies.name(BodyId{0}), "block[0]");
    EXPECT_EQ(loaded.model.bodies.name(BodyId{734}), "block[734]");
    const Vec3 last = loaded.state.bodies.position[734];
    EXPECT_DOUBLE_EQ(last.x, 6 * 1.8e-3);
    EXPECT_DOUBLE_EQ(last.z, 14 * 1.8e-3);
    EXPECT_NE(loaded.state.bodies.orientation[0], loaded.state.bodies.orientation[1]);
}

TEST(ReadCase, random_turns_are_uniform_over_all_directions) {
    const LoadedCase loaded = read(
        with(minimal_case,
             "shape =", "repeat = { counts = [20, 20, 25], pitch = [2, 2, 2], random_orientation = true }\nshape ="));
    Vec3 mean{};
    double square = 0;
    for (const Quat& q : loaded.state.bodies.orientation) {
        const Vec3 up = rotate(q, {0, 0, 1});
        mean += up / 10000.0;
        square += up.z * up.z / 10000.0;
    }
    EXPECT_LT(norm(mean), 4 / std::sqrt(10000.0));
    EXPECT_NEAR(square, 1.0 / 3, 4 * 0.3 / std::sqrt(10000.0));
}

TEST(ReadCase, a_seed_decides_everything_random) {
    const std::string text =
        minimal_case + "repeat = { counts = [3, 1, 1], pitch = [2, 2, 2], random_orientation = true, jitter = 0.1 }\n";
    EXPECT_EQ(hash_fields(read(text).state), hash_fields(read(text).state));
    EXPECT_NE(hash_fields(read(text).state), hash_fields(read(text, {"seed=2"}).state));
}

TEST(ReadCase, orientation_can_be_said_in_five_ways) {
    const double half = std::numbers::pi / 2;
    const auto turned = [](const std::string& orientation, const Vec3& axis) {
        return rotate(read(minimal_case + "orientation = " + orientation).state.bodies.orientation[0], axis);
    };
    const auto near = [](const Vec3& a, const Vec3& b) { return norm(a - b) < 1e-14; };
    EXPECT_TRUE(near(turned("{ axis_angle = { axis = [2, 0, 0], angle_deg = 90 } }", {0, 1, 0}), {0, 0, 1}));
    EXPECT_TRUE(near(turned("{ angle_deg = 90 }", {1, 0, 0}), {0, 1, 0}));
    EXPECT_TRUE(near(turned("{ euler_deg = [90, 0, 90] }", {0, 1, 0}), {0, 0, 1}));
    EXPECT_TRUE(near(turned("{ euler_deg = [90, 0, 90] }", {0, 0, 1}), {1, 0, 0}));
    EXPECT_TRUE(near(turned("{ quaternion = [1, 0, 0, 1] }", {1, 0, 0}), {0, 1, 0}));
    // A plane that dips 30 degrees towards the east (+x) has its normal tilted towards the east.
    const Vec3 normal = turned("{ dip_deg = 30, dip_direction_deg = 90 }", {0, 0, 1});
    EXPECT_TRUE(near(normal, {std::sin(half / 3), 0, std::cos(half / 3)}));
}

TEST(ReadCase, gravity_can_grow_and_turn) {
    const body::Gravity gravity = read(with(minimal_case, "gravity = [0.0, 0.0, -9.81]",
                                            "gravity = { value = [0, 0, -9.81], ramp = \"100 ms\", rotation = { axis = "
                                            "[0, -2, 0], rate = \"1 deg/s\", start = 1 } }"))
                                      .model.gravity;
    EXPECT_EQ(gravity.value.z, -9.81);
    EXPECT_EQ(gravity.ramp, 0.1);
    EXPECT_EQ(gravity.axis, (Vec3{0, -1, 0}));
    EXPECT_DOUBLE_EQ(gravity.rate, std::numbers::pi / 180);
    EXPECT_EQ(gravity.start, 1);
    EXPECT_GE(gravity.stop, 1e300);
}

TEST(ReadCase, GravityTurnsByGivenAnglesAndStopsOnItsWay) {
    const auto near = [](const Vec3& a, const Vec3& b) { return norm(a - b) < 1e-12; };
    const auto turning = [](const std::string& keys) {
        return with(minimal_case, "gravity = [0.0, 0.0, -9.81]",
                    "gravity = { value = [0, 0, -10], rotation = { axis = [0, -1, 0], " + keys + " } }");
    };
    const body::Gravity gravity =
        read(turning("time = [1, 2, 5, 6], angle = [\"0 deg\", \"90 deg\", \"90 deg\", \"0 deg\"]")).model.gravity;
    EXPECT_TRUE(near(gravity.at(0), {0, 0, -10}));
    EXPECT_TRUE(near(gravity.at(1.5), {std::sqrt(50.0), 0, -std::sqrt(50.0)}));
    EXPECT_TRUE(near(gravity.at(4), {10, 0, 0}));
    EXPECT_TRUE(near(gravity.at(7), {0, 0, -10}));
    EXPECT_TRUE(near(gravity.held().at(4), {0, 0, -10})) << "as it is at time 0";
    EXPECT_THAT(problems_of(turning("time = [1, 1], angle = [0, 1]")), ElementsAre(HasSubstr("increasing times")));
    EXPECT_THAT(problems_of(turning("time = [1, 2], angle = [0]")), ElementsAre(HasSubstr("2 times and 1 angles")));
    EXPECT_THAT(problems_of(turning("rate = 1, time = [1, 2], angle = [0, 1]")), ElementsAre(HasSubstr("rate")));
    EXPECT_THAT(problems_of(turning("start = 2, time = [1, 2], angle = [0, 1]")),
                ElementsAre(HasSubstr("'start' goes with 'rate'")));
}

TEST(ReadCase, a_pair_of_materials_replaces_the_mixed_values) {
    const std::string text = minimal_case + R"([[body]]
name = "ground"
material = "steel"
fixed = true
shape = { half_space = { normal = [0, 0, 1], offset = -0.25 } }
[material.steel]
density = 7800
normal_stiffness = 1e9
friction_coefficient = 0.3
shear_stiffness = 1e6
[contact]
friction_mixing = "maximum"
)";
    const material::MaterialSet mixed = read(text).model.materials;
    EXPECT_EQ(mixed.pair(MaterialId{0}, MaterialId{1}).friction, 0.3);
    const material::MaterialSet given =
        read(text + "[[contact.pair]]\nmaterials = [\"steel\", \"rock\"]\nfriction_coefficient = 0.9\n")
            .model.materials;
    EXPECT_EQ(given.pair(MaterialId{0}, MaterialId{1}).friction, 0.9);
    EXPECT_EQ(given.pair(MaterialId{1}, MaterialId{0}).friction, 0.9);
    EXPECT_EQ(given.pair(MaterialId{1}, MaterialId{1}).friction, 0.3);
}

TEST(ReadCase, warns_of_densities_that_no_solid_and_no_liquid_has) {
    const auto warnings_of = [](std::string_view density) {
        return read(with(minimal_case, "density = 2500.0", "density = " + std::string(density))).warnings;
    };
    EXPECT_THAT(warnings_of("2.5"), ElementsAre(HasSubstr("'block' has a density of 2.5 kg/m^3, as no solid has")));
    EXPECT_THAT(warnings_of("25000"), ElementsAre(HasSubstr("not the weight of a volume in N/m^3")));
    EXPECT_THAT(warnings_of("\"2.5 t/m^3\""), IsEmpty());
    EXPECT_THAT(warnings_of("15"), IsEmpty());  // foam
}

TEST(ReadCase, a_planar_scene_takes_two_components_and_polygons) {
    const LoadedCase loaded = read(R"(dimension = 2
gravity = [0, -9.81]
end = 1
[material.rock]
density = 2000
normal_stiffness = 1e7
[[body]]
name = "plate"
material = "rock"
shape = { polygon = [[0, 0], [2, 0], [2, 1], [0, 1]] }
position = [3, 4]
angular_velocity = 2.0
orientation = { angle_deg = 10 }
[[body]]
name = "bar"
material = "rock"
shape = { box = [2, 1] }
)");
    EXPECT_TRUE(loaded.model.bodies.is_planar);
    EXPECT_DOUBLE_EQ(loaded.model.bodies.mass[0], 4000);
    EXPECT_DOUBLE_EQ(loaded.model.bodies.mass[1], 4000);
    EXPECT_EQ(loaded.state.bodies.position[0].z, 0);
    EXPECT_EQ(loaded.state.bodies.angular_momentum[0].x, 0);
    EXPECT_GT(loaded.state.bodies.angular_momentum[0].z, 0);
}

}  // namespace
}  // namespace riprap::scene
