// SPDX-License-Identifier: Apache-2.0
// Finds the runs of a study: grids of values and lists in files.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string_view>

#include "riprap/core/error.hpp"
#include "riprap/run/study/sweep.hpp"
#include "riprap/run/study/sweep_keys.hpp"
#include "riprap/scene/text/file_kinds.hpp"

namespace riprap::run {

namespace {

/// A value of a list, and where it begins in its line, from 1.
struct Cell {
    std::string text;
    std::uint32_t column{1};
};

std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(" \t\r"), last = text.find_last_not_of(" \t\r");
    return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

/// Parts a text at marks outside of brackets and quotes.
std::vector<Cell> cells_of(const std::string& text, char mark = ',') {
    std::vector<Cell> cells{{"", 1}};
    int depth = 0;
    char quote = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (quote != 0) {
            quote = c == quote ? '\0' : quote;
        } else if (c == '"' || c == '\'') {
            quote = c;
        } else {
            depth += c == '[' || c == '{' ? 1 : c == ']' || c == '}' ? -1 : 0;
        }
        if (c == mark && depth == 0 && quote == 0) {
            cells.push_back({"", static_cast<std::uint32_t>(i + 2)});
        } else {
            cells.back().text += c;
        }
    }
    for (Cell& cell : cells) {
        const std::size_t begin = cell.text.find_first_not_of(" \t\r");
        cell.column += static_cast<std::uint32_t>(begin == std::string::npos ? 0 : begin);
        cell.text = trimmed(cell.text);
    }
    return cells;
}

/// Is this a number with one comma in it, as some countries write fractions?
bool has_decimal_comma(const std::string& text) {
    const std::size_t comma = text.find(',');
    const auto is_part = [](char c) {
        return (c >= '0' && c <= '9') || std::string_view("+-,.eE").find(c) != std::string_view::npos;
    };
    return comma != std::string::npos && std::all_of(text.begin(), text.end(), is_part);
}

std::string name_of(std::size_t number) { return fmt::format("run_{:03}", number + 1); }

/// The mark between the keys of a list: a comma, or what spreadsheets write instead.
char mark_of(const std::string& line) {
    for (const char mark : {',', ';', '\t'}) {
        if (line.find(mark) != std::string::npos) {
            return mark;
        }
    }
    return ',';
}

/// The lines of a text, whatever ends them.
std::vector<std::string> lines_of(std::string text) {
    if (text.starts_with("\xEF\xBB\xBF")) {
        text.erase(0, 3);
    }
    std::vector<std::string> lines{""};
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool is_crlf = text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n';
        if (text[i] == '\n' || (text[i] == '\r' && !is_crlf)) {
            lines.emplace_back();
        } else if (!is_crlf) {
            lines.back() += text[i];
        }
    }
    return lines;
}

/// The keys in the first line of a list. @throws CaseError for what can be none
std::vector<std::string> keys_of(const std::string& line, char mark, SourcePlace place) {
    std::vector<std::string> keys;
    for (Cell& cell : cells_of(line, mark)) {
        std::string& key = cell.text;
        place.column = cell.column;
        if (key.size() > 1 && key.front() == '"' && key.back() == '"') {
            key = key.substr(1, key.size() - 2);
        }
        if (key.empty() || key.find_first_of(" \t=\"'") != std::string::npos) {
            refuse_study(place, fmt::format("'{}' is no key", key),
                         "keys as for --set, parted by commas: end,solid.skin");
        }
        if (const std::string other = same_of(key, keys); !other.empty()) {
            refuse_study(place, stands_twice(key, other), "each key once");
        }
        keys.push_back(key);
    }
    return keys;
}

void refuse_control_bytes(const std::string& line, const SourcePlace& place) {
    for (std::size_t i = 0; i < line.size(); ++i) {
        const auto byte = static_cast<unsigned char>(line[i]);
        if (byte < ' ' && byte != '\t') {
            refuse_study({place.file, place.line, static_cast<std::uint32_t>(i + 1)},
                         fmt::format("a byte {:#04x}", byte), "text");
        }
    }
}

}  // namespace

