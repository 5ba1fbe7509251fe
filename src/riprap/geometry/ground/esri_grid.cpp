// SPDX-License-Identifier: Apache-2.0
// Grids of heights in the form of ESRI.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "riprap/core/index.hpp"
#include "riprap/geometry/ground/height_grid.hpp"
#include "riprap/geometry/text/cut_end.hpp"
#include "riprap/geometry/text/line_ends.hpp"
#include "riprap/geometry/text/marks_of_nothing.hpp"
#include "riprap/geometry/text/text_reader.hpp"

namespace riprap::geometry {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

[[noreturn]] void refuse_at(const std::string& file, const Word& word, std::string message, std::string allowed) {
    throw CaseError(Diagnostic{{file, word.line, word.column}, std::move(message), std::move(allowed)});
}

double number_of(const std::string& file, const Word& word, std::string_view what) {
    const auto value = parse_number(word.text);
    if (!value || !std::isfinite(*value)) {
        refuse_at(file, word, fmt::format("{} is {}", what, word.is_empty() ? "missing" : quote(word.text)),
                  "a finite number");
    }
    return *value;
}

/// The lines before the heights of an ESRI ASCII grid.
struct EsriHead {
    enum class Taken { yes, no, twice };

    std::optional<double> columns, rows, x, y, dx, dy, nodata;
    bool x_is_corner{true}, y_is_corner{true};

    Taken take(const Word& key, double value) {
        const auto is = [&key](std::string_view name) { return is_same_keyword(key.text, name); };
        bool is_twice = false;
        const auto set = [&](std::optional<double>& to) {
            is_twice = is_twice || (to && *to != value);
            to = value;
        };
        const auto set_corner = [&](std::optional<double>& to, bool& is_corner, std::string_view corner) {
            is_twice = is_twice || (to && is_corner != is(corner));
            is_corner = is(corner);
            set(to);
        };
        if (is("ncols")) {
            set(columns);
        } else if (is("nrows")) {
            set(rows);
        } else if (is("xllcorner") || is("xllcenter")) {
            set_corner(x, x_is_corner, "xllcorner");
        } else if (is("yllcorner") || is("yllcenter")) {
            set_corner(y, y_is_corner, "yllcorner");
        } else if (is("cellsize")) {
            set(dx);
            set(dy);
        } else if (is("dx")) {
            set(dx);
        } else if (is("dy")) {
            set(dy);
        } else if (is("nodata_value")) {
            set(nodata);
        } else {
            return Taken::no;
        }
        return is_twice ? Taken::twice : Taken::yes;
    }
    /// Names of the keys that have not come, parted by commas.
    std::string missing() const {
        std::string names;
        const auto ask = [&names](const std::optional<double>& value, std::string_view name) {
            names += value ? "" : fmt::format("{}{}", names.empty() ? "" : ", ", name);
        };
        ask(columns, "ncols");
        ask(rows, "nrows");
        ask(x, "xllcorner");
        ask(y, "yllcorner");
        ask(dx && dy ? dx : std::nullopt, "cellsize");
        return names;
    }
};

/// Says which numbers a key takes; empty where this one is allowed.
std::string allowed_of(const Word& key, double value) {
    const auto is = [&key](std::string_view name) { return is_same_keyword(key.text, name); };
    if ((is("ncols") || is("nrows")) && !(value >= 2 && value == std::floor(value) && value <= 1e9)) {
        return fmt::format("a whole number of 2 or more, and at most {} heights", most_heights);
    }
    return (is("cellsize") || is("dx") || is("dy")) && !(value > 0) ? "a number above 0" : "";
}

EsriHead read_head(TextReader& reader, const std::string& file) {
    EsriHead head;
    Word word = reader.peek_word();
    while (!word.is_empty() && std::isalpha(static_cast<unsigned char>(word.text.front())) != 0) {
        const Word key = reader.next_word(), text = reader.next_word_on_line();
        // Programs write "nan" for heights that are none, and as their mark.
        const bool is_nan = is_same_keyword(key.text, "nodata_value") && is_same_keyword(text.text, "nan");
        const double value = is_nan ? none : number_of(file, text, key.text);
        if (const std::string allowed = allowed_of(key, value); !allowed.empty()) {
            refuse_at(file, text, fmt::format("{} is {}", key.text, quote(text.text)), allowed);
        }
        const auto taken = head.take(key, value);
        if (taken != EsriHead::Taken::yes) {
            refuse_at(file, key,
                      taken == EsriHead::Taken::no
                          ? fmt::format("{} is no key of an ESRI ASCII grid", quote(key.text))
                          : fmt::format("{} says otherwise than a line above", quote(key.text)),
                      taken == EsriHead::Taken::no ? "ncols, nrows, xllcorner, yllcorner, cellsize, NODATA_value"
                                                   : "each key once");
        }
        word = reader.peek_word();
    }
    if (const std::string missing = head.missing(); !missing.empty()) {
        refuse_at(file, word, fmt::format("the head of the grid ends without {}", missing),
                  "ncols, nrows, xllcorner or xllcenter, yllcorner or yllcenter, cellsize, each with its number");
    }
    if (!(*head.columns * *head.rows <= static_cast<double>(most_heights))) {
        refuse_at(file, word, fmt::format("a grid of {:g} by {:g} heights", *head.columns, *head.rows),
                  fmt::format("at most {} heights", most_heights));
    }
    return head;
}

/// Words of each line that is left, with the first.
struct LineOfWords {
    Word first;
    std::int64_t count{0};
};

std::vector<LineOfWords> lines_of(TextReader reader) {
    std::vector<LineOfWords> lines;
    for (Word word = reader.next_word(); !word.is_empty(); word = reader.next_word()) {
        if (lines.empty() || lines.back().first.line != word.line) {
            lines.push_back({word, 0});
        }
        ++lines.back().count;
    }
    return lines;
}

/// Refuses lines that end elsewhere than the rows of the head: another grid, read row after row, would be scrambled.
/// Rows may go on in further lines, the last of which is shorter; all heights may stand in one line, or one in each.
void check_line_ends(const std::vector<LineOfWords>& lines, std::int64_t columns, std::int64_t rows,
                     const std::string& file) {
    std::int64_t all = 0, longest = 0;
    bool are_even = true;
    for (const LineOfWords& line : lines) {
        all += line.count;
        longest = std::max(longest, line.count);
        are_even = are_even && line.count == lines.front().count;
    }
    if (lines.size() == 1 || longest == 1 || (are_even && longest == columns)) {
        return;
    }
    std::int64_t left = columns;
    for (const LineOfWords& line : lines) {
        const bool goes_on = !are_even && line.count == longest && line.count < left;
        if (line.count != left && !goes_on) {
            refuse_at(file, line.first,
                      fmt::format("a line of {} heights, where ncols is {} and nrows {}", line.count, columns, rows),
                      are_even && all % longest == 0
                          ? fmt::format("a row in each line: ncols {} and nrows {}?", longest, all / longest)
                          : fmt::format("a row of {} heights in each line", columns));
        }
        left = line.count == left ? columns : left - line.count;
    }
}

}  // namespace

