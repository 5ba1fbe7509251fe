// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace riprap::scene {

/// Least number of insertions, deletions, replacements and swaps of neighbours that turn one word into the other
/// (optimal string alignment). Texts longer than 64 characters are cut.
int edit_distance(std::string_view a, std::string_view b);

/// The word of `known` nearest to `word`, or empty when none is near enough to be meant: at most a third of the
/// letters wrong, or one contains the other.
std::string nearest(std::string_view word, const std::vector<std::string>& known);

}  // namespace riprap::scene
