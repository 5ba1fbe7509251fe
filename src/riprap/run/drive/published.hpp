// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "riprap/run/drive/find_case.hpp"

namespace riprap::run {

/// A published experiment or exact answer that comes with Riprap as a case file.
struct PublishedCase : KnownCase {
    std::vector<std::string> citations;  ///< of its expected answers, each once
};

/// Cases below `validation/` that name a source or cite one in an answer, sorted by name.
std::vector<PublishedCase> published_cases();

/// Tells whether a source such as "Ding (2021), section 7.2.3, figures 7.7 to 7.9" names a number of a kind: figure
/// 7.8, section 7.2.3, and section 7.2, which holds it. An empty kind stands for all of them.
/// @param kind    "section", "figure", "table", ..., a plural or the first three letters
/// @param number  "7.8", "B1"
bool names_number(std::string_view source, std::string_view kind, std::string_view number);

/// Tells whether all words are about a case: a number after the word "figure", "table", "section", ... is one that its
/// source names; other words stand in its name, title, source or citations, in small or capital letters. Where the
/// source names several publications, divided by ";", all words are about one of them.
bool is_about(const PublishedCase& published, const std::vector<std::string>& words);

}  // namespace riprap::run
