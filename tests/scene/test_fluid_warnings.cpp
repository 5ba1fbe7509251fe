// SPDX-License-Identifier: Apache-2.0
// Warnings about cases with water that can still run.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "scene/case_fixture.hpp"

namespace riprap::scene {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// A planar flume 2 m long with 0.5 m of water at a spacing of 5 cm; bodies are appended.
const std::string flume = R"(dimension = 2
gravity = [0.0, -9.81]
end = 1.0
[material.rock]
density = 2500.0
normal_stiffness = 1.0e6
friction_coefficient = 0.3
[fluid]
spacing = 0.05
domain = { low = [-0.5, -0.2], high = [2.5, 1.5] }
[[fluid.region]]
box = { low = [0.0, 0.0], high = [2.0, 0.5] }
[[body]]
name = "floor"
material = "rock"
shape = { half_space = { normal = [0.0, 1.0] } }
fixed = true
)";

std::string body(const std::string& name, const std::string& size, const std::string& position,
                 const std::string& more = "") {
    return fmt::format("[[body]]\nname = \"{}\"\nmaterial = \"rock\"\nshape = {{ box = {} }}\nposition = {}\n{}\n",
                       name, size, position, more);
}

std::string paddle(const std::string& depth, const std::string& size = "[0.4, 1.0]",
                   const std::string& wave = "wave = \"regular\", height = 0.2, period = 1.5") {
    return body("paddle", size, "[-0.2, 0.5]", "motion = { wave_maker = { " + wave + ", depth = " + depth + " } }");
}

TEST(FluidWarnings, a_wave_maker_for_another_depth_than_the_water_before_it) {
    EXPECT_THAT(test::read(flume + paddle("0.5")).warnings, ElementsAre());
    EXPECT_THAT(test::read(flume + paddle("0.46")).warnings, ElementsAre());  // less than a spacing
    EXPECT_THAT(test::read(flume + paddle("0.3")).warnings,
                ElementsAre(AllOf(HasSubstr("case.toml:23:"), HasSubstr("'paddle' has depth = 0.3 m"),
                                  HasSubstr("water stands 0.5 m deep before it"))));
}

// Water pressed a fixed block on a fixed floor down with 707 N/m where it lifts it with 177 N/m: particle methods take
// both for one solid, the grid and water at rest do not.
TEST(FluidWarnings, a_load_of_water_that_lacks_the_joint_below_a_body_that_nothing_moves) {
    const std::string asked = "[[output.probe]]\nbody = \"b\"\nquantity = \"fluid_force\"\n";
    const std::string base = body("base", "[2.0, 0.2]", "[1.0, -0.1]", "fixed = true");
    const auto lacks = Contains(AllOf(HasSubstr("'b' touches 'base'"), HasSubstr("lacks its uplift")));
    const auto block = [](const std::string& more, const std::string& place = "[1.0, 0.125]") {
        return body("b", "[0.5, 0.25]", place, more);
    };
    const std::string whole = test::with(flume, "half_space = { normal = [0.0, 1.0] } }",
                                         "box = [4.0, 0.2] }\n"
                                         "position = [1.0, -0.4]");
    EXPECT_THAT(test::read(whole + base + block("fixed = true") + asked).warnings, lacks);
    EXPECT_THAT(test::read(whole + base + block("motion = { linear = { velocity = [0.0, 0.1] } }") + asked).warnings,
                lacks);
    EXPECT_THAT(test::read(whole + base + block("fixed = true") +
                           "[[expect]]\nname = \"a\"\nquantity = \"b.fluid_force.y\"\nlow = 0\nhigh = 1\n"
                           "citation = \"by hand\"\n")
                    .warnings,
                lacks);
    // Nobody asks, it is free or will be, it touches nothing, the water has no such joints or other methods have them.
    EXPECT_THAT(test::read(whole + base + block("fixed = true")).warnings, Not(lacks));
    EXPECT_THAT(test::read(whole + base + block("") + asked).warnings, Not(lacks));
    EXPECT_THAT(test::read(whole + base + block("fixed = true\nrelease_time = 0.5") + asked).warnings, Not(lacks));
    EXPECT_THAT(test::read(whole + base + block("fixed = true", "[1.0, 0.3]") + asked).warnings, Not(lacks));
    EXPECT_THAT(test::read(test::with(whole, "spacing = 0.05", "spacing = 0.05\njoint_pressure = false") + base +
                           block("fixed = true") + asked)
                    .warnings,
                Not(lacks));
    EXPECT_THAT(test::read(test::with(whole, "spacing = 0.05", "spacing = 0.05\nmethod = \"grid\"") + base +
                           block("fixed = true") + asked)
                    .warnings,
                Not(lacks));
}

