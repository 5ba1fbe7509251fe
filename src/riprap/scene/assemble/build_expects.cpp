// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/assemble/build_expects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/scene/assemble/expect_curves.hpp"
#include "riprap/scene/case/body_names.hpp"
#include "riprap/scene/text/suggest.hpp"
#include "riprap/sim/abilities.hpp"
#include "riprap/sim/column_group.hpp"
#include "riprap/sim/reductions.hpp"

namespace riprap::scene {

namespace {

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

/// Adds the names by which an [[expect]] asks for the numbers of a body.
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

/// Returns the name, of those between commas before a word in brackets ("row,top[mean].position.x"), that no body and
/// no entry has; empty where all have one, and for other quantities.
std::string unknown_of_several(const CaseBuild& build, const std::string& quantity) {
    const std::size_t open = quantity.find('['), close = quantity.find(']');
    if (open == std::string::npos || close == std::string::npos || close < open ||
        std::find(sim::group_words.begin(), sim::group_words.end(), quantity.substr(open + 1, close - open - 1)) ==
            sim::group_words.end()) {
        return "";
    }
    std::size_t begin = 0;
    while (quantity.find(',') < open && begin < open) {
        const std::size_t end = std::min(quantity.find(',', begin), open);
        const std::string name = quantity.substr(begin, end - begin);
        const std::vector<std::string>& names = build.model.bodies.names;
        if (std::find(names.begin(), names.end(), name) == names.end() &&
            !sim::find_body(build.model.bodies, name).is_valid()) {
            return name.empty() ? " " : name;
        }
        begin = end + 1;
    }
    return "";
}

/// Returns the name before a quantity of a body ("blok" of "blok.position.x") where no body has it; empty otherwise,
/// and for groups.
std::string unknown_body_of(const CaseBuild& build, const std::string& quantity) {
    const bool has_component = quantity.size() > 2 && quantity[quantity.size() - 2] == '.';
    const std::string whole = has_component ? quantity.substr(0, quantity.size() - 2) : quantity;
    const std::size_t dot = whole.rfind('.');
    if (dot == std::string::npos || sim::find_quantity(whole.substr(dot + 1), true) == nullptr) {
        return "";
    }
    const std::string body = whole.substr(0, dot);
    const std::size_t open = body.find('[');
    const bool is_group =
        body.find(',') != std::string::npos ||
        (open != std::string::npos && body.find_first_not_of("0123456789]", open + 1) != std::string::npos);
    return is_group || sim::find_body(build.model.bodies, body).is_valid() ? "" : body;
}

/// Tells whether a quantity is one of the water, where the case has none.
bool lacks_water(const sim::Model& model, const sim::QuantityInfo& info) {
    const auto begins = [&info](std::string_view word) { return info.name.starts_with(word); };
    return !model.has_fluid() && (begins("fluid_") || begins("water_") || begins("solver_") ||
                                  info.name == "max_water_speed" || info.name == "coupling_gap");
}

/// Lists the quantities that the methods of the case have, of bodies, of the scene or of accounts as `quantity` is.
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

/// Tells whether `quantity` names one number of the run; adds a problem with the nearest name otherwise.
bool check_column(CaseBuild& build, const std::string& quantity, const SourcePlace& place) {
    if (const std::optional<sim::ColumnGroup> found = sim::find_columns(build.model, quantity)) {
        const sim::QuantityInfo* info = found->columns.front().quantity;
        return info == nullptr || !refuses_quantity(build, *info, quantity, place);
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
    if (const std::string name = unknown_of_several(build, quantity); !name.empty()) {
        const std::string meant = nearest(name, build.model.bodies.names);
        build.problem(place, fmt::format("there is no body '{}' of '{}'", name, quantity),
                      meant.empty() ? "names of bodies before the bracket, with commas between"
                                    : fmt::format("did you mean '{}'?", meant));
        return false;
    }
    if (const std::string name = unknown_body_of(build, quantity); !name.empty()) {
        const NameAnswer answer = answer_to_name(build.model.bodies, name);
        build.problem(place, fmt::format("{} of '{}'", answer.message, quantity), answer.allowed);
        return false;
    }
    const std::string meant = nearest(quantity, known);
    build.problem(place, fmt::format("there is no quantity '{}'", quantity),
                  meant.empty() ? "PROBE, QUANTITY or BODY.QUANTITY, vectors with .x, .y or .z; BODY[mean], [sum], "
                                  "[min], [max], [above LEVEL] or [front NUMBER WIDTH] of many"
                                : fmt::format("did you mean '{}'?", meant));
    return false;
}

/// Tells whether the points of a curve lie along the gauges of a profile.
bool is_along_profile(const Value& table) {
    const Value* curve = table.find("curve");
    return curve != nullptr && get_text(*curve, "along") == sim::along_profile;
}

/// Reads the waves of reduce = "incident" and "reflection".
void read_waves(CaseBuild& build, const Value& table, sim::Expect& expect) {
    const Value* waves = table.find("waves");
    if (sim::is_of_waves(expect.reduce) != (waves != nullptr)) {
        build.problem(waves != nullptr ? waves->place : table.place,
                      "'waves' goes with reduce = \"incident\" and \"reflection\"", "give both or none");
    } else if (waves != nullptr) {
        expect.wave_period = get_number(*waves, "period");
        expect.wave_length = get_number(*waves, "length");
    }
}

/// Tells whether the quantity of an expected answer is a profile as long as the points of its curve; adds a problem
/// otherwise.
bool check_profile(CaseBuild& build, const sim::Expect& expect, const SourcePlace& place) {
    const std::optional<sim::Profile> profile = sim::find_profile(build.model, expect.quantity);
    if (!profile) {
        build.problem(place, fmt::format("there is no profile '{}'", expect.quantity),
                      "a [[output.gauge]] with 'count', of velocities with .x, .y or .z");
        return false;
    }
    const double length = profile->place.back();
    for (const double along : expect.curve.along) {
        if (along < 0 || along > length * (1 + 1e-9)) {
            build.problem(place,
                          fmt::format("a point of the curve at {:.6g} m of the profile '{}'", along, expect.quantity),
                          fmt::format("0 to {:.6g} m, from its first gauge to its last", length));
            return false;
        }
    }
    return true;
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

/// Reads the time window in which steps count.
void read_window(CaseBuild& build, const Value& table, sim::Expect& expect) {
    const Value* from = table.find("from");
    const Value* to = table.find("to");
    const Value* given = from != nullptr ? from : to;
    if (given == nullptr) {
        return;
    }
    if (table.find("at") != nullptr) {
        build.problem(given->place, "'from' and 'to' say nothing beside 'at'", "leave them out");
    }
    expect.from = get_number_or(table, "from", expect.from);
    expect.to = get_number_or(table, "to", expect.to);
    if (expect.from >= expect.to) {
        build.problem(given->place,
                      fmt::format("no step lies between from = {:.6g} s and to = {:.6g} s", expect.from, expect.to),
                      "from before to");
    } else if (to != nullptr && expect.reduce != "when") {  // which is judged once its moment has come
        warn_of_late(build, to->place, expect, "to", expect.to);
    } else if (from != nullptr) {
        warn_of_late(build, from->place, expect, "from", expect.from);
    }
}

/// Refuses an answer that needs physics which the methods of the case lack.
void check_needs(CaseBuild& build, const Value& table, const std::string& name) {
    const Value* needs = table.find("needs");
    for (const Value& need : needs != nullptr ? needs->items : std::vector<Value>{}) {
        if (!sim::has_ability(build.model, need.text)) {
            build.problem(need.place,
                          fmt::format("[[expect]] '{}' needs {}, which no method of this case has", name, need.text),
                          fmt::format("one of the methods {}", fmt::join(sim::methods_with(need.text), ", ")));
        }
    }
}

/// Reads the level that a quantity passes: that of `when` for reduce = "when", its own for "period".
void read_level(CaseBuild& build, const Value& table, sim::Expect& expect) {
    const Value *when = table.find("when"), *reaches = table.find("reaches");
    const bool is_when = expect.reduce == "when";
    if (is_when != (when != nullptr) || (is_when && reaches == nullptr)) {
        build.problem(table.place, "'when' and 'reaches' go with reduce = \"when\"", "give all or none");
        return;
    }
    if (reaches != nullptr && !is_when && expect.reduce != "period") {
        build.problem(reaches->place, fmt::format("'reaches' says nothing where reduce = \"{}\"", expect.reduce),
                      "with when or period");
    }
    expect.when = when != nullptr ? when->text : "";
    expect.reaches = reaches != nullptr ? reaches->as_number() : 0;
}

/// Returns the number of the earlier answer that a key names; -1 without the key, or with a problem.
std::int32_t earlier_answer(CaseBuild& build, const Value& table, std::string_view key) {
    const Value* name = table.find(key);
    if (name == nullptr) {
        return -1;
    }
    std::vector<std::string> known;
    std::int32_t found = -1;
    for (std::size_t i = 0; i < build.model.expects.size(); ++i) {
        known.push_back(build.model.expects[i].name);
        found = known.back() == name->text ? static_cast<std::int32_t>(i) : found;
    }
    if (found < 0) {
        const std::string meant = nearest(name->text, known);
        build.problem(name->place, fmt::format("no [[expect]] before this one is called '{}'", name->text),
                      meant.empty() ? "the name of an earlier one" : fmt::format("did you mean '{}'?", meant));
    }
    return found;
}

/// Reads the band about the expected number; false with a problem.
bool read_band(CaseBuild& build, const Value& table, sim::Expect& expect) {
    if (const Value* reported = table.find("reported")) {
        expect.is_reported = true;
        expect.low = -std::numeric_limits<double>::infinity();
        expect.high = std::numeric_limits<double>::infinity();
        if (!reported->boolean) {
            build.problem(reported->place, "reported = false says nothing", "a 'value' or 'low' and 'high' instead");
        }
        return reported->boolean;
    }
    if (const Value* value = table.find("value")) {
        expect.value = value->as_number();
        const Value* absolute = table.find("tolerance");
        const Value* relative = table.find("relative_tolerance");
        if (absolute == nullptr && relative == nullptr) {
            build.problem(table.place, fmt::format("[[expect]] '{}' lacks a tolerance", expect.name),
                          "tolerance or relative_tolerance");
            return false;
        }
        if (absolute == nullptr && expect.value == 0) {
            build.problem(relative->place, "a relative_tolerance of value = 0 is no band", "tolerance");
            return false;
        }
        const double band =
            absolute != nullptr ? absolute->as_number() : relative->as_number() * std::abs(expect.value);
        expect.low = expect.value - band;
        expect.high = expect.value + band;
        return true;
    }
    expect.low = get_number(table, "low");
    expect.high = get_number(table, "high");
    expect.value = 0.5 * (expect.low + expect.high);
    if (expect.low > expect.high) {
        build.problem(table.place, fmt::format("low = {} lies above high = {}", expect.low, expect.high), "");
        return false;
    }
    return true;
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
    if (std::ranges::find(build.model.expects, expect.name, &sim::Expect::name) != build.model.expects.end()) {
        // Tables of studies have one column for a name, and other answers find it by that.
        build.problem(get(table, "name").place, fmt::format("another [[expect]] is called '{}'", expect.name),
                      "names of their own");
    }
    check_needs(build, table, expect.name);
    const Value* at = table.find("at");
    if ((expect.reduce == "at" || is_along_profile(table)) != (at != nullptr)) {
        build.problem(table.place, "'at' goes with reduce = \"at\" and with a curve along = \"place\"",
                      "give both or none");
    } else if (at != nullptr) {
        expect.at = at->as_number();
        warn_of_late(build, at->place, expect, "at", expect.at);
    }
    read_window(build, table, expect);
    const Value* when = table.find("when");
    read_level(build, table, expect);
    read_waves(build, table, expect);
    expect.minus = earlier_answer(build, table, "minus");
    expect.over = earlier_answer(build, table, "over");
    if (!read_band(build, table, expect) || !read_curve(build, table, expect)) {
        return;
    }
    const Value* relative_to = table.find("relative_to");
    expect.relative_to = relative_to != nullptr ? relative_to->text : "";
    const bool is_of_profile = is_along_profile(table) || sim::is_of_waves(expect.reduce);
    if (relative_to != nullptr && is_of_profile) {
        build.problem(relative_to->place, "'relative_to' says nothing of a profile", "leave it out");
    } else if (relative_to != nullptr && expect.relative_to == expect.quantity) {
        build.problem(relative_to->place, fmt::format("'{}' relative to itself is always 0", expect.quantity),
                      "another quantity");
    }
    const bool has_quantity = is_of_profile ? check_profile(build, expect, get(table, "quantity").place)
                                            : check_column(build, expect.quantity, get(table, "quantity").place);
    const bool has_trigger = when == nullptr || check_column(build, expect.when, when->place);
    const bool has_other = relative_to == nullptr || check_column(build, expect.relative_to, relative_to->place);
    const Value* curve = table.find("curve");
    const bool has_along = curve == nullptr || is_along_profile(table) ||
                           check_column(build, expect.curve.quantity, get(*curve, "along").place);
    if (!has_quantity || !has_trigger || !has_other || !has_along) {
        return;
    }
    build.model.expects.push_back(std::move(expect));
}

}  // namespace

bool refuses_quantity(CaseBuild& build, const sim::QuantityInfo& quantity, const std::string& name,
                      const SourcePlace& place) {
    if (lacks_water(build.model, quantity)) {
        build.problem(place, fmt::format("'{}' in a case without water", name),
                      "a [fluid], or a quantity of the bodies");
        return true;
    }
    if (!has_quantity(build.model, quantity)) {
        build.problem(place, fmt::format("the methods of this case do not have '{}'", name),
                      other_names(build.model, quantity));
        return true;
    }
    return false;
}

void build_expects(CaseBuild& build, const Value& list) {
    for (const Value& expect : list.items) {
        read_expect(build, expect);
    }
}

}  // namespace riprap::scene
