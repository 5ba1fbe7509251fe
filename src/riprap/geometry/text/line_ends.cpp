// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/text/line_ends.hpp"

#include <algorithm>

namespace riprap::geometry {

std::string_view without_byte_order_mark(std::string_view text) {
    text.remove_prefix(text.starts_with("\xEF\xBB\xBF") ? 3 : 0);
    return text;
}

bool has_bare_returns(std::string_view text) {
    return text.find('\n') == std::string_view::npos && text.find('\r') != std::string_view::npos;
}

std::string line_feeds_in(std::string_view text) {
    std::string result(text);
    std::replace(result.begin(), result.end(), '\r', '\n');
    return result;
}

}  // namespace riprap::geometry
