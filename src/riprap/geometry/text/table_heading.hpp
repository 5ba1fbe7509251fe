// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "riprap/core/error.hpp"
#include "riprap/geometry/text/table_form.hpp"
#include "riprap/geometry/text/table_line.hpp"

namespace riprap::geometry {

/// The cells of a row that are read.
struct ColumnChoice {
    std::vector<std::size_t> take;      ///< cell of each wanted column
    bool is_named{false};               ///< the heading names them
    std::size_t cell_count{0};          ///< of the heading that names them
    std::vector<std::size_t> unread{};  ///< cells that must be 0, as nothing reads them (TableForm::unread)
};

/// A cell of a heading: its name in lower case, and its unit.
struct HeadingCell {
    std::string name, unit;
    bool is_certain{false};  ///< the unit stands in brackets: no other text is meant
    SourcePlace place;
    std::string text;
    std::size_t column{static_cast<std::size_t>(-1)};  ///< wanted column that it names, if any
};

/// Lines before the first row of a table, and what they say of its columns.
class TableHeadings {
 public:
    TableHeadings(std::string file, const TableForm& form) : file_(std::move(file)), form_(form) {}

    void add(std::string_view text, const std::vector<TableCell>& cells, std::uint32_t line);
    /// A line behind '#', which may be a heading.
    void add_comment(std::string_view line, std::uint32_t number, std::uint32_t column);
    /// Chooses the cells to read in rows of `cell_count` cells. @throws CaseError where the headings contradict that
    ColumnChoice choose(std::size_t cell_count);

    std::string names() const;   ///< "t,x,y,z"
    std::string wanted() const;  ///< "rows of 4 numbers: t, x, y, z"
    /// Heading that names a cell of the rows, as it is written.
    std::string name_of(std::size_t cell) const;
    std::vector<std::string> take_notes() { return std::move(notes_); }

 private:
    struct Line {
        std::vector<HeadingCell> cells;
        bool is_comment{false};
        bool has_marks{false};  ///< commas, semicolons or tabs stand between all cells: no prose
        std::string text;
        SourcePlace place;
        bool is_heading{false};  ///< of as many cells as the rows, and no title
    };

    HeadingCell heading_cell(const TableCell& cell, std::uint32_t line) const;
    std::size_t column_named(const std::string& name) const;
    std::size_t column_in_words(const std::string& name) const;
    bool is_unit_line(const Line& line) const;
    bool is_like_a_heading(const Line& line) const;
    ColumnChoice choice_of(const Line& line) const;
    void check_names(const Line& line) const;
    void check_width(const Line& line, std::size_t cell_count) const;
    bool is_unread(const HeadingCell& cell) const;
    void check_unit(std::size_t column, const HeadingCell& cell);
    void check_quantity(const Line& line) const;
    void check_title(const Line& line) const;

    std::string file_;
    const TableForm& form_;
    std::vector<Line> lines_;
    std::vector<bool> has_unit_;  ///< of each column: a heading gives one that is read
    std::vector<std::string> notes_;
};

}  // namespace riprap::geometry
