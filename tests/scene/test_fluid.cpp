// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "riprap/fluid/sph/device/device_sph.hpp"
#include "riprap/sim/quantity.hpp"
#include "scene/case_fixture.hpp"

namespace riprap::scene {
namespace {

using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// A tank one metre wide, half full, with a block afloat.
const std::string tank = R"(dimension = 2
gravity = [0.0, -9.81]
end = 1.0
[material.wood]
density = 500.0
normal_stiffness = 1.0e6
[[body]]
name = "bottom"
material = "wood"
shape = { half_space = { normal = [0.0, 1.0], offset = 0.0 } }
fixed = true
[[body]]
name = "block"
material = "wood"
shape = { box = [0.2, 0.2] }
position = [0.5, 0.5]
[fluid]
spacing = "2 cm"
domain = { low = [0.0, -0.1], high = [1.0, 1.0], periodic = [true, false] }
[[fluid.region]]
level = "50 cm"
)";

TEST(FluidCase, water_fills_its_region_outside_of_solids) {
    const LoadedCase loaded = test::read(tank);
    ASSERT_TRUE(loaded.model.particles() != nullptr);
    // 50 x 25 places, less the lower half of the block: 10 x 5 of them.
    EXPECT_EQ(loaded.state.fluid.size(), 50 * 25 - 10 * 5);
    EXPECT_NEAR(loaded.model.particles()->filled_volume, 0.48, 1e-12);
    EXPECT_NEAR(loaded.model.particles()->settings().particle_mass, 1000 * 0.02 * 0.02, 1e-12);
    EXPECT_EQ(loaded.model.particles()->settings().domain.dimension, 2);
}

TEST(FluidCase, the_sound_speed_follows_from_the_depth_unless_given) {
    // The lattice begins at the low corner of the domain, 10 cm below the bottom of the tank.
    EXPECT_NEAR(test::read(tank).model.particles()->settings().sound_speed, 10 * 2 * std::sqrt(9.81 * 0.5), 1e-9);
    EXPECT_NEAR(test::read(tank, {"fluid.expected_speed=0"}).model.particles()->settings().sound_speed,
                10 * std::sqrt(9.81 * 0.5), 1e-9);
    EXPECT_EQ(test::read(tank, {"fluid.sound_speed=33.0"}).model.particles()->settings().sound_speed, 33);
}

TEST(FluidCase, the_sound_speed_heeds_the_rim_of_a_body_that_spins) {
    const double spin = 200, rim = 0.1 * std::sqrt(2.0);
    const std::string spinning =
        test::with(tank, "position = [0.5, 0.5]", "position = [0.5, 0.5]\nangular_velocity = 200.0");
    EXPECT_GE(test::read(spinning).model.particles()->settings().sound_speed, 10 * spin * rim * (1 - 1e-9));
}

TEST(FluidCase, warns_of_the_limits_of_the_scheme_of_muller) {
    const auto about_muller = [](const LoadedCase& loaded) {
        return std::count_if(loaded.warnings.begin(), loaded.warnings.end(),
                             [](const std::string& text) { return text.find("muller") != std::string::npos; });
    };
    EXPECT_EQ(about_muller(test::read(tank)), 0);
    EXPECT_EQ(about_muller(test::read(tank, {"fluid.scheme=muller"})), 2);
    EXPECT_EQ(about_muller(
                  test::read(tank, {"fluid.scheme=muller", "fluid.artificial_alpha=0.1", "fluid.smoothing_ratio=1.2"})),
              1);
}

TEST(FluidCase, warns_where_there_is_no_device_for_the_water) {
    EXPECT_THAT(test::read(tank).warnings, Each(Not(HasSubstr("runs_on"))));
    const auto warnings = test::read(tank, {"fluid.runs_on=device"}).warnings;
    if (fluid::has_device()) {
        EXPECT_THAT(warnings, Each(Not(HasSubstr("runs_on"))));
    } else {
        EXPECT_THAT(warnings, Contains(HasSubstr("fluid.runs_on = \"device\", but this program finds none")));
    }
    EXPECT_THROW(test::read(tank, {"fluid.runs_on=device", "fluid.tait_exponent=6.5"}), CaseError);
}

TEST(FluidCase, corrected_gradients_can_be_left_out) {
    EXPECT_TRUE(test::read(tank).model.particles()->sph().gradient_correction);
    EXPECT_FALSE(test::read(tank, {"fluid.gradient_correction=false"}).model.particles()->sph().gradient_correction);
}

TEST(FluidCase, a_smoothing_ratio_at_which_its_constants_are_not_known_is_refused) {
    for (const char* ratio : {"1.2", "1.8", "2"}) {
        EXPECT_THROW(test::read(tank, {std::string("fluid.smoothing_ratio=") + ratio}), CaseError) << ratio;
    }
    EXPECT_NO_THROW(test::read(tank, {"fluid.smoothing_ratio=1.5"}));
    EXPECT_NO_THROW(test::read(tank, {"fluid.smoothing_ratio=1.2", "fluid.scheme=muller"}));
}

TEST(FluidCase, boundary_particles_stand_for_all_wet_bodies) {
    const LoadedCase loaded = test::read(tank);
    const coupling::SampleSet& samples = loaded.model.particles()->samples;
    EXPECT_EQ(std::count(samples.body.begin(), samples.body.end(), BodyId{1}), 10 * 10 - 4 * 4);
    const std::string dry = test::with(tank, "position = [0.5, 0.5]", "position = [0.5, 0.5]\nwet = false");
    const LoadedCase without = test::read(dry);
    EXPECT_EQ(std::count(without.model.particles()->samples.body.begin(), without.model.particles()->samples.body.end(),
                         BodyId{1}),
              0);
    EXPECT_EQ(test::read(tank, {"fluid.wall=\"penalty\""}).model.particles()->samples.size(), 0);
}

TEST(FluidCase, a_body_can_let_water_stick_to_it) {
    const std::string sticky = test::with(tank, "position = [0.5, 0.5]", "position = [0.5, 0.5]\nslip = false");
    const coupling::SampleSet samples = test::read(sticky).model.particles()->samples;
    for (std::size_t i = 0; i < samples.body.size(); ++i) {
        EXPECT_EQ(samples.is_slippery[i], samples.body[i] == BodyId{1} ? 0 : 1);
    }
}

TEST(FluidCase, problems_name_their_place) {
    EXPECT_THAT(test::problems_of(test::with(tank, "high = [1.0, 1.0]", "high = [-1.0, 1.0]")),
                ElementsAre(HasSubstr("case.toml:19:10: the domain reaches from 0 m to -1 m along x")));
    EXPECT_THAT(test::problems_of(test::with(tank, "2 cm", "3 cm")),
                ElementsAre(HasSubstr("33.3333333 spacings; a whole number of spacings")));
    EXPECT_THAT(test::problems_of(test::with(tank, "50 cm", "-50 cm")),
                ElementsAre(HasSubstr("case.toml:20:1: no particle of water fits into this region")));
    EXPECT_THAT(test::problems_of(test::with(tank, "2 cm", "0.01 mm")),
                ElementsAre(HasSubstr("places of the lattice; particles are at most 50000000")));
    EXPECT_THAT(test::problems_of(test::with(tank, "spacing = \"2 cm\"", "spacing = \"2 cm\"\nmethod = \"ether\"")),
                ElementsAre(HasSubstr("is not known")));
}

TEST(FluidCase, a_level_above_its_region_is_refused) {
    const auto problems = [](const std::string& region) {
        return test::problems_of(test::with(tank, "level = \"50 cm\"", region));
    };
    const std::string box = "box = { low = [0.0, 0.0], high = [0.3, 0.4] }\n";
    EXPECT_THAT(problems(box + "level = 0.4"), testing::IsEmpty());
    EXPECT_THAT(problems(box + "level = 0.42"),
                ElementsAre(HasSubstr("case.toml:22:9: the level 0.42 m lies above its region, which ends at 0.4 m")));
    EXPECT_THAT(problems("shape = { box = [0.2, 0.2] }\nposition = [0.2, 0.2]\nlevel = 0.4"),
                ElementsAre(HasSubstr("ends at 0.3 m")));
    EXPECT_THAT(problems("level = 1.0"), testing::IsEmpty());  // the domain is the region
    EXPECT_THAT(problems("level = 1.1"), ElementsAre(HasSubstr("ends at 1 m")));
}

TEST(FluidCase, density_at_the_start_is_hydrostatic) {
    const LoadedCase loaded = test::read(tank);
    const double c = loaded.model.particles()->settings().sound_speed;
    for (std::size_t i = 0; i < loaded.state.fluid.density.size(); ++i) {
        const double a = 9.81 * (0.5 - loaded.state.fluid.position[i].y) / (c * c);
        // (1 + 7 a)^(1/7) to second order; the third is 13 a^3, here at most 2e-7.
        EXPECT_NEAR(loaded.state.fluid.density[i], 1000 * (1 + a - 3 * a * a), 3e-4);
    }
}

TEST(FluidCase, a_spacing_beyond_all_counting_is_refused_for_what_it_is) {
    for (const char* spacing : {"1e-30", "1e-300", "1e-12"}) {
        EXPECT_THAT(
            test::problems_of(test::with(test::with(tank, "\"2 cm\"", spacing), ", periodic = [true, false]", "")),
            ElementsAre(HasSubstr("spacings of")))
            << spacing;
    }
}

TEST(FluidCase, a_period_within_which_a_free_block_meets_its_own_joints_is_refused) {
    // 8 spacings; joints look 4.5 to either side.
    const std::string coarse = test::with(tank, "\"2 cm\"", "0.125");
    EXPECT_THAT(test::problems_of(coarse), ElementsAre(HasSubstr("joints")));
    EXPECT_TRUE(test::read(coarse, {"fluid.joint_pressure=false"}).model.particles() != nullptr);
    EXPECT_TRUE(test::read(coarse, {"body.block.fixed=true"}).model.particles() != nullptr);
    EXPECT_TRUE(test::read(tank).model.particles()->has_joint_pressure);
    EXPECT_FALSE(test::read(tank, {"fluid.wall=penalty"}).model.particles()->has_joint_pressure);
    EXPECT_FALSE(test::read(tank, {"fluid.scheme=muller"}).model.particles()->has_joint_pressure);
}

TEST(FluidCase, gauges_become_columns_and_can_be_expected) {
    const LoadedCase loaded = test::read(tank + R"(
[[output.gauge]]
name  = "depth"
kind  = "level"
point = [0.2, 0.0]

[[output.gauge]]
name  = "current"
kind  = "velocity"
point = [0.5, 0.2]

[[expect]]
name      = "the water stands"
quantity  = "depth"
value     = 0.5
tolerance = 0.01
citation  = "the level at the start"
)");
    std::vector<std::string> names;
    for (const sim::Column& column : sim::record_columns(loaded.model)) {
        names.push_back(column.name + " [" + column.unit + "]");
    }
    EXPECT_THAT(names, ElementsAre("depth [m]", "current.x [m/s]", "current.y [m/s]", "current.z [m/s]"));
    const auto depth = sim::find_column(loaded.model, "depth");
    ASSERT_TRUE(depth);
    EXPECT_NEAR(sim::evaluate(*depth, {loaded.model, loaded.state, loaded.state, nullptr, nullptr}), 0.5, 0.01);
}

TEST(FluidCase, gauges_that_read_nothing_are_refused_with_the_reason) {
    const auto problems = [](const std::string& text) {
        return test::problems_of(tank + "\n[[output.gauge]]\nname = \"g\"\n" + text);
    };
    EXPECT_THAT(problems("kind = \"pressure\"\npoint = [90.0, 0.0]\n"), ElementsAre(HasSubstr("outside the domain")));
    EXPECT_THAT(
        test::problems_of(tank + "\n[[output.gauge]]\nname = \"water_mass\"\nkind = \"level\"\npoint = [0.5, 0.1]\n"),
        ElementsAre(HasSubstr("has the name of a quantity")));
    EXPECT_THAT(problems("kind = \"surface\"\npoint = [0.5, 0.1]\n"), ElementsAre(HasSubstr("without 'end'")));
    EXPECT_THAT(problems("kind = \"flow\"\npoint = [0.5, 0.1]\nend = [0.7, 0.4]\n"),
                ElementsAre(HasSubstr("its corners differ along every axis")));
    EXPECT_THAT(problems("kind = \"volume\"\npoint = [0.5, 0.1]\nend = [0.5, 0.4]\n"),
                ElementsAre(HasSubstr("without volume")));
    EXPECT_THAT(problems("kind = \"wall_pressure\"\npoint = [0.5, 0.25]\n"),
                ElementsAre(HasSubstr("no wet face within a spacing, 0.02 m, of the gauge 'g'")));
    for (const char* kind : {"pressure", "velocity", "level"}) {
        EXPECT_THAT(problems(fmt::format("kind = \"{}\"\npoint = [0.5, 0.1]\nend = [0.5, 0.4]\n", kind)),
                    ElementsAre(HasSubstr(fmt::format("'end' does nothing for a '{}' gauge", kind))));
        EXPECT_THAT(problems(fmt::format("kind = \"{}\"\npoint = [0.5, 0.1]\narea = 1e-4\n", kind)),
                    ElementsAre(HasSubstr(fmt::format("'area' does nothing for a '{}' gauge", kind))));
    }
}

TEST(FluidCase, a_gauge_may_go_with_a_body_that_it_names) {
    const auto gauge = [](const std::string& text) { return tank + "\n[[output.gauge]]\nname = \"g\"\n" + text; };
    const LoadedCase loaded =
        test::read(gauge("kind = \"surface\"\nbody = \"block\"\npoint = [0.5, 0.1]\nend = [0.5, 0.9]\n"));
    const fluid::Gauge& g = loaded.model.output.gauges.at(0);
    EXPECT_EQ(g.carrier, 1);
    EXPECT_EQ(g.point, (Vec3{0, -0.4, 0}));  // from the centre of the block
    EXPECT_EQ(g.end, (Vec3{0, 0.4, 0}));
    EXPECT_THAT(test::problems_of(gauge("kind = \"level\"\nbody = \"blok\"\npoint = [0.5, 0.1]\n")),
                ElementsAre(HasSubstr("did you mean 'block'?")));
    EXPECT_THAT(test::problems_of(gauge("kind = \"volume\"\nbody = \"block\"\npoint = [0.5, 0.1]\nend = [0.7, 0.3]\n")),
                ElementsAre(HasSubstr("the 'volume' gauge 'g' cannot move with a body")));
    // The bottom is nearer, but the gauge belongs to the block.
    const std::string wall = "kind = \"wall_pressure\"\npoint = [0.5, 0.0]\nbody = ";
    EXPECT_THAT(test::problems_of(gauge(wall + "\"block\"\n")), ElementsAre(HasSubstr("no wet face of 'block'")));
    EXPECT_EQ(test::read(gauge(wall + "\"bottom\"\n")).model.output.faces.at(0).body, BodyId{0});
}

TEST(FluidCase, warns_of_a_step_above_the_acoustic_limit_of_a_lattice) {
    const auto about_courant = [](const std::vector<std::string>& settings) {
        const auto all = test::read(tank, settings).warnings;
        return std::count_if(all.begin(), all.end(),
                             [](const std::string& text) { return text.find("short waves of sound") < text.size(); });
    };
    EXPECT_EQ(about_courant({}), 0);
    EXPECT_EQ(about_courant({"fluid.density_diffusion=0.5"}), 1);
    EXPECT_EQ(about_courant({"fluid.density_diffusion=0.5", "fluid.courant=0.4"}), 0);
    EXPECT_EQ(about_courant({"fluid.scheme=muller", "fluid.density_diffusion=0.5"}), 0);
    EXPECT_THAT(test::read(tank, {"fluid.gradient_correction=false", "fluid.density_diffusion=0.5"}).warnings,
                Contains(HasSubstr("no acoustic_damping, as gradient_correction is off")));
}

// A gauge on the underside of the wall, between the parts of the tank, would read 0 for ever.
TEST(FluidCase, a_gauge_in_the_corner_of_a_tank_of_parts_is_in_a_face_that_water_can_reach) {
    const std::string basin = R"([[body]]
name = "basin"
material = "wood"
fixed = true
position = [0.5, 0.6]
shape = { union = [
    { shape = { box = [0.4, 0.1] }, position = [0.2, -0.05] },
    { shape = { box = [0.1, 0.1] }, position = [-0.05, -0.05] },
    { shape = { box = [0.1, 0.3] }, position = [-0.05, 0.15] },
] }
[[output.gauge]]
name = "g"
kind = "wall_pressure"
body = "basin"
point = )";
    const std::string room = test::with(tank, "position = [0.5, 0.5]", "position = [0.2, 0.2]");
    for (const char* point : {"[0.5, 0.6]\n", "[0.497, 0.602]\n", "[0.49, 0.598]\n"}) {  // about the corner
        const LoadedCase at_corner = test::read(room + basin + point);
        const Vec3 corner = at_corner.model.output.faces.at(0).normal;
        EXPECT_TRUE(corner.x == 1 || corner.y == 1) << point << corner.x << ' ' << corner.y;
    }
}

