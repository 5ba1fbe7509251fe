// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include "riprap/coupling/particle_walls/gauge_edges.hpp"
#include "riprap/scene/assemble/build_case.hpp"
#include "riprap/scene/case/placed_part.hpp"
#include "riprap/sim/method_traits.hpp"
#include "riprap/sim/quantity.hpp"

namespace riprap::scene {

namespace {

/// Corners in order: the lower one first along every axis.
void order_corners(fluid::Gauge& gauge) {
    for (int axis = 0; axis < 3; ++axis) {
        if (gauge.point[axis] > gauge.end[axis]) {
            std::swap(gauge.point[axis], gauge.end[axis]);
        }
    }
}

int flat_axes(const fluid::Gauge& gauge, int dimension) {
    int count = 0;
    for (int axis = 0; axis < dimension; ++axis) {
        count += gauge.point[axis] == gauge.end[axis] ? 1 : 0;
    }
    return count;
}

void check_extent(CaseBuild& build, const Value& table, fluid::Gauge& gauge, int dimension) {
    const Value* end = table.find("end");
    if (end == nullptr) {
        build.problem(table.place,
                      fmt::format("the '{}' gauge '{}' without 'end'", get_text(table, "kind"), gauge.name),
                      "the other end of its line, or the other corner of its rectangle or box");
        return;
    }
    gauge.end = to_vector(*end);
    const fluid::GaugeExtent extent = gauge.kind->extent;
    const bool is_line = extent == fluid::GaugeExtent::line || extent == fluid::GaugeExtent::way;
    if (is_line && gauge.point == gauge.end) {
        build.problem(end->place, "a line without length", "an end away from the point");
    }
    constexpr double longest = 1e15;  // samples along a line are counted exactly up to there
    if (is_line && !(norm(gauge.end - gauge.point) <= longest)) {
        build.problem(
            end->place,
            fmt::format("a line that ends at ({:.3g}, {:.3g}, {:.3g}) m", gauge.end.x, gauge.end.y, gauge.end.z),
            fmt::format("a line of at most {:.3g} m", longest));
    }
    if (is_line) {
        return;
    }
    order_corners(gauge);
    const int flat = flat_axes(gauge, dimension);
    if (extent == fluid::GaugeExtent::section && flat != 1) {
        build.problem(end->place,
                      flat == 0 ? "a box where a section is asked for: its corners differ along every axis"
                                : fmt::format("a section without extent along {} axes", flat),
                      "corners that agree along exactly one axis, the way of the flow");
    }
    if (extent == fluid::GaugeExtent::box && flat != 0) {
        build.problem(end->place, "a box without volume", "corners that differ along every axis");
    }
}

/// The body that the gauge goes with, which it notes, or an invalid one when it names none; nothing with a problem.
std::optional<BodyId> find_carrier(CaseBuild& build, const Value& table, fluid::Gauge& gauge) {
    const Value* name = table.find("body");
    if (name == nullptr) {
        return BodyId{};
    }
    if (!may_move(gauge.kind->extent)) {
        build.problem(name->place,
                      fmt::format("the '{}' gauge '{}' cannot move with a body", get_text(table, "kind"), gauge.name),
                      "no 'body', as rectangles and boxes keep to the axes, or another kind");
        return std::nullopt;
    }
    const BodyId body = build.body_named(*name);
    if (!body.is_valid()) {
        return std::nullopt;
    }
    if (gauge.kind->extent != fluid::GaugeExtent::face) {
        const auto index = static_cast<std::size_t>(body.value);
        const Pose pose{build.state.bodies.position[index], build.state.bodies.orientation[index]};
        gauge.carrier = body.value;
        gauge.point = to_body(pose, gauge.point);
        gauge.end = to_body(pose, gauge.end);
    }
    return body;
}

/// A transducer that another body lies on reads nothing, one at an edge too little.
void warn_of_cover(CaseBuild& build, const coupling::FaceGauge& face, const fluid::Gauge& gauge) {
    const coupling::ParticleFluid& water = *build.model.particles();
    body::Motion motion;
    for (std::size_t i = 0; i < build.state.bodies.position.size(); ++i) {
        motion.pose.push_back({build.state.bodies.position[i], build.state.bodies.orientation[i]});
    }
    const fluid::ParticleSettings& sph = water.settings();
    const coupling::LoadedFaces faces{build.model.shapes, build.model.bodies, water.is_dry,         motion, {}, {},
                                      sph.domain,         sph.spacing,        sph.support_radius(), {}};
    if (!coupling::is_open(face, faces)) {
        build.warnings.push_back(
            fmt::format("the gauge '{}' is covered at the start and reads 0 as long as it is", gauge.name));
    } else if (coupling::is_near_edge(face, faces)) {
        build.warnings.push_back(
            fmt::format("the gauge '{}' is nearer than {}two spacings, {:.3g} m, to an edge of its face, and reads up "
                        "to a third too little there",
                        gauge.name, face.side > 0 ? "half of its side and " : "",
                        coupling::near_edge * sph.spacing + 0.5 * face.side));
    }
}

/// Refuses gauges that compare the water with what the case does not say: a flow, or a start that no body shares.
void check_flow_gauge(CaseBuild& build, const Value& table, const fluid::GaugeKind& kind) {
    const Value* water = build.root.find("fluid");
    const bool has_flow = water != nullptr && water->find("flow") != nullptr;
    if ((kind.needs & fluid::reading::flow_error) != 0 && !has_flow) {
        build.problem(get(table, "kind").place,
                      fmt::format("the gauge '{}' compares the water with a flow that the case does not name",
                                  get_text(table, "name")),
                      "fluid.flow, or another kind");
    }
    const bool has_wet_body = std::find(build.is_dry.begin(), build.is_dry.end(), 0) != build.is_dry.end();
    if ((kind.needs & fluid::reading::changed) != 0 && has_wet_body) {
        build.problem(get(table, "kind").place,
                      fmt::format("the gauge '{}' compares the water with the start, which bodies were in",
                                  get_text(table, "name")),
                      "a case without bodies in the water, or another kind");
    }
}

/// Refuses a kind of gauge that means nothing in the fluid of the case.
void check_kind(CaseBuild& build, const Value& table, const fluid::GaugeKind& kind) {
    const sim::Model& model = build.model;
    if (!model.has_fluid() || sim::reads_gauge(model, kind)) {
        check_flow_gauge(build, table, kind);
        return;
    }
    std::vector<std::string_view> kinds;
    for (const fluid::GaugeKind* other : fluid::gauge_kinds()) {
        if (sim::reads_gauge(model, *other)) {
            kinds.push_back(other->word);
        }
    }
    build.problem(
        get(table, "kind").place,
        fmt::format("the fluid '{}' has no '{}' to read at the gauge '{}'",
                    get_text(get(build.root, "fluid"), "method"), get_text(table, "kind"), get_text(table, "name")),
        fmt::format("{}, or fluid.method = {}", fmt::join(kinds, ", "), fmt::join(sim::fluids_that_read(kind), ", ")));
}

/// Takes the sensing area and the time of response of an instrument.
void take_sensor(CaseBuild& build, const Value& table, fluid::Gauge& gauge) {
    const Value* area = table.find("area");
    if (area != nullptr && gauge.kind->extent != fluid::GaugeExtent::face) {
        build.problem(area->place, fmt::format("'area' does nothing for a '{}' gauge", get_text(table, "kind")),
                      "no 'area', or a kind on a face");
    }
    const Value* response = table.find("response");
    if (response == nullptr) {
        return;
    }
    gauge.response = response->as_number();
    if (gauge.response > build.model.time.end) {
        build.warnings.push_back(to_string(Diagnostic{
            response->place,
            fmt::format("the gauge '{}' responds in {:.4g} s, and the case ends at {:.4g} s: it shows little of it",
                        gauge.name, gauge.response, build.model.time.end),
            ""}));
    }
}

/// Notes the face that a transducer stands in.
void find_wall(CaseBuild& build, const Value& table, BodyId body, fluid::Gauge& gauge) {
    const double spacing = sim::fluid_spacing(build.model);
    if (gauge.kind->extent != fluid::GaugeExtent::face || spacing == 0 || !build.has_all_bodies) {
        return;
    }
    auto face = coupling::find_face(build.model.shapes, build.model.bodies, build.state.bodies, build.is_dry,
                                    gauge.point, spacing, body);
    if (!face) {
        const std::string whose = body.is_valid() ? fmt::format(" of '{}'", get_text(table, "body")) : "";
        build.problem(
            get(table, "point").place,
            fmt::format("no wet face{} within a spacing, {:.4g} m, of the gauge '{}'", whose, spacing, gauge.name),
            "a point on a face of a body that is not wet = false, or the kind 'pressure'");
        return;
    }
    if (const Value* area = table.find("area")) {
        face->side = std::sqrt(area->as_number());
    }
    if (build.model.particles() != nullptr) {
        warn_of_cover(build, *face, gauge);
    }
    gauge.face = static_cast<std::int32_t>(build.model.output.faces.size());
    build.model.output.faces.push_back(*face);
}

/// The first solid along the line of a run_up gauge, as far as that is in the domain.
BodyId first_solid(const CaseBuild& build, const fluid::Gauge& gauge, double spacing) {
    constexpr double touched = 0.25;  // of a spacing
    const fluid::Domain& domain = *build.domain;
    const Vec3 along = gauge.end - gauge.point;
    double length = norm(along);
    const Vec3 direction = along / length;
    for (int axis = 0; axis < domain.dimension; ++axis) {
        const double side = direction[axis] > 0 ? domain.high[axis] : domain.low[axis];
        if (direction[axis] != 0 && !domain.is_periodic[static_cast<std::size_t>(axis)]) {
            length = std::min(length, std::max(0.0, (side - gauge.point[axis]) / direction[axis]));
        }
    }
    const Vec3 end = gauge.point + length * direction;
    const PlacedSolids solids(build, build.is_dry, min(gauge.point, end), max(gauge.point, end));
    constexpr double most_steps = 1e6;  // a line along a period may be any length
    const double steps = std::clamp(std::ceil(length / (0.5 * spacing)), 1.0, most_steps);
    for (double k = 0; k <= steps; ++k) {
        if (const BodyId solid = solids.at(gauge.point + (k / steps * length) * direction, touched * spacing);
            solid.is_valid()) {
            return solid;
        }
    }
    return {};
}

/// A point in a solid has no water to look at until the solid has left; a run_up ends where a solid stands in its way.
void warn_of_buried(CaseBuild& build, const SourcePlace& place, const fluid::Gauge& gauge) {
    const double spacing = sim::fluid_spacing(build.model);
    if (spacing == 0 || !build.has_all_bodies || build.is_dry.size() != build.state.bodies.position.size()) {
        return;  // no water that solids keep out, or something has a problem
    }
    const auto warn = [&](BodyId solid, std::string_view text) {
        if (solid.is_valid()) {
            build.warnings.push_back(to_string(Diagnostic{
                place, fmt::format(fmt::runtime(text), gauge.name, build.model.bodies.name(solid), gauge.kind->word),
                ""}));
        }
    };
    const fluid::GaugeExtent extent = gauge.kind->extent;
    if (extent == fluid::GaugeExtent::way) {
        if (gauge.end != gauge.point) {
            warn(first_solid(build, gauge, spacing),
                 "the {2} gauge '{0}' meets '{1}' at the start, and reads no farther than there");
        }
    } else if (extent == fluid::GaugeExtent::line) {
        const PlacedSolids solids(build, build.is_dry, gauge.point, gauge.point);
        warn(solids.at(gauge.point, spacing),
             "the line of the {2} gauge '{0}' begins inside '{1}' at the start: its readings count from there, and "
             "are 0 where no water is beyond");
    } else if (extent == fluid::GaugeExtent::point) {
        const PlacedSolids solids(build, build.is_dry, gauge.point, gauge.point);
        const BodyId around = solids.at(gauge.point, spacing);
        warn(around, "the gauge '{0}' lies inside '{1}' at the start and reads 0 there");
        if (!around.is_valid()) {
            constexpr double least = 0.1;  // of a spacing: a gauge on a face is beside the water
            warn(solids.at(gauge.point, least * spacing),
                 "the gauge '{0}' lies inside '{1}' at the start and reads the water beside it there");
        }
    }
}

}  // namespace

void build_gauges(CaseBuild& build, const Value& list) {
    sim::Model& model = build.model;
    for (const Value& table : list.items) {
        if (!build.domain) {
            if (build.root.find("fluid") == nullptr) {
                build.problem(table.place,
                              fmt::format("the gauge '{}' in a case without water", get_text(table, "name")),
                              "a [fluid], or a [[output.probe]] of a body");
            }
            continue;
        }
        fluid::Gauge gauge;
        gauge.name = get_text(table, "name");
        gauge.kind = fluid::find_gauge_kind(get_text(table, "kind"));
        gauge.point = get_vector(table, "point");
        check_kind(build, table, *gauge.kind);
        gauge.up = build.up();
        if (!build.domain->holds(gauge.point)) {
            const Vec3 &x = gauge.point, &low = build.domain->low, &high = build.domain->high;
            build.problem(get(table, "point").place,
                          fmt::format("the gauge '{}' at ({:.6g}, {:.6g}, {:.6g}) m is outside the domain of the water",
                                      gauge.name, x.x, x.y, x.z),
                          fmt::format("a point from ({:.6g}, {:.6g}, {:.6g}) to ({:.6g}, {:.6g}, {:.6g}) m", low.x,
                                      low.y, low.z, high.x, high.y, high.z));
        }
        if (has_end(gauge.kind->extent)) {
            check_extent(build, table, gauge, build.domain->dimension);
        } else if (const Value* end = table.find("end")) {
            build.problem(end->place, fmt::format("'end' does nothing for a '{}' gauge", get_text(table, "kind")),
                          "no 'end', or a kind along a line, through a rectangle or in a box");
        }
        warn_of_buried(build, get(table, "point").place, gauge);  // before its point is its body's
        take_sensor(build, table, gauge);
        if (const auto body = find_carrier(build, table, gauge)) {
            find_wall(build, table, *body, gauge);
        }
        const auto& gauges = model.output.gauges;
        const auto& probes = model.output.probes;
        if (std::any_of(gauges.begin(), gauges.end(), [&](const auto& other) { return other.name == gauge.name; }) ||
            std::any_of(probes.begin(), probes.end(), [&](const auto& other) { return other.name == gauge.name; })) {
            build.problem(get(table, "name").place, fmt::format("a second record '{}'", gauge.name), "another name");
        }
        if (sim::find_quantity(gauge.name, false) != nullptr) {
            build.problem(get(table, "name").place,
                          fmt::format("the gauge '{}' has the name of a quantity of the scene", gauge.name),
                          "another name, as [[expect]] could not tell them apart");
        }
        model.output.gauges.push_back(std::move(gauge));
    }
}

}  // namespace riprap::scene
