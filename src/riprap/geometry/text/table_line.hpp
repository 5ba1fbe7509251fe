// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace riprap::geometry {

/// A cell of a line, without blanks and quotes around it, and where it begins (from 1).
struct TableCell {
    std::string_view text;
    std::uint32_t column{0};
    bool may_have_decimal_comma{false};  ///< commas do not separate the cells of this line
};

/// Lines of a text, which end in LF, CRLF or CR. A byte order mark at the start is passed over.
class LineReader {
 public:
    explicit LineReader(std::string_view text);
    /// The next line without its end; nothing after the last.
    std::optional<std::string_view> next();
    std::uint32_t number() const { return number_; }  ///< of the line that next() returned, from 1

 private:
    std::string_view rest_;
    std::uint32_t number_{0};
};

/// True for a line whose first cell begins with a letter: a heading, and no row of numbers.
bool is_heading(std::string_view line);

/// Splits a line into its cells; a comment from '#' on is left out, and so are separators after the last cell.
void split_table_line(std::string_view line, std::vector<TableCell>& cells);

}  // namespace riprap::geometry