TEST(FluidCase, warns_of_a_gauge_inside_a_block) {
    const std::string gauge = tank + "\n[[output.gauge]]\nname = \"g\"\nkind = \"velocity\"\npoint = ";
    EXPECT_THAT(test::read(gauge + "[0.5, 0.5]\n").warnings,
                Contains(HasSubstr("'g' lies inside 'block' at the start")));
    EXPECT_THAT(test::read(gauge + "[0.5, 0.2]\n").warnings, Each(Not(HasSubstr("lies inside"))));
    EXPECT_THAT(test::read(test::with(gauge, "\"velocity\"", "\"level\"") + "[0.5, 0.5]\n").warnings,
                Contains(HasSubstr("'g' lies inside 'block' at the start")));
}

TEST(FluidCase, warns_of_a_gauge_that_starts_in_a_block_thinner_than_two_spacings_and_of_one_in_water_of_the_grid) {
    const std::string gauge = "\n[[output.gauge]]\nname = \"g\"\nkind = \"pressure\"\npoint = ";
    const std::string thin = test::with(tank, "{ box = [0.2, 0.2] }", "{ box = [0.03, 0.2] }");
    EXPECT_THAT(test::read(thin + gauge + "[0.5, 0.5]\n").warnings,
                Contains(HasSubstr("'g' lies inside 'block' at the start and reads the water beside it")));
    const std::string cells =
        test::with(test::with(tank, "[fluid]\n", "[fluid]\nmethod = \"grid\"\n"), ", periodic = [true, false]", "");
    EXPECT_THAT(test::read(cells + gauge + "[0.5, 0.5]\n").warnings,
                Contains(HasSubstr("'g' lies inside 'block' at the start")));
    EXPECT_THAT(test::read(cells + gauge + "[0.5, 0.2]\n").warnings, Each(Not(HasSubstr("lies inside"))));
}

