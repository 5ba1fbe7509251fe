// SPDX-License-Identifier: Apache-2.0
// Rows of the key table: packs of blocks and jointed rock masses.
#include "riprap/scene/keys/key_table.hpp"
#include "riprap/scene/keys/limits.hpp"

namespace riprap::scene {

using namespace form;

namespace {

const Table& voronoi_table() {
    static const Table table{
        "pack.voronoi",
        "voronoi = { ... }",
        "Divides a convex region among random points. The cells fill the region and touch face to face.",
        {{"region", {form::table(shape_table)}, "A convex shape.", {}, true},
         {"position", {vector(dimension::length)}, "Position of the origin of the region.", Value::of(Vec3{})},
         {"orientation", {form::table(orientation_table)}, "Orientation of the region.", {}},
         {"count", {integer(1, static_cast<double>(limits::cells))}, "Number of cells.", {}, true},
         {"lloyd",
          {integer(0, 1000)},
          "Times that each point moves to the centre of its cell: more makes cells more alike.",
          Value::of(0)},
         {"gap",
          {number(dimension::length, non_negative())},
          "Width of the open joint between neighbouring cells.",
          Value::of(0.0)},
         {"seed", {integer(0, 9e15)}, "Own seed; otherwise from the seed of the case and the name.", {}}}};
    return table;
}

const Table& mix_table() {
    static const Table table{
        "pack.mix",
        "mix = [ { ... }, ... ]",
        "One kind of block of a mixed pack.",
        {{"shape", {form::table(shape_table)}, "A shape; not a half-space.", {}, true},
         {"fraction",
          {number(dimension::plain, positive())},
          "Share of this kind by number, relative to those of the other kinds.",
          Value::of(1.0)},
         {"sizes", {list(number(dimension::plain, positive()), 1, 64)}, "Factors on the size, equally likely.", {}}}};
    return table;
}

const Table& lattice_table() {
    static const Table table{
        "pack.lattice",
        "lattice = { ... }",
        "Blocks of several kinds at the points of a lattice.",
        {{"origin", {vector(dimension::length)}, "First point of the lattice.", Value::of(Vec3{})},
         {"counts",
          {list(integer(1, static_cast<double>(limits::bodies)), 2, 3)},
          "Points along x, y and z.",
          {},
          true},
         {"pitch", {vector(dimension::length)}, "Distance between points along x, y and z.", {}, true},
         {"total",
          {integer(1, static_cast<double>(limits::bodies))},
          "Use only the first so many points; all when not given.",
          {}},
         {"random_orientation", {boolean()}, "Turn every block at random.", Value::of(true)},
         {"jitter",
          {number(dimension::length, non_negative())},
          "Move every block at random by at most this much along each axis.",
          Value::of(0.0)},
         {"mix", {table_list(mix_table, 1)}, "The kinds of blocks.", {}, true},
         {"seed", {integer(0, 9e15)}, "Own seed; otherwise from the seed of the case and the name.", {}}}};
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
        {{"shape", {form::table(shape_table)}, "Shape of a unit.", {}, true},
         {"from",
          {vector(dimension::length)},
          "Foot of the slope; in space its end at which the layer begins.",
          {},
          true},
         {"to", {vector(dimension::length)}, "Head of the slope, up from there.", {}, true},
         {"width",
          {number(dimension::length, positive())},
          "Width of the layer along the breakwater, to the left when one looks up the slope; not in planar scenes.",
          {}},
         {"layers", {integer(1, 16)}, "Layers of units.", Value::of(2)},
         {"packing_density",
          {number(dimension::plain, positive())},
          "Units of all layers on D_n^2 of slope, D_n the nominal diameter; on D_n of it in planar scenes.",
          {},
          true},
         {"placement",
          {choice({"regular", "random"})},
          "In rows half a pitch apart, with the orientation that is given; or anywhere, turned at random.",
          Value::of("regular")},
         {"orientation",
          {form::table(orientation_table)},
          "Turn of the units of the lowest layer, x up the slope, normal to it y in planar scenes, else z.",
          {}},
         {"upper_orientation",
          {form::table(orientation_table)},
          "Orientation of units of the other layers; as the lowest when not given.",
          {}},
         {"seed", {integer(0, 9e15)}, "Own seed; otherwise from the seed of the case and the name.", {}}}};
    return table;
}

const Table& joint_set_table() {
    static const Table table{
        "rock_mass.joint_set",
        "[[rock_mass.joint_set]]",
        "Parallel joints through the region. z is up.",
        {{"dip", {number(dimension::angle, between(0, 1.5707963267948966))}, "Angle below the horizontal.", {}, true},
         {"dip_direction",
          {number(dimension::angle)},
          "Azimuth towards which the joints dip, clockwise from +y (north) to +x (east).",
          {},
          true},
         {"spacing", {number(dimension::length, positive())}, "Distance between joints, across them.", {}, true},
         {"persistence",
          {number(dimension::plain, {.low = 0, .high = 1, .is_low_open = true})},
          "Chance that a joint cuts a block that it meets; 1 cuts all.",
          Value::of(1.0)},
         {"spacing_scatter",
          {number(dimension::plain, {.low = 0, .high = 1, .is_high_open = true})},
          "Spacings vary at random by up to this share.",
          Value::of(0.0)},
         {"origin",
          {vector(dimension::length)},
          "A point of the world that one joint of the set passes through.",
          Value::of(Vec3{})}}};
    return table;
}

}  // namespace

