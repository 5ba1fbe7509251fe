// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "riprap/view/page_content.hpp"

namespace riprap::view {

/// The bytes of a page, at most, unless told otherwise.
inline constexpr std::size_t default_budget = 60'000'000;

/// Tells whether the program carries a page: it does where it was built with Node.js and the packages of page/.
bool has_page();

/// The page of one run: everything in one text. @throws FileError when the program carries no page
std::string page_of(const PageContent& content);

/// Most runs that one page shows side by side.
inline constexpr std::size_t most_compared = 9;

/// The page of several runs side by side under one clock; `names` are their headings. @throws FileError
std::string page_of(const std::vector<PageContent>& contents, const std::vector<std::string>& names);

/// The page of a study or an ensemble, by the text of its sweep.json or ensemble.json with curves. @throws FileError
std::string page_of_study(const std::string& json);

}  // namespace riprap::view
