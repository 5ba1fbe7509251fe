// SPDX-License-Identifier: Apache-2.0
// Finds the runs of a study: grids of values and lists in files.
#include <fmt/format.h>

#include <algorithm>

#include "riprap/core/error.hpp"
#include "riprap/run/sweep.hpp"
#include "riprap/scene/text/file_kinds.hpp"

namespace riprap::run {

namespace {

[[noreturn]] void refuse(const SourcePlace& place, std::string message, std::string allowed) {
    throw CaseError(Diagnostic{place, std::move(message), std::move(allowed)});
}

std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(" \t\r"), last = text.find_last_not_of(" \t\r");
    return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

/// Parts a text at marks outside of brackets and quotes.
std::vector<std::string> values_of(const std::string& text, char mark = ',') {
    std::vector<std::string> values{""};
    int depth = 0;
    char quote = 0;
    for (const char c : text) {
        if (quote != 0) {
            quote = c == quote ? '\0' : quote;
        } else if (c == '"' || c == '\'') {
            quote = c;
        } else {
            depth += c == '[' || c == '{' ? 1 : c == ']' || c == '}' ? -1 : 0;
        }
        if (c == mark && depth == 0 && quote == 0) {
            values.emplace_back();
        } else {
            values.back() += c;
        }
    }
    std::transform(values.begin(), values.end(), values.begin(), trimmed);
    return values;
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
std::vector<std::string> keys_of(const std::string& line, char mark, const SourcePlace& place) {
    std::vector<std::string> keys = values_of(line, mark);
    for (std::string& key : keys) {
        if (key.size() > 1 && key.front() == '"' && key.back() == '"') {
            key = key.substr(1, key.size() - 2);
        }
        if (key.empty() || key.find_first_of(" \t=\"'") != std::string::npos) {
            refuse(place, fmt::format("'{}' is no key", key), "keys as for --set, parted by commas: end,solid.skin");
        }
        if (std::count(keys.begin(), keys.end(), key) > 1) {
            refuse(place, fmt::format("'{}' stands twice", key), "each key once");
        }
    }
    return keys;
}

void refuse_control_bytes(const std::string& line, const SourcePlace& place) {
    for (std::size_t i = 0; i < line.size(); ++i) {
        const auto byte = static_cast<unsigned char>(line[i]);
        if (byte < ' ' && byte != '\t') {
            refuse({place.file, place.line, static_cast<std::uint32_t>(i + 1)}, fmt::format("a byte {:#04x}", byte),
                   "text");
        }
    }
}

}  // namespace

Variation read_variation(const std::string& text) {
    const std::size_t equals = text.find('=');
    Variation variation;
    if (equals != std::string::npos) {
        variation = {trimmed(text.substr(0, equals)), values_of(text.substr(equals + 1))};
    }
    const auto is_empty = [](const std::string& value) { return value.empty(); };
    if (variation.key.empty() || std::any_of(variation.values.begin(), variation.values.end(), is_empty)) {
        refuse({"--vary"}, fmt::format("'{}' does not say what to vary", text), "KEY=VALUE,VALUE,...");
    }
    return variation;
}

std::vector<SweepPoint> grid_of(const std::vector<Variation>& variations) {
    constexpr std::size_t most = 10'000;
    std::vector<SweepPoint> points{{}};
    for (const Variation& variation : variations) {
        const auto is_same = [&](const Variation& other) { return other.key == variation.key; };
        if (std::count_if(variations.begin(), variations.end(), is_same) > 1) {
            refuse({"--vary"}, fmt::format("'{}' is varied twice", variation.key), "all its values behind one --vary");
        }
        std::vector<SweepPoint> next;
        for (const SweepPoint& point : points) {
            for (const std::string& value : variation.values) {
                next.push_back(point);
                next.back().overrides.push_back(fmt::format("{}={}", variation.key, value));
            }
        }
        points = std::move(next);
        if (points.size() > most) {
            refuse({"--vary"}, fmt::format("{} runs or more", points.size()), fmt::format("at most {}", most));
        }
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        points[i].name = name_of(i);
    }
    return points;
}

std::vector<SweepPoint> list_of(const std::string& text, const std::string& file) {
    if (const std::optional<scene::OtherKind> kind = scene::other_kind(text)) {
        refuse({file}, fmt::format("the list {}", kind->what), kind->allowed);
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
            keys = keys_of(line, mark, place);
            continue;
        }
        const std::vector<std::string> values = values_of(mark == '\t' ? whole : line, mark);
        if (values.size() != keys.size()) {
            refuse(place, fmt::format("{} values for {} keys", values.size(), keys.size()),
                   "as many values as the first line has keys; lists in brackets");
        }
        SweepPoint point{name_of(points.size()), {}};
        for (std::size_t k = 0; k < keys.size(); ++k) {
            if (values[k].empty()) {
                refuse(place, fmt::format("no value of '{}'", keys[k]), "a value of each key");
            }
            point.overrides.push_back(fmt::format("{}={}", keys[k], values[k]));
        }
        points.push_back(std::move(point));
    }
    if (points.empty()) {
        refuse({file}, "no runs in the list", "a line of keys, then a line of values for each run");
    }
    return points;
}

void refuse_set_and_varied(const SweepOptions& options) {
    const auto key_of = [](const std::string& text) { return trimmed(text.substr(0, text.find('='))); };
    for (const std::string& set : options.overrides) {
        for (const std::string& varied : options.points.front().overrides) {
            if (key_of(set) == key_of(varied)) {
                refuse({fmt::format("--set {}", set)}, fmt::format("'{}' is varied, too", key_of(set)),
                       "a key that is set in all runs, or one that is varied");
            }
        }
    }
}

}  // namespace riprap::run
