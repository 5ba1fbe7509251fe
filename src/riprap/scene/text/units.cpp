// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/text/units.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>

namespace riprap::scene {

namespace {

struct NamedUnit {
    std::string_view name;
    Unit unit;
};

constexpr double pi = std::numbers::pi;

// The kilogram, not the gram, is the base: decimal counts from SI base units.
constexpr std::array named_units{
    NamedUnit{"um", {dimension::length, -6, 1}},
    NamedUnit{"mm", {dimension::length, -3, 1}},
    NamedUnit{"cm", {dimension::length, -2, 1}},
    NamedUnit{"m", {dimension::length, 0, 1}},
    NamedUnit{"km", {dimension::length, 3, 1}},
    NamedUnit{"mg", {{0, 1, 0, 0}, -6, 1}},
    NamedUnit{"g", {{0, 1, 0, 0}, -3, 1}},
    NamedUnit{"kg", {{0, 1, 0, 0}, 0, 1}},
    NamedUnit{"t", {{0, 1, 0, 0}, 3, 1}},
    NamedUnit{"us", {dimension::time, -6, 1}},
    NamedUnit{"ms", {dimension::time, -3, 1}},
    NamedUnit{"s", {dimension::time, 0, 1}},
    NamedUnit{"min", {dimension::time, 0, 60}},
    NamedUnit{"h", {dimension::time, 0, 3600}},
    NamedUnit{"Hz", {dimension::frequency, 0, 1}},
    NamedUnit{"rad", {dimension::angle, 0, 1}},
    NamedUnit{"mrad", {dimension::angle, -3, 1}},
    NamedUnit{"deg", {dimension::angle, 0, pi / 180}},
    NamedUnit{"rev", {dimension::angle, 0, 2 * pi}},
    NamedUnit{"rpm", {dimension::angular_velocity, 0, 2 * pi / 60}},
    NamedUnit{"N", {dimension::force, 0, 1}},
    NamedUnit{"kN", {dimension::force, 3, 1}},
    NamedUnit{"MN", {dimension::force, 6, 1}},
    NamedUnit{"Pa", {dimension::pressure, 0, 1}},
    NamedUnit{"kPa", {dimension::pressure, 3, 1}},
    NamedUnit{"MPa", {dimension::pressure, 6, 1}},
    NamedUnit{"GPa", {dimension::pressure, 9, 1}},
    NamedUnit{"J", {{2, 1, -2, 0}, 0, 1}},
    NamedUnit{"kJ", {{2, 1, -2, 0}, 3, 1}},
    NamedUnit{"W", {{2, 1, -3, 0}, 0, 1}},
};

const NamedUnit* find_unit(std::string_view name) {
    for (const NamedUnit& named : named_units) {
        if (named.name == name) {
            return &named;
        }
    }
    return nullptr;
}

struct NamedDimension {
    Dimension dimension;
    std::string_view words, unit;
};
constexpr std::array named_dimensions{
    NamedDimension{dimension::plain, "a plain number", "-"},
    NamedDimension{dimension::length, "a length", "m"},
    NamedDimension{dimension::area, "an area", "m^2"},
    NamedDimension{{0, 1, 0, 0}, "a mass", "kg"},
    NamedDimension{dimension::time, "a time", "s"},
    NamedDimension{dimension::frequency, "a rate", "1/s"},
    NamedDimension{dimension::angle, "an angle", "rad"},
    NamedDimension{dimension::velocity, "a velocity", "m/s"},
    NamedDimension{dimension::kinematic_viscosity, "a kinematic viscosity", "m^2/s"},
    NamedDimension{dimension::acceleration, "an acceleration", "m/s^2"},
    NamedDimension{dimension::angular_velocity, "an angular velocity", "rad/s"},
    NamedDimension{dimension::density, "a density", "kg/m^3"},
    NamedDimension{dimension::force, "a force", "N"},
    NamedDimension{dimension::pressure, "a pressure", "Pa"},
    NamedDimension{dimension::stiffness, "a stiffness", "N/m"},
    NamedDimension{{2, 1, -2, 0}, "an energy", "J"},
    NamedDimension{{-2, 1, -2, 0}, "a stiffness per area", "Pa/m"},
};

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// Reads one factor of a unit expression, a name with an optional power, from the front of `text`.
std::optional<Unit> take_factor(std::string_view& text) {
    std::size_t length = 0;
    while (length < text.size() && is_letter(text[length])) {
        ++length;
    }
    const NamedUnit* named = find_unit(text.substr(0, length));
    if (named == nullptr) {
        return std::nullopt;
    }
    text.remove_prefix(length);
    int power = 1;
    if (!text.empty() && text.front() == '^') {
        text.remove_prefix(1);
        const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), power);
        if (code != std::errc{} || power < -9 || power > 9 || power == 0) {
            return std::nullopt;
        }
        text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    }
    const Dimension& d = named->unit.dimension;
    return Unit{{d.length * power, d.mass * power, d.time * power, d.angle * power},
                named->unit.decimal * power,
                std::pow(named->unit.factor, power)};
}

void multiply(Unit& unit, const Unit& by, int sign) {
    unit.dimension.length += sign * by.dimension.length;
    unit.dimension.mass += sign * by.dimension.mass;
    unit.dimension.time += sign * by.dimension.time;
    unit.dimension.angle += sign * by.dimension.angle;
    unit.decimal += sign * by.decimal;
    unit.factor = sign > 0 ? unit.factor * by.factor : unit.factor / by.factor;
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && text.front() == ' ') {
        text.remove_prefix(1);
    }
    while (!text.empty() && text.back() == ' ') {
        text.remove_suffix(1);
    }
    return text;
}

