// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "riprap/scene/build/build_case.hpp"
#include "riprap/scene/keys/limits.hpp"

namespace riprap::scene {

bool check_loads(CaseBuild& build, const Value& loads, const body::NewBody& body, std::int64_t copies) {
    if (body.drive != body::Drive::free && !std::isfinite(body.release_time)) {
        build.problem(loads.place, fmt::format("body '{}' has a load and does not follow forces", body.name),
                      "loads on free bodies, or with a release_time");
        return false;
    }
    for (const Value& one : loads.items) {
        const double start = get_number(one, "start");
        if (const Value* stop = one.find("stop"); stop != nullptr && stop->as_number() <= start) {
            build.problem(stop->place, fmt::format("a load from {} s to {} s", start, stop->as_number()),
                          "stop after start");
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
        body::PointLoad load{.body = body, .force = get_vector(one, "force")};
        if (const Value* at = one.find("at")) {
            const Vec3 place = pose.position + rotate(pose.orientation, scale * to_vector(*at));
            load.point = rotate_back(pose.orientation, place - center);
        }
        load.start = get_number(one, "start");
        load.ramp = get_number(one, "ramp");
        load.stop = get_number_or(one, "stop", load.stop);
        build.model.loads.push_back(load);
    }
}

}  // namespace riprap::scene
