// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/study/method_scales.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "riprap/scene/keys/methods.hpp"
#include "riprap/scene/text/toml_reader.hpp"
#include "riprap/sim/method_traits.hpp"

namespace riprap::run {

namespace {

using scene::Value;

struct Factor {
    double value;
    const char* text;
};
constexpr std::array factors{Factor{0.25, "1/4"}, Factor{4, "4"}};

bool has_key(const std::string& solid, std::string_view name) {
    for (const scene::Method& method : scene::SolidMethods::all()) {
        if (method.word == solid) {
            return std::ranges::any_of(method.keys, [name](const scene::Key& key) { return key.name == name; });
        }
    }
    return false;
}

/// Appends "table.key=value times factor" where the resolved case has a number there, or leaves it to its blocks.
/// @param chosen  that number then; 0 = none
void scale(const Value& table, const std::string& path, std::string_view key, double factor, double most,
           std::vector<std::string>& overrides, double chosen = 0) {
    const Value* value = table.find(key);
    const double number = value != nullptr && value->is_number() ? value->as_number() : value != nullptr ? chosen : 0;
    if (number > 0) {
        overrides.push_back(fmt::format("{}{}={}", path, key, scene::number_text(std::min(factor * number, most))));
    }
}

/// Returns the step that an implicit method wants; 0 for others [s].
double wanted_step(const sim::SolidSettings& settings) {
    const double* const step = sim::step_of(settings);
    return step != nullptr ? *step : 0;
}

/// Returns the stiffness of a contact point; 0 for methods without one, and where it is one of an area [N/m].
double point_stiffness(const sim::SolidSettings& settings) {
    const auto* const elasticity = sim::elasticity_of(settings);
    return elasticity != nullptr && !elasticity->stiffness_per_area ? elasticity->contact_stiffness : 0;
}

std::vector<std::string> scaled_step(const Value& root, const std::string& solid, double factor,
                                     const sim::SolidSettings& settings) {
    std::vector<std::string> overrides;
    if (has_key(solid, "step")) {
        scale(get(root, "solid"), "solid.", "step", factor, 1e9, overrides, wanted_step(settings));
    } else {
        scale(root, "", "time_step_factor", factor, 1, overrides);
    }
    return overrides;
}

std::vector<std::string> scaled_stiffness(const Value& root, const std::string& solid, double factor,
                                          const sim::SolidSettings& settings) {
    constexpr double any = 1e300;
    std::vector<std::string> overrides;
    const char* key = has_key(solid, "contact_stiffness") ? "contact_stiffness" : "youngs_modulus";
    scale(get(root, "solid"), "solid.", key, factor, any, overrides, point_stiffness(settings));
    scale(get(root, "solid"), "solid.", "contact_stiffness_per_area", factor, any, overrides);
    const scene::Key* of_materials = scene::material_table().find("normal_stiffness");
    for (const scene::Entry& material : get(root, "material").entries) {
        if (of_materials != nullptr && of_materials->is_of(solid)) {
            scale(material.value, fmt::format("material.{}.", material.key), "normal_stiffness", factor, any,
                  overrides);
        }
    }
    return overrides;
}

}  // namespace

std::vector<scene::Variation> method_scales(const std::string& resolved_toml, const std::string& solid,
                                            const sim::SolidSettings& settings) {
    std::vector<Diagnostic> problems;
    const Value root = scene::parse_toml(resolved_toml, "the resolved case", problems);
    std::vector<scene::Variation> runs;
    for (const Factor& factor : factors) {
        runs.push_back({fmt::format("step x {}", factor.text), scaled_step(root, solid, factor.value, settings)});
    }
    for (const Factor& factor : factors) {
        runs.push_back(
            {fmt::format("stiffness x {}", factor.text), scaled_stiffness(root, solid, factor.value, settings)});
    }
    std::erase_if(runs, [](const scene::Variation& run) { return run.overrides.empty(); });
    return runs;
}

}  // namespace riprap::run
