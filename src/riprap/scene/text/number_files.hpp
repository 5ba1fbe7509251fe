// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "riprap/core/dimension.hpp"
#include "riprap/geometry/text/number_table.hpp"
#include "riprap/scene/text/case_files.hpp"

namespace riprap::scene {

/// A column of a table, with the quantity that it holds.
struct ReadColumn {
    geometry::TableColumn column;
    Dimension dimension;
    bool is_force_in_plane{false};  ///< may be given per metre of width
};

/// Columns x, y, z of lengths.
std::vector<ReadColumn> columns_of_places();

/// The form of a table with these columns, which knows the units of headings.
/// @param scale  metres per unit of lengths in the file
geometry::TableForm form_of(std::vector<ReadColumn> columns, std::int64_t most_rows, double scale = 1);

/// Reads a table of numbers (geometry/text/number_table.hpp) that the case names at `place`. Nothing, with problems,
/// where it is refused. @param notes  gets what was found that the user may not expect
std::optional<geometry::NumberTable> read_numbers(CaseFiles& files, const std::string& path,
                                                  const geometry::TableForm& form, const SourcePlace& place,
                                                  std::vector<Diagnostic>& problems, std::vector<std::string>& notes);

/// Adds the problems of a file that the case names at `place`, which is said behind each.
void add_problems_of(const CaseError& error, const SourcePlace& place, std::vector<Diagnostic>& problems);

}  // namespace riprap::scene