const Table& pack_table() {
    static const Table table{
        "pack",
        "[[pack]]",
        "Many blocks from one recipe; named NAME[0], NAME[1], ...",
        {{"name", {form::name()}, "Unique.", {}, true},
         {"material", {form::name()}, "Name of the material of all blocks.", {}, true},
         {"voronoi", {form::table(voronoi_table)}, "Cells that fill a box.", {}},
         {"lattice", {form::table(lattice_table)}, "A mix of shapes on a lattice.", {}},
         {"slope", {form::table(slope_table)}, "Armour units on a slope.", {}},
         {"velocity", {vector(dimension::velocity)}, "Velocity of every block at the start.", Value::of(Vec3{})},
         {"fixed", {boolean()}, "The blocks do not move.", Value::of(false)},
         {"release_time", {number(dimension::time, non_negative())}, "Fixed blocks become free at this time.", {}}},
        {{GroupRule::exactly_one, {"voronoi", "lattice", "slope"}}}};
    return table;
}

const Table& rock_mass_table() {
    static const Table table{
        "rock_mass",
        "[[rock_mass]]",
        "A convex region cut into blocks by joint sets; named NAME[0], NAME[1], ...",
        {{"name", {form::name()}, "Unique.", {}, true},
         {"material", {form::name()}, "Name of the material of all blocks.", {}, true},
         {"region", {form::table(shape_table)}, "A convex shape.", {}, true},
         {"position", {vector(dimension::length)}, "Position of the origin of the region.", Value::of(Vec3{})},
         {"orientation",
          {form::table(orientation_table)},
          "Orientation of the region; joints do not turn with it.",
          {}},
         {"seed", {integer(0, 9e15)}, "Own seed (persistence); otherwise from the seed of the case and the name.", {}},
         {"minimum_volume",
          {number({3, 0, 0, 0}, non_negative())},
          "A joint that would cut off a smaller piece leaves that block whole.",
          Value::of(0.0)},
         {"fixed_below",
          {number(dimension::length)},
          "Blocks whose centre of mass lies lower than this z do not move.",
          {}},
         {"fixed", {boolean()}, "The blocks do not move.", Value::of(false)},
         {"release_time", {number(dimension::time, non_negative())}, "Fixed blocks become free at this time.", {}},
         {"joint_set", {table_list(joint_set_table, 1)}, "The joint sets.", {}, true}}};
    return table;
}

}  // namespace riprap::scene