HeightGrid read_esri_ascii(std::string_view text, const std::string& file, double scale, const NoHeight& no_height) {
    text = without_byte_order_mark(text);
    const std::string with_line_feeds = has_bare_returns(text) ? line_feeds_in(text) : "";
    TextReader reader(with_line_feeds.empty() ? text : with_line_feeds);
    const EsriHead head = read_head(reader, file);
    HeightGrid grid;
    grid.columns = static_cast<std::int64_t>(*head.columns);
    grid.rows = static_cast<std::int64_t>(*head.rows);
    grid.dx = scale * *head.dx;
    grid.dy = scale * *head.dy;
    grid.x0 = scale * *head.x + (head.x_is_corner ? 0.5 * grid.dx : 0);
    grid.y0 = scale * *head.y + (head.y_is_corner ? 0.5 * grid.dy : 0);
    grid.z.resize(riprap::at(grid.columns * grid.rows));
    check_line_ends(lines_of(reader), grid.columns, grid.rows, file);
    const double nodata = no_height.mark.value_or(head.nodata.value_or(-9999));
    TextReader heights = reader;
    CutEnd end;
    Word last;
    for (std::int64_t row = grid.rows - 1; row >= 0; --row) {
        for (std::int64_t column = 0; column < grid.columns; ++column) {
            const Word word = reader.next_word();
            last = word;
            end.add(word.text);
            const bool is_nan = std::isnan(nodata) && is_same_keyword(word.text, "nan");
            const double z = is_nan ? none : number_of(file, word, "a height");
            grid.z[riprap::at(row * grid.columns + column)] = is_nan || is_same_mark(z, nodata) ? none : scale * z;
        }
    }
    if (const Word more = reader.next_word(); !more.is_empty()) {
        refuse_at(file, more, fmt::format("more than the {} heights of the head", grid.columns * grid.rows),
                  "ncols times nrows numbers");
    }
    if (end.is_cut(text)) {
        refuse_at(file, last, "the last height has fewer digits than those above it, and the file ends in it",
                  "the whole file; a line end after the last row where that is whole");
    }
    const auto mark = no_height.is_certain
                          ? std::nullopt
                          : find_mark_of_nothing(grid.z, grid.columns, std::max(grid.dx, grid.dy), scale);
    if (mark) {
        Word found;
        for (std::int64_t row = grid.rows - 1, left = 1; row >= 0 && left > 0; --row) {
            for (std::int64_t column = 0; column < grid.columns && left > 0; ++column) {
                found = heights.next_word();
                left = riprap::at(row * grid.columns + column) == mark->index ? 0 : 1;
            }
        }
        refuse_at(file, found, mark->message,
                  fmt::format("NODATA_value {} in the head, or nodata = \"none\" where it is a height", found.text));
    }
    return grid;
}

bool is_esri_ascii(std::string_view text) {
    const std::string_view word = TextReader(without_byte_order_mark(text)).next_word().text;
    return is_same_keyword(word, "ncols") || is_same_keyword(word, "nrows");
}

}  // namespace riprap::geometry