TEST(FluidCase, warns_of_a_gauge_nearer_than_two_spacings_to_an_edge_of_its_face) {
    const auto warnings = [](const std::string& point) {
        return test::read(
                   test::with(tank, "{ box = [0.2, 0.2] }", "{ box = [0.2, 0.4] }") +
                   "\n[[output.gauge]]\nname = \"g\"\nkind = \"wall_pressure\"\nbody = \"block\"\npoint = " + point)
            .warnings;
    };
    const auto of_an_edge = HasSubstr("'g' is nearer than two spacings");
    EXPECT_THAT(warnings("[0.4, 0.5]\n"), Each(Not(of_an_edge)));
    EXPECT_THAT(warnings("[0.4, 0.67]\n"), Contains(of_an_edge));
    EXPECT_THAT(warnings("[0.4, 0.65]\n"), Each(Not(of_an_edge)));
    EXPECT_THAT(warnings("[0.5, 0.7]\n"), Each(Not(of_an_edge)));  // in the middle of the top
    EXPECT_THAT(warnings("[0.57, 0.7]\n"), Contains(of_an_edge));
}

TEST(FluidCase, warns_of_a_run_up_line_that_ends_at_a_block) {
    const std::string gauge = tank + "\n[[output.gauge]]\nname = \"g\"\nkind = \"run_up\"\npoint = ";
    EXPECT_THAT(test::read(gauge + "[0.2, 0.5]\nend = [0.9, 0.5]\n").warnings,
                Contains(HasSubstr("the run_up gauge 'g' meets 'block' at the start")));
    EXPECT_THAT(test::read(gauge + "[0.2, 0.1]\nend = [0.2, 0.5]\n").warnings, Each(Not(HasSubstr("meets"))));
}

