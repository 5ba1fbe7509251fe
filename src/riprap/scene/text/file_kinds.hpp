// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace riprap::scene {

/// Says what a file is, where it is none of those that Riprap reads, and what to give instead.
struct OtherKind {
    std::string what;  ///< "is compressed (gzip)"
    std::string allowed;
};

/// Knows files by their first bytes that no reader takes and people give: archives, workbooks, images, text in UTF-16.
/// Nothing for all others, a binary STL among them whatever its first 80 bytes say.
std::optional<OtherKind> other_kind(std::string_view bytes);

}  // namespace riprap::scene
