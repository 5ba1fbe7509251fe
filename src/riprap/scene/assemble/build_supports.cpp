// SPDX-License-Identifier: Apache-2.0
// Fixed points and bolts.
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "riprap/core/index.hpp"
#include "riprap/scene/assemble/build_case.hpp"
#include "riprap/scene/assemble/point_in_body.hpp"
#include "riprap/sim/method_traits.hpp"

namespace riprap::scene {

namespace {

/// Do forces move the body, now or later?
bool follows_forces(const body::BodySet& bodies, BodyId body) {
    return is_free(bodies, body, std::numeric_limits<double>::max());
}

/// Reads where a support is tied to its body; false with a problem.
bool read_point(CaseBuild& build, const Value& value, const SourcePlace& place, BodyId body, Vec3& point) {
    point = build.point_of(body, to_vector(value));
    if (is_in(build.model, body, point)) {
        return true;
    }
    const std::string holders = holders_of(build, to_vector(value));
    build.problem(place,
                  fmt::format("the point does not lie in '{}' but in {}", build.model.bodies.name(body),
                              holders.empty() ? "no body" : holders),
                  "a point in it or on its surface, where it is at the start");
    return false;
}

/// Tells whether the solid method of the case has supports of this kind; a problem otherwise.
bool check_method(CaseBuild& build, const Value& table, const char* what, sim::SolidAbility asks) {
    if (sim::does(build.model, asks)) {
        return true;
    }
    build.problem(table.place, fmt::format("the solid method of this case knows no {}", what),
                  fmt::format("solid.method = \"{}\"", fmt::join(sim::solids_that(asks), "\" or \"")));
    return false;
}

void read_fixed_point(CaseBuild& build, const Value& table) {
    const BodyId body = build.body_named(get(table, "body"));
    body::FixedPoint support{.body = body, .place = get_vector(table, "at")};
    if (!body.is_valid() || !check_method(build, table, "fixed points", sim::SolidAbility::fixed_points) ||
        !read_point(build, get(table, "at"), get(table, "at").place, body, support.point)) {
        return;
    }
    if (!follows_forces(build.model.bodies, body)) {
        build.problem(table.place, fmt::format("'{}' does not follow forces", build.model.bodies.name(body)),
                      "fixed points of free bodies, or of ones with a release_time");
        return;
    }
    support.stiffness = get_number_or(table, "stiffness", 0);
    build.model.fixed_points.push_back(support);
}

void read_bolt(CaseBuild& build, const Value& table) {
    const std::vector<Value>&names = get(table, "bodies").items, &ends = get(table, "ends").items;
    body::Bolt bolt{.first = build.body_named(names[0]), .second = build.body_named(names[1])};
    if (!bolt.first.is_valid() || !bolt.second.is_valid() ||
        !check_method(build, table, "bolts", sim::SolidAbility::bolts)) {
        return;
    }
    const body::BodySet& bodies = build.model.bodies;
    if (bolt.first == bolt.second || !(follows_forces(bodies, bolt.first) || follows_forces(bodies, bolt.second))) {
        build.problem(get(table, "bodies").place, "a bolt that holds nothing",
                      "two bodies, one of which follows forces at least");
        return;
    }
    const SourcePlace& place = get(table, "ends").place;
    const double length = norm(to_vector(ends[1]) - to_vector(ends[0]));
    if (!(length > 0)) {
        build.problem(place, "a bolt without length", "two ends apart from each other");
        return;
    }
    if (!read_point(build, ends[0], place, bolt.first, bolt.first_point) ||
        !read_point(build, ends[1], place, bolt.second, bolt.second_point)) {
        return;
    }
    bolt.stiffness = get_number(table, "stiffness");
    bolt.rest_length = length - get_number(table, "pretension") / bolt.stiffness;
    if (!(bolt.rest_length > 0)) {
        build.problem(get(table, "pretension").place, "the pretension takes more than the whole length of the bolt",
                      fmt::format("less than {:.4g} N", length * bolt.stiffness));
        return;
    }
    build.model.bolts.push_back(bolt);
}

}  // namespace

void build_supports(CaseBuild& build) {
    for (const Value& table : get(build.root, "fixed_point").items) {
        read_fixed_point(build, table);
    }
    for (const Value& table : get(build.root, "bolt").items) {
        read_bolt(build, table);
    }
}

}  // namespace riprap::scene
