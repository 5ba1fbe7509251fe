// SPDX-License-Identifier: Apache-2.0
#include "riprap/sim/quantity.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "riprap/fluid/gauge/gauge.hpp"
#include "riprap/sim/ledger_table.hpp"
#include "riprap/sim/quantity_table.hpp"
#include "riprap/sim/scratch_data.hpp"

namespace riprap::sim {

namespace {

/// The table in the order of the manual: quantities of bodies, accounts of the energy balance, others of the scene.
const std::vector<QuantityInfo>& all_infos() {
    static const std::vector<QuantityInfo> infos = [] {
        std::vector<QuantityInfo> list;
        for (const Quantity& quantity : body_quantities()) {
            list.push_back(quantity.info);
        }
        for (const LedgerLine& line : ledger_lines()) {
            list.push_back({line.name, LedgerLine::unit, 1, false, line.help});
        }
        for (const Quantity& quantity : scene_quantities()) {
            list.push_back(quantity.info);
        }
        return list;
    }();
    return infos;
}

std::size_t place_of(const QuantityInfo& info) { return static_cast<std::size_t>(&info - all_infos().data()); }

/// The account that a quantity is; nullptr for others.
const LedgerLine* account_behind(const QuantityInfo& info) {
    const std::size_t first = body_quantities().size(), place = place_of(info);
    return place >= first && place < first + ledger_lines().size() ? &ledger_lines()[place - first] : nullptr;
}

/// The function of a quantity that is no account.
const Quantity& behind(const QuantityInfo& info) {
    const std::size_t bodies = body_quantities().size(), place = place_of(info);
    return place < bodies ? body_quantities()[place] : scene_quantities()[place - bodies - ledger_lines().size()];
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

/// Reads a gauge of the fluid of the case.
std::array<double, 3> read_gauge(const Moment& moment, const fluid::Gauge& gauge) {
    const Model& model = moment.model;
    const coupling::FaceGauge* const face =
        gauge.face >= 0 ? &model.output.faces[static_cast<std::size_t>(gauge.face)] : nullptr;
    const coupling::FluidScene scene{model.shapes, model.bodies, model.gravity};
    return Fluids::visit(model.fluid, [&]<class Fluid>(const typename Fluid::Settings& settings) {
        const auto* const scratch =
            moment.scratch == nullptr ? nullptr : std::get_if<typename Fluid::Scratch>(&moment.scratch->data().fluid);
        return Fluid::read(scene, settings, moment.state.fluid, scratch, gauge, face, moment.state.time);
    });
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
    const LedgerLine* line = account_behind(quantity);
    return line == nullptr || has_line(model, *line);
}

const QuantityInfo* find_quantity(std::string_view name, bool of_body) {
    for (const QuantityInfo& info : all_infos()) {
        if (info.is_of_body == of_body && info.name == name) {
            return &info;
        }
    }
    return nullptr;
}

double evaluate(const Column& column, const Moment& moment) {
    if (column.gauge >= 0) {
        const fluid::Gauge& gauge = moment.model.output.gauges[static_cast<std::size_t>(column.gauge)];
        const body::BodyState& bodies = moment.state.bodies;
        const bool is_carried = gauge.carrier >= 0 && gauge.face < 0;
        return read_gauge(moment, is_carried ? carried(gauge, bodies.position, bodies.orientation)
                                             : gauge)[static_cast<std::size_t>(column.component)];
    }
    if (const LedgerLine* line = account_behind(*column.quantity)) {
        return moment.report == nullptr ? std::numeric_limits<double>::quiet_NaN()
                                        : value_of(*line, moment.model, moment.report->ledger);
    }
    const Quantity& quantity = behind(*column.quantity);
    const Vec3 value = quantity.info.is_of_body ? quantity.of_body(moment, column.body) : quantity.of_scene(moment);
    return value[column.component];
}

std::string unit_in(std::string_view unit, bool is_planar) {
    constexpr std::array<std::string_view, 12> extensive{"N",  "N m",    "N s",    "N m s",    "J",   "W",
                                                         "kg", "kg m/s", "kg m^2", "kg m^2/s", "m^3", "m^3/s"};
    const bool is_extensive = std::find(extensive.begin(), extensive.end(), unit) != extensive.end();
    return std::string(unit) + (is_planar && is_extensive ? "/m" : "");
}

std::vector<Column> columns_of(const Probe& probe, bool is_planar) {
    std::vector<Column> columns;
    const QuantityInfo* quantity = find_quantity(probe.quantity, probe.body.is_valid());
    if (quantity != nullptr) {
        for (int c = 0; c < quantity->components; ++c) {
            columns.push_back({with_component(probe.name, *quantity, c), unit_in(quantity->unit, is_planar), probe.body,
                               quantity, c});
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
        const fluid::GaugeInfo& info = fluid::info_of(gauge.kind);
        for (int c = 0; c < info.components; ++c) {
            const std::string name = info.components > 1 ? gauge.name + '.' + static_cast<char>('x' + c) : gauge.name;
            columns.push_back(
                {name, unit_in(info.unit, model.bodies.is_planar), BodyId{}, nullptr, c, static_cast<std::int32_t>(g)});
        }
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
