// SPDX-License-Identifier: Apache-2.0
// Rows of the key table: water.
#include "riprap/fluid/sph/sph_settings.hpp"
#include "riprap/scene/keys/key_table.hpp"
#include "riprap/scene/keys/limits.hpp"

namespace riprap::scene {

using namespace form;

namespace {

const Table& fluid_domain_table() {
    static const Table table{
        "fluid.domain",
        "domain = { ... }",
        "The box that water may be in. A particle that leaves it through a side that is not periodic ends the run: "
        "give it room above walls that water may splash over, or an outflow there.",
        {{"low", {vector(dimension::length)}, "Low corner.", {}, true},
         {"high", {vector(dimension::length)}, "High corner.", {}, true},
         {"periodic",
          {list(boolean(), 2, 3)},
          "Whether what leaves through one side enters through the other, along x, y and z; not when not given.",
          {}}}};
    return table;
}

const Table& fluid_box_table() {
    static const Table table{"fluid.region.box",
                             "box = { ... }",
                             "A box along the axes.",
                             {{"low", {vector(dimension::length)}, "Low corner.", {}, true},
                              {"high", {vector(dimension::length)}, "High corner.", {}, true}}};
    return table;
}

const Table& fluid_region_table() {
    static const Table table{
        "fluid.region",
        "[[fluid.region]]",
        "Water at the start: what lies in the region, below its level and outside every solid. The whole domain when "
        "neither box nor shape is given. All regions share one lattice; where they overlap the first one counts.",
        {{"box", {form::table(fluid_box_table)}, "The region as a box.", {}},
         {"shape", {form::table(shape_table)}, "The region as a shape; not a half-space.", {}},
         {"position", {vector(dimension::length)}, "Of the origin of the shape.", Value::of(Vec3{})},
         {"orientation", {form::table(orientation_table)}, "How the shape is turned.", {}},
         {"level",
          {number(dimension::length)},
          "Height of the surface at the start, against gravity from the origin: z where gravity points down z. At most "
          "the top of the region, which it is when not given.",
          {}},
         {"velocity", {vector(dimension::velocity)}, "At the start.", Value::of(Vec3{})}},
        {{GroupRule::at_most_one, {"box", "shape"}}}};
    return table;
}

const Form way = choice({"x", "-x", "y", "-y", "z", "-z"});

const Table& fluid_sponge_table() {
    static const Table table{
        "fluid.sponge",
        "[[fluid.sponge]]",
        "A box in which water is slowed down ever more along one direction, so that waves die before they come back. "
        "The "
        "energy is booked as water_absorbed.",
        {{"low", {vector(dimension::length)}, "Low corner.", {}, true},
         {"high", {vector(dimension::length)}, "High corner.", {}, true},
         {"towards", {way}, "The direction along which it grows, from nothing.", {}, true},
         {"rate",
          {choice({"auto"}), number(dimension::frequency, positive())},
          "At its end; it grows as the square. \"auto\": that which sends a long wave back with a hundredth of its "
          "height.",
          Value::of("auto")},
         {"velocity", {vector(dimension::velocity)}, "That of a current that stays.", Value::of(Vec3{})}}};
    return table;
}

const Table& fluid_inflow_table() {
    static const Table table{
        "fluid.inflow",
        "[[fluid.inflow]]",
        "Water enters through a rectangle (a line in a planar scene) at a given speed; its pressure is that of the "
        "water in "
        "front of it. Leave room for its layers, a support and one spacing (four spacings by default), behind it.",
        {{"name", {form::name()}, "Unique among the openings.", {}, true},
         {"low", {vector(dimension::length)}, "A corner.", {}, true},
         {"high", {vector(dimension::length)}, "The opposite corner, equal along the axis of `towards`.", {}, true},
         {"towards", {way}, "The way the water goes.", {}, true},
         {"speed", {number(dimension::velocity, positive())}, "Of the water that enters.", {}, true},
         {"ramp", {number(dimension::time, non_negative())}, "Time in which the speed grows from 0.", Value::of(0.0)},
         {"level",
          {number(dimension::length)},
          "Height up to which water enters, from the origin against gravity; all of the rectangle when not given.",
          {}}}};
    return table;
}

const Table& fluid_outflow_table() {
    static const Table table{
        "fluid.outflow",
        "[[fluid.outflow]]",
        "Water that passes a rectangle (a line in a planar scene) is gone. Where neither speed nor level is given it "
        "falls "
        "into nothing: for water that drops or runs faster than its waves.",
        {{"name", {form::name()}, "Unique among the openings.", {}, true},
         {"low", {vector(dimension::length)}, "A corner.", {}, true},
         {"high", {vector(dimension::length)}, "The opposite corner, equal along the axis of `towards`.", {}, true},
         {"towards", {way}, "The way the water goes.", {}, true},
         {"speed", {number(dimension::velocity, positive())}, "At which it is drawn off.", {}},
         {"level",
          {number(dimension::length)},
          "Height of still water behind it, from the origin against gravity: the outflow has its pressure.",
          {}}},
        {{GroupRule::at_most_one, {"speed", "level"}}}};
    return table;
}

}  // namespace

const Table& fluid_table() {
    static const fluid::SphSettings defaults;  // one place says them, for cases and for programs
    static const Table table{
        "fluid",
        "[fluid]",
        "Water as particles. The defaults serve every case; spacing, domain and regions say what is special.",
        {{"method",
          {choice({"sph"}, {"wcmps", "mps", "finite_volume", "hydrostatic"})},
          "How water moves.",
          Value::of("sph")},
         {"scheme",
          {choice({"delta_sph", "muller"})},
          "Form of SPH: with diffusion of density and shifting of particles; or that of Mueller et al. (2003), density "
          "by summation, for comparison: it needs an artificial_alpha of 0.1 or more.",
          Value::of("delta_sph")},
         {"spacing", {number(dimension::length, positive())}, "Distance of particles at the start.", {}, true},
         {"smoothing_ratio",
          {number(dimension::plain, between(1, 3))},
          "Smoothing length over spacing; the kernel ends at twice that.",
          Value::of(defaults.smoothing_ratio)},
         {"density",
          {number(dimension::density, positive())},
          "At rest, without pressure.",
          Value::of(defaults.rest_density)},
         {"sound_speed",
          {choice({"auto"}), number(dimension::velocity, positive())},
          "Of the model. \"auto\": ten times the largest of sqrt(g H), expected_speed and the speeds that the case "
          "gives water and moving bodies, H the depth of the water at the start. Density then varies by about 1 %.",
          Value::of("auto")},
         {"expected_speed",
          {choice({"auto"}), number(dimension::velocity, non_negative())},
          "The highest speed that water will reach, for the sound speed. \"auto\": that of the tip of a dam break, "
          "2 sqrt(g H).",
          Value::of("auto")},
         {"state_equation", {choice({"tait", "linear"})}, "How pressure follows from density.", Value::of("tait")},
         {"tait_exponent",
          {number(dimension::plain, between(1, 10))},
          "Of the Tait equation.",
          Value::of(defaults.tait_exponent)},
         {"viscosity",
          {choice({"artificial", "laminar_sps"})},
          "Artificial viscosity, or that of water with a model of what turbulence the particles do not resolve.",
          Value::of("artificial")},
         {"artificial_alpha",
          {number(dimension::plain, between(0, 1))},
          "Strength of the artificial viscosity.",
          Value::of(defaults.artificial_alpha)},
         {"kinematic_viscosity",
          {number(dimension::kinematic_viscosity, non_negative())},
          "Of the fluid, for laminar_sps.",
          Value::of(defaults.kinematic_viscosity)},
         {"smagorinsky",
          {number(dimension::plain, between(0, 1))},
          "Constant of the turbulence model of laminar_sps.",
          Value::of(defaults.smagorinsky)},
         {"density_diffusion",
          {number(dimension::plain, between(0, 1))},
          "Strength of the diffusion of density.",
          Value::of(defaults.density_diffusion)},
         {"acoustic_damping",
          {number(dimension::plain, between(0, 1))},
          "Strength of the bulk viscosity that damps sound inside the water; 0 = off. None without "
          "gradient_correction.",
          Value::of(defaults.acoustic_damping)},
         {"gradient_correction",
          {boolean()},
          "Inside the water density follows the divergence of velocity, not the arrangement of particles; false for "
          "comparison. Laid out for smoothing_ratio = 1.5.",
          Value::of(defaults.gradient_correction)},
         {"shifting",
          {number(dimension::plain, between(0, 100))},
          "Strength of the shifting of particles; 0 = off.",
          Value::of(defaults.shifting)},
         {"courant",
          {number(dimension::plain, {.low = 0, .high = 1, .is_low_open = true})},
          "Share of the time that sound needs through a smoothing length that a step may last; a warning tells where a "
          "lattice would be unstable.",
          Value::of(defaults.courant)},
         {"sort_interval",
          {integer(1, 1e6)},
          "Steps between sorts of the particles by place: part of the result, as sums follow the order.",
          Value::of(defaults.sort_interval)},
         {"wall",
          {choice({"boundary_particles", "penalty"})},
          "How solids hold water back: particles in layers under their faces that take part in all sums, or faces "
          "that push particles away (for comparison).",
          Value::of("boundary_particles")},
         {"joint_pressure",
          {boolean()},
          "Water presses apart faces that are too close for particles to come between: uplift of blocks that lie on "
          "something. False where joints are watertight. wall = \"penalty\" and scheme = \"muller\" have none.",
          Value::of(true)},
         {"domain", {form::table(fluid_domain_table)}, "Where water may be.", {}, true},
         {"region", {table_list(fluid_region_table, 1)}, "Water at the start.", {}, true},
         {"sponge", {table_list(fluid_sponge_table)}, "Where waves die.", Value::array()},
         {"inflow", {table_list(fluid_inflow_table)}, "Where water enters.", Value::array()},
         {"outflow", {table_list(fluid_outflow_table)}, "Where water leaves.", Value::array()}}};
    return table;
}

}  // namespace riprap::scene
