// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/table_heading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "riprap/geometry/text_reader.hpp"

namespace riprap::geometry {

namespace {

constexpr std::size_t no_column = static_cast<std::size_t>(-1);
constexpr std::size_t most_lines = 100;  ///< of headings that are looked at

std::string lower(std::string_view text) {
    std::string result(text);
    std::transform(result.begin(), result.end(), result.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return result;
}

std::string_view trimmed(std::string_view text) {
    const std::size_t begin = std::min(text.find_first_not_of(" \t"), text.size());
    const std::size_t end = text.find_last_not_of(" \t");
    return end == std::string_view::npos ? std::string_view{} : text.substr(begin, end + 1 - begin);
}

/// Splits "x [mm]", "x (mm)", "x_mm", "x/mm" and "x mm".
HeadingCell heading_cell(const TableCell& cell, const std::string& file, std::uint32_t line) {
    HeadingCell heading{lower(cell.text), "", false, {file, line, cell.column}, std::string(cell.text)};
    const std::string_view text = cell.text;
    if (text.empty()) {
        return heading;
    }
    const char close = text.back(), open = close == ']' ? '[' : close == ')' ? '(' : '\0';
    const std::size_t bracket = open == '\0' ? std::string_view::npos : text.rfind(open);
    if (bracket != std::string_view::npos) {
        heading.name = lower(trimmed(text.substr(0, bracket)));
        heading.unit = trimmed(text.substr(bracket + 1, text.size() - bracket - 2));
        heading.is_certain = true;
        return heading;
    }
    if (const std::size_t mark = text.find_last_of("_/ "); mark != std::string_view::npos && mark > 0) {
        heading.unit = trimmed(text.substr(mark + 1));
    }
    return heading;
}

/// Words for angles on the globe, which are no lengths.
bool is_in_degrees(const std::string& name) {
    constexpr std::array<std::string_view, 6> words{"lon", "lat", "longitude", "latitude", "long", "lng"};
    return std::find(words.begin(), words.end(), name) != words.end();
}

}  // namespace

std::string TableHeadings::names() const {
    std::string text;
    for (const TableColumn& column : form_.columns) {
        text += fmt::format("{}{}", text.empty() ? "" : ",", column.name);
    }
    return text;
}

std::string TableHeadings::wanted() const {
    std::string text;
    for (const TableColumn& column : form_.columns) {
        text += fmt::format("{}{}", text.empty() ? "" : ", ", column.name);
    }
    return fmt::format("rows of {} numbers: {}", form_.columns.size(), text);
}

void TableHeadings::add(const std::vector<TableCell>& cells, std::uint32_t line) {
    if (lines_.size() >= most_lines) {
        return;
    }
    Line heading;
    for (const TableCell& cell : cells) {
        heading.cells.push_back(heading_cell(cell, file_, line));
    }
    lines_.push_back(std::move(heading));
}

void TableHeadings::add_comment(std::string_view line, std::uint32_t number, std::uint32_t column) {
    std::vector<TableCell> cells;
    split_table_line(line, cells);
    if (cells.size() < form_.columns.size() || lines_.size() >= most_lines) {
        return;
    }
    for (TableCell& cell : cells) {
        cell.column += column - 1;
    }
    add(cells, number);
    lines_.back().is_comment = true;
}

std::size_t TableHeadings::column_named(const std::string& name) const {
    for (std::size_t k = 0; k < form_.columns.size(); ++k) {
        const auto& aliases = form_.columns[k].aliases;
        if (std::find(aliases.begin(), aliases.end(), name) != aliases.end()) {
            return k;
        }
    }
    return no_column;
}

bool TableHeadings::is_unit_line(const Line& line) const {
    return form_.unit && std::all_of(line.cells.begin(), line.cells.end(), [&](const HeadingCell& cell) {
               const std::string& text = cell.is_certain && cell.name.empty() ? cell.unit : cell.text;
               return form_.unit(0, text).is_known;
           });
}

void TableHeadings::check_unit(std::size_t column, const HeadingCell& cell) {
    if (cell.unit.empty() || !form_.unit) {
        return;
    }
    const UnitAnswer answer = form_.unit(column, cell.unit);
    if (!answer.problem.empty() && (cell.is_certain || answer.is_of_its_kind)) {
        throw CaseError(Diagnostic{
            cell.place, fmt::format("{} stands over column {}", quote(cell.text), form_.columns[column].name),
            answer.problem});
    }
    if (!answer.is_known && cell.is_certain && cell.unit != "-") {
        notes_.push_back(fmt::format("the unit in {} is not known and not used", quote(cell.text)));
    }
}

ColumnChoice TableHeadings::choose_by(const Line& line) {
    const std::size_t width = form_.columns.size();
    ColumnChoice choice{std::vector<std::size_t>(width, no_column), false};
    const auto contradicts = [&line](const HeadingCell& cell, std::string message, std::string allowed) {
        if (!line.is_comment) {
            throw CaseError(Diagnostic{cell.place, std::move(message), std::move(allowed)});
        }
    };
    for (std::size_t k = 0; k < line.cells.size(); ++k) {
        const HeadingCell& cell = line.cells[k];
        const std::string bare = cell.is_certain || cell.unit.empty()
                                     ? cell.name
                                     : cell.name.substr(0, cell.name.size() - cell.unit.size() - 1);
        const std::size_t whole = column_named(cell.name);
        const std::size_t column = whole != no_column ? whole : column_named(bare);
        if (is_in_degrees(cell.name) || is_in_degrees(bare)) {
            contradicts(cell, fmt::format("{} is an angle on the globe", quote(cell.text)),
                        "places in metres, of a map projection");
        }
        if (column == no_column) {
            continue;
        }
        if (choice.take[column] != no_column) {
            contradicts(cell,
                        fmt::format("{} is the second heading of {}", quote(cell.text), form_.columns[column].name),
                        "one column of each name");
        }
        choice.take[column] = k;
    }
    choice.is_named = std::find(choice.take.begin(), choice.take.end(), no_column) == choice.take.end();
    if (choice.is_named) {
        return choice;
    }
    for (std::size_t column = 0; column < width; ++column) {
        const std::size_t k = choice.take[column];
        if (k != no_column && k != column) {
            contradicts(line.cells[k], fmt::format("{} heads column {}", quote(line.cells[k].text), k + 1),
                        fmt::format("a heading for every column, with {} among them, or {}", names(), wanted()));
        }
    }
    return choice;
}

ColumnChoice TableHeadings::choose(std::size_t cell_count) {
    const std::size_t width = form_.columns.size();
    // A line of another number of cells is a title.
    std::erase_if(lines_, [&](const Line& line) { return line.cells.size() != cell_count; });
    ColumnChoice choice;
    for (const Line& line : lines_) {
        if (!is_unit_line(line)) {
            ColumnChoice by_line = choose_by(line);
            choice = by_line.is_named ? std::move(by_line) : choice;
        }
    }
    if (!choice.is_named) {
        choice.take.resize(width);
        std::iota(choice.take.begin(), choice.take.end(), std::size_t{0});
    }
    for (Line& line : lines_) {
        const bool is_units = is_unit_line(line);
        for (std::size_t column = 0; column < width && choice.take[column] < cell_count; ++column) {
            HeadingCell& cell = line.cells[choice.take[column]];
            if (is_units && !(cell.is_certain && cell.name.empty())) {
                cell.unit = cell.text;
            }
            check_unit(column, cell);
        }
    }
    if (choice.is_named && cell_count > width) {
        notes_.push_back(fmt::format("of {} columns {} are read, by their names", cell_count, names()));
    }
    return choice;
}

}  // namespace riprap::geometry