TEST(FluidWarnings, a_driven_wall_that_moves_out_of_the_domain_but_not_a_gate_that_is_lifted) {
    const auto moving = [](const std::string& velocity) {
        return test::read(flume + body("wall", "[0.2, 1.0]", "[2.1, 0.5]",
                                       "motion = { linear = { velocity = " + velocity + " } }"))
            .warnings;
    };
    EXPECT_THAT(moving("[0.2, 0]"), ElementsAre());
    EXPECT_THAT(
        moving("[0.8, 0]"),
        ElementsAre(HasSubstr("'wall' moves out of 'fluid.domain': it reaches x = 3 m at t = 1 s, the domain ends "
                              "at 2.5 m")));
    EXPECT_THAT(moving("[0, 3]"), ElementsAre());
}

TEST(FluidWarnings, a_pusher_below_the_water_that_moves_out_of_the_open_top) {
    const auto lifted = [](const std::string& velocity) {
        return test::read(flume + body("pusher", "[0.5, 0.2]", "[1.0, 0.1]",
                                       "motion = { linear = { velocity = [0, " + velocity + "] } }"))
            .warnings;
    };
    EXPECT_THAT(lifted("0.5"), ElementsAre());
    EXPECT_THAT(lifted("2"),
                ElementsAre(HasSubstr("'pusher' moves out of 'fluid.domain': it reaches y = 2.2 m at t = 1 s")));
}

TEST(FluidWarnings, a_wall_that_water_passes_through_holds_none) {
    const auto wall = [](const std::string& place) {
        return test::read(flume + body("wall", "[0.2, 1.0]", place, "fixed = true\nwet = false")).warnings;
    };
    EXPECT_THAT(wall("[2.1, 0.5]"), ElementsAre(AllOf(HasSubstr("water stands at 'wall'"), HasSubstr("wet = false"))));
    EXPECT_THAT(wall("[2.4, 0.5]"), ElementsAre());
}

TEST(FluidRecords, a_gauge_with_a_count_is_a_profile_of_gauges) {
    const std::string profile =
        "[[output.gauge]]\nname = \"wave\"\nkind = \"level\"\npoint = [0.2, 0.0]\nend = [1.8, 0.0]\ncount = 11\n";
    const LoadedCase loaded = test::read(flume + profile);
    const auto& gauges = loaded.model.output.gauges;
    ASSERT_EQ(gauges.size(), 11U);
    EXPECT_EQ(gauges[0].name, "wave_01");
    EXPECT_EQ(gauges[10].name, "wave_11");
    EXPECT_NEAR(gauges[5].point.x, 1.0, 1e-12);
    EXPECT_NEAR(gauges[10].point.x, 1.8, 1e-12);
    EXPECT_THAT(loaded.resolved_toml, HasSubstr("wave_11"));  // other programs need not know of profiles
    EXPECT_THAT(test::read(loaded.resolved_toml).model.output.gauges, testing::SizeIs(11));
    EXPECT_THROW(test::read(flume + test::with(profile, "end = [1.8, 0.0]\n", "")), CaseError);
    EXPECT_THROW(test::read(flume + test::with(profile, "\"level\"", "\"surface\"")), CaseError);
}

TEST(FluidRecords, a_probe_of_several_quantities_is_one_of_each) {
    const std::string probe = "[[output.probe]]\nbody = \"floor\"\nquantity = [\"position\", \"fluid_force\"]\n";
    const auto& unnamed = test::read(flume + probe).model.output.probes;
    ASSERT_EQ(unnamed.size(), 2U);
    EXPECT_EQ(unnamed[1].name, "floor.fluid_force");
    EXPECT_EQ(test::read(flume + probe + "name = \"bed\"\n").model.output.probes[0].name, "bed.position");
    EXPECT_THROW(test::read(flume + test::with(probe, "fluid_force", "position")), CaseError);
}

TEST(FluidWarnings, water_with_a_density_in_another_unit) {
    EXPECT_THAT(test::read(test::with(flume, "spacing = 0.05", "spacing = 0.05\ndensity = 1.0")).warnings,
                ElementsAre(AllOf(HasSubstr("case.toml:8:"), HasSubstr("the water has a density of 1 kg/m^3"))));
    EXPECT_THAT(test::read(test::with(flume, "spacing = 0.05", "spacing = 0.05\ndensity = 790.0")).warnings,
                ElementsAre());
}