TEST(FluidCase, a_run_up_line_of_any_length_is_looked_along_at_a_bounded_cost) {
    const std::string gauge = tank + "\n[[output.gauge]]\nname = \"g\"\nkind = \"run_up\"\npoint = [0.2, 0.1]\nend = ";
    EXPECT_THAT(test::read(gauge + "[0.2, 1e12]\n").warnings, Each(Not(HasSubstr("meets"))));
    EXPECT_THAT(test::problems_of(gauge + "[0.2, 1e300]\n"), Contains(HasSubstr("a line that ends at (0.2, 1e+300")));
}

TEST(FluidCase, warns_of_a_covered_gauge) {
    const auto warnings = [](const char* point) {
        const auto all =
            test::read(tank + "\n[[output.gauge]]\nname = \"g\"\nkind = \"wall_pressure\"\npoint = " + point).warnings;
        return std::count_if(all.begin(), all.end(),
                             [](const std::string& text) { return text.find("'g' is covered") != std::string::npos; });
    };
    EXPECT_EQ(warnings("[0.3, 0.0]\n"), 0);
    EXPECT_EQ(warnings("[0.3, 0.0]\n[[body]]\nname = \"slab\"\nshape = { box = [0.2, 0.1] }\nposition = [0.3, 0.05]\n"
                       "material = \"wood\"\nfixed = true\n"),
              1);
}

