// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/text/number_files.hpp"

#include <fmt/format.h>

#include <cmath>

#include "riprap/scene/text/heading_units.hpp"
#include "riprap/scene/text/limits.hpp"
#include "riprap/scene/text/units.hpp"

namespace riprap::scene {

namespace {

/// Says what a unit over a column means, where numbers are read in `dimension`.
geometry::UnitAnswer answer_to(std::string_view text, const ReadColumn& column, double scale) {
    const std::optional<Unit> unit = parse_heading_unit(text);
    const bool is_length = column.dimension == dimension::length;
    const double factor = is_length ? scale : 1;
    const std::string read =
        factor == 1 ? si_unit(column.dimension) : fmt::format("{:g} {}", factor, si_unit(column.dimension));
    if (!unit) {
        return {false, false, fmt::format("numbers in {}", read)};
    }
    if (!(unit->dimension == column.dimension)) {
        const bool is_per_width = column.is_force_in_plane && unit->dimension == dimension::stiffness;
        // Weights are written in units of mass.
        const bool is_weight = column.dimension == dimension::force && unit->dimension == Dimension{0, 1, 0, 0};
        return is_per_width && to_si(1, *unit) == 1
                   ? geometry::UnitAnswer{true, true, ""}
                   : geometry::UnitAnswer{true, is_weight || is_per_width, fmt::format("numbers in {}", read)};
    }
    const double here = to_si(1, *unit) / factor;
    const bool is_same = std::abs(here - 1) <= 1e-12;
    return {true, true, is_same ? "" : fmt::format("numbers in {}: those in {} times {:.10g}", read, text, here)};
}

}  // namespace

std::vector<ReadColumn> columns_of_places() {
    std::vector<ReadColumn> columns;
    for (const geometry::TableColumn& column : geometry::table_of_places(0).columns) {
        columns.push_back({column, dimension::length});
    }
    return columns;
}

geometry::TableForm form_of(std::vector<ReadColumn> columns, std::int64_t most_rows, double scale) {
    geometry::TableForm form;
    form.most_rows = most_rows;
    form.is_list = columns.front().dimension == dimension::length;
    for (const ReadColumn& column : columns) {
        form.columns.push_back(column.column);
        form.shown.push_back({column.dimension == dimension::length ? scale : 1, si_unit(column.dimension)});
    }
    form.unit = [columns = std::move(columns), scale](std::size_t k, std::string_view text) {
        return answer_to(text, columns[k], scale);
    };
    return form;
}

std::optional<geometry::NumberTable> read_numbers(CaseFiles& files, const std::string& path,
                                                  const geometry::TableForm& form, const SourcePlace& place,
                                                  std::vector<Diagnostic>& problems, std::vector<std::string>& notes) {
    const std::optional<std::string> bytes = files.read(path, limits::table_bytes, place, problems);
    if (!bytes) {
        return std::nullopt;
    }
    try {
        geometry::NumberTable table = geometry::read_number_table(*bytes, path, form);
        for (const std::string& note : table.notes) {
            notes.push_back(fmt::format("{}: {}", path, note));
        }
        notes.push_back(fmt::format("{}: {}", path, geometry::text_of(table, form)));
        return table;
    } catch (const CaseError& error) {
        add_problems_of(error, place, problems);
        return std::nullopt;
    }
}

void add_problems_of(const CaseError& error, const SourcePlace& place, std::vector<Diagnostic>& problems) {
    for (Diagnostic problem : error.problems()) {
        if (place.line > 0) {
            problem.message += fmt::format(" (file of {}:{}:{})", place.file, place.line, place.column);
        }
        problems.push_back(std::move(problem));
    }
}

}  // namespace riprap::scene
