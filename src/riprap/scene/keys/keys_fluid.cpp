// SPDX-License-Identifier: Apache-2.0
// Rows of the key table: water.
#include "riprap/scene/keys/flow_tables.hpp"
#include "riprap/scene/keys/key_table.hpp"
#include "riprap/scene/keys/methods.hpp"
#include "riprap/scene/keys/sea_words.hpp"
#include "riprap/scene/text/limits.hpp"

namespace riprap::scene {

using namespace form;

namespace {

const Table& fluid_domain_table() {
    static const Table table{
        "fluid.domain",
        "domain = { ... }",
        "The box that water may be in. What leaves it through its top is counted and let go, up to a thousandth of the "
        "water; more, or a particle that leaves through another side that is not periodic, ends the run.",
        {required_key("low", {vector(dimension::length)}, "Low corner."),
         required_key("high", {vector(dimension::length)}, "High corner."),
         optional_key(
             "periodic", {list(boolean(), 2, 3)},
             "Whether what leaves through one side enters through the other, along x, y and z; not when not given.")}};
    return table;
}

const Table& fluid_box_table() {
    static const Table table{"fluid.region.box",
                             "box = { ... }",
                             "A box along the axes.",
                             {required_key("low", {vector(dimension::length)}, "Low corner."),
                              required_key("high", {vector(dimension::length)}, "High corner.")}};
    return table;
}

const Table& fluid_region_table() {
    static const Table table{
        "fluid.region",
        "[[fluid.region]]",
        "Water at the start: what lies in the region, below its level and outside every solid. The whole domain when "
        "neither box nor shape is given. All regions share one lattice; where they overlap the first one counts.",
        {optional_key("box", {form::table(fluid_box_table)}, "The region as a box."),
         optional_key("shape", {form::table(shape_table)}, "The region as a shape; not a half-space."),
         key_or("position", {vector(dimension::length)}, Value::of(Vec3{}), "Position of the origin of the shape."),
         optional_key("orientation", {form::table(orientation_table)}, "Orientation of the shape."),
         optional_key("level", {number(dimension::length)},
                      "Height of the surface at the start, against gravity from the origin: z where gravity points "
                      "down z. At most the top of the region, which it is when not given."),
         key_or("velocity", {vector(dimension::velocity)}, Value::of(Vec3{}), "Velocity at the start.")},
        {{GroupRule::at_most_one, {"box", "shape"}}}};
    return table;
}

const Form way = choice(ways());

const Table& fluid_sponge_table() {
    static const Table table{
        "fluid.sponge",
        "[[fluid.sponge]]",
        "A box in which water is slowed down ever more along one direction, so that waves die before they come back. "
        "The "
        "energy is booked as fluid.absorbed.",
        {required_key("low", {vector(dimension::length)}, "Low corner."),
         required_key("high", {vector(dimension::length)}, "High corner."),
         required_key("towards", {way}, "The direction along which it grows, from nothing."),
         key_or("rate", {choice({"auto"}), number(dimension::frequency, positive())}, Value::of("auto"),
                "At its end; it grows as the square. \"auto\": that which sends a long wave back with a hundredth of "
                "its height."),
         key_or("velocity", {vector(dimension::velocity)}, Value::of(Vec3{}), "Velocity of a steady current.")}};
    return table;
}

const Table& fluid_wave_table() {
    static const Table table{
        "fluid.wave",
        "[[fluid.wave]]",
        "Waves that come in through a side of the domain, by theory (docs/theory/waves.md), or a side that lets waves "
        "out.",
        {required_key("towards", {way}, "Direction of the waves: \"x\" comes in through the low side along x."),
         key_or(
             "wave", {choice(side_waves())}, Value::of("regular"),
             "Steady waves of finite height, by the stream function or to Stokes' second order; one solitary wave of "
             "any height; one by the second-order formulas of [Ding2021]; a sea; none, for a side that only absorbs."),
         optional_key("height", {number(dimension::length, positive())}, "Crest to trough; of a sea H_m0."),
         required_key("depth", {number(dimension::length, positive())}, "Depth of still water at the side."),
         optional_key("period", {number(dimension::time, positive())},
                      "Period of regular waves; peak period of a sea."),
         key_or("absorb", {boolean()}, Value::of(false), "Long waves that arrive at the side go out: kd below pi/10."),
         optional_key("crest_time", {number(dimension::time, non_negative())},
                      "Time at which the first crest enters; when not given, the earliest that still water at the "
                      "start allows."),
         optional_key("ramp", {number(dimension::time, non_negative())},
                      "Time over which regular waves and seas grow; two periods when not given."),
         key_or("spectrum", {choice(spectra())}, Value::of("jonswap"), "Spectrum of a sea."),
         key_or("gamma", {number(dimension::plain, between(1, 10))}, Value::of(3.3), "Peak enhancement of jonswap."),
         optional_key("spectrum_file", {path()},
                      "Spectrum of a sea: table (docs/howto/tables.md) with rows f [1/s], S [m^2 s], instead of "
                      "'spectrum' and 'period'; scaled to 'height' where that is given."),
         key_or("seed", {integer(0, 1e15)}, Value::of(std::int64_t{1}), "Seed of the phases of a sea.")}};
    return table;
}

const Table& fluid_porous_table() {
    static const Table table{
        "fluid.porous",
        "[[fluid.porous]]",
        "Stones that water flows through: cells whose middle lies in the box or shape; a closed surface from an STL or "
        "OBJ file may have any form. The last zone counts where they overlap (docs/theory/grid.md).",
        {optional_key("box", {form::table(fluid_box_table)}, "The zone as a box."),
         optional_key("shape", {form::table(shape_table)}, "The zone as a shape; not a half-space."),
         key_or("position", {vector(dimension::length)}, Value::of(Vec3{}), "Position of the origin of the shape."),
         optional_key("orientation", {form::table(orientation_table)}, "Orientation of the shape."),
         required_key("porosity", {number(dimension::plain, {.low = 0, .high = 1, .is_low_open = true})},
                      "Share of pores."),
         required_key("grain_size", {number(dimension::length, positive())}, "D_50 of the stones."),
         required_key("linear", {number(dimension::plain, non_negative())}, "mu_1 or alpha of the closure."),
         required_key("quadratic", {number(dimension::plain, non_negative())}, "mu_2 or beta of the closure."),
         key_or("added_mass", {number(dimension::plain, non_negative())}, Value::of(0.34), "C_A of closure \"ding\"."),
         key_or("keulegan_carpenter", {number(dimension::plain, non_negative())}, Value::of(0.0),
                "K_C of waves in the pores, for the factor 1 + 7.5/K_C; 0: steady flow."),
         key_or("closure", {choice(porous_closures())}, Value::of("ding"), "Formulas of the resistance.")},
        {{GroupRule::exactly_one, {"box", "shape"}}}};
    return table;
}

const Table& fluid_inflow_table() {
    static const Table table{
        "fluid.inflow",
        "[[fluid.inflow]]",
        "Water enters through a rectangle (a line in a planar scene) at a given speed; its pressure is that of the "
        "water in "
        "front of it. Leave room for its layers, a support and one spacing (four spacings by default), behind it.",
        {required_key("name", {form::name()}, "Unique among the openings."),
         required_key("low", {vector(dimension::length)}, "A corner."),
         required_key("high", {vector(dimension::length)}, "The opposite corner, equal along the axis of `towards`."),
         required_key("towards", {way}, "The way the water goes."),
         required_key("speed", {number(dimension::velocity, positive())}, "Speed of the water that enters."),
         key_or("ramp", {number(dimension::time, non_negative())}, Value::of(0.0),
                "Time in which the speed grows from 0."),
         optional_key("level", {number(dimension::length)},
                      "Height up to which water enters, from the origin against gravity; all of the rectangle when not "
                      "given.")}};
    return table;
}

const Table& fluid_outflow_table() {
    static const Table table{
        "fluid.outflow",
        "[[fluid.outflow]]",
        "Water that passes a rectangle (a line in a planar scene) is gone. Where neither speed nor level is given it "
        "flows out freely: for overfalls and water that runs faster than its waves.",
        {required_key("name", {form::name()}, "Unique among the openings."),
         required_key("low", {vector(dimension::length)}, "A corner."),
         required_key("high", {vector(dimension::length)}, "The opposite corner, equal along the axis of `towards`."),
         required_key("towards", {way}, "The way the water goes."),
         optional_key("speed", {number(dimension::velocity, positive())}, "At which it is drawn off."),
         optional_key(
             "level", {number(dimension::length)},
             "Height of still water behind it, from the origin against gravity: the outflow has its pressure.")},
        {{GroupRule::at_most_one, {"speed", "level"}}}};
    return table;
}

/// Rows that methods may name among their scene_keys.
std::vector<Key> scene_rows() {
    std::vector<Key> rows{
        key_or("sound_speed", {choice({"auto"}), number(dimension::velocity, positive())}, Value::of("auto"),
               "Sound speed of the model. \"auto\": ten times the largest of sqrt(g H), expected_speed and the speeds "
               "that the case gives water and moving bodies, H the depth of the water at the start. Density then "
               "varies by about 1 %."),
        key_or("expected_speed", {choice({"auto"}), number(dimension::velocity, non_negative())}, Value::of("auto"),
               "The highest speed that water will reach, for the sound speed. \"auto\": that of the tip of a dam "
               "break, 2 sqrt(g H)."),
        required_key("domain", {form::table(fluid_domain_table)}, "Box that water may be in."),
        required_key("region", {table_list(fluid_region_table, 1)}, "Water at the start."),
        optional_key("flow", {form::table(flow_table)}, "Velocity of the water at the start by a formula."),
        key_or("jitter", {number(dimension::plain, between(0, 0.25))}, Value::of(0.0),
               "Places of particles at the start are off their lattice by up to this share of the spacing along each "
               "axis, at random: a perfect lattice stretches along lines where water parts until it tears."),
        key_or("side", {table_list(side_table)}, Value::array(), "Sides of the domain that are not as the others."),
        key_or("levels", {list(list(number(dimension::plain), 2, 2), 0, 10'000)}, Value::array(),
               "Pairs of a time [s] and the level of the water then [m], in rising order of time: linear between them "
               "and constant beyond. Each region keeps its own level where none are given."),
        key_or("wave", {table_list(fluid_wave_table)}, Value::array(), "Sides that waves come in through or go out."),
        key_or("porous", {table_list(fluid_porous_table)}, Value::array(), "Stones that water flows through."),
        key_or("sponge", {table_list(fluid_sponge_table)}, Value::array(), "Zones that damp waves."),
        key_or("inflow", {table_list(fluid_inflow_table)}, Value::array(), "Inflow boundaries."),
        key_or("outflow", {table_list(fluid_outflow_table)}, Value::array(), "Outflow boundaries.")};
    const std::vector<Key> bound = rows_of(fluid_model_keys());
    rows.insert(rows.end(), bound.begin(), bound.end());
    return rows;
}

}  // namespace

KeyList<coupling::ParticleFluid> fluid_model_keys() {
    using S = coupling::ParticleFluid;
    return {key::choice(&S::wall, "wall",
                        {{"boundary_particles", coupling::WallTreatment::boundary_particles},
                         {"penalty", coupling::WallTreatment::penalty}},
                        "Treatment of walls: particles in layers under their faces that take part in all sums, "
                        "or faces that push particles away (for comparison)."),
            key::boolean(&S::has_joint_pressure, "joint_pressure",
                         "Water presses apart faces that are too close for particles to come between: uplift of blocks "
                         "that lie on something. False where joints are watertight. wall = \"penalty\" and scheme = "
                         "\"muller\" have none.")};
}

const Table& fluid_table() {
    static const Table table =
        with_methods({"fluid",
                      "[fluid]",
                      "Water. The defaults serve every case; spacing, domain and regions say what is special.",
                      {}},
                     "Method of the water.", FluidMethods::all(), scene_rows());
    return table;
}

}  // namespace riprap::scene