/// A channel between x = 0 and 0.8 m.
const std::string channel = test::with(test::with(tank, ", periodic = [true, false] }", " }"), "level = \"50 cm\"",
                                       "box = { low = [0.2, 0.0], high = [0.8, 0.3] }") +
                            R"([[fluid.inflow]]
name = "upstream"
low = [0.2, 0.0]
high = [0.2, 0.3]
towards = "x"
speed = 0.5
[[fluid.outflow]]
name = "downstream"
low = [0.8, 0.0]
high = [0.8, 0.3]
towards = "x"
level = 0.3
)";

TEST(FluidCase, openings_stand_clear_of_solids_and_of_water_behind_them) {
    EXPECT_THAT(test::problems_of(channel), testing::IsEmpty());
    EXPECT_THAT(test::problems_of(test::with(channel, "position = [0.5, 0.5]", "position = [0.05, 0.2]")),
                ElementsAre(HasSubstr("'block' stands in the opening 'upstream'")));
    EXPECT_THAT(test::problems_of(test::with(channel, "position = [0.5, 0.5]", "position = [0.95, 0.2]")),
                ElementsAre(HasSubstr("'block' stands in the opening 'downstream'")));
    EXPECT_THAT(
        test::problems_of(test::with(channel, "low = [0.2, 0.0], high = [0.8", "low = [0.16, 0.0], high = [0.8")),
        ElementsAre(HasSubstr("30 particles of water start behind the opening 'upstream'")));
    EXPECT_THAT(test::problems_of(test::with(channel, "high = [0.8, 0.3] }", "high = [0.82, 0.3] }")),
                ElementsAre(HasSubstr("15 particles of water start behind the opening 'downstream'")));
}

