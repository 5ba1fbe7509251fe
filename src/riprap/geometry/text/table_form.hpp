// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace riprap::geometry {

/// Answers a table that asks its reader for the unit in a heading.
struct UnitAnswer {
    bool is_known{false};
    bool is_of_its_kind{false};  ///< a length where a length is read, ...
    std::string problem;         ///< which numbers are read, where those in this unit are not; else empty
};

/// One column that a reader wants.
struct TableColumn {
    std::string_view name;                  ///< for messages: "x"
    std::vector<std::string_view> aliases;  ///< words of headings that mean it, in lower case
};

/// Says how numbers of a column are told.
struct ShownUnit {
    double factor{1};  ///< SI per unit of the file
    std::string name;  ///< of the unit in SI
};

/// Columns that a reader must not leave out in silence.
struct UnreadPart {
    std::function<bool(std::string_view word)>
        is_named_by{};     ///< a word of their headings, in lower case; may be empty
    std::string remedy{};  ///< what to write instead
};

/// Form of the tables that a reader takes.
struct TableForm {
    std::vector<TableColumn> columns;
    bool may_have_more{false};  ///< columns beyond them need no heading; they are not read
    std::int64_t most_rows{0};
    /// Looks at the unit in the heading of a column; may be empty.
    std::function<UnitAnswer(std::size_t column, std::string_view unit)> unit{};
    bool is_list{false};             ///< rows in any order, such as points: a first row may count those that follow
    std::vector<ShownUnit> shown{};  ///< of each column, for text_of(); may be empty
    /// Names columns that belong to the same thing and are not read, such as turns beside displacements: one is left
    /// out where all its numbers are 0, and the file is refused otherwise.
    UnreadPart unread{};
};

}  // namespace riprap::geometry
