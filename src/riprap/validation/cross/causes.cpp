// SPDX-License-Identifier: Apache-2.0
#include "riprap/validation/cross/causes.hpp"

#include <fmt/format.h>

#include <algorithm>

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

bool contains(const std::vector<std::string>& list, const std::string& word) {
    return std::ranges::find(list, word) != list.end();
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
        Red red{texts_of(table, "scenes"),    text_of(table, "solid"),       text_of(table, "fluid"),
                text_of(table, "cause"),      texts_of(table, "variations"), is_set(table, "energy"),
                is_set(table, "may_be_right")};
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
    const auto fits = [](const std::string& asked, const std::string& given) {
        return asked.empty() || asked == given;
    };
    const bool is_variation = red.variations.empty() || contains(red.variations, cell.variation);
    return contains(red.scenes, cell.scene) && fits(red.solid, cell.solid) && fits(red.fluid, cell.fluid) &&
           is_variation && red.is_energy == cell.is_energy;
}

void Causes::note(Cell& cell) const {
    const auto red = std::ranges::find_if(reds_, [&](const Red& one) { return is_about(one, cell); });
    if (red == reds_.end()) {
        return;
    }
    if (cell.finding == "wrong") {
        cell.cause = red->cause;
    }
    cell.is_stale = cell.finding == "right" && !red->may_be_right;
}

}  // namespace riprap::validation::cross
