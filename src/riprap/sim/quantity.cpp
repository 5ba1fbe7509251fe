// SPDX-License-Identifier: Apache-2.0
#include "riprap/sim/quantity.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "riprap/fluid/gauge/gauge.hpp"
#include "riprap/sim/gauge_reading.hpp"
#include "riprap/sim/ledger_table.hpp"
#include "riprap/sim/quantity_table.hpp"
#include "riprap/sim/shown.hpp"

namespace riprap::sim {

namespace {

/// The table in the order of the manual: quantities of bodies, fields that methods show, accounts of the energy
/// balance, others of the scene.
const std::vector<QuantityInfo>& all_infos() {
    static const std::vector<QuantityInfo> infos = [] {
        std::vector<QuantityInfo> list;
        for (const Quantity& quantity : body_quantities()) {
            list.push_back(quantity.info);
        }
        for (const ShownField& field : all_shown_fields()) {
            list.push_back({field.name, field.unit, 1, true, field.help});
        }
        for (const LedgerLine& line : ledger_lines()) {
            list.push_back({line.name, line.unit, 1, false, line.help});
        }
        for (const Quantity& quantity : scene_quantities()) {
            list.push_back(quantity.info);
        }
        return list;
    }();
    return infos;
}

std::size_t place_of(const QuantityInfo& info) { return static_cast<std::size_t>(&info - all_infos().data()); }

/// Table of which a quantity is a line.
enum class Owner { body_table, shown_fields, ledger, scene_table };
struct Line {
    Owner owner;
    std::size_t place;  ///< in that table
};

Line line_of(const QuantityInfo& info) {
    std::size_t place = place_of(info);
    if (place < body_quantities().size()) {
        return {Owner::body_table, place};
    }
    place -= body_quantities().size();
    if (place < all_shown_fields().size()) {
        return {Owner::shown_fields, place};
    }
    place -= all_shown_fields().size();
    return place < ledger_lines().size() ? Line{Owner::ledger, place}
                                         : Line{Owner::scene_table, place - ledger_lines().size()};
}

Vec3 read(const QuantityInfo& info, BodyId body, const Moment& moment) {
    const Line line = line_of(info);
    switch (line.owner) {
        case Owner::body_table:
            return body_quantities()[line.place].of_body(moment, body);
        case Owner::shown_fields:
            return {shown_value(moment.model, moment.state, info.name, body), 0, 0};
        case Owner::ledger:
            return {moment.report == nullptr
                        ? std::numeric_limits<double>::quiet_NaN()
                        : value_of(ledger_lines()[line.place], moment.model, moment.report->ledger),
                    0, 0};
        case Owner::scene_table:
            break;
    }
    return scene_quantities()[line.place].of_scene(moment);
}

/// Splits a trailing ".x", ".y" or ".z" off; the component, or -1.
int split_component(std::string_view& text) {
    if (text.size() > 2 && text[text.size() - 2] == '.' && text.back() >= 'x' && text.back() <= 'z') {
        const int component = text.back() - 'x';
        text.remove_suffix(2);
        return component;
    }
    return -1;
}

std::string with_component(std::string_view name, const QuantityInfo& quantity, int component) {
    std::string text(name);
    if (quantity.components > 1) {
        text += '.';
        text += static_cast<char>('x' + component);
    }
    return text;
}

/// Number of units of a group that have moved farther than its distance, or N_od, that number per strip as wide as a
/// nominal diameter.
double read_damage(const Moment& moment, const Damage& group, int component) {
    double displaced = 0;
    for (const BodyId body : group.bodies) {
        const auto b = static_cast<std::size_t>(body.value);
        const Vec3 moved = moment.state.bodies.position[b] - moment.initial.bodies.position[b];
        displaced += norm(moved) > group.distance ? 1 : 0;
    }
    return component == 0 ? displaced : displaced / group.strips;
}

/// The column of one quantity with the component that the text gave (-1 = none); nothing where they do not fit.
std::optional<Column> make_column(std::string_view text, BodyId body, const QuantityInfo* quantity, int component,
                                  bool is_planar) {
    if (quantity == nullptr || (quantity->components > 1) != (component >= 0)) {
        return std::nullopt;
    }
    return Column{std::string(text), unit_in(quantity->unit, is_planar), body, quantity, component < 0 ? 0 : component};
}

}  // namespace

std::span<const QuantityInfo> quantities() { return all_infos(); }

bool has_quantity(const Model& model, const QuantityInfo& quantity) {
    const Line line = line_of(quantity);
    if (line.owner == Owner::shown_fields) {
        const std::span<const ShownField> fields = shown_fields(model);
        return std::any_of(fields.begin(), fields.end(),
                           [&](const ShownField& field) { return field.name == quantity.name; });
    }
    return line.owner != Owner::ledger || has_line(model, ledger_lines()[line.place]);
}

const QuantityInfo* find_quantity(std::string_view name, bool of_body) {
    for (const QuantityInfo& info : all_infos()) {
        if (info.is_of_body == of_body && info.name == name) {
            return &info;
        }
    }
    return nullptr;
}

bool is_of_points(const QuantityInfo& quantity) {
    const Line line = line_of(quantity);
    return line.owner == Owner::body_table && body_quantities()[line.place].of_point != nullptr;
}

double evaluate(const Column& column, const Moment& moment) {
    if (column.gauge >= 0) {
        return read_gauge(moment.model, moment.state, moment.scratch,
                          static_cast<std::size_t>(column.gauge))[static_cast<std::size_t>(column.component)];
    }
    if (column.damage >= 0) {
        return read_damage(moment, moment.model.output.damage[static_cast<std::size_t>(column.damage)],
                           column.component);
    }
    if (column.point) {
        return body_quantities()[line_of(*column.quantity).place].of_point(moment, column.body,
                                                                           *column.point)[column.component];
    }
    return read(*column.quantity, column.body, moment)[column.component];
}

std::string unit_in(std::string_view unit, bool is_planar) {
    constexpr std::array<std::string_view, 13> extensive{
        "N", "N m", "N s", "N m s", "J", "W", "kg", "kg m/s", "kg m^2", "kg m^2/s", "m^3", "m^3/s", "m^5/s^2"};
    const bool is_extensive = std::find(extensive.begin(), extensive.end(), unit) != extensive.end();
    return std::string(unit) + (is_planar && is_extensive ? "/m" : "");
}

std::vector<Column> columns_of(const Probe& probe, bool is_planar) {
    std::vector<Column> columns;
    const QuantityInfo* quantity = find_quantity(probe.quantity, probe.body.is_valid());
    if (quantity != nullptr) {
        for (int c = 0; c < quantity->components; ++c) {
            columns.push_back({with_component(probe.name, *quantity, c), unit_in(quantity->unit, is_planar), probe.body,
                               quantity, c, probe.point});
        }
    }
    return columns;
}

std::vector<Column> record_columns(const Model& model) {
    std::vector<Column> columns;
    for (const Probe& probe : model.output.probes) {
        for (Column& column : columns_of(probe, model.bodies.is_planar)) {
            columns.push_back(std::move(column));
        }
    }
    for (std::size_t g = 0; g < model.output.gauges.size(); ++g) {
        const fluid::Gauge& gauge = model.output.gauges[g];
        const fluid::GaugeKind& kind = *gauge.kind;
        for (int c = 0; c < kind.components; ++c) {
            const std::string name = kind.components > 1 ? gauge.name + '.' + static_cast<char>('x' + c) : gauge.name;
            columns.push_back({name, unit_in(kind.unit, model.bodies.is_planar), BodyId{}, nullptr, c, std::nullopt,
                               static_cast<std::int32_t>(g)});
        }
    }
    for (std::size_t d = 0; d < model.output.damage.size(); ++d) {
        const auto group = static_cast<std::int32_t>(d);
        const std::string& name = model.output.damage[d].name;
        columns.push_back({name + ".displaced", "-", BodyId{}, nullptr, 0, std::nullopt, -1, group});
        columns.push_back({name + ".n_od", "-", BodyId{}, nullptr, 1, std::nullopt, -1, group});
    }
    return columns;
}

std::optional<Column> find_column(const Model& model, std::string_view text) {
    for (const Column& column : record_columns(model)) {
        if (column.name == text) {
            return column;
        }
    }
    const bool is_planar = model.bodies.is_planar;
    std::string_view rest = text;
    const int component = split_component(rest);
    if (std::optional<Column> column = make_column(text, BodyId{}, find_quantity(rest, false), component, is_planar)) {
        return column;
    }
    const std::size_t dot = rest.rfind('.');
    if (dot == std::string_view::npos) {
        return std::nullopt;
    }
    const BodyId body = find_body(model.bodies, rest.substr(0, dot));
    if (!body.is_valid()) {
        return std::nullopt;
    }
    return make_column(text, body, find_quantity(rest.substr(dot + 1), true), component, is_planar);
}

BodyId find_body(const body::BodySet& bodies, std::string_view name) {
    for (std::int32_t i = 0; i < bodies.size(); ++i) {
        if (bodies.name(BodyId{i}) == name) {
            return BodyId{i};
        }
    }
    return {};
}

}  // namespace riprap::sim
