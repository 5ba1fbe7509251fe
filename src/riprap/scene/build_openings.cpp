// SPDX-License-Identifier: Apache-2.0
// Sponges, and the openings through which water enters and leaves.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "riprap/scene/build_case.hpp"
#include "riprap/scene/limits.hpp"

namespace riprap::scene {

namespace {

/// "x" to "z" and "-x" to "-z".
struct Way {
    int axis;
    bool is_towards_high;
};

Way way_of(const std::string& text) { return {text.back() - 'x', text.size() == 1}; }

bool is_in(const Vec3& x, const fluid::Domain& domain) {
    for (int axis = 0; axis < domain.dimension; ++axis) {
        if (!(x[axis] >= domain.low[axis] && x[axis] <= domain.high[axis])) {
            return false;
        }
    }
    return true;
}

Vec3 weight_of(const CaseBuild& build, const sim::FluidModel& fluid) {
    Vec3 g = build.model.gravity.value;
    for (int axis = 0; axis < fluid.sph.domain.dimension; ++axis) {
        g[axis] = fluid.sph.domain.is_periodic[static_cast<std::size_t>(axis)] ? 0 : g[axis];
    }
    return g;
}

void build_sponge(CaseBuild& build, const Value& table, sim::FluidModel& fluid) {
    fluid::Sponge sponge;
    sponge.low = get_vector(table, "low");
    sponge.high = get_vector(table, "high");
    const Way way = way_of(get_text(table, "towards"));
    sponge.axis = way.axis;
    sponge.is_towards_high = way.is_towards_high;
    sponge.velocity = get_vector(table, "velocity");
    for (int axis = 0; axis < fluid.sph.domain.dimension; ++axis) {
        if (!(sponge.low[axis] < sponge.high[axis])) {
            build.problem(table.place,
                          fmt::format("the sponge reaches from {} m to {} m along {}", sponge.low[axis],
                                      sponge.high[axis], "xyz"[axis]),
                          "low below high");
            return;
        }
    }
    if (sponge.axis >= fluid.sph.domain.dimension) {
        build.problem(get(table, "towards").place, "a sponge that grows out of the plane",
                      "\"x\", \"-x\", \"y\" or \"-y\"");
        return;
    }
    const Value& rate = get(table, "rate");
    const double gravity = norm(weight_of(build, fluid));
    if (rate.is_text() && !(gravity * fluid.depth > 0)) {
        build.problem(rate.place, "no rate follows for a sponge where water has no depth", "a rate in 1/s");
        return;
    }
    sponge.rate = rate.is_text()
                      ? fluid::sponge_rate(gravity, fluid.depth, sponge.high[sponge.axis] - sponge.low[sponge.axis])
                      : rate.as_number();
    fluid.sponges.push_back(sponge);
}

/// The rectangle of an inflow or outflow; false with a problem.
bool read_opening(CaseBuild& build, const Value& table, const fluid::Domain& domain, fluid::Opening& opening) {
    opening.name = get_text(table, "name");
    opening.low = get_vector(table, "low");
    opening.high = get_vector(table, "high");
    const Way way = way_of(get_text(table, "towards"));
    opening.axis = way.axis;
    opening.way = way.is_towards_high ? 1 : -1;
    for (int axis = 0; axis < domain.dimension; ++axis) {
        const bool is_good =
            axis == opening.axis ? opening.low[axis] == opening.high[axis] : opening.low[axis] < opening.high[axis];
        if (!is_good) {
            build.problem(table.place,
                          fmt::format("the opening '{}' reaches from {} m to {} m along {}, towards {}", opening.name,
                                      opening.low[axis], opening.high[axis], "xyz"[axis], get_text(table, "towards")),
                          "corners that agree along 'towards', and low below high along the others");
            return false;
        }
    }
    if (opening.axis >= domain.dimension) {
        build.problem(get(table, "towards").place, "an opening that leads out of the plane",
                      "\"x\", \"-x\", \"y\" or \"-y\"");
        return false;
    }
    if (domain.is_periodic[static_cast<std::size_t>(opening.axis)]) {
        build.problem(get(table, "towards").place, "an opening across a periodic axis", "a domain that ends there");
        return false;
    }
    if (!is_in(opening.low, domain) || !is_in(opening.high, domain)) {
        build.problem(table.place, fmt::format("the opening '{}' lies outside the domain", opening.name),
                      "corners inside it, with room for the fastest water behind");
        return false;
    }
    return true;
}

}  // namespace

void build_openings(CaseBuild& build, const Value& table, sim::FluidModel& fluid) {
    const fluid::Domain& domain = fluid.sph.domain;
    const double gravity = norm(weight_of(build, fluid));
    const Vec3 up = gravity > 0 ? -1 / gravity * weight_of(build, fluid) : Vec3{};
    std::set<std::string> names;
    const auto claim = [&](const Value& entry) {
        if (!names.insert(get_text(entry, "name")).second) {
            build.problem(get(entry, "name").place, fmt::format("a second opening '{}'", get_text(entry, "name")),
                          "another name");
        }
    };
    for (const Value& entry : get(table, "sponge").items) {
        build_sponge(build, entry, fluid);
    }
    for (const Value& entry : get(table, "inflow").items) {
        claim(entry);
        fluid::Inflow inflow;
        if (!read_opening(build, entry, domain, inflow.opening)) {
            continue;
        }
        inflow.speed = get_number(entry, "speed");
        inflow.ramp = get_number(entry, "ramp");
        inflow.rows = rows_of(inflow.opening, fluid.sph, up, get_number_or(entry, "level", 1e300));
        if (inflow.rows.empty()) {
            build.problem(entry.place, "no particle of water fits into this inflow", "an extent of a spacing or more");
        }
        if (static_cast<std::int64_t>(inflow.rows.size()) > limits::particles) {
            build.problem(entry.place, fmt::format("an inflow of {} rows", inflow.rows.size()),
                          fmt::format("at most {}", limits::particles));
        }
        fluid.open.inflows.push_back(std::move(inflow));
    }
    for (const Value& entry : get(table, "outflow").items) {
        claim(entry);
        fluid::Outflow outflow;
        if (!read_opening(build, entry, domain, outflow.opening)) {
            continue;
        }
        outflow.up = up;
        outflow.gravity = gravity;
        if (const Value* speed = entry.find("speed")) {
            outflow.kind = fluid::OutflowKind::speed;
            outflow.speed = speed->as_number();
        } else if (const Value* level = entry.find("level")) {
            outflow.kind = fluid::OutflowKind::level;
            outflow.level = level->as_number();
            if (gravity == 0) {
                build.problem(level->place, "a level without gravity", "a speed, or nothing");
            }
        }
        fluid.open.outflows.push_back(std::move(outflow));
    }
    fluid.open.most_particles = limits::particles;
    const bool has_penalty = fluid.wall == sim::WallTreatment::penalty;
    if (!fluid.open.empty() && (has_penalty || fluid.sph.scheme == fluid::SphScheme::muller)) {
        build.problem(table.place, "inflow and outflow need the scheme delta_sph and walls of boundary particles",
                      "scheme = \"delta_sph\", wall = \"boundary_particles\"");
    }
}

}  // namespace riprap::scene
