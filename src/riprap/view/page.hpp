// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "riprap/view/page_content.hpp"

namespace riprap::view {

/// The bytes of a page, at most, unless told otherwise.
inline constexpr std::size_t default_budget = 60'000'000;

/// The page of one run: everything in one text. @throws FileError when the program carries no page
std::string page_of(const PageContent& content);

/// Most runs that one page shows side by side.
inline constexpr std::size_t most_compared = 9;

/// The page of several runs side by side under one clock; `names` are their headings. @throws FileError
std::string page_of(const std::vector<PageContent>& contents, const std::vector<std::string>& names);

}  // namespace riprap::view
