// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/text/heading_words.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include "riprap/geometry/text/text_reader.hpp"

namespace riprap::geometry {

namespace {

bool is_of_a_word(char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte >= 0x80 || std::isalnum(byte) != 0;
}

template <std::size_t N>
bool is_one_of(std::string_view word, const std::array<std::string_view, N>& words) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

/// A part of a title without blanks and marks around it.
std::string_view bare(std::string_view text) {
    constexpr std::string_view marks = " \t,;:=.\"'()[]";
    const std::size_t begin = text.find_first_not_of(marks);
    return begin == std::string_view::npos ? std::string_view{}
                                           : text.substr(begin, text.find_last_not_of(marks) + 1 - begin);
}

}  // namespace

std::string lower_case(std::string_view text) {
    std::string result(text);
    std::transform(result.begin(), result.end(), result.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return result;
}

std::vector<std::string> words_of(std::string_view text) {
    std::vector<std::string> words;
    for (std::size_t begin = 0; begin < text.size();) {
        std::size_t end = begin;
        while (end < text.size() && is_of_a_word(text[end])) {
            ++end;
        }
        if (end > begin) {
            words.push_back(lower_case(text.substr(begin, end - begin)));
        }
        begin = end + 1;
    }
    return words;
}

bool is_other_quantity(std::string_view word) {
    constexpr std::array<std::string_view, 61> words{
        "v",     "dot",      "ddot",        "rate",         "velocity",     "velocities", "vel",        "speed",
        "vx",    "vy",       "vz",          "acceleration", "accel",        "acc",        "ax",         "ay",
        "az",    "omega",    "angular",     "period",       "periods",      "tp",         "wavelength", "step",
        "steps", "cycle",    "sample",      "frame",        "index",        "idx",        "id",         "fid",
        "no",    "nr",       "row",         "diameter",     "diameters",    "diam",       "dia",        "d50",
        "depth", "depths",   "tiefe",       "wavenumber",   "moment",       "moments",    "torque",     "mx",
        "my",    "mz",       "rotation",    "rx",           "ry",           "rz",         "roll",       "pitch",
        "yaw",   "pressure", "durchmesser", "periode",      "kreisfrequenz"};
    return is_one_of(word, words);
}

bool is_quantity_of_title(std::string_view word) {
    constexpr std::array<std::string_view, 21> words{"velocity",
                                                     "velocities",
                                                     "speed",
                                                     "speeds",
                                                     "acceleration",
                                                     "accelerations",
                                                     "accelerogram",
                                                     "geschwindigkeit",
                                                     "geschwindigkeiten",
                                                     "beschleunigung",
                                                     "beschleunigungen",
                                                     "vitesse",
                                                     "vitesses",
                                                     "acc\xC3\xA9l\xC3\xA9ration",
                                                     "pressure",
                                                     "pressures",
                                                     "druck",
                                                     "moment",
                                                     "moments",
                                                     "torque",
                                                     "rotation"};
    return is_one_of(word, words);
}

bool is_no_unit(std::string_view text) {
    constexpr std::array<std::string_view, 24> words{"-",     "",         "east",       "north",    "west",  "south",
                                                     "up",    "upward",   "upwards",    "down",     "right", "left",
                                                     "along", "vertical", "horizontal", "absolute", "abs",   "rel",
                                                     "total", "utm",      "local",      "e",        "n",     "u"};
    return is_one_of(lower_case(text), words) || parse_number(text).has_value();
}

std::vector<std::string_view> units_in_words(std::string_view title) {
    std::vector<std::string_view> found;
    for (std::size_t i = 0; i < title.size(); ++i) {
        const char close = title[i] == '[' ? ']' : title[i] == '(' ? ')' : '\0';
        const std::size_t end = close == '\0' ? std::string_view::npos : title.find(close, i);
        if (end != std::string_view::npos) {
            found.push_back(title.substr(i + 1, end - i - 1));
        }
    }
    bool is_next = false;
    for (std::size_t begin = title.find_first_not_of(" \t"); begin < title.size();
         begin = title.find_first_not_of(" \t", begin)) {
        const std::size_t end = std::min(title.find_first_of(" \t", begin), title.size());
        const std::string_view whole = title.substr(begin, end - begin);
        const std::string word = lower_case(bare(whole));
        const std::size_t mark = whole.find_first_of("=:");
        begin = end;
        if (mark != std::string_view::npos && mark + 1 < whole.size()) {  // "units=mm"
            const std::string before = lower_case(bare(whole.substr(0, mark)));
            if (before == "unit" || before == "units") {
                found.push_back(bare(whole.substr(mark + 1)));
            }
        }
        if (is_next && !word.empty()) {
            found.push_back(bare(whole));
        }
        is_next = word == "in" || word == "unit" || word == "units" || (is_next && word.empty());
    }
    return found;
}

}  // namespace riprap::geometry