Variation read_variation(const std::string& text) {
    const std::size_t equals = text.find('=');
    Variation variation;
    if (equals != std::string::npos) {
        variation.key = trimmed(text.substr(0, equals));
        for (const Cell& cell : cells_of(text.substr(equals + 1))) {
            variation.values.push_back(cell.text);
        }
    }
    const auto is_empty = [](const std::string& value) { return value.empty(); };
    if (variation.key.empty() || std::any_of(variation.values.begin(), variation.values.end(), is_empty)) {
        refuse_study({"--vary"}, fmt::format("'{}' does not say what to vary", text), "KEY=VALUE,VALUE,...");
    }
    if (cells_of(text, ';').size() > 1) {
        // "end=0,5;1" would be 0, "5;1".
        refuse_study({"--vary"}, fmt::format("'{}' parts values by semicolons", text),
                     "KEY=VALUE,VALUE,... with decimal points; a list of a spreadsheet by --list");
    }
    return variation;
}

std::vector<SweepPoint> grid_of(const std::vector<Variation>& variations) {
    constexpr std::size_t most = 10'000;
    std::vector<SweepPoint> points{{}};
    std::vector<std::string> keys;
    for (const Variation& variation : variations) {
        if (const std::string other = same_of(variation.key, keys); !other.empty()) {
            refuse_study({"--vary"}, stands_twice(variation.key, other), "all its values behind one --vary");
        }
        keys.push_back(variation.key);
        std::vector<SweepPoint> next;
        for (const SweepPoint& point : points) {
            for (const std::string& value : variation.values) {
                next.push_back(point);
                next.back().overrides.push_back(fmt::format("{}={}", variation.key, value));
            }
        }
        points = std::move(next);
        if (points.size() > most) {
            refuse_study({"--vary"}, fmt::format("{} runs or more", points.size()), fmt::format("at most {}", most));
        }
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        points[i].name = name_of(i);
    }
    return points;
}

namespace {

/// The run of one line of a list. @throws CaseError where it has not one value for each key
SweepPoint point_of(const std::vector<Cell>& cells, const std::vector<std::string>& keys, char mark, std::string name,
                    SourcePlace place) {
    if (cells.size() != keys.size()) {
        place.column = cells[std::min(keys.size(), cells.size() - 1)].column;
        refuse_study(place, fmt::format("{} values for {} keys", cells.size(), keys.size()),
                     "as many values as the first line has keys; lists in brackets");
    }
    SweepPoint point{std::move(name), {}};
    for (std::size_t k = 0; k < keys.size(); ++k) {
        place.column = cells[k].column;
        if (cells[k].text.empty()) {
            refuse_study(place, fmt::format("no value of '{}'", keys[k]), "a value of each key");
        }
        if (mark != ',' && has_decimal_comma(cells[k].text)) {
            refuse_study(place, fmt::format("'{}' has a comma", cells[k].text), "numbers with decimal points");
        }
        point.overrides.push_back(fmt::format("{}={}", keys[k], cells[k].text));
    }
    return point;
}

}  // namespace

std::vector<SweepPoint> list_of(const std::string& text, const std::string& file) {
    if (const std::optional<scene::OtherKind> kind = scene::other_kind(text)) {
        refuse_study({file}, fmt::format("the list {}", kind->what), kind->allowed);
    }
    std::vector<std::string> keys;
    std::vector<SweepPoint> points;
    char mark = ',';
    SourcePlace place{file, 0, 1};
    for (const std::string& whole : lines_of(text)) {
        ++place.line;
        refuse_control_bytes(whole, place);
        const std::string line = trimmed(whole);
        if (line.empty() || line.front() == '#') {
            continue;
        }
        if (keys.empty()) {
            mark = mark_of(line);
            keys = keys_of(whole, mark, place);
            continue;
        }
        points.push_back(point_of(cells_of(whole, mark), keys, mark, name_of(points.size()), place));
    }
    if (points.empty()) {
        refuse_study({file}, "no runs in the list", "a line of keys, then a line of values for each run");
    }
    return points;
}

}  // namespace riprap::run
