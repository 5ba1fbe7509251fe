// SPDX-License-Identifier: Apache-2.0
#include "riprap/view/case_waves.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "riprap/scene/text/toml_reader.hpp"

namespace riprap::view {

namespace {

using scene::Value;

const Value* at_path(const Value& root, std::initializer_list<std::string_view> keys) {
    const Value* value = &root;
    for (const std::string_view key : keys) {
        value = value != nullptr && value->is_table() ? value->find(key) : nullptr;
    }
    return value;
}

/// A finite number above 0.
std::optional<double> positive_at(const Value& table, std::string_view key) {
    const Value* value = at_path(table, {key});
    const bool is_good = value != nullptr && value->is_number() && value->as_number() > 0;
    return is_good && std::isfinite(value->as_number()) ? std::optional(value->as_number()) : std::nullopt;
}

std::optional<Vec3> vector_at(const Value& table, std::string_view key) {
    const Value* value = at_path(table, {key});
    const bool is_good = value != nullptr && value->is_array() &&
                         std::all_of(value->items.begin(), value->items.end(), [](const Value& item) {
                             return item.is_number() && std::isfinite(item.as_number());
                         });
    return is_good ? std::optional(scene::to_vector(*value)) : std::nullopt;
}

std::string text_at(const Value& table, std::string_view key) {
    const Value* value = at_path(table, {key});
    return value != nullptr && value->is_text() ? value->text : std::string();
}

bool is_upright(const Value& gauge, const Vec3& point, const Vec3& gravity) {
    const std::optional<Vec3> end = vector_at(gauge, "end");
    const double along = end ? std::abs(dot(*end - point, gravity)) : 0;
    return end && along > (1 - 1e-9) * norm(*end - point) * norm(gravity);
}

void read_gauge(const Value& gauge, const Vec3& gravity, CaseWaves& waves) {
    const std::string kind = text_at(gauge, "kind"), name = text_at(gauge, "name");
    const std::optional<Vec3> point = vector_at(gauge, "point");
    if (!name.empty() && point && (kind == "level" || (kind == "surface" && is_upright(gauge, *point, gravity)))) {
        waves.gauges.push_back({name, *point});
    }
    if (!name.empty() && kind == "flow") {
        waves.flows.push_back(name);
    }
}

/// A wave maker that makes waves.
struct Maker {
    std::optional<Vec3> direction;
    std::optional<double> period, depth;
};

/// Paddles that make waves, not those that absorb only.
std::vector<Maker> makers_of(const Value& root) {
    std::vector<Maker> makers;
    const Value* bodies = at_path(root, {"body"});
    for (std::size_t i = 0; bodies != nullptr && i < bodies->items.size(); ++i) {
        const Value* maker = at_path(bodies->items[i], {"motion", "wave_maker"});
        if (maker == nullptr || text_at(*maker, "wave") == "none") {
            continue;
        }
        const std::optional<Vec3> way = vector_at(*maker, "direction");
        const std::string wave = text_at(*maker, "wave");
        const bool is_regular = wave != "solitary" && wave != "irregular";
        makers.push_back({way && norm(*way) > 0 ? std::optional(normalized(*way)) : std::nullopt,
                          is_regular ? positive_at(*maker, "period") : std::nullopt, positive_at(*maker, "depth")});
    }
    return makers;
}

}  // namespace

CaseWaves waves_of_case(const RecordedRun& run) {
    std::vector<Diagnostic> problems;
    const Value root = scene::parse_toml(run.resolved_text, "resolved.toml", problems);
    CaseWaves waves;
    const Value* gauges = at_path(root, {"output", "gauge"});
    for (std::size_t i = 0; gauges != nullptr && i < gauges->items.size(); ++i) {
        read_gauge(gauges->items[i], run.gravity, waves);
    }
    const std::vector<Maker> makers = makers_of(root);
    waves.why_no_period = "no wave maker of the case makes regular waves: give a period and a depth";
    if (makers.empty()) {
        return waves;
    }
    const Maker& first = makers.front();
    const auto all = [&](auto what) {
        return std::all_of(makers.begin(), makers.end(), [&](const Maker& one) { return one.*what == first.*what; });
    };
    if (!all(&Maker::period) || !all(&Maker::depth) || !all(&Maker::direction)) {
        waves.why_no_period =
            "the wave makers of the case do not make the same waves: give a period, a depth and a direction";
        return waves;
    }
    waves.direction = first.direction;
    waves.period = first.period;
    waves.depth = first.depth;
    waves.why_no_period = first.period ? "" : waves.why_no_period;
    return waves;
}

}  // namespace riprap::view
