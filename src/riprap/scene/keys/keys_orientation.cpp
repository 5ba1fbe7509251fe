// SPDX-License-Identifier: Apache-2.0
// Rows of the key table: how bodies are turned.
#include "riprap/scene/keys/key_table.hpp"

namespace riprap::scene {

using namespace form;

namespace {

const Table& orientation_axis_table() {
    static const Table table{"orientation.axis_angle",
                             "orientation = { axis_angle = { ... } }",
                             "A turn about an axis by the right-hand rule.",
                             {key_or("axis", {form::axis()}, Value::of(Vec3{0, 0, 1}), "Axis of the turn."),
                              required_key("angle", {number(dimension::angle)}, "Angle of the turn.")}};
    return table;
}

}  // namespace

const Table& orientation_table() {
    static const Table table{
        "orientation",
        "orientation = { ... }",
        "Rotation of the body from its own axes to those of the world, in one of these forms.",
        {optional_key("axis_angle", {form::table(orientation_axis_table)}, "A turn about an axis."),
         optional_key("angle", {number(dimension::angle)}, "A turn about z; the way of planar scenes."),
         optional_key("euler", {list(number(dimension::angle), 3, 3)},
                      "Turns about the fixed x, then y, then z axis (roll, pitch, yaw)."),
         optional_key("quaternion", {list(number(dimension::plain), 4, 4)},
                      "w, x, y, z of the turn from body to world; any length but zero."),
         optional_key("dip", {number(dimension::angle, between(-1.5707963267948966, 1.5707963267948966))},
                      "Tilts the body's z axis: its x-y plane dips by this angle below the horizontal, z up."),
         optional_key("dip_direction", {number(dimension::angle)},
                      "Azimuth towards which the plane dips, clockwise from +y (north) to +x (east).")},
        {{GroupRule::exactly_one, {"axis_angle", "angle", "euler", "quaternion", "dip"}},
         {GroupRule::all_or_none, {"dip", "dip_direction"}}}};
    return table;
}

}  // namespace riprap::scene