TEST(FluidWarnings, a_region_that_the_domain_cuts_and_water_that_no_wall_holds_there) {
    const std::string wide = test::with(flume, "high = [2.0, 0.5] }", "high = [4.0, 0.5] }");
    EXPECT_THAT(test::read(wide).warnings,
                ElementsAre(AllOf(HasSubstr("case.toml:11:1"), HasSubstr("reaches 1.5 m out of 'fluid.domain'")),
                            AllOf(HasSubstr("case.toml:10:10"), HasSubstr("water stands at the side x = 2.5 m"))));
    const std::string wall =
        "[[body]]\nname = \"wall\"\nmaterial = \"rock\"\nfixed = true\nposition = [2.5, 0.0]\n"
        "shape = { half_space = { normal = [-1.0, 0.0] } }\n";
    EXPECT_THAT(test::read(wide + wall).warnings, ElementsAre());  // in a solid no water would be placed either
    const std::string low_wall = body("wall", "[2.0, 0.4]", "[3.5, 0.2]", "fixed = true");
    EXPECT_THAT(test::read(wide + low_wall).warnings,
                ElementsAre(HasSubstr("reaches 1.5 m out"), HasSubstr("at the side x = 2.5 m")));
    const std::string flap =
        "[[fluid.outflow]]\nname = \"top\"\nlow = [0.0, 1.2]\nhigh = [1.0, 1.2]\ntowards = \"y\"\n";
    EXPECT_THAT(test::read(wide + flap).warnings, Contains(HasSubstr("water stands at the side x = 2.5 m")));
    const std::string tall = test::with(flume, "high = [2.0, 0.5] }", "high = [2.0, 5.0] }");
    EXPECT_THAT(test::read(test::with(tall, "high = [2.0, 5.0] }", "high = [2.0, 5.0] }\nlevel = 0.5")).warnings,
                ElementsAre());  // above its level it is empty
    EXPECT_THAT(test::read(tall + paddle("1.5")).warnings,
                Not(Contains(HasSubstr("has depth"))));  // 1.5 m deep is what the domain leaves of it
}

TEST(FluidWarnings, of_several_levels_that_of_the_water_at_the_paddle_counts) {
    const std::string two = test::with(flume, "high = [2.0, 0.5] }",
                                       "high = [1.0, 0.5] }\n[[fluid.region]]\nbox = { low = [1.0, 0.0], high = "
                                       "[2.0, 0.3] }");
    EXPECT_THAT(test::read(two + paddle("0.5")).warnings, ElementsAre());
    EXPECT_THAT(test::read(two + paddle("0.3")).warnings, ElementsAre(HasSubstr("0.5 m deep before it")));
    const std::string away = test::with(flume, "low = [0.0, 0.0], high", "low = [0.5, 0.0], high");
    EXPECT_THAT(test::read(away + paddle("0.3")).warnings,
                ElementsAre(HasSubstr("no water touches the face of the wave maker 'paddle'")));
}

TEST(FluidWarnings, a_paddle_off_the_water) {
    const auto warnings = [](const std::string& begin) {
        return test::read(test::with(flume, "low = [0.0, 0.0], high", "low = [" + begin + ", 0.0], high") +
                          paddle("0.5"))
            .warnings;
    };
    EXPECT_THAT(warnings("0.04"), ElementsAre());
    EXPECT_THAT(warnings("0.15"),
                ElementsAre(AllOf(HasSubstr("case.toml:23:"), HasSubstr("no water touches"), HasSubstr("0.075 m"))));
}

