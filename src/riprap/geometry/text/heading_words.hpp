// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace riprap::geometry {

/// ASCII letters in lower case.
std::string lower_case(std::string_view text);

/// Words of a heading: runs of letters, digits and bytes beyond ASCII, in lower case.
std::vector<std::string> words_of(std::string_view text);

/// True for a word that names a quantity which no table holds in the place of a coordinate, time, force or frequency:
/// velocity, depth, diameter, period, step, ...
bool is_other_quantity(std::string_view word);

/// True for a word by which a title says that rows are of another quantity: velocity, acceleration, pressure, ...
bool is_quantity_of_title(std::string_view word);

/// True for text in brackets that says something else than a unit: "-", a number, a direction ("east", "up"), a datum.
bool is_no_unit(std::string_view text);

/// Texts of a title that may be units: those in brackets, and the word after "in", "unit" or "units".
std::vector<std::string_view> units_in_words(std::string_view title);

}  // namespace riprap::geometry
