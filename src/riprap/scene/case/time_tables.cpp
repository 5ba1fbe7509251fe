// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/case/time_tables.hpp"

#include <fmt/format.h>

#include "riprap/scene/text/limits.hpp"
#include "riprap/scene/text/number_files.hpp"

namespace riprap::scene {

namespace {

bool check_rows(CaseBuild& build, const TimeTable& rows, const SourcePlace& place, const std::string& key) {
    if (rows.time.empty() || rows.time.size() != rows.value.size()) {
        build.problem(place, fmt::format("{} times and {} {}s", rows.time.size(), rows.value.size(), key),
                      "as many of both, at least one");
        return false;
    }
    for (std::size_t i = 1; i < rows.time.size(); ++i) {
        if (rows.time[i] <= rows.time[i - 1]) {
            build.problem(place,
                          fmt::format("time {} of row {} does not follow {}", rows.time[i], i + 1, rows.time[i - 1]),
                          "increasing times");
            return false;
        }
    }
    return true;
}

/// Columns t, x, y, z of displacements or forces, in a plane without z.
geometry::TableForm form_of_vectors(bool is_planar, bool is_force) {
    const Dimension& kind = is_force ? dimension::force : dimension::length;
    const bool per_width = is_force && is_planar;
    std::vector<ReadColumn> columns{
        {{"t", {"t", "time", "zeit", "temps", "tiempo", "sec", "seconds"}}, dimension::time}};
    if (is_force) {
        columns.push_back({{"Fx", {"fx", "x", "f_x", "px"}}, kind, per_width});
        columns.push_back({{"Fy", {"fy", "y", "f_y", "py"}}, kind, per_width});
        columns.push_back({{"Fz", {"fz", "z", "f_z", "pz"}}, kind, per_width});
    } else {
        columns.push_back({{"x", {"x", "dx", "ux", "surge"}}, kind});
        columns.push_back({{"y", {"y", "dy", "uy", "sway"}}, kind});
        columns.push_back({{"z", {"z", "dz", "uz", "heave"}}, kind});
    }
    if (is_planar) {
        columns.pop_back();
    }
    return form_of(std::move(columns), limits::table_rows);
}

}  // namespace

TimeTable read_time_table(CaseBuild& build, const Value& table, const std::string& key) {
    TimeTable read;
    SourcePlace place = table.place;
    if (const Value* file = table.find("file")) {
        place = file->place;
        const auto rows = read_numbers(build.files, file->text, form_of_vectors(build.is_planar, key == "force"), place,
                                       build.problems, build.notes);
        if (!rows) {
            return {};
        }
        for (std::size_t i = 0; i < rows->row_count(); ++i) {
            if (i > 0 && !(rows->at(i, 0) > rows->at(i - 1, 0))) {
                const Diagnostic problem{rows->place(i, 0),
                                         fmt::format("time {} does not follow {}", rows->at(i, 0), rows->at(i - 1, 0)),
                                         "increasing times"};
                add_problems_of(CaseError(problem), place, build.problems);
                return {};
            }
            read.time.push_back(rows->at(i, 0));
            read.value.push_back({rows->at(i, 1), rows->at(i, 2), build.is_planar ? 0.0 : rows->at(i, 3)});
        }
    } else {
        for (const Value& time : get(table, "time").items) {
            read.time.push_back(time.as_number());
        }
        for (const Value& value : get(table, key).items) {
            read.value.push_back(value.is_array() ? to_vector(value) : Vec3{value.as_number(), 0, 0});
        }
    }
    return check_rows(build, read, place, key) ? read : TimeTable{};
}

}  // namespace riprap::scene
