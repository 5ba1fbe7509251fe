// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace riprap {

/// A text that a terminal shows and does not obey: control characters but line feed and tab as \x1b, in UTF-8 too.
std::string printable(std::string_view text);

}  // namespace riprap
