// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/text/number_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "riprap/geometry/text/cut_end.hpp"
#include "riprap/geometry/text/table_heading.hpp"
#include "riprap/geometry/text/table_line.hpp"
#include "riprap/geometry/text/text_reader.hpp"

namespace riprap::geometry {

namespace {

/// Tells decimal commas from commas between thousands, over a whole file.
class DecimalMarks {
 public:
    /// The number of a cell; nothing where it is none.
    std::optional<double> number(const TableCell& cell, const SourcePlace& place) {
        if (const auto plain = parse_number(cell.text)) {
            if (!has_point_ && cell.text.find('.') != std::string_view::npos) {
                has_point_ = true;
                point_ = place;
            }
            return plain;
        }
        const std::size_t comma = cell.text.find(',');
        if (!cell.may_have_decimal_comma || comma == std::string_view::npos ||
            cell.text.find_first_of(",.", comma + 1) != std::string_view::npos) {
            return std::nullopt;
        }
        std::string with_point(cell.text);
        with_point[comma] = '.';
        const auto number = parse_number(with_point);
        if (number && !has_comma_) {
            has_comma_ = true;
            comma_ = place;
            text_ = cell.text;
        }
        is_certain_ = is_certain_ || !may_be_thousands(cell.text, comma);
        return number;
    }
    bool has_point() const { return has_point_; }
    /// Refuses a file in which a comma may mean two things.
    void check() const {
        if (has_comma_ && has_point_) {
            throw CaseError(Diagnostic{
                comma_, fmt::format("{} has a comma, and line {} a point in a number", quote(text_), point_.line),
                "one decimal mark in the whole file, and none between thousands"});
        }
        if (has_comma_ && !is_certain_) {
            throw CaseError(Diagnostic{comma_, fmt::format("{} may be a decimal fraction or thousands", quote(text_)),
                                       "decimal points"});
        }
    }

 private:
    /// True for "1,234" and "-12,345": one to three digits that do not begin with 0, and three.
    static bool may_be_thousands(std::string_view text, std::size_t comma) {
        const std::size_t sign = text.starts_with('-') || text.starts_with('+') ? 1 : 0;
        const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
        const std::string_view before = text.substr(sign, comma - sign), after = text.substr(comma + 1);
        return !before.empty() && before.size() <= 3 && before.front() != '0' && after.size() == 3 &&
               std::all_of(after.begin(), after.end(), is_digit);
    }

    SourcePlace comma_, point_;
    std::string text_;
    bool has_comma_{false}, has_point_{false}, is_certain_{false};
};

class TableReader {
 public:
    TableReader(std::string_view text, const std::string& file, const TableForm& form)
        : text_(text), lines_(text), form_(form), headings_(file, form) {
        table_.file = file;
        table_.width = form.columns.size();
        if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
            refuse(file, "the text is UTF-16", "UTF-8 or plain ASCII");
        }
    }

    NumberTable read() {
        while (const auto line = lines_.next()) {
            read_line(*line);
        }
        if (table_.lines.empty()) {
            Diagnostic problem;
            problem.place.file = table_.file;
            problem.place.line = std::max(lines_.number(), 1U);
            problem.place.column = 1;
            problem.message = "there is no row of numbers";
            problem.allowed = headings_.wanted();
            throw CaseError(std::move(problem));
        }
        check_end();
        marks_.check();
        check_counter();
        check_count();
        std::vector<std::string> notes = headings_.take_notes();
        table_.notes.insert(table_.notes.end(), notes.begin(), notes.end());
        return std::move(table_);
    }

 private:
    [[noreturn]] void refuse_at(std::uint32_t column, std::string message, std::string allowed) const {
        throw CaseError(Diagnostic{{table_.file, lines_.number(), column}, std::move(message), std::move(allowed)});
    }

    void read_line(std::string_view line) {
        const std::size_t begin = line.find_first_not_of(" \t\v\f");
        if (begin != std::string_view::npos && line[begin] == '#' && table_.lines.empty()) {
            headings_.add_comment(line.substr(begin + 1), lines_.number(), static_cast<std::uint32_t>(begin + 2));
            return;
        }
        split_table_line(line, cells_);
        if (cells_.empty()) {
            return;
        }
        if (is_heading(line)) {
            if (!table_.lines.empty()) {
                refuse_at(cells_.front().column, fmt::format("{} stands among the rows", quote(cells_.front().text)),
                          "headings before the first row only; comments begin with '#'");
            }
            headings_.add(line, cells_, lines_.number());
            return;
        }
        read_row();
    }

