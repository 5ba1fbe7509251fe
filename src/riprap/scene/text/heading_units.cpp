// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/text/heading_units.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

namespace riprap::scene {

namespace {

struct Spelling {
    std::string_view spelt, meant;
};

/// Other spellings of units that parse_unit() knows.
constexpr std::array spellings{Spelling{"metre", "m"},         Spelling{"metres", "m"},
                               Spelling{"meter", "m"},         Spelling{"meters", "m"},
                               Spelling{"millimetre", "mm"},   Spelling{"millimetres", "mm"},
                               Spelling{"millimeter", "mm"},   Spelling{"millimeters", "mm"},
                               Spelling{"centimetre", "cm"},   Spelling{"centimetres", "cm"},
                               Spelling{"centimeter", "cm"},   Spelling{"centimeters", "cm"},
                               Spelling{"kilometre", "km"},    Spelling{"kilometres", "km"},
                               Spelling{"kilometer", "km"},    Spelling{"kilometers", "km"},
                               Spelling{"mtr", "m"},           Spelling{"masl", "m"},
                               Spelling{"mnn", "m"},           Spelling{"mnhn", "m"},
                               Spelling{"sec", "s"},           Spelling{"secs", "s"},
                               Spelling{"second", "s"},        Spelling{"seconds", "s"},
                               Spelling{"sekunde", "s"},       Spelling{"sekunden", "s"},
                               Spelling{"msec", "ms"},         Spelling{"millisecond", "ms"},
                               Spelling{"milliseconds", "ms"}, Spelling{"minute", "min"},
                               Spelling{"minutes", "min"},     Spelling{"hr", "h"},
                               Spelling{"hrs", "h"},           Spelling{"hour", "h"},
                               Spelling{"hours", "h"},         Spelling{"hz", "Hz"},
                               Spelling{"hertz", "Hz"},        Spelling{"newton", "N"},
                               Spelling{"newtons", "N"},       Spelling{"kilonewton", "kN"},
                               Spelling{"kilonewtons", "kN"},  Spelling{"kn", "kN"},
                               Spelling{"tonne", "t"},         Spelling{"tonnes", "t"},
                               Spelling{"radians", "rad"},     Spelling{"degrees", "deg"}};

struct Foreign {
    std::string_view name;
    Dimension dimension;
    double factor;  ///< to SI
};

constexpr double foot = 0.3048, pound_force = 4.4482216152605, kilogram_force = 9.80665;

/// Units that a case does not have. Feet, pounds and their multiples are exact by the agreement of 1959.
constexpr std::array foreign_units{Foreign{"ft", dimension::length, foot},
                                   Foreign{"foot", dimension::length, foot},
                                   Foreign{"feet", dimension::length, foot},
                                   Foreign{"'", dimension::length, foot},
                                   Foreign{"ftus", dimension::length, 1200.0 / 3937},
                                   Foreign{"in", dimension::length, foot / 12},
                                   Foreign{"inch", dimension::length, foot / 12},
                                   Foreign{"inches", dimension::length, foot / 12},
                                   Foreign{"\"", dimension::length, foot / 12},
                                   Foreign{"zoll", dimension::length, foot / 12},
                                   Foreign{"yd", dimension::length, 3 * foot},
                                   Foreign{"yard", dimension::length, 3 * foot},
                                   Foreign{"yards", dimension::length, 3 * foot},
                                   Foreign{"fathom", dimension::length, 6 * foot},
                                   Foreign{"fathoms", dimension::length, 6 * foot},
                                   Foreign{"mi", dimension::length, 5280 * foot},
                                   Foreign{"mile", dimension::length, 5280 * foot},
                                   Foreign{"miles", dimension::length, 5280 * foot},
                                   Foreign{"nmi", dimension::length, 1852},
                                   Foreign{"dm", dimension::length, 0.1},
                                   Foreign{"dam", dimension::length, 10},
                                   Foreign{"hm", dimension::length, 100},
                                   Foreign{"d", dimension::time, 86400},
                                   Foreign{"day", dimension::time, 86400},
                                   Foreign{"days", dimension::time, 86400},
                                   Foreign{"lbf", dimension::force, pound_force},
                                   Foreign{"lb", dimension::force, pound_force},
                                   Foreign{"lbs", dimension::force, pound_force},
                                   Foreign{"klbf", dimension::force, 1000 * pound_force},
                                   Foreign{"kip", dimension::force, 1000 * pound_force},
                                   Foreign{"kips", dimension::force, 1000 * pound_force},
                                   Foreign{"tonf", dimension::force, 2000 * pound_force},
                                   Foreign{"kgf", dimension::force, kilogram_force},
                                   Foreign{"kp", dimension::force, kilogram_force},
                                   Foreign{"tf", dimension::force, 1000 * kilogram_force},
                                   Foreign{"dan", dimension::force, 10},
                                   Foreign{"dyn", dimension::force, 1e-5},
                                   Foreign{"gn", dimension::force, 1e9}};

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string lower_case(std::string_view text) {
    std::string result(text);
    std::transform(result.begin(), result.end(), result.begin(),
                   [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
    return result;
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
        text.replace(at, from.size(), to);
    }
}

/// "m2s-1" and "m²·s" as "m^2 s^-1" and "m^2 s", the form that parse_unit() takes; words as their symbols.
std::string in_symbols(std::string_view written) {
    std::string text(written);
    for (const auto& [from, to] : {std::pair{"\xC2\xB2", "^2"},
                                   {"\xC2\xB3", "^3"},
                                   {"\xE2\x81\xBB\xC2\xB9", "^-1"},
                                   {"\xC2\xB7", " "},
                                   {"\xE2\x8B\x85", " "},
                                   {"**", "^"},
                                   {"\xC2\xB5", "u"},
                                   {"\xCE\xBC", "u"}}) {
        replace_all(text, from, to);
    }
    std::string result;
    for (std::size_t i = 0; i < text.size();) {
        if (!is_letter(text[i])) {
            result += text[i++];
            continue;
        }
        std::size_t end = i;
        while (end < text.size() && is_letter(text[end])) {
            ++end;
        }
        const std::string word = text.substr(i, end - i), low = lower_case(word);
        const auto* found =
            std::find_if(spellings.begin(), spellings.end(), [&](const Spelling& one) { return one.spelt == low; });
        result += found == spellings.end() || parse_unit(word) ? word : std::string(found->meant);
        i = end;
        const bool has_sign = i + 1 < text.size() && text[i] == '-' && is_digit(text[i + 1]);
        if (i < text.size() && (is_digit(text[i]) || has_sign)) {
            result += '^';
        }
        if (i < text.size() && (is_digit(text[i]) || has_sign || text[i] == '^')) {
            do {
                result += text[i++];
            } while (i < text.size() && (is_digit(text[i]) || text[i] == '-'));
            result += i < text.size() && is_letter(text[i]) ? " " : "";
        }
    }
    return result;
}

}  // namespace

std::optional<Unit> parse_heading_unit(std::string_view text) {
    const std::string low = lower_case(text);
    if (const auto unit = parse_unit(in_symbols(text))) {
        return unit;
    }
    for (const Foreign& one : foreign_units) {
        if (one.name == low) {
            return Unit{one.dimension, 0, one.factor};
        }
    }
    const bool is_upper = std::none_of(text.begin(), text.end(), [](char c) { return c >= 'a' && c <= 'z'; });
    if (is_upper && (text.size() > 1 || text == "M" || text == "S")) {  // "T" is a period more often than a tonne
        if (const auto unit = parse_unit(in_symbols(low))) {            // "[MM]"
            return unit;
        }
    }
    const std::size_t blank = text.find_first_of(" .");
    const bool has_more = blank != std::string_view::npos && blank > 0 && blank + 1 < text.size();
    return has_more ? parse_heading_unit(text.substr(0, blank)) : std::nullopt;  // "m a.s.l."
}

}  // namespace riprap::scene
