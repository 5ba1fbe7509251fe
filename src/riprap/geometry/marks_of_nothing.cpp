// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/marks_of_nothing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace riprap::geometry {

namespace {

bool is_customary(double value) {
    constexpr std::array<double, 16> marks{-999,   -9999,  -99999, -999999, 999,  9999,         99999,      999999,
                                           -32767, -32768, 32767,  65535,   1e20, 3.4028235e38, 1.70141e38, 1e30};
    return std::any_of(marks.begin(), marks.end(), [value](double mark) {
        const double size = mark > 1e6 ? std::abs(value) : value;  // the large ones come with either sign
        return std::abs(size - mark) <= 1e-5 * std::abs(mark);
    });
}

}  // namespace

std::optional<MarkOfNothing> find_mark_of_nothing(std::span<const double> heights, double spacing, double scale) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double low = infinity, high = -infinity;
    for (const double z : heights) {
        low = z < low ? z : low;  // false for NaN
        high = z > high ? z : high;
    }
    double second = infinity, last_but_one = -infinity;
    for (const double z : heights) {
        second = z > low && z < second ? z : second;
        last_but_one = z < high && z > last_but_one ? z : last_but_one;
    }
    if (!(second < infinity)) {
        return std::nullopt;  // all heights are equal
    }
    for (const bool is_low : {true, false}) {
        const double mark = is_low ? low : high;
        const double gap = is_low ? second - low : high - last_but_one;
        const double reach = is_low ? high - second : last_but_one - low;
        const bool is_known = is_customary(mark / scale) && gap > std::max(reach, spacing);
        if (is_known || gap > std::max(10 * reach, 1000 * spacing)) {
            const auto first = std::find(heights.begin(), heights.end(), mark);
            return MarkOfNothing{static_cast<std::size_t>(first - heights.begin()),
                                 fmt::format("a height of {:.9g} m, {:.6g} m {} all others: a mark for no height?",
                                             mark, gap, is_low ? "below" : "above")};
        }
    }
    return std::nullopt;
}

}  // namespace riprap::geometry
