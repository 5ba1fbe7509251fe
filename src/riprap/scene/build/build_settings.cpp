// SPDX-License-Identifier: Apache-2.0
// Time axis, gravity, solid settings, output, probes and expected answers.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/body/locks.hpp"
#include "riprap/core/index.hpp"
#include "riprap/scene/build/build_case.hpp"
#include "riprap/scene/keys/methods.hpp"
#include "riprap/scene/text/suggest.hpp"
#include "riprap/sim/method_traits.hpp"
#include "riprap/sim/quantity.hpp"

namespace riprap::scene {

namespace {

body::Gravity read_gravity(CaseBuild& build, const Value& gravity) {
    body::Gravity out;
    if (gravity.is_array()) {
        out.value = to_vector(gravity);
        return out;
    }
    out.value = get_vector(gravity, "value");
    out.ramp = get_number(gravity, "ramp");
    if (const Value* rotation = gravity.find("rotation")) {
        out.axis = normalized(get_vector(*rotation, "axis"));
        out.rate = get_number(*rotation, "rate");
        out.start = get_number(*rotation, "start");
        out.stop = get_number_or(*rotation, "stop", out.stop);
        if (out.stop <= out.start) {
            build.problem(rotation->place, fmt::format("gravity turns from {} s to {} s", out.start, out.stop),
                          "stop after start");
        }
    }
    return out;
}

}  // namespace

BodyId CaseBuild::body_named(const Value& name) {
    const BodyId body = sim::find_body(model.bodies, name.text);
    if (!body.is_valid() && (!is_claimed(name.text) || problems.empty())) {  // else the body itself has a problem
        const std::string meant = nearest(name.text, model.bodies.names);
        problem(name.place, fmt::format("there is no body '{}'", name.text),
                meant.empty() ? "a name of [[body]], or NAME[17]" : fmt::format("did you mean '{}'?", meant));
    }
    return body;
}

namespace {

/// Returns the column of a probe: the name that the case gives it, else BODY.QUANTITY.
std::string name_of_probe(const Value& table) {
    const Value* name = table.find("name");
    const Value* body = table.find("body");
    return name != nullptr ? name->text : (body != nullptr ? body->text + "." : "") + get_text(table, "quantity");
}

/// Quantities that only some methods have and those of this case do, of the same owner.
std::string other_names(const sim::Model& model, const sim::QuantityInfo& quantity) {
    const bool is_account = quantity.name.find('.') != std::string_view::npos;
    std::string names;
    for (const sim::QuantityInfo& info : sim::quantities()) {
        const bool is_alike =
            info.is_of_body == quantity.is_of_body && is_account == (info.name.find('.') != std::string_view::npos);
        if (is_alike && has_quantity(model, info)) {
            names += fmt::format("{}'{}'", names.empty() ? "" : ", ", info.name);
        }
    }
    return names;
}

/// Reads the point of a body that a probe follows; false with a problem.
bool read_point_of_probe(CaseBuild& build, const Value& at, const sim::QuantityInfo& quantity, sim::Probe& probe) {
    if (!probe.body.is_valid() || !is_of_points(quantity)) {
        build.problem(at.place, fmt::format("'{}' is no quantity of a point of a body", quantity.name),
                      "a 'body', and position, displacement, distance, velocity or speed");
        return false;
    }
    probe.point = build.point_of(probe.body, to_vector(at));
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
    if (!has_quantity(build.model, quantity)) {
        build.problem(get(table, "quantity").place,
                      fmt::format("the methods of this case do not have '{}'", probe.quantity),
                      other_names(build.model, quantity));
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

/// Tells whether `quantity` may be missing only because the record or body that it names has a problem of its own.
bool may_lack_its_subject(const CaseBuild& build, const std::string& quantity) {
    if (build.problems.empty()) {
        return false;
    }
    const auto begins = [&quantity](const std::string& name) {
        return quantity.compare(0, name.size(), name) == 0 &&
               (quantity.size() == name.size() || quantity[name.size()] == '.');
    };
    if (std::any_of(build.records.begin(), build.records.end(), begins)) {
        return true;
    }
    const std::string body = quantity.substr(0, quantity.find('.'));
    return build.is_claimed(body) && !sim::find_body(build.model.bodies, body).is_valid();
}

/// Every number of a body as an [[expect]] names it.
void add_quantities_of(const std::string& body, std::vector<std::string>& names) {
    for (const sim::QuantityInfo& info : sim::quantities()) {
        if (!info.is_of_body) {
            continue;
        }
        for (const char* const component : {".x", ".y", ".z"}) {
            names.push_back(fmt::format("{}.{}{}", body, info.name, info.components > 1 ? component : ""));
        }
    }
}

/// Tells whether `quantity` names one number of the run; adds a problem with the nearest name otherwise.
bool check_column(CaseBuild& build, const std::string& quantity, const SourcePlace& place) {
    if (const std::optional<sim::Column> column = sim::find_column(build.model, quantity)) {
        if (column->quantity == nullptr || has_quantity(build.model, *column->quantity)) {
            return true;
        }
        build.problem(place, fmt::format("the methods of this case do not have '{}'", quantity),
                      other_names(build.model, *column->quantity));
        return false;
    }
    if (may_lack_its_subject(build, quantity)) {
        return false;
    }
    std::vector<std::string> known;
    for (const sim::Column& column : sim::record_columns(build.model)) {
        known.push_back(column.name);
    }
    for (const sim::QuantityInfo& info : sim::quantities()) {
        known.emplace_back(info.name);
    }
    if (const std::string body = quantity.substr(0, quantity.find('.'));
        sim::find_body(build.model.bodies, body).is_valid()) {
        add_quantities_of(body, known);
    }
    const std::string meant = nearest(quantity, known);
    build.problem(place, fmt::format("there is no quantity '{}'", quantity),
                  meant.empty() ? "PROBE, QUANTITY or BODY.QUANTITY, vectors with .x, .y or .z"
                                : fmt::format("did you mean '{}'?", meant));
    return false;
}

/// Warns of an expected answer that is not judged as the run ends before it, say because --end shortens the run.
void warn_of_late(CaseBuild& build, const SourcePlace& place, const sim::Expect& expect, std::string_view key,
                  double time) {
    if (time > build.model.time.end) {
        build.warnings.push_back(to_string(
            Diagnostic{place,
                       fmt::format("[[expect]] '{}' is not judged: the run ends at {:.6g} s, before {} = {:.6g} s",
                                   expect.name, build.model.time.end, key, time),
                       ""}));
    }
}

/// From when to when steps count.
void read_window(CaseBuild& build, const Value& table, sim::Expect& expect) {
    const Value* from = table.find("from");
    const Value* to = table.find("to");
    const Value* given = from != nullptr ? from : to;
    if (given == nullptr) {
        return;
    }
    if (expect.reduce == "at" || expect.reduce == "when") {
        build.problem(given->place, fmt::format("'from' and 'to' say nothing where reduce = \"{}\"", expect.reduce),
                      "with last, min, max, extreme or mean");
    }
    expect.from = get_number_or(table, "from", expect.from);
    expect.to = get_number_or(table, "to", expect.to);
    if (expect.from >= expect.to) {
        build.problem(given->place,
                      fmt::format("no step lies between from = {:.6g} s and to = {:.6g} s", expect.from, expect.to),
                      "from before to");
    } else if (to != nullptr) {
        warn_of_late(build, to->place, expect, "to", expect.to);
    } else {
        warn_of_late(build, from->place, expect, "from", expect.from);
    }
}

void read_expect(CaseBuild& build, const Value& table) {
    sim::Expect expect;
    expect.name = get_text(table, "name");
    expect.quantity = get_text(table, "quantity");
    expect.reduce = get_text(table, "reduce");
    expect.citation = get_text(table, "citation");
    expect.place = fmt::format("{}:{}:{}", table.place.file, table.place.line, table.place.column);
    if (expect.citation.empty()) {
        build.problem(get(table, "citation").place, "the citation is empty", "say where the value comes from");
    }
    const Value* at = table.find("at");
    if ((expect.reduce == "at") != (at != nullptr)) {
        build.problem(table.place, "'at' goes with reduce = \"at\"", "give both or none");
    } else if (at != nullptr) {
        expect.at = at->as_number();
        warn_of_late(build, at->place, expect, "at", expect.at);
    }
    read_window(build, table, expect);
    const Value* when = table.find("when");
    if ((expect.reduce == "when") != (when != nullptr)) {
        build.problem(table.place, "'when' and 'reaches' go with reduce = \"when\"", "give all or none");
    } else if (when != nullptr) {
        expect.when = when->text;
        expect.reaches = get_number(table, "reaches");
    }
    if (const Value* value = table.find("value")) {
        expect.value = value->as_number();
        const Value* absolute = table.find("tolerance");
        const Value* relative = table.find("relative_tolerance");
        if (absolute == nullptr && relative == nullptr) {
            build.problem(table.place, fmt::format("[[expect]] '{}' lacks a tolerance", expect.name),
                          "tolerance or relative_tolerance");
            return;
        }
        if (absolute == nullptr && expect.value == 0) {
            build.problem(relative->place, "a relative_tolerance of value = 0 is no band", "tolerance");
            return;
        }
        const double band =
            absolute != nullptr ? absolute->as_number() : relative->as_number() * std::abs(expect.value);
        expect.low = expect.value - band;
        expect.high = expect.value + band;
    } else {
        expect.low = get_number(table, "low");
        expect.high = get_number(table, "high");
        expect.value = 0.5 * (expect.low + expect.high);
        if (expect.low > expect.high) {
            build.problem(table.place, fmt::format("low = {} lies above high = {}", expect.low, expect.high), "");
            return;
        }
    }
    const bool has_quantity = check_column(build, expect.quantity, get(table, "quantity").place);
    const bool has_trigger = when == nullptr || check_column(build, expect.when, when->place);
    if (!has_quantity || !has_trigger) {
        return;
    }
    build.model.expects.push_back(std::move(expect));
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

void build_settings(CaseBuild& build) {
    const Value& root = build.root;
    sim::Model& model = build.model;
    model.title = get_text(root, "title");
    model.seed = static_cast<std::uint64_t>(get_integer(root, "seed"));
    model.gravity = read_gravity(build, get(root, "gravity"));
    model.bodies.is_planar = build.is_planar;

    model.time.end = get_number(root, "end");
    const Value& step = get(root, "time_step");
    model.time.time_step = step.is_text() ? 0 : step.as_number();
    read_keys(root, time_keys(), model.time);

    model.solid = SolidMethods::read(get(root, "solid"), build.problems);
}

namespace {

/// Says which pairs of kinds the method has no physics for, and which methods have one.
solid::SceneProblem unanswered_problem(const sim::Model& model, const solid::UnansweredBody& unanswered) {
    const auto name = [](solid::BodyKind kind) { return solid::kind_names[static_cast<std::size_t>(kind)]; };
    std::string pairs, words;
    for (const solid::BodyKind other : unanswered.others) {
        pairs += fmt::format("{}{} on {}", pairs.empty() ? "" : " and for ", name(unanswered.kind), name(other));
    }
    sim::Solids::for_each([&]<class Solid>() {
        const bool has_all = std::ranges::all_of(unanswered.others, [&](solid::BodyKind other) {
            return solid::answers(solid::pairs_of<Solid>(), unanswered.kind, other);
        });
        if (has_all) {
            words += fmt::format("{}\"{}\"", words.empty() ? "" : ", ", Solid::Settings::method_name);
        }
    });
    return {unanswered.body,
            fmt::format("'{}' meets others by its {}, and this method has no physics for {}",
                        model.bodies.name(unanswered.body), name(unanswered.kind), pairs),
            words.empty() ? "no method has" : "solid.method = " + words};
}

}  // namespace

void check_solid_method(CaseBuild& build) {
    const sim::Model& model = build.model;
    const solid::SolidScene scene = sim::solid_scene(model);
    const auto problems = sim::Solids::visit(
        model.solid, [&]<class Solid>(const typename Solid::Settings& settings) -> std::vector<solid::SceneProblem> {
            std::vector<solid::SceneProblem> found;
            if constexpr (requires { Solid::problems_of(scene, settings, build.state.bodies); }) {
                found = Solid::problems_of(scene, settings, build.state.bodies);
            }
            for (const solid::UnansweredBody& body : solid::unanswered_bodies(
                     model.bodies, solid::kinds_of<Solid>(scene, settings), solid::pairs_of<Solid>())) {
                found.push_back(unanswered_problem(model, body));
            }
            // Rigid bodies have six degrees of freedom, blocks that deform twelve, of which no guide is made.
            for (std::int32_t b = 0; b < model.bodies.size() && !sim::does(model, sim::has_locks); ++b) {
                if (locks_of(model.bodies, at(b)).any()) {
                    found.push_back({BodyId{b}, "this method locks no degrees of freedom of a body",
                                     fmt::format("leave out 'locked', or solid.method = \"{}\"",
                                                 fmt::join(sim::solids_that(sim::has_locks), "\" or \""))});
                }
            }
            return found;
        });
    const Value& solid = get(build.root, "solid");
    const Value* method = solid.find("method");
    for (const solid::SceneProblem& problem : problems) {
        SourcePlace place = method != nullptr ? method->place : solid.place;
        if (problem.body.is_valid()) {
            place = build.names[model.bodies.names[at(model.bodies.name_id[at(problem.body.value)])]];
        }
        build.problem(place, problem.message, problem.allowed);
    }
}

void build_output(CaseBuild& build) {
    const Value& output = get(build.root, "output");
    read_keys(output, output_keys(), build.model.output);
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
    for (const Value& expect : get(build.root, "expect").items) {
        read_expect(build, expect);
    }
}

}  // namespace riprap::scene
