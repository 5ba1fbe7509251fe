// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "riprap/geometry/dda_files/dda_text.hpp"

namespace riprap::geometry::dda_text {

/// Refuses an element that is not among those `known` where it holds numbers or its name is nearly one of theirs: what
/// a misspelt element says would be missing from the blocks. Notes it otherwise, such as a title.
void take_unread(const std::vector<MarkupElement>& elements, const MarkupElement& element,
                 const std::vector<std::string_view>& known, Numbers& numbers, std::vector<std::string>& notes);

/// Refuses an element whose attribute named num... (numpoints, numjoints) promises another number of `entries` than
/// there are: the file was cut, or changed by hand.
void compare_counts(const MarkupElement& element, std::int64_t count, std::string_view entries, Numbers& numbers);

}  // namespace riprap::geometry::dda_text
