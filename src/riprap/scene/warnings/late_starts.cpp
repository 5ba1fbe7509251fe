// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/warnings/late_starts.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string_view>

namespace riprap::scene {

namespace {

/// Rough joints reach 2; 5 is the tangent of 79 degrees.
constexpr double steepest_friction = 5;

void warn(CaseBuild& build, const SourcePlace& place, std::string message, std::string_view allowed) {
    build.warnings.push_back(to_string(Diagnostic{place, std::move(message), std::string(allowed)}));
}

/// @param what  that begins at `time`, after "the run ends before"
void warn_of_late(CaseBuild& build, const SourcePlace& place, double time, std::string_view what) {
    const double end = build.model.time.end;
    if (time > 0 && time >= end) {
        warn(build, place, fmt::format("the run ends at {:.6g} s, before {} at {:.6g} s", end, what, time),
             "times are in s; others have their unit with them: \"200 ms\"");
    }
}
void warn_of_late(CaseBuild& build, const Value* time, std::string_view what) {
    if (time != nullptr) {
        warn_of_late(build, time->place, time->as_number(), what);
    }
}

void look_at_loads(CaseBuild& build, const Value& owner) {
    const Value* loads = owner.find("load");
    if (loads == nullptr) {
        return;
    }
    for (const Value& load : loads->items) {
        const auto table = build.force_tables.find(load.find("table"));
        if (table != build.force_tables.end() && !table->second->time.empty()) {
            warn_of_late(build, table->first->place, get_number(load, "start") + table->second->time.front(),
                         "this load begins");
        } else {
            warn_of_late(build, load.find("start"), "this load begins");
        }
        const Value* stop = load.find("stop");
        const Value* ramp = load.find("ramp");
        if (stop != nullptr && ramp != nullptr &&
            ramp->as_number() > (1 + 1e-9) * (stop->as_number() - get_number_or(load, "start", 0))) {
            warn(build, ramp->place,
                 fmt::format("this load stops at {:.6g} s, before it has grown to its full size", stop->as_number()),
                 "a ramp no longer than from start to stop");
        }
    }
}

void look_at_friction(CaseBuild& build, const Value& table) {
    const Value* friction = table.find("friction_coefficient");
    if (friction != nullptr && friction->as_number() > steepest_friction) {
        warn(build, friction->place,
             fmt::format("friction_coefficient = {:.6g} is the tangent of {:.3g} degrees", friction->as_number(),
                         std::atan(friction->as_number()) * 180 / std::numbers::pi),
             "an angle is friction_angle_deg");
    }
}

}  // namespace

void warn_of_late_starts(CaseBuild& build) {
    for (const Value& body : get(build.root, "body").items) {
        look_at_loads(build, body);
        const std::string name = fmt::format("'{}'", get(body, "name").text);
        if (const Value* motion = body.find("motion")) {
            warn_of_late(build, motion->find("start"), fmt::format("{} begins to move", name));
        }
        warn_of_late(build, body.find("release_time"), fmt::format("{} is released", name));
    }
    for (const Value& section : get(build.root, "section").items) {
        look_at_loads(build, section);
    }
    const Value& gravity = get(build.root, "gravity");
    const Value* turn = gravity.is_table() ? gravity.find("rotation") : nullptr;
    if (turn != nullptr) {
        const Value* times = turn->find("time");
        const bool has_times = times != nullptr && !times->items.empty();
        warn_of_late(build, has_times ? &times->items.front() : turn->find("start"), "gravity begins to turn");
    }
}

void warn_of_steep_friction(CaseBuild& build) {
    for (const Entry& material : get(build.root, "material").entries) {
        look_at_friction(build, material.value);
    }
    for (const Value& pair : get(get(build.root, "contact"), "pair").items) {
        look_at_friction(build, pair);
    }
}

}  // namespace riprap::scene
