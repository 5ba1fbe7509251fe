// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <string>
#include <string_view>

namespace riprap {

/// Tells what a word says, for its colour on a terminal: green, red or yellow.
enum class Tint { good, bad, caution };

/// Whether text written to `out` may carry colours: `out` is a terminal, TERM is not "dumb", and NO_COLOR is unset or
/// empty (https://no-color.org). Files, pipes and logs then hold plain text.
bool shows_colours(std::FILE* out);

/// `text` in the colour of `tint` if `is_coloured`, else as it is. Apply it after printable(), which shows escapes.
std::string tinted(std::string_view text, Tint tint, bool is_coloured);

}  // namespace riprap
