// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace riprap::geometry {

/// A height that stands for "no height" in the program that wrote it.
struct MarkOfNothing {
    std::size_t index{0};  ///< of the first such height
    std::string message;   ///< what is odd about it
};

/// Looks for such a mark among heights: the lowest or the highest value, where it is one of the customary numbers
/// (-9999, -32768, 1e30, ...) and farther from all other heights than these reach and than points are apart, or any
/// number ten times as far and steeper than 1000 to 1.
/// @param spacing  of the points [m]
/// @param scale    metres per unit of the file: marks are numbers of the file [m]
std::optional<MarkOfNothing> find_mark_of_nothing(std::span<const double> heights, double spacing, double scale);

}  // namespace riprap::geometry
