// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "riprap/geometry/text/text_reader.hpp"

namespace riprap::geometry {

/// An element of a marked-up text: <name key="value"> text </name>. Prefixes of names ("Berkeley:") are left out.
struct MarkupElement {
    std::string_view name;
    std::vector<std::pair<std::string_view, Word>> attributes;
    std::vector<Word> words;         ///< of its text, without that of elements inside
    std::vector<std::size_t> marks;  ///< words before each ';' of its text
    std::vector<std::size_t> children;
    std::uint32_t line{0}, column{0};

    /// The value of an attribute, or nothing.
    const Word* attribute(std::string_view key) const;
};

/// Elements in the order in which they begin; the first one is the whole text. The text must outlive them. Comments,
/// declarations and entities are skipped. Tags that do not match are reported.
std::vector<MarkupElement> read_markup(std::string_view text, const std::string& file, ProblemList& problems);

}  // namespace riprap::geometry
