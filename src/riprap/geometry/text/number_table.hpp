// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "riprap/core/error.hpp"
#include "riprap/geometry/text/table_form.hpp"

namespace riprap::geometry {

/// Rows of finite numbers.
struct NumberTable {
    std::string file;  ///< for messages
    std::size_t width{0};
    std::vector<double> values;         ///< row after row
    std::vector<std::uint32_t> lines;   ///< of each row in the file
    std::vector<std::uint32_t> places;  ///< column of the text where each value begins
    std::vector<std::string> notes;     ///< what was found that the user may not expect

    std::size_t row_count() const { return lines.size(); }
    double at(std::size_t row, std::size_t column) const { return values[row * width + column]; }
    SourcePlace place(std::size_t row, std::size_t column) const {
        return {file, lines[row], places[row * width + column]};
    }
};

/// Reads rows of numbers as spreadsheets, programs and people write them. The one reader of all tables, so that all
/// tell a heading from a row in the same way:
///
/// - a line whose first cell begins with a letter is a heading; it may stand before the numbers only. A table without
///   heading begins with its first row. Lines that are empty or begin with '#' are passed over;
/// - cells are separated by ';' where a line has one, else by ',', else by blanks and tabs; they may stand in quotes. A
///   last separator may follow the last cell. Lines end in LF, CRLF or CR; a byte order mark is passed over;
/// - numbers are those of C: 1, +0.5, 1e-3. A comma inside a cell is a decimal comma, where cells are not separated by
///   commas and no number of the file has a point; "1,234" alone could be either and is refused;
/// - where the heading names every wanted column (see TableColumn::aliases), columns are taken by their names; else all
///   columns are taken in order. A heading that names some of them and another quantity, or one of them in another
///   place, is refused, and so is one of other quantities ("vx", "omega", "step");
/// - units in headings, in brackets, after a mark or a blank, in a line of their own or in the words of a title ("in
///   mm"), are given to TableForm::unit. One in brackets must be known.
///
/// @throws CaseError with file:line:column for anything else: a cell that is no finite number, rows of another number
/// of columns, text between rows, no row at all, a file cut within its last row (CutEnd), a first row that counts the
/// others, UTF-16, too many rows.
NumberTable read_number_table(std::string_view text, const std::string& file, const TableForm& form);

/// "3 rows; t 0 to 2 s, x -0.1 to 0.1 m, y 0 m": what was read, for someone who gave the table.
std::string text_of(const NumberTable& table, const TableForm& form);

/// Columns of places: x, y, z.
TableForm table_of_places(std::int64_t most_rows);

}  // namespace riprap::geometry
