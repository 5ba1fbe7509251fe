// SPDX-License-Identifier: Apache-2.0
// Sponges, and the openings through which water enters and leaves.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>

#include "riprap/geometry/polyhedra/convex_query.hpp"
#include "riprap/scene/assemble/build_case.hpp"
#include "riprap/scene/case/placed_part.hpp"
#include "riprap/scene/keys/words.hpp"
#include "riprap/scene/text/limits.hpp"

namespace riprap::scene {

namespace {

void build_sponge(CaseBuild& build, const Value& table, coupling::ParticleFluid& fluid) {
    fluid::Sponge sponge;
    sponge.low = get_vector(table, "low");
    sponge.high = get_vector(table, "high");
    const Way way = get_word(table, "towards", ways());
    sponge.axis = way.axis;
    sponge.is_towards_high = way.is_towards_high;
    sponge.velocity = get_vector(table, "velocity");
    for (int axis = 0; axis < fluid.settings().domain.dimension; ++axis) {
        if (!(sponge.low[axis] < sponge.high[axis])) {
            build.problem(table.place,
                          fmt::format("the sponge reaches from {} m to {} m along {}", sponge.low[axis],
                                      sponge.high[axis], "xyz"[axis]),
                          "low below high");
            return;
        }
    }
    if (sponge.axis >= fluid.settings().domain.dimension) {
        build.problem(get(table, "towards").place, "a sponge that grows out of the plane",
                      "\"x\", \"-x\", \"y\" or \"-y\"");
        return;
    }
    for (int axis = 0; axis < fluid.settings().domain.dimension; ++axis) {
        const double low = fluid.settings().domain.low[axis], high = fluid.settings().domain.high[axis];
        if (!(sponge.high[axis] > low && sponge.low[axis] < high)) {
            build.problem(table.place,
                          fmt::format("the sponge lies outside the domain: from {} m to {} m along {}",
                                      sponge.low[axis], sponge.high[axis], "xyz"[axis]),
                          fmt::format("a box that meets it, which reaches from {} m to {} m", low, high));
            return;
        }
    }
    const Value& rate = get(table, "rate");
    const double gravity = norm(fluid::without_periodic(build.model.gravity.value, fluid.settings().domain));
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
    const Way way = get_word(table, "towards", ways());
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
    if (!domain.holds(opening.low) || !domain.holds(opening.high)) {
        build.problem(table.place, fmt::format("the opening '{}' lies outside the domain", opening.name),
                      "corners inside it, with room for the fastest water behind");
        return false;
    }
    return true;
}

/// Refuses solids among the layers behind an opening, and water that is there already.
/// @param side  +1 where layers lie past the plane (outflow), -1 where before it
/// @param rows  of its layers
void check_behind(CaseBuild& build, const Value& table, const coupling::ParticleFluid& fluid,
                  const fluid::Opening& opening, double side, const std::vector<Vec3>& rows) {
    const double dp = fluid.settings().spacing;
    const auto layers = static_cast<int>(std::ceil(fluid.settings().support_radius() / dp - 1e-9)) + 1;
    const Vec3 away = side * opening.direction(), behind = layers * dp * away, before = dp * away;
    const PlacedSolids solids(build, fluid.is_dry, min(opening.low - before, opening.low + behind),
                              max(opening.high - before, opening.high + behind));
    const double slack = 1e-6 * dp;  // faces may touch
    for (const Vec3& row : rows) {
        BodyId solid = solids.at(row - 0.5 * dp * away, slack);
        if (solid.is_valid() && side > 0) {
            continue;  // no water comes to the plane there
        }
        for (int layer = 0; layer < layers && !solid.is_valid(); ++layer) {
            solid = solids.at(row + (layer + 0.5) * dp * away, slack);
        }
        if (solid.is_valid()) {
            build.problem(table.place,
                          fmt::format("'{}' stands in the opening '{}' or in the {:.3g} m behind it",
                                      build.model.bodies.name(solid), opening.name, layers * dp),
                          "no solid there, or a body with wet = false");
            return;
        }
    }
    const auto& water = build.state.fluid.position;
    const auto is_behind = [&](const Vec3& x) {
        const double past = side * opening.past(x);
        return past > 1e-6 * dp && past <= layers * dp && opening.is_across(x, fluid.settings().domain.dimension);
    };
    const auto count = std::count_if(water.begin(), water.end(), is_behind);
    if (count > 0) {
        build.problem(table.place,
                      fmt::format("{} particles of water start behind the opening '{}'", count, opening.name),
                      "regions that end at its plane");
    }
}

/// Warns where an inflow is not a whole number of spacings high and wide.
void warn_of_rows(CaseBuild& build, const Value& table, const fluid::ParticleSettings& sph, const Vec3& up,
                  const fluid::Inflow& inflow) {
    const Value* level = table.find("level");
    bool is_cut = level == nullptr;
    double asked = 1, made = static_cast<double>(inflow.rows.size());
    for (int axis = 0; axis < sph.domain.dimension; ++axis) {
        if (axis != inflow.opening.axis) {
            const bool is_up = level != nullptr && up[axis] > 1 - 1e-9;
            is_cut = is_cut || is_up;
            const double high =
                is_up ? std::min(inflow.opening.high[axis], level->as_number()) : inflow.opening.high[axis];
            asked *= high - inflow.opening.low[axis];
            made *= sph.spacing;
        }
    }
    constexpr double least = 1e-3;  // of the area: spacings are written with a few digits
    if (is_cut && std::abs(made - asked) > least * asked) {
        const char* const area = sph.domain.dimension == 2 ? "m" : "m^2";
        build.warnings.push_back(fmt::format(
            "the inflow '{}' takes {:.6g} {} of {:.6g} {}, whole spacings of {:.6g} m: it brings {:.6g} {}/s",
            inflow.opening.name, made, area, asked, area, sph.spacing, made * inflow.speed,
            sph.domain.dimension == 2 ? "m^2" : "m^3"));
    }
}

}  // namespace

void build_openings(CaseBuild& build, const Value& table, coupling::ParticleFluid& fluid) {
    const fluid::Domain& domain = fluid.settings().domain;
    const Vec3 weight = fluid::without_periodic(build.model.gravity.value, domain);
    const double gravity = norm(weight);
    const Vec3 up = gravity > 0 ? -1 / gravity * weight : Vec3{};
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
        inflow.rows = rows_of(inflow.opening, fluid.settings(), up, get_number_or(entry, "level", 1e300));
        if (inflow.rows.empty()) {
            build.problem(entry.place, "no particle of water fits into this inflow", "an extent of a spacing or more");
        }
        if (static_cast<std::int64_t>(inflow.rows.size()) > limits::particles) {
            build.problem(entry.place, fmt::format("an inflow of {} rows", inflow.rows.size()),
                          fmt::format("at most {}", limits::particles));
        }
        if (!inflow.rows.empty() && static_cast<std::int64_t>(inflow.rows.size()) <= limits::particles) {
            check_behind(build, entry, fluid, inflow.opening, -1, inflow.rows);
            warn_of_rows(build, entry, fluid.settings(), up, inflow);
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
        const bool has_layers = outflow.kind != fluid::OutflowKind::free;
        check_behind(build, entry, fluid, outflow.opening, 1,
                     has_layers ? rows_of(outflow.opening, fluid.settings(), up, 1e300) : std::vector<Vec3>{});
        fluid.open.outflows.push_back(std::move(outflow));
    }
    fluid.open.most_particles = limits::particles;
    const bool has_penalty = fluid.wall == coupling::WallTreatment::penalty;
    if (!fluid.open.empty() && (has_penalty || !takes_openings(fluid.scheme))) {
        build.problem(
            table.place, "this water takes no inflow and no outflow",
            "method = \"sph\" with scheme = \"delta_sph\" and wall = \"boundary_particles\"; or method = \"grid\"");
    }
}

}  // namespace riprap::scene
