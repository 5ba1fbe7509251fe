// SPDX-License-Identifier: Apache-2.0
// Rows of the key table: packs of blocks and jointed rock masses.
#include "riprap/scene/keys/key_table.hpp"
#include "riprap/scene/text/limits.hpp"

namespace riprap::scene {

using namespace form;

namespace {

const Table& voronoi_table() {
    static const Table table{
        "pack.voronoi",
        "voronoi = { ... }",
        "Divides a convex region among random points. The cells fill the region and touch face to face.",
        {required_key("region", {form::table(shape_table)}, "A convex shape."),
         key_or("position", {vector(dimension::length)}, Value::of(Vec3{}), "Position of the origin of the region."),
         optional_key("orientation", {form::table(orientation_table)}, "Orientation of the region."),
         required_key("count", {integer(1, static_cast<double>(limits::cells))}, "Number of cells."),
         key_or("lloyd", {integer(0, 1000)}, Value::of(0),
                "Times that each point moves to the centre of its cell: more makes cells more alike."),
         key_or("gap", {number(dimension::length, non_negative())}, Value::of(0.0),
                "Width of the open joint between neighbouring cells."),
         optional_key("seed", {integer(0, 9e15)}, "Own seed; otherwise from the seed of the case and the name.")}};
    return table;
}

const Table& mix_table() {
    static const Table table{"pack.mix",
                             "mix = [ { ... }, ... ]",
                             "One kind of block of a mixed pack.",
                             {required_key("shape", {form::table(shape_table)}, "A shape; not a half-space."),
                              key_or("fraction", {number(dimension::plain, positive())}, Value::of(1.0),
                                     "Share of this kind by number, relative to those of the other kinds."),
                              optional_key("sizes", {list(number(dimension::plain, positive()), 1, 64)},
                                           "Factors on the size, equally likely.")}};
    return table;
}

const Table& lattice_table() {
    static const Table table{
        "pack.lattice",
        "lattice = { ... }",
        "Blocks of several kinds at the points of a lattice.",
        {key_or("origin", {vector(dimension::length)}, Value::of(Vec3{}), "First point of the lattice."),
         required_key("counts", {list(integer(1, static_cast<double>(limits::bodies)), 2, 3)},
                      "Points along x, y and z."),
         required_key("pitch", {vector(dimension::length)}, "Distance between points along x, y and z."),
         optional_key("total", {integer(1, static_cast<double>(limits::bodies))},
                      "Use only the first so many points; all when not given."),
         key_or("random_orientation", {boolean()}, Value::of(true), "Turn every block at random."),
         key_or("jitter", {number(dimension::length, non_negative())}, Value::of(0.0),
                "Move every block at random by at most this much along each axis."),
         required_key("mix", {table_list(mix_table, 1)}, "The kinds of blocks."),
         optional_key("seed", {integer(0, 9e15)}, "Own seed; otherwise from the seed of the case and the name.")}};
    return table;
}

const Table& slope_table() {
    static const Table table{
        "pack.slope",
        "slope = { ... }",
        "Armour units on a slope, row by row from its foot and layer by layer, each as low as it can lie clear of "
        "those "
        "before it: by spheres around their parts, so that they touch nowhere yet. The top-level `settle` lets them "
        "come "
        "to rest.",
        {required_key("shape", {form::table(shape_table)}, "Shape of a unit."),
         required_key("from", {vector(dimension::length)},
                      "Foot of the slope; in space its end at which the layer begins."),
         required_key("to", {vector(dimension::length)}, "Head of the slope, up from there."),
         optional_key(
             "width", {number(dimension::length, positive())},
             "Width of the layer along the breakwater, to the left when one looks up the slope; not in planar scenes."),
         key_or("layers", {integer(1, 16)}, Value::of(2), "Layers of units."),
         required_key(
             "packing_density", {number(dimension::plain, positive())},
             "Units of all layers on D_n^2 of slope, D_n the nominal diameter; on D_n of it in planar scenes."),
         key_or("placement", {choice({"regular", "random"})}, Value::of("regular"),
                "In rows half a pitch apart, with the orientation that is given; or anywhere, turned at random."),
         optional_key(
             "orientation", {form::table(orientation_table)},
             "Turn of the units of the lowest layer, x up the slope, normal to it y in planar scenes, else z."),
         optional_key("upper_orientation", {form::table(orientation_table)},
                      "Orientation of units of the other layers; as the lowest when not given."),
         optional_key("seed", {integer(0, 9e15)}, "Own seed; otherwise from the seed of the case and the name.")}};
    return table;
}

const Table& joint_set_table() {
    static const Table table{
        "rock_mass.joint_set",
        "[[rock_mass.joint_set]]",
        "Parallel joints through the region. z is up.",
        {required_key("dip", {number(dimension::angle, between(0, 1.5707963267948966))}, "Angle below the horizontal."),
         required_key("dip_direction", {number(dimension::angle)},
                      "Azimuth towards which the joints dip, clockwise from +y (north) to +x (east)."),
         required_key("spacing", {number(dimension::length, positive())}, "Distance between joints, across them."),
         key_or("persistence", {number(dimension::plain, {.low = 0, .high = 1, .is_low_open = true})}, Value::of(1.0),
                "Chance that a joint cuts a block that it meets; 1 cuts all."),
         key_or("spacing_scatter", {number(dimension::plain, {.low = 0, .high = 1, .is_high_open = true})},
                Value::of(0.0), "Spacings vary at random by up to this share."),
         key_or("origin", {vector(dimension::length)}, Value::of(Vec3{}),
                "A point of the world that one joint of the set passes through.")}};
    return table;
}

}  // namespace

const Table& pack_table() {
    static const Table table{
        "pack",
        "[[pack]]",
        "Many blocks from one recipe; named NAME[0], NAME[1], ...",
        {required_key("name", {form::name()}, "Unique."),
         required_key("material", {form::name()}, "Name of the material of all blocks."),
         optional_key("voronoi", {form::table(voronoi_table)}, "Cells that fill a box."),
         optional_key("lattice", {form::table(lattice_table)}, "A mix of shapes on a lattice."),
         optional_key("slope", {form::table(slope_table)}, "Armour units on a slope."),
         key_or("velocity", {vector(dimension::velocity)}, Value::of(Vec3{}), "Velocity of every block at the start."),
         key_or("fixed", {boolean()}, Value::of(false), "The blocks do not move."),
         optional_key("release_time", {number(dimension::time, non_negative())},
                      "Fixed blocks become free at this time.")},
        {{GroupRule::exactly_one, {"voronoi", "lattice", "slope"}}}};
    return table;
}

const Table& rock_mass_table() {
    static const Table table{
        "rock_mass",
        "[[rock_mass]]",
        "A convex region cut into blocks by joint sets; named NAME[0], NAME[1], ...",
        {required_key("name", {form::name()}, "Unique."),
         required_key("material", {form::name()}, "Name of the material of all blocks."),
         required_key("region", {form::table(shape_table)}, "A convex shape."),
         key_or("position", {vector(dimension::length)}, Value::of(Vec3{}), "Position of the origin of the region."),
         optional_key("orientation", {form::table(orientation_table)},
                      "Orientation of the region; joints do not turn with it."),
         optional_key("seed", {integer(0, 9e15)},
                      "Own seed (persistence); otherwise from the seed of the case and the name."),
         key_or("minimum_volume", {number({3, 0, 0, 0}, non_negative())}, Value::of(0.0),
                "A joint that would cut off a smaller piece leaves that block whole."),
         optional_key("fixed_below", {number(dimension::length)},
                      "Blocks whose centre of mass lies lower than this z do not move."),
         key_or("fixed", {boolean()}, Value::of(false), "The blocks do not move."),
         optional_key("release_time", {number(dimension::time, non_negative())},
                      "Fixed blocks become free at this time."),
         required_key("joint_set", {table_list(joint_set_table, 1)}, "The joint sets.")}};
    return table;
}

}  // namespace riprap::scene