TEST(FluidWarnings, water_as_shallow_as_the_support_of_its_particles) {
    const auto warnings = [](const std::string& depth, const std::string& method) {
        const std::string wide = test::with(flume, "low = [-0.5, -0.2], high = [2.5", "low = [0.0, -0.2], high = [2.0");
        const std::string walls = body("left", "[0.2, 2.0]", "[-0.1, 0.5]", "fixed = true") +
                                  body("right", "[0.2, 2.0]", "[2.1, 0.5]", "fixed = true");
        return test::read(test::with(test::with(wide, "high = [2.0, 0.5] }", "high = [2.0, " + depth + "] }"),
                                     "[fluid]\n", "[fluid]\nmethod = \"" + method + "\"\n") +
                          walls)
            .warnings;
    };
    EXPECT_THAT(warnings("0.15", "sph"), Contains(AllOf(HasSubstr("3 spacings deep"), HasSubstr("0.015 m"))));
    EXPECT_THAT(warnings("0.15", "wcmps"), Contains(HasSubstr("3 spacings deep")));
    EXPECT_THAT(warnings("0.2", "sph"), Not(Contains(HasSubstr("spacings deep"))));  // 3 of support and one
    EXPECT_THAT(warnings("0.2", "mps"), Contains(HasSubstr("4 spacings deep")));     // 3.1 and one
    EXPECT_THAT(warnings("0.25", "mps"), Not(Contains(HasSubstr("spacings deep"))));
    // A wet floor beside a column is part of its water, one apart from it is not.
    const auto floor = [](const std::string& begin) {
        return "0.1] }\n[[fluid.region]]\nbox = { low = [" + begin + ", 0.0], high = [1.9, 0.6";
    };
    EXPECT_THAT(warnings(floor("0.3"), "sph"), Not(Contains(HasSubstr("spacings deep"))));
    const std::string apart = "0.1] }\n[[fluid.region]]\nbox = { low = [0.5, 0.5], high = [0.9, 1.0";
    EXPECT_THAT(warnings(apart, "sph"), Contains(HasSubstr("2 spacings deep")));
}

TEST(FluidWarnings, a_wave_lower_than_four_spacings) {
    const auto wave = [](const std::string& text) { return test::read(flume + paddle("0.5", "[0.4, 1.0]", text)); };
    EXPECT_THAT(wave("wave = \"regular\", height = 0.1, period = 1.5").warnings,
                ElementsAre(AllOf(HasSubstr("the wave of 'paddle' is 2 spacings high"),
                                  HasSubstr("fluid.spacing = 0.01 makes it ten"))));
    EXPECT_THAT(wave("wave = \"solitary\", height = 0.1").warnings, ElementsAre(HasSubstr("2 spacings high")));
    EXPECT_THAT(wave("wave = \"none\", absorb = [0.0, 0.0]").warnings, ElementsAre());
}

TEST(FluidWarnings, a_paddle_that_draws_back_out_of_the_domain) {
    // H/S = 2 (cosh 2kd - 1)/(sinh 2kd + 2kd) = 1.125 at kd = 1.105: it goes 0.089 m to both sides of its place.
    const auto domain_from = [](const std::string& low) {
        const std::string long_run = test::with(flume, "end = 1.0", "end = 6.0");  // it grows for two periods
        return test::with(long_run, "low = [-0.5, -0.2]", "low = [" + low + ", -0.2]") + paddle("0.5");
    };
    EXPECT_THAT(test::read(domain_from("-0.1")).warnings, ElementsAre());
    // As a piston of a whole plane, and where no water touches it, and whatever part of a period the end of the run is.
    const std::string plane = test::with(domain_from("-0.08"), "shape = { box = [0.4, 1.0] }\nposition = [-0.2, 0.5]",
                                         "shape = { half_space = { normal = [1.0, 0.0] } }");
    EXPECT_THAT(test::read(plane).warnings, ElementsAre(HasSubstr("which ends at -0.08 m")));
    EXPECT_THAT(test::read(test::with(plane, "low = [0.0, 0.0], high", "low = [0.3, 0.0], high")).warnings,
                ElementsAre(HasSubstr("which ends at -0.08 m"), HasSubstr("no water touches")));
    EXPECT_THAT(test::read(test::with(plane, "end = 6.0", "end = 2998.5")).warnings,  // 1999 periods
                ElementsAre(HasSubstr("which ends at -0.08 m")));
    EXPECT_THAT(test::read(domain_from("-0.08")).warnings,
                ElementsAre(AllOf(HasSubstr("the face of 'paddle' draws back to x = -0.0"),
                                  HasSubstr("which ends at -0.08 m"), HasSubstr("ends the run"))));
    EXPECT_THAT(test::read(domain_from("0.0")).warnings, ElementsAre(HasSubstr("which ends at 0 m")));
}