TEST(FluidCase, an_inflow_of_broken_spacings_says_what_it_brings) {
    const auto warnings = [](const std::string& high) {
        return test::read(test::with(channel, "high = [0.2, 0.3]", "high = [0.2, " + high + "]")).warnings;
    };
    EXPECT_THAT(warnings("0.3"), testing::Not(testing::Contains(HasSubstr("inflow"))));
    EXPECT_THAT(warnings("0.29"), testing::Contains(HasSubstr("takes 0.28 m of 0.29 m")));
    EXPECT_THAT(warnings("0.29"), testing::Contains(HasSubstr("it brings 0.14 m^2/s")));
}

TEST(FluidCase, a_sponge_that_meets_no_water_is_refused) {
    EXPECT_THAT(
        test::problems_of(channel + "[[fluid.sponge]]\nlow = [50, 0]\nhigh = [51, 1]\ntowards = \"x\"\nrate = 1.0\n"),
        ElementsAre(HasSubstr("the sponge lies outside the domain")));
}

TEST(FluidCase, a_paddle_that_absorbs_does_not_stop) {
    const auto problems = [](const std::string& more) {
        return test::problems_of(
            test::with(tank, "shape = { half_space = { normal = [0.0, 1.0], offset = 0.0 } }\nfixed = true",
                       "shape = { half_space = { normal = [0.0, 1.0], offset = 0.0 } }\nfixed = true\n"
                       "[[body]]\nname = \"paddle\"\nmaterial = \"wood\"\n"
                       "shape = { half_space = { normal = [1.0, 0.0] } }\n"
                       "motion = { wave_maker = { wave = \"none\", depth = 0.5, absorb = [0.0, 0.0] }" +
                           more + " }"));
    };
    EXPECT_THAT(problems(", stop = 0.5"), testing::Contains(HasSubstr("stops and absorbs")));
    EXPECT_THAT(problems(""), testing::Not(testing::Contains(HasSubstr("stops and absorbs"))));
}

