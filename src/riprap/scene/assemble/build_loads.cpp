// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "riprap/scene/assemble/build_case.hpp"
#include "riprap/scene/assemble/load_tables.hpp"
#include "riprap/scene/case/time_tables.hpp"
#include "riprap/scene/text/limits.hpp"

namespace riprap::scene {

bool check_times(CaseBuild& build, const Value& load) {
    const double start = get_number(load, "start");
    const Value* stop = load.find("stop");
    if (stop == nullptr || stop->as_number() > start) {
        return true;
    }
    build.problem(stop->place, fmt::format("a load from {} s to {} s", start, stop->as_number()), "stop after start");
    return false;
}

bool read_force_table(CaseBuild& build, const Value& load) {
    const Value* table = load.find("table");
    if (table == nullptr) {
        return true;
    }
    TimeTable rows = read_time_table(build, *table, "force");
    const bool is_read = !rows.time.empty();
    build.force_tables[table] =
        std::make_shared<body::ForceTable>(body::ForceTable{std::move(rows.time), std::move(rows.value)});
    return is_read;
}

body::PointLoad load_on(const CaseBuild& build, BodyId body, const Value& load) {
    body::PointLoad read{.body = body};
    if (const Value* force = load.find("force")) {
        read.force = to_vector(*force);
    } else {
        read.table = build.force_tables.at(load.find("table"));
    }
    read.start = get_number(load, "start");
    read.ramp = get_number(load, "ramp");
    read.stop = get_number_or(load, "stop", read.stop);
    return read;
}

bool check_loads(CaseBuild& build, const Value& loads, const body::NewBody& body, std::int64_t copies) {
    if (body.drive != body::Drive::free && !std::isfinite(body.release_time)) {
        build.problem(loads.place, fmt::format("body '{}' has a load and does not follow forces", body.name),
                      "loads on free bodies, or with a release_time");
        return false;
    }
    for (const Value& one : loads.items) {
        if (!check_times(build, one) || !read_force_table(build, one)) {
            return false;
        }
    }
    const std::int64_t room = limits::loads - static_cast<std::int64_t>(build.model.loads.size());
    const auto count = static_cast<std::int64_t>(loads.items.size());
    if (count > 0 && copies > room / count) {
        build.problem(loads.place, fmt::format("{} loads on each of {} bodies", count, copies),
                      fmt::format("at most {} loads in a scene", limits::loads));
        return false;
    }
    return true;
}

void add_loads(CaseBuild& build, const Value& loads, BodyId body, const Pose& pose, double scale) {
    const Vec3 center = build.state.bodies.position[static_cast<std::size_t>(body.value)];
    for (const Value& one : loads.items) {
        body::PointLoad load = load_on(build, body, one);
        if (const Value* at = one.find("at")) {
            const Vec3 place = pose.position + rotate(pose.orientation, scale * to_vector(*at));
            load.point = rotate_back(pose.orientation, place - center);
        }
        build.model.loads.push_back(load);
    }
}

}  // namespace riprap::scene
