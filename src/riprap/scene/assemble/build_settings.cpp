// SPDX-License-Identifier: Apache-2.0
// Time axis, gravity and settings of the solid method.
#include <fmt/format.h>

#include "riprap/core/direction.hpp"
#include "riprap/scene/assemble/build_case.hpp"
#include "riprap/scene/case/time_tables.hpp"
#include "riprap/scene/keys/methods.hpp"

namespace riprap::scene {

namespace {

/// Reads angles at given times; the turn starts and stops with them.
void read_turns(CaseBuild& build, const Value& rotation, body::Gravity& out) {
    TimeTable rows = read_time_table(build, rotation, "angle");
    for (const Vec3& row : rows.value) {
        out.angles.push_back(row.x);
    }
    out.times = std::move(rows.time);
    if (!out.times.empty()) {
        out.start = out.times.front();
        out.stop = out.times.back();
    }
    for (const char* key : {"start", "stop"}) {
        const Value* given = rotation.find(key);
        if (given != nullptr && given->as_number() != 0) {
            build.problem(given->place, fmt::format("'{}' goes with 'rate'", key), "times of the table alone");
        }
    }
}

body::Gravity read_gravity(CaseBuild& build, const Value& gravity) {
    body::Gravity out;
    if (gravity.is_array()) {
        out.value = to_vector(gravity);
        return out;
    }
    out.value = get_vector(gravity, "value");
    out.ramp = get_number(gravity, "ramp");
    if (const Value* rotation = gravity.find("rotation")) {
        out.axis = direction_of(get_vector(*rotation, "axis"));
        if (rotation->find("rate") == nullptr) {
            read_turns(build, *rotation, out);
            return out;
        }
        out.rate = get_number(*rotation, "rate");
        out.start = get_number(*rotation, "start");
        out.stop = get_number_or(*rotation, "stop", out.stop);
        if (out.stop <= out.start) {
            build.problem(rotation->place, fmt::format("gravity turns from {} s to {} s", out.start, out.stop),
                          "stop after start");
        }
    }
    return out;
}

}  // namespace

void build_settings(CaseBuild& build) {
    const Value& root = build.root;
    sim::Model& model = build.model;
    model.title = get_text(root, "title");
    model.seed = static_cast<std::uint64_t>(get_integer(root, "seed"));
    model.gravity = read_gravity(build, get(root, "gravity"));
    model.bodies.is_planar = build.is_planar;

    model.time.end = get_number(root, "end");
    const Value& step = get(root, "time_step");
    model.time.time_step = step.is_text() ? 0 : step.as_number();
    read_keys(root, time_keys(), model.time);
    for (const std::string_view key : {"settle_static", "settle_time_step", "settle_friction"}) {
        const Value* given = root.find(key);
        const bool is_asked = given != nullptr && (given->is_number() || given->boolean);
        if (is_asked && model.time.settle <= 0) {
            build.problem(given->place, fmt::format("'{}' says nothing where bodies do not settle", key),
                          "with settle above 0");
        }
    }

    model.solid = SolidMethods::read(get(root, "solid"), "[solid]", build.problems, build.warnings);
}

}  // namespace riprap::scene
