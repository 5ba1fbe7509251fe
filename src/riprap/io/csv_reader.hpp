// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "riprap/io/csv.hpp"

namespace riprap::io {

/// A table as csv.hpp writes it.
struct CsvTable {
    std::vector<CsvColumn> columns;
    std::vector<std::vector<double>> values;  ///< per column, a value per row; NaN where the field is empty
    std::vector<std::string> texts;           ///< fields of the column that was asked for as text, a field per row
    bool is_cut{false};        ///< a line had no end or another number of fields: it and those after it were left out
    std::size_t lost_from{0};  ///< number of that line, the heading being 1; 0 when it is the last, or there is none

    std::size_t row_count() const { return values.empty() ? 0 : values.front().size(); }
};

/// Reads a table with headings `name [unit]`. A last line that is cut is left out: a run may be writing it.
/// `text_column` names the column whose fields are kept as texts, and are NaN among the values.
/// @throws FileError for a file that is not such a table, naming line and column of a field that is no number
CsvTable read_csv(const std::filesystem::path& path, std::string_view text_column = {});

/// Reads a table whose rows follow each other in time, such as probes.csv. @throws FileError also where they do not
CsvTable read_record(const std::filesystem::path& path);

}  // namespace riprap::io
