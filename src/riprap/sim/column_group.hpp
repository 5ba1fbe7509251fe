// SPDX-License-Identifier: Apache-2.0
#pragma once

// Several numbers of a run taken together, as expected answers ask for them: of all bodies of one entry of a case, or
// of all gauges of a profile.

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "riprap/sim/quantity.hpp"

namespace riprap::sim {

/// Words in brackets behind a name, and how the numbers of all are taken together. "above" is followed by a level:
/// how many of them are above it. "front" is followed by a number and a width: the first value, from the
/// median on, above which the next width holds fewer of them, how far a heap reaches without what rolled off it.
inline constexpr std::array<std::string_view, 6> group_words{"mean", "sum", "min", "max", "above", "front"};

/// Columns of one quantity and the number that they make together.
struct ColumnGroup {
    std::string_view word;  ///< of group_words; empty: the one column itself
    std::vector<Column> columns;
    double level{0};  ///< of "above" [unit of the quantity]; number of "front" [-]
    double width{0};  ///< of "front" [unit of the quantity]
};

/// Finds what an expected answer names: one column as find_column does, or "NAME[mean].position.x" of all bodies called
/// NAME[0], NAME[1], ..., "NAME,OTHER[mean].position.x" of those of several entries, or "NAME[mean]" and "NAME[mean].x"
/// of the gauges NAME_1, NAME_2, ... of a profile; "NAME[above 0.3].displacement.y" is the number of bodies above,
/// "NAME[front 6 0.01].position.x" how far six on a centimetre reach.
std::optional<ColumnGroup> find_columns(const Model& model, std::string_view text);

/// Returns mean, sum, least, largest or front of the columns [their unit], or how many are above; NaN where one of them
/// has no value.
double evaluate(const ColumnGroup& group, const Moment& moment);

/// Gauges along a line.
struct Profile {
    std::vector<Column> columns;
    std::vector<double> place;  ///< of each gauge, from the first [m]
};

/// Finds the gauges NAME_1, NAME_2, ... of a profile by "NAME", or "NAME.x" where they read vectors; nothing where
/// there are less than two.
std::optional<Profile> find_profile(const Model& model, std::string_view text);

/// Returns the value of a profile between its gauges, by the straight line, at the moment; NaN beyond its ends.
double evaluate(const Profile& profile, double place, const Moment& moment);

}  // namespace riprap::sim
