// SPDX-License-Identifier: Apache-2.0
// Output, probes and damage.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/core/index.hpp"
#include "riprap/io/output/output_kinds.hpp"
#include "riprap/scene/assemble/build_case.hpp"
#include "riprap/scene/assemble/build_expects.hpp"
#include "riprap/scene/assemble/point_in_body.hpp"
#include "riprap/scene/keys/methods.hpp"
#include "riprap/scene/text/suggest.hpp"

namespace riprap::scene {

namespace {

/// Returns the column of a probe: the name that the case gives it, else BODY.QUANTITY.
std::string name_of_probe(const Value& table) {
    const Value* name = table.find("name");
    const Value* body = table.find("body");
    return name != nullptr ? name->text : (body != nullptr ? body->text + "." : "") + get_text(table, "quantity");
}

/// Reads the point of a body that a probe follows; false with a problem.
bool read_point_of_probe(CaseBuild& build, const Value& at, const sim::QuantityInfo& quantity, sim::Probe& probe) {
    if (!probe.body.is_valid() || !is_of_points(quantity)) {
        build.problem(at.place, fmt::format("'{}' is no quantity of a point of a body", quantity.name),
                      "a 'body', and position, displacement, distance, velocity or speed");
        return false;
    }
    probe.point = build.point_of(probe.body, to_vector(at));
    constexpr double beside = 0.02;  // of the size: a disc or ball is judged by the polyhedron that stands for it
    if (!is_in(build.model, probe.body, *probe.point, beside)) {
        const std::string holders = holders_of(build, to_vector(at));
        build.warnings.push_back(to_string(Diagnostic{
            at.place,
            fmt::format("the point does not lie in '{}' but in {}: it moves and turns with the body as if it did",
                        build.model.bodies.name(probe.body), holders.empty() ? "no body" : holders),
            ""}));
    }
    return true;
}

void read_probe(CaseBuild& build, const Value& table) {
    sim::Probe probe;
    probe.quantity = get_text(table, "quantity");
    const Value* body = table.find("body");
    if (body != nullptr) {
        probe.body = build.body_named(*body);
        if (!probe.body.is_valid()) {
            return;
        }
    }
    probe.name = name_of_probe(table);
    if (sim::find_quantity(probe.quantity, body != nullptr) == nullptr) {
        build.problem(
            get(table, "quantity").place,
            fmt::format("'{}' is {} quantity of {}", probe.quantity, "no", body != nullptr ? "a body" : "the scene"),
            body != nullptr ? "leave out 'body'" : "give the 'body'");
        return;
    }
    const sim::QuantityInfo& quantity = *sim::find_quantity(probe.quantity, body != nullptr);
    if (refuses_quantity(build, quantity, probe.quantity, get(table, "quantity").place)) {
        return;
    }
    if (const Value* at = table.find("at"); at != nullptr && !read_point_of_probe(build, *at, quantity, probe)) {
        return;
    }
    const auto& probes = build.model.output.probes;
    if (std::any_of(probes.begin(), probes.end(), [&](const sim::Probe& p) { return p.name == probe.name; })) {
        build.problem(table.place, fmt::format("a second probe '{}'", probe.name), "give it another 'name'");
        return;
    }
    build.model.output.probes.push_back(std::move(probe));
}

/// Nominal diameter of a body: edge of the cube of its volume, in planar scenes of the square of its area [m].
double nominal_diameter(const sim::Model& model, BodyId body) {
    double volume = 0;
    for (auto p = model.bodies.part_begin[at(body.value)]; p < model.bodies.part_begin[at(body.value) + 1]; ++p) {
        volume += model.shapes.volume(model.bodies.parts[at(p)].shape);
    }
    return model.bodies.is_planar ? std::sqrt(volume) : std::cbrt(volume);
}

void read_damage(CaseBuild& build, const Value& table) {
    const sim::Model& model = build.model;
    sim::Damage damage;
    damage.name = get_text(table, "name");
    for (const Value& name : get(table, "bodies").items) {
        const std::size_t before = damage.bodies.size();
        for (std::int32_t b = 0; b < model.bodies.size(); ++b) {
            if (model.bodies.names[at(model.bodies.name_id[at(b)])] == name.text) {
                damage.bodies.push_back(BodyId{b});
            }
        }
        if (damage.bodies.size() == before && (!build.is_claimed(name.text) || build.problems.empty())) {
            const std::string meant = nearest(name.text, model.bodies.names);
            build.problem(name.place, fmt::format("there is no body '{}'", name.text),
                          meant.empty() ? "a name of [[body]] or [[pack]]" : fmt::format("did you mean '{}'?", meant));
        }
    }
    if (damage.bodies.empty()) {
        return;
    }
    const double diameter = nominal_diameter(model, damage.bodies.front());
    damage.distance = get_number_or(table, "distance", diameter);
    const Value* width = table.find("width");
    if (!build.is_planar && width == nullptr) {
        build.problem(table.place, fmt::format("the damage of '{}' without 'width'", damage.name),
                      "the width of the layer along the breakwater");
        return;
    }
    damage.strips = build.is_planar || !(diameter > 0) ? 1 : width->as_number() / diameter;
    build.model.output.damage.push_back(std::move(damage));
}

}  // namespace

void build_output(CaseBuild& build) {
    const Value& output = get(build.root, "output");
    read_keys(output, output_keys(), build.model.output);
    read_keys(output, io::output_keys(), build.outputs);
    for (const Value& probe : get(output, "probe").items) {
        build.records.insert(name_of_probe(probe));
    }
    for (const Value& gauge : get(output, "gauge").items) {
        build.records.insert(get_text(gauge, "name"));
    }
    for (const Value& damage : get(output, "damage").items) {
        build.records.insert(get_text(damage, "name"));
    }
    for (const Value& probe : get(output, "probe").items) {
        read_probe(build, probe);
    }
    build_gauges(build, get(output, "gauge"));  // after the probes, whose names are taken
    for (const Value& damage : get(output, "damage").items) {
        read_damage(build, damage);
    }
    build_expects(build, get(build.root, "expect"));
}

}  // namespace riprap::scene