    void read_row() {
        if (table_.lines.empty()) {
            choice_ = headings_.choose(cells_.size());
            // Commas between columns cannot be told from decimal commas by a row alone.
            count_ = choice_.is_named ? std::max(choice_.cell_count, cells_.size()) : number_count();
            may_be_count_ = form_.is_list && !choice_.is_named && std::all_of(cells_.begin(), cells_.end(), is_whole);
            is_open_ = form_.may_have_more && !choice_.is_named;
        }
        std::size_t found = is_open_ ? number_count() : cells_.size();
        const std::size_t wanted = is_open_ ? std::max(count_, table_.width) : choice_.is_named ? count_ : table_.width;
        if (choice_.is_named && found < wanted && found > *std::ranges::max_element(choice_.take)) {
            found = wanted;  // empty cells at the end, which are not read
            is_short_ = true;
            ++short_rows_;
        } else {
            is_short_ = false;
        }
        if (found != wanted) {
            check_cells(found, wanted);
        }
        if (static_cast<std::int64_t>(table_.lines.size()) >= form_.most_rows) {
            refuse_at(1, "more rows than a table may have", fmt::format("at most {}", form_.most_rows));
        }
        for (std::size_t k = 0; k < table_.width; ++k) {
            const TableCell& cell = cells_[choice_.take[k]];
            table_.values.push_back(number_of(choice_.take[k]));
            table_.places.push_back(cell.column);
        }
        check_unread();
        table_.lines.push_back(lines_.number());
        end_.add(cells_.back().text);
        last_column_ = cells_.back().column;
        is_separated_by_commas_ = is_separated_by_commas_ || !cells_.front().may_have_decimal_comma;
        if (is_open_ && count_ > table_.width) {
            follow_counter();
        }
    }

    /// Refuses a row of another number of columns, or with a cell that is no number.
    void check_cells(std::size_t found, std::size_t wanted) {
        for (std::size_t k = 0; k < std::min({found, wanted, cells_.size()}); ++k) {
            if (!choice_.is_named || std::find(choice_.take.begin(), choice_.take.end(), k) != choice_.take.end()) {
                number_of(k);
            }
        }
        if (found < wanted && found < cells_.size()) {
            number_of(found);  // which is none
        }
        if (found != wanted) {
            refuse_at(cells_[std::min(wanted, cells_.size() - 1)].column,
                      fmt::format("{} columns instead of {}", found, wanted), headings_.wanted());
        }
    }

    double number_of(std::size_t k) {
        const TableCell& cell = cells_[k];
        const auto number = marks_.number(cell, {table_.file, lines_.number(), cell.column});
        if (!number || !std::isfinite(*number)) {
            refuse_at(cell.column,
                      cell.text.empty()
                          ? fmt::format("column {} is empty", k + 1)
                          : fmt::format("{} in column {} is not a finite number", quote(cell.text), k + 1),
                      headings_.wanted());
        }
        return *number;
    }

    /// Refuses a row with something else than 0 in a column that belongs to what is read and is left out.
    void check_unread() {
        for (const std::size_t k : choice_.unread) {
            if (k < cells_.size() && !cells_[k].text.empty() && number_of(k) != 0) {
                refuse_at(cells_[k].column,
                          fmt::format("{} in the column {}, which is not read", quote(cells_[k].text),
                                      quote(headings_.name_of(k))),
                          form_.unread.remedy);
            }
        }
    }

    /// Numbers at the beginning of the row.
    std::size_t number_count() const {
        DecimalMarks unasked;
        std::size_t count = 0;
        while (count < cells_.size() && unasked.number(cells_[count], {})) {
            ++count;
        }
        return count;
    }

    void follow_counter() {
        const double value = table_.values[table_.values.size() - table_.width];
        is_counted_ = is_counted_ && (table_.lines.size() == 1 || value == last_ + 1);
        last_ = value;
    }

    /// Refuses a file that was cut within its last row, as far as the rows before it tell.
    void check_end() const {
        const bool ends_a_line = text_.ends_with('\n') || text_.ends_with('\r');
        const bool is_alone_short = !ends_a_line && is_short_ && short_rows_ == 1 && table_.row_count() > 1;
        if (is_alone_short || end_.is_cut(text_)) {
            throw CaseError(Diagnostic{
                {table_.file, table_.lines.back(), last_column_},
                is_alone_short
                    ? std::string("the last row is shorter than all others, and the file ends in it")
                    : std::string("the last number has fewer digits than those above it, and the file ends in it"),
                "the whole file; a line end after the last row where that is whole"});
        }
    }

