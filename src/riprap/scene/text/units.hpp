// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "riprap/core/dimension.hpp"

namespace riprap::scene {

/// "m/s^2", "Pa", "-" for a plain number: the SI unit in which bare numbers are read.
std::string si_unit(const Dimension& dimension);

/// "a length", "a pressure", "a plain number": for messages.
std::string describe(const Dimension& dimension);

/// A unit such as "kN/m" as a factor to SI: 10^decimal * factor. The decimal part is kept apart so that "0.7 mm" has
/// exactly the bits of 0.7e-3.
struct Unit {
    Dimension dimension;
    int decimal{0};
    double factor{1};
};

/// Parses products, quotients and integer powers of named units: "kN/m", "kg m^-3", "m/s^2", "1/s".
/// Empty when a name is unknown or the text is malformed.
std::optional<Unit> parse_unit(std::string_view text);

/// value * unit in SI; exact (correctly rounded) when the unit is a power of ten of SI.
double to_si(double value, const Unit& unit);

/// Result of reading a text as a quantity: a value, or a message saying what is wrong.
struct Quantity {
    double value{0};
    std::string problem;  ///< empty when `value` is good
};

/// Reads "2.5 cm", "26 deg", "0.4 MPa", "9.81 m/s^2", "30 t"; a bare number is SI.
Quantity parse_quantity(std::string_view text, const Dimension& expected);

/// If `key` ends in a unit ("friction_angle_deg", "spacing_mm"): the base name and the unit.
struct SuffixedKey {
    std::string_view base;
    Unit unit;
};
std::optional<SuffixedKey> split_unit_suffix(std::string_view key);

/// Names of the units that may end a key and have this dimension, e.g. {"mm", "cm", "m", "km"}, separated by '|'.
std::string suffixes_for(const Dimension& dimension);

}  // namespace riprap::scene
