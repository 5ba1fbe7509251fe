// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/study/missing_physics.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "riprap/fluid/gauge/gauge.hpp"
#include "riprap/scene/read_case.hpp"
#include "riprap/sim/abilities.hpp"
#include "riprap/sim/method_traits.hpp"

namespace riprap::run {

namespace {

using scene::Value;

/// A block by itself, which every solid method moves.
constexpr const char* block_alone = R"(dimension = 2
gravity = [0.0, -9.81]
end = 0.01
[material.rock]
density = 2500.0
normal_stiffness = 1.0e7
[[body]]
name = "block"
shape = { box = [1.0, 1.0] }
position = [2.0, 3.0]
material = "rock"
)";
/// The same above a pool, which every fluid fills.
constexpr const char* pool = R"([fluid]
spacing = 0.5
domain = { low = [0.0, 0.0], high = [8.0, 6.0] }
[[fluid.region]]
box = { low = [0.0, 0.0], high = [8.0, 2.0] }
)";

struct Feature {
    std::string lacking;                 ///< what a method without it is said to be
    bool is_asked_for;                   ///< by the case
    bool is_of_fluid;                    ///< else of the solids
    std::vector<std::string> overrides;  ///< that bring it into the smallest case
};

/// Tells whether an entry of the list at a path of tables has a key.
bool any_has(const Value& root, std::initializer_list<std::string_view> path, std::string_view key) {
    const Value* at = &root;
    for (const std::string_view step : path) {
        at = at != nullptr && at->is_table() ? at->find(step) : nullptr;
    }
    return at != nullptr && at->is_array() &&
           std::ranges::any_of(at->items, [key](const Value& item) { return item.is_table() && item.find(key); });
}

/// Tells whether a body has a shape of several parts.
bool has_union(const Value& root) {
    const Value* bodies = root.find("body");
    return bodies != nullptr && std::ranges::any_of(bodies->items, [](const Value& body) {
               const Value* shape = body.find("shape");
               return shape != nullptr && shape->is_table() && (shape->find("union") || shape->find("armour"));
           });
}

bool needs(const Value& root, std::string_view word) {
    const Value* expects = root.find("expect");
    for (const Value& expect : expects != nullptr ? expects->items : std::vector<Value>{}) {
        const Value* list = expect.find("needs");
        if (list != nullptr &&
            std::ranges::any_of(list->items, [word](const Value& item) { return item.text == word; })) {
            return true;
        }
    }
    return false;
}

bool has_gauge(const Value& root, std::string_view kind) {
    const Value* output = root.find("output");
    const Value* gauges = output != nullptr ? output->find("gauge") : nullptr;
    return gauges != nullptr && std::ranges::any_of(gauges->items, [kind](const Value& gauge) {
               const Value* given = gauge.find("kind");
               return given != nullptr && given->text == kind;
           });
}

void add_solid_features(const Value& root, std::vector<Feature>& features) {
    const Value* dimension = root.find("dimension");
    const bool is_planar = dimension != nullptr && dimension->as_number() == 2;
    features.push_back({"plane only",
                        !is_planar,
                        false,
                        {"dimension=3", "gravity=[0.0, 0.0, -9.81]", "body.0.shape={ cube = 1.0 }",
                         "body.0.position=[0.0, 0.0, 0.0]"}});
    features.push_back({"no bodies of several parts",
                        has_union(root),
                        false,
                        {"body.0.shape={ union = [{ shape = { box = [1.0, 1.0] } }, { shape = { box = [1.0, 1.0] }, "
                         "position = [1.0, 0.0] }] }"}});
    features.push_back({"no locks", any_has(root, {"body"}, "locked"), false, {"body.0.locked=[\"rotation\"]"}});
    features.push_back({"no fixed points",
                        root.find("fixed_point") != nullptr,
                        false,
                        {"fixed_point=[{ body = \"block\", at = [2.0, 3.0] }]"}});
    features.push_back(
        {"no bolts",
         root.find("bolt") != nullptr,
         false,
         {"body=[{ name = \"a\", material = \"rock\", shape = { box = [1.0, 1.0] } }, { name = \"b\", material = "
          "\"rock\", shape = { box = [1.0, 1.0] }, position = [3.0, 0.0] }]",
          "bolt=[{ bodies = [\"a\", \"b\"], ends = [[0.0, 0.0], [3.0, 0.0]], stiffness = 1.0e6 }]"}});
}

void add_needs(const Value& root, std::vector<Feature>& features) {
    for (const sim::Ability& ability : sim::abilities()) {
        const std::string expect = fmt::format(
            "expect=[{{ name = \"it\", quantity = \"time\", value = 0.0, tolerance = 1.0, citation = \"none\", needs = "
            "[\"{}\"] }}]",
            ability.word);
        features.push_back(
            {std::string(ability.lacking), needs(root, ability.word), ability.word == "moving_water", {expect}});
    }
}

void add_periods(const Value& root, std::vector<Feature>& features) {
    const Value* fluid = root.find("fluid");
    const Value* domain = fluid != nullptr ? fluid->find("domain") : nullptr;
    features.push_back({"no periodic domain",
                        domain != nullptr && domain->find("periodic") != nullptr,
                        true,
                        {"fluid.domain.periodic=[true, false]"}});
}

/// Adds the kinds of gauges of the case that the fluid does not read.
void add_gauges(const Value& root, std::string_view fluid, std::vector<std::string>& missing) {
    for (const fluid::GaugeKind* kind : fluid::gauge_kinds()) {
        const std::vector<std::string_view> readers = sim::fluids_that_read(*kind);
        if (fluid != "none" && has_gauge(root, kind->word) && std::ranges::find(readers, fluid) == readers.end()) {
            missing.push_back(fmt::format("no gauge '{}'", kind->word));
        }
    }
}

bool is_refused(const std::string& text, const std::vector<std::string>& overrides) {
    try {
        scene::read_case_text(text, "the smallest case", "/nonexistent", overrides);
        return false;
    } catch (const CaseError&) {
        return true;
    }
}

/// Tells whether a method refuses the smallest case with a feature, and takes the one without.
bool lacks(const Feature& feature, std::string_view solid, std::string_view fluid) {
    const std::string text = feature.is_of_fluid ? std::string(block_alone) + pool : block_alone;
    std::vector<std::string> overrides{feature.is_of_fluid ? fmt::format("fluid.method=\"{}\"", fluid)
                                                           : fmt::format("solid.method=\"{}\"", solid)};
    if (is_refused(text, overrides)) {
        return false;
    }
    overrides.insert(overrides.end(), feature.overrides.begin(), feature.overrides.end());
    return is_refused(text, overrides);
}

}  // namespace

std::vector<std::string> missing_physics(const Value& root, std::string_view solid, std::string_view fluid) {
    std::vector<Feature> features;
    add_solid_features(root, features);
    add_needs(root, features);
    add_periods(root, features);
    std::vector<std::string> missing;
    for (const Feature& feature : features) {
        const bool can_be_tried = !feature.is_of_fluid || fluid != "none";
        if (feature.is_asked_for && can_be_tried && lacks(feature, solid, fluid)) {
            missing.push_back(feature.lacking);
        }
    }
    add_gauges(root, fluid, missing);
    return missing;
}

}  // namespace riprap::run