/// "t/m3" as "t/m^3".
std::string with_carets(std::string_view text) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool is_power = i > 0 && is_letter(text[i - 1]) && (text[i] == '-' || (text[i] >= '0' && text[i] <= '9'));
        result += is_power ? fmt::format("^{}", text[i]) : std::string(1, text[i]);
    }
    return result;
}

/// The decimal text `digits` times 10^shift, correctly rounded.
double shifted(std::string_view digits, int shift) {
    const std::size_t e = digits.find_first_of("eE");
    int exponent = 0;
    if (e != std::string_view::npos) {
        std::string_view tail = digits.substr(e + 1);
        if (!tail.empty() && tail.front() == '+') {
            tail.remove_prefix(1);
        }
        std::from_chars(tail.data(), tail.data() + tail.size(), exponent);
    }
    const std::string text = fmt::format("{}e{}", digits.substr(0, e), exponent + shift);
    double value = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (code == std::errc::result_out_of_range) {
        return exponent + shift > 0 ? std::numeric_limits<double>::infinity() : 0.0;
    }
    return value;
}

}  // namespace

std::string si_unit(const Dimension& d) {
    for (const NamedDimension& named : named_dimensions) {
        if (named.dimension == d) {
            return std::string(named.unit);
        }
    }
    std::string text;
    const auto add = [&text](std::string_view name, int power) {
        if (power != 0) {
            text += fmt::format("{}{}", text.empty() ? "" : " ", name);
            text += power == 1 ? "" : fmt::format("^{}", power);
        }
    };
    add("kg", d.mass);
    add("m", d.length);
    add("s", d.time);
    add("rad", d.angle);
    return text;
}

std::string describe(const Dimension& d) {
    for (const NamedDimension& named : named_dimensions) {
        if (named.dimension == d) {
            return std::string(named.words);
        }
    }
    return "a quantity in " + si_unit(d);
}

std::optional<Unit> parse_unit(std::string_view text) {
    text = trimmed(text);
    Unit unit;
    if (text.empty()) {
        return std::nullopt;
    }
    if (text.size() > 1 && text.front() == '1') {  // "1/s"
        text = trimmed(text.substr(1));
        if (text.front() != '/') {
            return std::nullopt;
        }
    }
    int sign = 1;
    bool is_first = true;
    while (!text.empty()) {
        if (text.front() == '/' || text.front() == '*') {
            if (is_first && text.front() == '*') {
                return std::nullopt;
            }
            sign = text.front() == '/' ? -1 : 1;
            text = trimmed(text.substr(1));
        } else {
            sign = 1;  // a blank multiplies: "kg m^-3"
        }
        const auto factor = take_factor(text);
        if (!factor) {
            return std::nullopt;
        }
        multiply(unit, *factor, sign);
        is_first = false;
        const bool has_blank = !text.empty() && text.front() == ' ';
        text = trimmed(text);
        if (!text.empty() && !has_blank && text.front() != '/' && text.front() != '*') {
            return std::nullopt;  // "m2": a power wants '^'
        }
    }
    return unit;
}

double to_si(double value, const Unit& unit) {
    if (!std::isfinite(value)) {
        return value;
    }
    const double decimal = unit.decimal == 0 ? value : shifted(fmt::format("{}", value), unit.decimal);
    return decimal * unit.factor;
}

Quantity parse_quantity(std::string_view text, const Dimension& expected) {
    text = trimmed(text);
    std::string_view digits = text;
    if (!digits.empty() && digits.front() == '+') {
        digits.remove_prefix(1);
    }
    double value = 0;
    const auto [end, code] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (code == std::errc::result_out_of_range) {
        return {0, "the number is out of range"};
    }
    if (code != std::errc{} || !std::isfinite(value)) {
        return {0, "it does not start with a number"};
    }
    const auto length = static_cast<std::size_t>(end - digits.data());
    const std::string_view unit_text = trimmed(digits.substr(length));
    if (unit_text.empty()) {
        return {value, ""};
    }
    if (unit_text == "%" && expected.is_plain()) {
        return {shifted(digits.substr(0, length), -2), ""};
    }
    const auto unit = parse_unit(unit_text);
    if (!unit) {
        const std::string meant = with_carets(unit_text);
        return {0, fmt::format("'{}' is not a unit Riprap knows{}", unit_text,
                               parse_unit(meant) ? fmt::format("; did you mean '{}'?", meant) : "")};
    }
    if (unit->dimension != expected) {
        return {0, fmt::format("'{}' is {}, not {}", unit_text, describe(unit->dimension), describe(expected))};
    }
    value = shifted(digits.substr(0, length), unit->decimal) * unit->factor;
    if (!std::isfinite(value)) {
        return {0, "the number is out of range"};
    }
    return {value, ""};
}

std::optional<SuffixedKey> split_unit_suffix(std::string_view key) {
    const std::size_t underscore = key.rfind('_');
    if (underscore == std::string_view::npos || underscore == 0) {
        return std::nullopt;
    }
    const NamedUnit* named = find_unit(key.substr(underscore + 1));
    if (named == nullptr) {
        return std::nullopt;
    }
    return SuffixedKey{key.substr(0, underscore), named->unit};
}

std::string suffixes_for(const Dimension& d) {
    std::string text;
    for (const NamedUnit& named : named_units) {
        if (named.unit.dimension == d) {
            text += text.empty() ? "" : "|";
            text += named.name;
        }
    }
    return text;
}

}  // namespace riprap::scene
