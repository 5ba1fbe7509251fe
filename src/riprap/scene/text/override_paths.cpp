// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/text/override_paths.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "riprap/scene/text/units.hpp"

namespace riprap::scene {

std::vector<std::string> split_path(std::string_view path) {
    std::vector<std::string> steps;
    std::size_t begin = 0;
    while (begin <= path.size()) {
        const std::size_t dot = std::min(path.find('.', begin), path.size());
        steps.emplace_back(path.substr(begin, dot - begin));
        begin = dot + 1;
    }
    return steps;
}

std::string_view base_of_key(std::string_view key) {
    const auto suffixed = split_unit_suffix(key);
    return suffixed ? suffixed->base : key;
}

bool gives_the_same(std::string_view key, std::string_view other) {
    return key == other || base_of_key(other) == key || other == base_of_key(key) ||
           (base_of_key(key) != key && base_of_key(other) == base_of_key(key));
}

std::optional<std::size_t> find_entry(const Value& list, const std::vector<std::string>& steps, std::size_t& first) {
    const std::string& step = steps[first];
    std::size_t index = 0;
    const auto [end, code] = std::from_chars(step.data(), step.data() + step.size(), index);
    if (code == std::errc{} && end == step.data() + step.size()) {
        return index < list.items.size() ? std::optional(index) : std::nullopt;
    }
    for (std::size_t last = steps.size(); last-- > first;) {
        const std::string called =
            fmt::format("{}", fmt::join(steps.begin() + static_cast<std::ptrdiff_t>(first),
                                        steps.begin() + static_cast<std::ptrdiff_t>(last) + 1, "."));
        for (std::size_t i = 0; i < list.items.size(); ++i) {
            if (const Value* name = list.items[i].find("name"); name != nullptr && name->text == called) {
                first = last;
                return i;
            }
        }
    }
    return std::nullopt;
}

std::string plain_path(const Value& root, std::string_view path) {
    const std::vector<std::string> steps = split_path(path);
    std::string plain;
    const Value* here = &root;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        std::string step = i + 1 == steps.size() ? std::string(base_of_key(steps[i])) : steps[i];
        if (here != nullptr && here->is_array()) {
            const std::optional<std::size_t> entry = find_entry(*here, steps, i);
            step = entry ? std::to_string(*entry) : steps[i];
            here = entry ? &here->items[*entry] : nullptr;
        } else if (here != nullptr) {
            here = here->is_table() ? here->find(steps[i]) : nullptr;
        }
        plain += (plain.empty() ? "" : ".") + step;
    }
    return plain;
}

}  // namespace riprap::scene
