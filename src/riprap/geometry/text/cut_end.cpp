// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/text/cut_end.hpp"

#include <algorithm>

namespace riprap::geometry {

namespace {

/// Digits, and what stands behind them ("e-03"), after the decimal mark.
std::size_t digits_of(std::string_view number) {
    const std::size_t mark = number.find_first_of(".,");
    return mark == std::string_view::npos ? 0 : number.size() - mark - 1;
}

}  // namespace

void CutEnd::add(std::string_view number) {
    if (rows_ == 1) {
        digits_ = last_;
    }
    are_alike_ = are_alike_ && (rows_ <= 1 || last_ == digits_);
    last_ = digits_of(number);
    ++rows_;
}

bool CutEnd::is_cut(std::string_view text) const {
    constexpr std::size_t enough = 3;
    const bool ends_a_line = text.ends_with('\n') || text.ends_with('\r');
    return !ends_a_line && rows_ > enough && are_alike_ && last_ < digits_;
}

}  // namespace riprap::geometry