TEST(FluidWarnings, the_wave_of_a_paddle_is_reported) {
    const std::vector<PaddleWave> waves = test::read(flume + paddle("0.5")).waves;
    ASSERT_EQ(waves.size(), 1);
    EXPECT_EQ(waves[0].paddle, "paddle");
    // omega^2 d/g = kd tanh kd with omega = 2 pi/1.5 s, d = 0.5 m: kd = 1.105.
    const double kd = 2 * std::numbers::pi / waves[0].length * 0.5, omega = 2 * std::numbers::pi / 1.5;
    EXPECT_NEAR(kd * std::tanh(kd), omega * omega * 0.5 / 9.81, 1e-12);
    EXPECT_NEAR(waves[0].celerity, waves[0].length / 1.5, 1e-12);
    EXPECT_NEAR(waves[0].stroke, 0.2 / (2 * (std::cosh(2 * kd) - 1) / (std::sinh(2 * kd) + 2 * kd)), 1e-12);
    EXPECT_THAT(text_of(waves[0]),
                AllOf(HasSubstr("regular, 0.2 m high in 0.5 m of water, 1.5 s, 2.8"), HasSubstr("stroke 0.1")));
}

TEST(FluidWarnings, all_thin_bodies_are_named_with_a_sufficient_spacing) {
    const std::string bodies = body("gate", "[0.16, 1.0]", "[1.0, 0.6]", "fixed = true") +
                               body("raft", "[0.4, 0.155]", "[0.5, 0.5]") + body("block", "[0.2, 0.2]", "[1.5, 0.3]");
    EXPECT_THAT(test::read(flume + bodies).warnings,
                ElementsAre(AllOf(HasSubstr("'gate' and 'raft' are 3.1 to 3.2 spacings thick"),
                                  HasSubstr("opposite sides feels each other through them"),
                                  HasSubstr("fluid.spacing = 0.0387 or less would do"))));
    const std::string fine = test::with(flume, "spacing = 0.05", "spacing = 0.0387");
    EXPECT_THAT(test::read(fine + bodies).warnings, Not(Contains(HasSubstr("thick"))));
}

TEST(FluidWarnings, a_thin_body_with_water_on_one_side_does_no_harm_yet) {
    const std::vector<std::string> warnings =
        test::read(flume + paddle("0.5", "[0.4, 1.0]") + body("wall", "[0.1, 1.0]", "[2.05, 0.5]", "fixed = true"))
            .warnings;
    EXPECT_THAT(warnings, ElementsAre(AllOf(HasSubstr("'wall' is 2 spacings thick"),
                                            HasSubstr("no harm while water stays on one side"))));
}

TEST(FluidWarnings, the_room_for_water_is_that_outside_of_solids_and_counts_once) {
    const auto room = [](const std::string& text) { return test::read(text).model.particles()->region_volume; };
    EXPECT_NEAR(room(flume), 1.0, 1e-12);
    EXPECT_NEAR(room(flume + body("block", "[0.4, 0.4]", "[1.0, 0.4]")), 1.0 - 0.4 * 0.3, 1e-12);
    const std::string more = test::with(flume, "high = [2.0, 0.5] }",
                                        "high = [2.0, 0.5] }\n[[fluid.region]]\nbox = { low = [1.5, -0.1], high = "
                                        "[2.2, 0.6] }");
    EXPECT_NEAR(room(more), 1.0 + 0.5 * 0.1 + 0.2 * 0.6, 1e-12);
}

// Story: once a block had slid by micrometres the water of a region that ended at its face was gone.
TEST(FluidWarnings, a_region_of_still_water_that_ends_at_a_face_of_a_block_is_told) {
    const auto warnings_of = [](const char* end) {
        return test::read(std::string(R"(gravity = [0.0, 0.0, -9.81]
end = 1.0
[material.rock]
density = 2500.0
normal_stiffness = 1.0e7
[[body]]
name = "block"
material = "rock"
shape = { cube = 1.0 }
[fluid]
method = "hydrostatic"
spacing = 0.1
domain = { low = [-5, -5, -5], high = [5, 5, 5] }
[[fluid.region]]
box = { low = [-5, -5, -5], high = [)") +
                          end + ", 5, 5] }\nlevel = 1.0\n")
            .warnings;
    };
    const auto told = testing::Contains(testing::HasSubstr("case.toml:14:1: the region ends at a face of 'block'"));
    EXPECT_THAT(warnings_of("-0.5"), told);
    EXPECT_THAT(warnings_of("-0.4"), testing::Not(told));
    EXPECT_THAT(warnings_of("5"), testing::Not(told));
}

}  // namespace
}  // namespace riprap::scene
