// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace riprap::geometry {

/// A text without the byte order mark of UTF-8 at its begin.
std::string_view without_byte_order_mark(std::string_view text);

/// True for a text whose lines end in carriage returns alone.
bool has_bare_returns(std::string_view text);

/// A text with carriage returns alone as line feeds.
std::string line_feeds_in(std::string_view text);

}  // namespace riprap::geometry
