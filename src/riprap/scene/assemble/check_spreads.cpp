// SPDX-License-Identifier: Apache-2.0
// Numbers that differ between the members of an ensemble: tried before any member runs.
#include "riprap/scene/assemble/check_spreads.hpp"

#include <fmt/format.h>

#include <optional>
#include <set>
#include <string>

#include "riprap/scene/keys/check_keys.hpp"
#include "riprap/scene/keys/key_table.hpp"
#include "riprap/scene/text/override_paths.hpp"
#include "riprap/scene/text/toml_reader.hpp"

namespace riprap::scene {

namespace {

/// Why a case may not have a number in the place of a key; nothing where it may.
std::optional<Diagnostic> refusal(Value root, const std::string& key, double value, bool is_planar) {
    std::vector<Diagnostic> found;
    apply_override(root, fmt::format("{}={}", key, value), found);
    if (found.empty()) {
        check_keys(root, case_table(), is_planar, found);
    }
    return found.empty() ? std::nullopt : std::optional(found.front());
}

}  // namespace

void check_spreads(const Value& checked, const Value& root, bool is_planar, std::vector<Diagnostic>& problems) {
    const Value* spreads = checked.find("spread");
    std::set<std::string> keys;
    for (const Value& spread : spreads != nullptr ? spreads->items : std::vector<Value>{}) {
        const Value& key = get(spread, "key");
        if (!keys.insert(plain_path(root, key.text)).second) {
            problems.push_back({key.place, fmt::format("'{}' has a [[spread]] already", key.text), "one of each key"});
            continue;
        }
        std::vector<double> ends;
        if (const Value* low = spread.find("low")) {
            const Value& high = get(spread, "high");
            ends = {low->as_number(), high.as_number()};
            if (ends[0] > ends[1]) {
                problems.push_back(
                    {low->place, fmt::format("low = {} is above high = {}", ends[0], ends[1]), "low at most high"});
                continue;
            }
        } else {
            ends = {get_number(spread, "mean")};
        }
        for (const double end : ends) {
            if (const auto refused = refusal(root, key.text, end, is_planar)) {
                problems.push_back(
                    {key.place, fmt::format("{} = {}: {}", key.text, end, refused->message), refused->allowed});
                break;
            }
        }
    }
}

std::vector<Diagnostic> problems_of_keys(std::string_view text, const std::string& name,
                                         std::span<const std::string> overrides) {
    std::vector<Diagnostic> problems;
    Value root = parse_toml(text, name, problems);
    for (const std::string& assignment : overrides) {
        apply_override(root, assignment, problems);
    }
    if (problems.empty()) {
        const Value* dimension = root.find("dimension");
        check_keys(root, case_table(), dimension != nullptr && dimension->as_number() == 2, problems);
    }
    return problems;
}

}  // namespace riprap::scene
