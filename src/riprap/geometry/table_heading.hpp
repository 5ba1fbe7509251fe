// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "riprap/geometry/number_table.hpp"
#include "riprap/geometry/table_line.hpp"

namespace riprap::geometry {

/// The cells of a row that are read.
struct ColumnChoice {
    std::vector<std::size_t> take;  ///< cell of each wanted column
    bool is_named{false};           ///< the heading names them
};

/// A cell of a heading: its name in lower case, and its unit.
struct HeadingCell {
    std::string name, unit;
    bool is_certain{false};  ///< the unit stands in brackets: no other text is meant
    SourcePlace place;
    std::string text;
};

/// Lines before the first row of a table, and what they say of its columns.
class TableHeadings {
 public:
    TableHeadings(std::string file, const TableForm& form) : file_(std::move(file)), form_(form) {}

    void add(const std::vector<TableCell>& cells, std::uint32_t line);
    /// A line behind '#', which may be a heading.
    void add_comment(std::string_view line, std::uint32_t number, std::uint32_t column);
    /// Chooses the cells to read in rows of `cell_count` cells. @throws CaseError where the headings contradict that
    ColumnChoice choose(std::size_t cell_count);

    std::string names() const;   ///< "t,x,y,z"
    std::string wanted() const;  ///< "rows of 4 numbers: t, x, y, z"
    std::vector<std::string> take_notes() { return std::move(notes_); }

 private:
    struct Line {
        std::vector<HeadingCell> cells;
        bool is_comment{false};
    };

    bool is_unit_line(const Line& line) const;
    std::size_t column_named(const std::string& name) const;
    void check_unit(std::size_t column, const HeadingCell& cell);
    ColumnChoice choose_by(const Line& line);

    std::string file_;
    const TableForm& form_;
    std::vector<Line> lines_;
    std::vector<std::string> notes_;
};

}  // namespace riprap::geometry
