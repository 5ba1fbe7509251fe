// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "riprap/scene/text/value.hpp"

namespace riprap::scene {

/// Splits "path.to.key" at its points.
std::vector<std::string> split_path(std::string_view path);

/// A key without the unit at its end: "end" for "end_ms" and for "end".
std::string_view base_of_key(std::string_view key);

/// Tells whether one key of a table takes the place of the other: a value has one key, whatever its unit.
bool gives_the_same(std::string_view key, std::string_view other);

/// Number of the entry of a list that steps of a path from `first` on mean, by that number or by its name: names may
/// hold points, the longest that fits counts. `first` becomes the last step that it takes; nothing where the list has
/// no such entry.
std::optional<std::size_t> find_entry(const Value& list, const std::vector<std::string>& steps, std::size_t& first);

/// The one spelling of a path among those of the same value in `root`: entries of lists by their numbers, the last key
/// without its unit.
std::string plain_path(const Value& root, std::string_view path);

}  // namespace riprap::scene
