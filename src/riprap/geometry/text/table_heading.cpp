// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/text/table_heading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "riprap/geometry/text/heading_words.hpp"
#include "riprap/geometry/text/text_reader.hpp"

namespace riprap::geometry {

namespace {

constexpr std::size_t no_column = static_cast<std::size_t>(-1);
constexpr std::size_t most_lines = 100;  ///< of headings that are looked at

std::string_view trimmed(std::string_view text) {
    const std::size_t begin = std::min(text.find_first_not_of(" \t"), text.size());
    const std::size_t end = text.find_last_not_of(" \t");
    return end == std::string_view::npos ? std::string_view{} : text.substr(begin, end + 1 - begin);
}

/// The unit behind a name: "mm" of "_mm", ", mm" and " in mm".
std::string_view unit_behind(std::string_view text) {
    const std::string_view unit = trimmed(text.substr(std::min(text.find_first_not_of("_/., \t"), text.size())));
    return unit.starts_with("in ") ? trimmed(unit.substr(3)) : unit;
}

/// Words for angles on the globe, which are no lengths.
bool is_in_degrees(const std::string& name) {
    constexpr std::array<std::string_view, 6> words{"lon", "lat", "longitude", "latitude", "long", "lng"};
    return std::find(words.begin(), words.end(), name) != words.end();
}

/// True where more than blanks stand between all cells of a line.
bool has_marks_between(const std::vector<TableCell>& cells) {
    for (std::size_t k = 0; k + 1 < cells.size(); ++k) {
        const char* end = cells[k].text.data() + cells[k].text.size();
        const std::string_view gap(end, static_cast<std::size_t>(cells[k + 1].text.data() - end));
        if (gap.find_first_of(",;\t") == std::string_view::npos) {
            return false;
        }
    }
    return cells.size() > 1;
}

bool names_other_quantity(const HeadingCell& cell) {
    const std::vector<std::string> words = words_of(cell.name);
    return std::any_of(words.begin(), words.end(), is_other_quantity);
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

std::size_t TableHeadings::column_named(const std::string& name) const {
    for (std::size_t k = 0; k < form_.columns.size(); ++k) {
        const auto& aliases = form_.columns[k].aliases;
        if (std::find(aliases.begin(), aliases.end(), name) != aliases.end()) {
            return k;
        }
    }
    return no_column;
}

/// The one column that a word of the name means: "displacement x", but not "velocity x".
std::size_t TableHeadings::column_in_words(const std::string& name) const {
    std::size_t found = no_column;
    for (const std::string& word : words_of(name)) {
        const std::size_t column = column_named(word);
        // "d x" is a displacement; "a x" is none.
        const bool is_letter = word.size() == 1 && word >= "a" && word != "d" && word != "u" && column == no_column;
        if (is_letter || is_other_quantity(word) || (column != no_column && found != no_column && column != found)) {
            return no_column;
        }
        found = column != no_column ? column : found;
    }
    return found;
}

/// Splits "x [mm]", "x (mm)", "x_mm", "x/mm", "x.mm", "x, mm", "x in mm" and "x mm". What divides or multiplies a name
/// ("x/L", "x*1000") must be a unit, as in brackets.
HeadingCell TableHeadings::heading_cell(const TableCell& cell, std::uint32_t line) const {
    HeadingCell heading{lower_case(cell.text), "", false, {file_, line, cell.column}, std::string(cell.text)};
    std::string_view text = cell.text;
    if (text.empty()) {
        return heading;
    }
    const char close = text.back(), open = close == ']' ? '[' : close == ')' ? '(' : '\0';
    const std::size_t bracket = open == '\0' ? std::string_view::npos : text.rfind(open);
    if (bracket != std::string_view::npos) {
        heading.name = lower_case(trimmed(text.substr(0, bracket)));
        heading.unit = trimmed(text.substr(bracket + 1, text.size() - bracket - 2));
        // "S(f)" is S as a function of f.
        const bool is_of_column = close == ')' && column_named(lower_case(heading.unit)) != no_column && form_.unit &&
                                  !form_.unit(0, heading.unit).is_known;
        heading.is_certain = !is_of_column;
        heading.unit = is_of_column ? "" : heading.unit;
    }
    heading.column = column_named(heading.name);
    if (heading.column != no_column || heading.is_certain) {
        heading.column = heading.column != no_column ? heading.column : column_in_words(heading.name);
        return heading;
    }
    constexpr std::string_view marks = "_/*., ";
    for (std::size_t mark = text.find_first_of(marks, 1); mark < text.size();
         mark = text.find_first_of(marks, mark + 1)) {
        const std::size_t column = column_named(lower_case(trimmed(text.substr(0, mark))));
        if (column != no_column) {
            const std::string unit(unit_behind(text.substr(mark)));
            // "x velocity" is no x.
            const std::vector<std::string> words = words_of(unit);
            const bool is_other = std::any_of(words.begin(), words.end(), is_other_quantity);
            heading.column = is_other ? no_column : column;
            heading.unit = is_other ? "" : unit;
            heading.is_certain = !is_other && trimmed(text.substr(mark)).find_first_of("/*") == 0;
            return heading;
        }
    }
    if (const std::size_t mark = text.find_last_of(marks); mark != std::string_view::npos && mark > 0) {
        heading.unit = unit_behind(text.substr(mark));
    }
    heading.column = column_in_words(heading.name);
    return heading;
}

void TableHeadings::add(std::string_view text, const std::vector<TableCell>& cells, std::uint32_t line) {
    if (lines_.size() >= most_lines) {
        return;
    }
    Line heading;
    for (const TableCell& cell : cells) {
        HeadingCell named = heading_cell(cell, line);
        if (is_unread(named)) {  // "rot_z" is no z
            named.column = no_column;
        }
        heading.cells.push_back(std::move(named));
    }
    heading.has_marks = has_marks_between(cells);
    heading.text = text;
    heading.place = {file_, line, 1};
    lines_.push_back(std::move(heading));
}

void TableHeadings::add_comment(std::string_view line, std::uint32_t number, std::uint32_t column) {
    std::vector<TableCell> cells;
    split_table_line(line, cells);
    if (cells.empty() || lines_.size() >= most_lines) {
        return;
    }
    for (TableCell& cell : cells) {
        cell.column += column - 1;
    }
    add(line, cells, number);
    lines_.back().is_comment = true;
}

bool TableHeadings::is_unit_line(const Line& line) const {
    return form_.unit && std::all_of(line.cells.begin(), line.cells.end(), [&](const HeadingCell& cell) {
               const std::string& text = cell.is_certain && cell.name.empty() ? cell.unit : cell.text;
               return form_.unit(0, text).is_known;
           });
}

/// Tells a heading from a title: words between marks, or at least half of all words are names of quantities.
bool TableHeadings::is_like_a_heading(const Line& line) const {
    const auto names = std::count_if(line.cells.begin(), line.cells.end(), [](const HeadingCell& cell) {
        return cell.column != no_column || names_other_quantity(cell);
    });
    return (line.has_marks && !line.is_comment) || 2 * static_cast<std::size_t>(names) >= line.cells.size();
}

ColumnChoice TableHeadings::choice_of(const Line& line) const {
    ColumnChoice choice{std::vector<std::size_t>(form_.columns.size(), no_column), false, line.cells.size()};
    for (std::size_t k = 0; k < line.cells.size(); ++k) {
        const HeadingCell& cell = line.cells[k];
        if (cell.column == no_column) {
            if (is_unread(cell)) {
                choice.unread.push_back(k);
            }
            continue;
        }
        if (choice.take[cell.column] != no_column && !line.is_comment) {
            throw CaseError(Diagnostic{
                cell.place,
                fmt::format("{} is the second heading of {}", quote(cell.text), form_.columns[cell.column].name),
                "one column of each name"});
        }
        choice.take[cell.column] = k;
    }
    choice.is_named = std::find(choice.take.begin(), choice.take.end(), no_column) == choice.take.end();
    return choice;
}

bool TableHeadings::is_unread(const HeadingCell& cell) const {
    const std::vector<std::string> words = words_of(cell.name);
    return form_.unread.is_named_by && std::any_of(words.begin(), words.end(), form_.unread.is_named_by);
}

std::string TableHeadings::name_of(std::size_t cell) const {
    const auto names_it = [&](const Line& line) {
        return line.is_heading && cell < line.cells.size() && is_unread(line.cells[cell]);
    };
    const auto line = std::find_if(lines_.begin(), lines_.end(), names_it);
    return line != lines_.end() ? line->cells[cell].text : fmt::format("column {}", cell + 1);
}

/// Refuses a heading that does not name every column and says something else of one of them than its place does.
void TableHeadings::check_names(const Line& line) const {
    const std::string allowed = fmt::format("a heading for every column, with {} among them, or {}", names(), wanted());
    const bool names_some = std::any_of(line.cells.begin(), line.cells.end(),
                                        [](const HeadingCell& cell) { return cell.column != no_column; });
    for (std::size_t k = 0; k < line.cells.size(); ++k) {
        const HeadingCell& cell = line.cells[k];
        const auto refuse_cell = [&cell](std::string message, std::string wanted_text) {
            throw CaseError(Diagnostic{cell.place, std::move(message), std::move(wanted_text)});
        };
        const std::vector<std::string> words = words_of(cell.name);
        if (std::any_of(words.begin(), words.end(), is_in_degrees)) {
            refuse_cell(fmt::format("{} is an angle on the globe", quote(cell.text)),
                        "places in metres, of a map projection");
        }
        if (cell.column != no_column && cell.column != k) {
            refuse_cell(fmt::format("{} heads column {}", quote(cell.text), k + 1), allowed);
        }
        const bool is_other = names_some ? cell.column == no_column : names_other_quantity(cell);
        if (k < form_.columns.size() && is_other && !cell.text.empty()) {
            refuse_cell(
                fmt::format("{} heads column {}, where {} is read", quote(cell.text), k + 1, form_.columns[k].name),
                allowed);
        }
    }
}

/// Refuses a heading of columns that the rows do not have.
void TableHeadings::check_width(const Line& line, std::size_t cell_count) const {
    const bool names_all = std::all_of(line.cells.begin(), line.cells.end(),
                                       [](const HeadingCell& cell) { return cell.column != no_column; });
    if (names_all && line.has_marks && !line.is_comment && line.cells.size() != cell_count) {
        throw CaseError(
            Diagnostic{line.cells.front().place,
                       fmt::format("a heading of {} columns above rows of {}", line.cells.size(), cell_count),
                       fmt::format("a heading for every column, with {} among them", names())});
    }
}

void TableHeadings::check_unit(std::size_t column, const HeadingCell& cell) {
    if (cell.unit.empty() || !form_.unit || (cell.is_certain && is_no_unit(cell.unit))) {
        return;
    }
    const UnitAnswer answer = form_.unit(column, cell.unit);
    if (!answer.is_known) {
        if (cell.is_certain) {
            throw CaseError(Diagnostic{cell.place, fmt::format("the unit in {} is not known", quote(cell.text)),
                                       answer.problem.empty() ? "a unit that is read, or none" : answer.problem});
        }
        return;
    }
    // One letter behind a name may be an index; "min" and "rev" have other meanings.
    const bool is_clear = cell.unit.size() > 1 && cell.unit != "min" && cell.unit != "rev";
    if (!answer.problem.empty() && (cell.is_certain || answer.is_of_its_kind || is_clear)) {
        throw CaseError(Diagnostic{
            cell.place, fmt::format("{} stands over column {}", quote(cell.text), form_.columns[column].name),
            answer.problem});
    }
    has_unit_[column] = has_unit_[column] || answer.problem.empty();
}

/// Refuses a title that says of rows without names of their columns that they are of another quantity.
void TableHeadings::check_quantity(const Line& line) const {
    for (const std::string& word : words_of(line.text)) {
        if (is_quantity_of_title(word)) {
            throw CaseError(Diagnostic{line.place,
                                       fmt::format("{} speaks of another quantity than {}", quote(line.text), names()),
                                       fmt::format("a line {} above the rows where they are that", names())});
        }
    }
}

/// Refuses a title that gives columns without a unit of their own one that is not read: "Displacement in mm".
void TableHeadings::check_title(const Line& line) const {
    for (const std::string_view unit : units_in_words(line.text)) {
        std::string problem;
        bool is_read = false;
        for (std::size_t column = 0; form_.unit && column < form_.columns.size(); ++column) {
            const UnitAnswer answer = form_.unit(column, unit);
            if (!answer.is_known || !answer.is_of_its_kind) {
                continue;
            }
            is_read = is_read || answer.problem.empty() || has_unit_[column];
            problem = answer.problem.empty() ? problem : answer.problem;
        }
        if (!problem.empty() && !is_read) {
            throw CaseError(Diagnostic{
                line.place, fmt::format("{} says that numbers are in {}", quote(line.text), quote(unit)), problem});
        }
    }
}

ColumnChoice TableHeadings::choose(std::size_t cell_count) {
    const std::size_t width = form_.columns.size();
    has_unit_.assign(width, false);
    ColumnChoice choice;
    for (Line& line : lines_) {
        line.is_heading = line.cells.size() == cell_count && is_like_a_heading(line);
        if (is_unit_line(line)) {
            line.is_heading = line.cells.size() == cell_count;
            continue;
        }
        ColumnChoice by_line =
            line.is_heading || (line.has_marks && line.cells.size() > cell_count) ? choice_of(line) : ColumnChoice{};
        // Empty cells at the end of the first row are not counted in it.
        if (by_line.is_named && *std::ranges::max_element(by_line.take) < cell_count) {
            line.is_heading = true;
            choice = std::move(by_line);
        }
    }
    if (!choice.is_named) {
        for (const Line& line : lines_) {
            if (!is_unit_line(line)) {
                line.is_heading ? check_names(line) : check_width(line, cell_count);
            }
        }
        choice.take.resize(width);
        std::iota(choice.take.begin(), choice.take.end(), std::size_t{0});
    }
    for (Line& line : lines_) {
        const bool is_units = is_unit_line(line);
        for (std::size_t column = 0; line.is_heading && column < width && choice.take[column] < line.cells.size();
             ++column) {
            HeadingCell& cell = line.cells[choice.take[column]];
            if (is_units && !(cell.is_certain && cell.name.empty())) {
                cell.unit = cell.text;
            }
            check_unit(column, cell);
        }
    }
    for (const Line& line : lines_) {
        if (!line.is_heading) {
            check_title(line);
        }
        if (!line.is_heading && !choice.is_named) {
            check_quantity(line);
        }
    }
    if (choice.is_named && choice.cell_count > width) {
        notes_.push_back(fmt::format("of {} columns {} are read, by their names", choice.cell_count, names()));
    }
    return choice;
}

}  // namespace riprap::geometry
