// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/scene/build/build_case.hpp"
#include "riprap/scene/build/direction.hpp"
#include "riprap/scene/build/sea_tables.hpp"
#include "riprap/scene/build/time_tables.hpp"
#include "riprap/scene/keys/limits.hpp"

namespace riprap::scene {

namespace {

/// Refuses displacements whose squares, times a mass, are beyond double precision.
void check_displacements(CaseBuild& build, const Value& table, const TimeTable& rows) {
    constexpr double most = 1e100;  // [m]
    for (std::size_t i = 0; i < rows.value.size(); ++i) {
        const Vec3& x = rows.value[i];
        if (std::max({std::abs(x.x), std::abs(x.y), std::abs(x.z)}) > most) {
            build.problem(
                table.place,
                fmt::format("row {} of the motion is displaced by ({:.3g}, {:.3g}, {:.3g}) m", i + 1, x.x, x.y, x.z),
                fmt::format("components of at most {:g} m", most));
            return;
        }
    }
}

}  // namespace

std::int32_t add_motion(CaseBuild& build, const Value& table) {
    body::PrescribedMotion motion;
    if (const Value* linear = table.find("linear")) {
        motion.law = body::LinearMotion{get_vector(*linear, "velocity")};
    } else if (const Value* sine = table.find("sinusoidal")) {
        motion.law = body::SinusoidalMotion{get_vector(*sine, "amplitude"), get_number(*sine, "period"),
                                            get_number(*sine, "phase"), get_number(*sine, "ramp")};
    } else if (const Value* rotation = table.find("rotation")) {
        motion.law = body::RotatingMotion{get_vector(*rotation, "center"), direction_of(get_vector(*rotation, "axis")),
                                          get_number(*rotation, "rate"),   get_number(*rotation, "amplitude"),
                                          get_number(*rotation, "period"), get_number(*rotation, "phase"),
                                          get_number(*rotation, "ramp")};
    } else if (const Value* maker = table.find("wave_maker"); maker != nullptr && makes_sea(*maker)) {
        std::optional<body::SplineMotion> sea = sea_motion(build, *maker);
        if (!sea) {
            return -1;
        }
        motion.law = std::move(*sea);
    } else if (maker != nullptr) {
        std::optional<body::PrescribedMotion> paddle = wave_maker_motion(build, *maker);
        if (!paddle) {
            return -1;
        }
        motion = std::move(*paddle);
    } else {
        const std::size_t before = build.problems.size();
        TimeTable rows = read_time_table(build, get(table, "table"), "displacement");
        check_displacements(build, get(table, "table"), rows);
        motion.law = body::TableMotion{std::move(rows.time), std::move(rows.value)};
        if (build.problems.size() > before) {
            return -1;
        }
    }
    motion.start = get_number(table, "start");
    motion.stop = get_number_or(table, "stop", motion.stop);
    if (motion.stop <= motion.start) {
        build.problem(table.place, fmt::format("a motion from {} s to {} s", motion.start, motion.stop),
                      "stop after start");
        return -1;
    }
    build.model.bodies.motions.push_back(std::move(motion));
    return static_cast<std::int32_t>(build.model.bodies.motions.size()) - 1;
}

}  // namespace riprap::scene
