// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "riprap/scene/case/time_tables.hpp"
#include "riprap/scene/keys/bound_keys.hpp"
#include "riprap/scene/motions/build_motion.hpp"

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

/// Warns of a table with rows only when the run is over, as times in another unit have, or before it begins.
void warn_of_late_rows(CaseBuild& build, const Value& table, const body::PrescribedMotion& motion) {
    const auto* law = std::get_if<body::TableMotion>(&motion.law);
    const double end = build.model.time.end;
    if (law == nullptr || motion.start >= end) {
        return;
    }
    const double first = motion.start + law->time.front(), last = motion.start + law->time.back();
    if (first > 0 && first >= end) {
        build.warnings.push_back(to_string(Diagnostic{
            table.place, fmt::format("the run ends at {:.6g} s, before this table begins at {:.6g} s", end, first),
            "times in s"}));
    } else if (last < 0) {
        build.warnings.push_back(
            to_string(Diagnostic{table.place, fmt::format("this table ends at {:.6g} s, before the run begins", last),
                                 "times from 0 s on"}));
    }
}

/// Reads a law from its table; problems are noted.
template <class Law>
Law read_law(CaseBuild& /*build*/, const Value& table) {
    Law law;
    read_keys(table, Law::keys(), law);
    return law;
}
template <>
body::TableMotion read_law(CaseBuild& build, const Value& table) {
    TimeTable rows = read_time_table(build, table, "displacement");
    check_displacements(build, table, rows);
    return {std::move(rows.time), std::move(rows.value)};
}

}  // namespace

std::int32_t add_motion(CaseBuild& build, const Value& table) {
    const std::size_t before = build.problems.size();
    body::PrescribedMotion motion;
    body::MotionLaws::for_each([&]<class Law>() {
        if (const Value* given = table.find(Law::word)) {
            motion.law = read_law<Law>(build, *given);
        }
    });
    if (const Value* maker = table.find("wave_maker")) {
        std::optional<body::PrescribedMotion> paddle = wave_maker_motion(build, *maker);
        if (!paddle) {
            return -1;
        }
        motion = std::move(*paddle);
    }
    if (build.problems.size() > before) {
        return -1;
    }
    motion.start = get_number(table, "start");
    motion.stop = get_number_or(table, "stop", motion.stop);
    if (motion.stop <= motion.start) {
        build.problem(table.place, fmt::format("a motion from {} s to {} s", motion.start, motion.stop),
                      "stop after start");
        return -1;
    }
    if (const Value* rows = table.find(body::TableMotion::word)) {
        warn_of_late_rows(build, *rows, motion);
    }
    build.model.bodies.motions.push_back(std::move(motion));
    return static_cast<std::int32_t>(build.model.bodies.motions.size()) - 1;
}

}  // namespace riprap::scene