    /// Columns beyond those wanted, without a heading that says which are which.
    void check_counter() {
        if (!is_open_ || count_ <= table_.width || table_.lines.empty()) {
            return;
        }
        const SourcePlace first{table_.file, table_.lines.front(), 1};
        if (is_counted_ && table_.lines.size() > 1) {
            throw CaseError(
                Diagnostic{first,
                           fmt::format("the first of {} columns counts the rows, where {} is read", count_,
                                       form_.columns.front().name),
                           fmt::format("a heading that names the columns, such as id,{}", headings_.names())});
        }
        if (is_separated_by_commas_ && !marks_.has_point()) {
            throw CaseError(Diagnostic{
                first, fmt::format("{} columns between commas: are these decimal commas?", count_),
                fmt::format("{} and decimal points, or a heading that names the columns", headings_.wanted())});
        }
        table_.notes.push_back(
            fmt::format("the first {} of {} columns are read as {}", table_.width, count_, headings_.names()));
    }

    /// Refuses a first row of whole numbers that tells how many rows follow, as some programs write: "25 5 5".
    void check_count() const {
        const std::size_t width = table_.width, following = table_.row_count() - 1;
        if (!may_be_count_ || width < 2 || following < 3) {
            return;
        }
        const auto is_beyond = [&](std::size_t column) {
            double most = table_.at(1, column);
            for (std::size_t row = 2; row < table_.row_count(); ++row) {
                most = std::max(most, table_.at(row, column));
            }
            return table_.at(0, column) > most;
        };
        const double first = table_.at(0, 0), second = table_.at(0, 1), count = static_cast<double>(following);
        const bool is_count = first == count && is_beyond(0);
        if (is_count || (first * second == count && is_beyond(0) && is_beyond(1))) {
            throw CaseError(Diagnostic{
                table_.place(0, 0), fmt::format("{} rows follow: does the first one count them?", following),
                fmt::format("rows of numbers without their count, or a heading such as {} above a row that is one",
                            headings_.names())});
        }
    }

    /// True for "25", but not for "25.0".
    static bool is_whole(const TableCell& cell) {
        const auto number = parse_integer(cell.text);
        return number && *number >= 0;
    }

    std::string_view text_;
    LineReader lines_;
    const TableForm& form_;
    TableHeadings headings_;
    DecimalMarks marks_;
    NumberTable table_;
    std::vector<TableCell> cells_;
    ColumnChoice choice_;
    std::size_t count_{0};  ///< of columns in the first row
    bool is_open_{false}, is_counted_{true}, is_separated_by_commas_{false};
    CutEnd end_;
    std::uint32_t last_column_{1};  ///< of the text, where the last cell begins
    std::size_t short_rows_{0};     ///< without cells at their end, which are not read
    bool is_short_{false};          ///< the last row is one of them
    bool may_be_count_{false};      ///< the first row is of whole numbers, without names above it
    double last_{0};
};

}  // namespace

NumberTable read_number_table(std::string_view text, const std::string& file, const TableForm& form) {
    return TableReader(text, file, form).read();
}

std::string text_of(const NumberTable& table, const TableForm& form) {
    std::string text = fmt::format("{} row{};", table.row_count(), table.row_count() == 1 ? "" : "s");
    for (std::size_t column = 0; column < table.width && table.row_count() > 0; ++column) {
        double low = table.at(0, column), high = low;
        for (std::size_t row = 1; row < table.row_count(); ++row) {
            low = std::min(low, table.at(row, column));
            high = std::max(high, table.at(row, column));
        }
        const ShownUnit unit = column < form.shown.size() ? form.shown[column] : ShownUnit{};
        text += fmt::format("{} {} {:.9g}", column == 0 ? "" : ",", form.columns[column].name, unit.factor * low);
        text += low < high ? fmt::format(" to {:.9g}", unit.factor * high) : "";
        text += unit.name.empty() ? "" : " " + unit.name;
    }
    return text;
}

TableForm table_of_places(std::int64_t most_rows) {
    return {{{"x", {"x", "easting", "east", "e", "rechtswert", "xcoord"}},
             {"y", {"y", "northing", "north", "n", "hochwert", "ycoord"}},
             {"z", {"z",           "height", "elevation", "altitude", "elev",   "alt",       "h",     "hoehe",
                    "h\xC3\xB6he", "level",  "ground",    "bed",      "bottom", "topo",      "dem",   "dtm",
                    "dsm",         "kote",   "kota",      "cota",     "value",  "grid_code", "zcoord"}}},
            false,
            most_rows,
            {},
            true};
}

}  // namespace riprap::geometry