// A metre in front of its paddle the point was taken, and waves grew fivefold.
TEST(FluidCase, absorption_looks_at_the_water_from_the_foot_of_the_paddle) {
    const auto problems = [](const std::string& foot) {
        return test::problems_of(
            test::with(tank, "shape = { half_space = { normal = [0.0, 1.0], offset = 0.0 } }\nfixed = true",
                       "shape = { half_space = { normal = [0.0, 1.0], offset = 0.0 } }\nfixed = true\n"
                       "[[body]]\nname = \"paddle\"\nmaterial = \"wood\"\n"
                       "shape = { half_space = { normal = [1.0, 0.0] } }\n"
                       "motion = { wave_maker = { wave = \"none\", depth = 0.5, absorb = " +
                           foot + " } }"));
    };
    EXPECT_THAT(problems("[0.0, 0.0]"), testing::Not(testing::Contains(HasSubstr("'absorb'"))));
    EXPECT_THAT(problems("[0.5, 0.0]"), testing::Contains(HasSubstr("more than a spacing from the faces of 'paddle'")));
}

TEST(FluidCase, warns_of_a_free_body_outside_the_domain) {
    const std::string block =
        "[[body]]\nname = \"far\"\nmaterial = \"wood\"\nshape = { box = [0.1, 0.1] }\nposition = ";
    EXPECT_THAT(test::read(std::string(tank) + block + "[0.2, 7.0]\n").warnings,
                testing::Contains(HasSubstr("'far' at (0.2, 7, 0) m starts outside of 'fluid.domain'")));
    EXPECT_THAT(test::read(std::string(tank) + block + "[0.2, 7.0]\nrepeat = { counts = [1, 3], pitch = [0.2, 0.2] }\n")
                    .warnings,
                testing::Contains(HasSubstr("and 2 more start outside")));  // a slide of a thousand is one line
    EXPECT_THAT(test::read(std::string(tank) + block + "[0.2, 0.2]\n").warnings,
                testing::Not(testing::Contains(HasSubstr("outside of 'fluid.domain'"))));
}

}  // namespace
}  // namespace riprap::scene
