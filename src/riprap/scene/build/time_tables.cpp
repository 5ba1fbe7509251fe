// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/build/time_tables.hpp"

#include <fmt/format.h>

#include "riprap/scene/keys/limits.hpp"

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

}  // namespace

TimeTable read_time_table(CaseBuild& build, const Value& table, const std::string& key) {
    TimeTable read;
    SourcePlace place = table.place;
    if (const Value* file = table.find("file")) {
        place = file->place;
        const auto rows =
            build.files.read_table(file->text, build.is_planar ? 3 : 4, limits::table_rows, place, build.problems);
        if (!rows) {
            return {};
        }
        for (const std::vector<double>& row : *rows) {
            read.time.push_back(row[0]);
            read.value.push_back({row[1], row[2], build.is_planar ? 0.0 : row[3]});
        }
    } else {
        for (const Value& time : get(table, "time").items) {
            read.time.push_back(time.as_number());
        }
        for (const Value& value : get(table, key).items) {
            read.value.push_back(to_vector(value));
        }
    }
    return check_rows(build, read, place, key) ? read : TimeTable{};
}

}  // namespace riprap::scene
