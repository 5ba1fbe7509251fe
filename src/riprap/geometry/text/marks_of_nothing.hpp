// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace riprap::geometry {

/// A height that stands for "no height" in the program that wrote it.
struct MarkOfNothing {
    std::size_t index{0};  ///< of the first such height
    std::string message;   ///< what is odd about it
};

/// Looks for such a mark among the heights of a grid: the lowest or the highest value, where it is
/// - a customary mark (-9999, -32768, 1e30, ...) farther from all other heights than these reach and than points are
///   apart, or one that stands out: all steps from it to its neighbours are twice the largest step between others;
/// - 0, -1 or -99 at less than a quarter of the points, which stands out three times as far, and steeper than 3 to 1:
///   a shore or a sea of height 0 is read;
/// - any number at points of which no two are neighbours, less than a quarter of all, which stands out ten times as
/// far,
///   and steeper than 10 to 1: no ground has pits or needles of one point;
/// - any number ten times as far from the others as these reach and steeper than 1000 to 1.
/// @param heights  row after row of `columns` points; NaN where there is none [m]
/// @param spacing  of the points [m]
/// @param scale    metres per unit of the file: marks are numbers of the file [m]
std::optional<MarkOfNothing> find_mark_of_nothing(std::span<const double> heights, std::int64_t columns, double spacing,
                                                  double scale);

}  // namespace riprap::geometry
