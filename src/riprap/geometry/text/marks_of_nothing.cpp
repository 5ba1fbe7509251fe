// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/text/marks_of_nothing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace riprap::geometry {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

template <std::size_t N>
bool is_one_of(double value, const std::array<double, N>& marks) {
    return std::any_of(marks.begin(), marks.end(), [value](double mark) {
        const double size = std::abs(mark) > 1e6 ? std::copysign(value, mark) : value;  // these come with either sign
        return std::abs(size - mark) <= 1e-5 * std::abs(mark);
    });
}

/// Numbers that no height is by chance. -999.25 is that of well logs.
bool is_customary(double value) {
    constexpr std::array<double, 25> marks{
        -999,  -9999,  -99999, -999999, 999,   9999,  99999, 999999, -999.9, -9999.9, -999.99,    -9999.99,    -999.25,
        -8888, -88888, -32767, -32768,  32767, 65535, 1e10,  1e20,   1e30,   1e38,    1.70141e38, 3.4028235e38};
    return is_one_of(value, marks) || std::abs(value) > 1e9;
}

/// Numbers that are heights too.
bool is_doubtful(double value) {
    constexpr std::array<double, 3> marks{0, -1, -99};
    return is_one_of(value, marks);
}

/// The lowest or the highest height, and how it lies among the others.
struct Extreme {
    double value{0};
    double gap{0};                ///< from the nearest other height [m]
    double reach{0};              ///< of the others [m]
    double least_step{infinity};  ///< from a point of this height to a neighbour of another [m]
    double other_step{0};         ///< largest between neighbours of other heights [m]
    std::size_t count{0}, all{0};
    bool is_low{true};
    bool stands_alone{true};  ///< no two neighbours have it

    bool stands_out(double times) const { return least_step > times * other_step; }
};

/// Measures the lowest or highest height; nothing where all are equal.
std::optional<Extreme> extreme_of(std::span<const double> heights, std::size_t columns, bool is_low) {
    const double sign = is_low ? 1 : -1;
    double least = infinity, second = infinity, most = -infinity;
    for (const double z : heights) {  // comparisons are false for NaN
        least = sign * z < least ? sign * z : least;
        most = sign * z > most ? sign * z : most;
    }
    for (const double z : heights) {
        second = sign * z > least && sign * z < second ? sign * z : second;
    }
    if (!(second < infinity)) {
        return std::nullopt;
    }
    Extreme found{.value = sign * least, .gap = second - least, .reach = most - second, .is_low = is_low};
    const auto look_at = [&found](double a, double b) {
        if (std::isfinite(a) && std::isfinite(b) && (a == found.value) != (b == found.value)) {
            found.least_step = std::min(found.least_step, std::abs(a - b));
        } else if (std::isfinite(a) && std::isfinite(b)) {
            found.other_step = std::max(found.other_step, std::abs(a - b));
            found.stands_alone = found.stands_alone && a != found.value;
        }
    };
    for (std::size_t n = 0; n < heights.size(); ++n) {
        found.all += std::isfinite(heights[n]) ? 1 : 0;
        found.count += heights[n] == found.value ? 1 : 0;
        if ((n + 1) % columns != 0 && n + 1 < heights.size()) {
            look_at(heights[n], heights[n + 1]);
        }
        if (n + columns < heights.size()) {
            look_at(heights[n], heights[n + columns]);
        }
    }
    return found;
}

bool is_mark(const Extreme& z, double spacing, double scale) {
    constexpr double clear = 2, doubtful = 3, any = 10;  // times the largest step of the others
    constexpr std::size_t share = 4;                     // a bed at 0 under a quay takes more of the points
    const double number = z.value / scale;
    if (is_customary(number)) {
        return z.gap > std::max(z.reach, spacing) || (z.gap > spacing && z.stands_out(clear));
    }
    if (is_doubtful(number) && z.reach > 0 && z.gap > 3 * spacing && z.stands_out(doubtful) &&
        share * z.count < z.all) {
        return true;
    }
    if (z.stands_alone && z.gap > any * spacing && z.stands_out(any) && share * z.count < z.all) {
        return true;  // no ground has pits or needles of one point
    }
    return z.gap > std::max(10 * z.reach, 1000 * spacing);
}

}  // namespace

std::optional<MarkOfNothing> find_mark_of_nothing(std::span<const double> heights, std::int64_t columns, double spacing,
                                                  double scale) {
    std::optional<Extreme> found;
    for (const bool is_low : {true, false}) {
        const auto one = extreme_of(heights, static_cast<std::size_t>(columns), is_low);
        if (!one || !is_mark(*one, spacing, scale)) {
            continue;
        }
        // Of two heights each may be the mark of the other: the customary one is, else the rarer.
        const bool is_better = found && (is_customary(one->value / scale) != is_customary(found->value / scale)
                                             ? is_customary(one->value / scale)
                                             : one->count < found->count);
        found = !found || is_better ? one : found;
    }
    if (!found) {
        return std::nullopt;
    }
    const auto first = std::find(heights.begin(), heights.end(), found->value);
    return MarkOfNothing{static_cast<std::size_t>(first - heights.begin()),
                         fmt::format("a height of {:.9g} m, {:.6g} m {} all others: a mark for no height?",
                                     found->value, found->gap, found->is_low ? "below" : "above")};
}

}  // namespace riprap::geometry
