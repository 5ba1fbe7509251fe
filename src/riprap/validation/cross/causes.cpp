// SPDX-License-Identifier: Apache-2.0
#include "riprap/validation/cross/causes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "riprap/core/error.hpp"
#include "riprap/io/atomic_file.hpp"
#include "riprap/scene/text/toml_reader.hpp"

namespace riprap::validation::cross {

namespace {

constexpr std::size_t text_limit = std::size_t{1} << 20U;

std::string text_of(const scene::Value& table, std::string_view key) {
    const scene::Value* value = table.find(key);
    return value != nullptr ? value->text : "";
}

std::vector<std::string> texts_of(const scene::Value& table, std::string_view key) {
    const scene::Value* list = table.find(key);
    std::vector<std::string> texts;
    for (const scene::Value& one : list != nullptr ? list->items : std::vector<scene::Value>{}) {
        texts.push_back(one.text);
    }
    return texts;
}

/// A misspelt key would make an entry speak of more cells than it means.
void note_unknown(const scene::Value& table, std::vector<Diagnostic>& problems) {
    constexpr std::array<std::string_view, 6> known{"scenes", "solids", "fluids", "variations", "cause", "energy"};
    for (const scene::Entry& entry : table.entries) {
        if (std::ranges::find(known, entry.key) == known.end()) {
            problems.push_back({entry.value.place, fmt::format("a [[red]] has no key '{}'", entry.key),
                                fmt::format("one of {}", fmt::join(known, ", "))});
        }
    }
}

/// Tells whether a word is one of a list, or none is asked for.
bool fits(const std::vector<std::string>& list, const std::string& word) {
    return list.empty() || std::ranges::find(list, word) != list.end();
}

bool is_set(const scene::Value& table, std::string_view key) {
    const scene::Value* value = table.find(key);
    return value != nullptr && value->boolean;
}

}  // namespace

Causes::Causes(const std::filesystem::path& file) {
    if (!std::filesystem::exists(file)) {
        return;
    }
    std::vector<Diagnostic> problems;
    const scene::Value root = scene::parse_toml(io::read_file(file, text_limit), file.string(), problems);
    const scene::Value* list = root.find("red");
    for (const scene::Value& table : list != nullptr ? list->items : std::vector<scene::Value>{}) {
        note_unknown(table, problems);
        Red red{texts_of(table, "scenes"),     texts_of(table, "solids"), texts_of(table, "fluids"),
                texts_of(table, "variations"), text_of(table, "cause"),   is_set(table, "energy")};
        if (red.scenes.empty() || red.cause.empty()) {
            problems.push_back({table.place, "a [[red]] without scenes or cause", "both"});
        }
        reds_.push_back(std::move(red));
    }
    if (!problems.empty()) {
        throw CaseError(std::move(problems));
    }
}

bool Causes::is_about(const Red& red, const Cell& cell) {
    const std::string variation = cell.variation.empty() ? "as it is" : cell.variation;
    return fits(red.scenes, cell.scene) && fits(red.solids, cell.solid) && fits(red.fluids, cell.fluid) &&
           fits(red.variations, variation) && red.is_energy == cell.is_energy;
}

void Causes::note(Cell& cell) const {
    const auto red = std::ranges::find_if(reds_, [&](const Red& one) { return is_about(one, cell); });
    if (red == reds_.end()) {
        return;
    }
    if (cell.finding == "wrong") {
        cell.cause = red->cause;
    }
    cell.is_stale = cell.finding == "right";
}

}  // namespace riprap::validation::cross
