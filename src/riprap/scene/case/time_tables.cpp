// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/case/time_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

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

template <std::size_t N>
bool is_one_of(std::string_view word, const std::array<std::string_view, N>& words) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

template <std::size_t N>
bool begins_with(std::string_view word, const std::array<std::string_view, N>& beginnings) {
    return std::any_of(beginnings.begin(), beginnings.end(),
                       [word](std::string_view beginning) { return word.starts_with(beginning); });
}

/// True for a heading of turns beside displacements: "theta", "rot_z", "roll", quaternions.
bool names_turn(std::string_view word) {
    constexpr std::array<std::string_view, 20> words{"rx",  "ry",  "rz", "urx",  "ury",   "urz",  "ur1",
                                                     "ur2", "ur3", "qw", "qx",   "qy",    "qz",   "q0",
                                                     "q1",  "q2",  "q3", "turn", "alpha", "omega"};
    constexpr std::array<std::string_view, 14> beginnings{"rot",     "theta",  "phi",   "psi", "angle",
                                                          "angular", "roll",   "pitch", "yaw", "tilt",
                                                          "quat",    "winkel", "dreh",  "neig"};
    return is_one_of(word, words) || begins_with(word, beginnings);
}

/// True for a heading of couples beside forces: "M", "Mz", "moment", "torque".
bool names_couple(std::string_view word) {
    constexpr std::array<std::string_view, 10> words{"m", "mx", "my", "mz", "m1", "m2", "m3", "mxx", "myy", "mzz"};
    constexpr std::array<std::string_view, 5> beginnings{"moment", "torque", "torsion", "couple", "drehmoment"};
    return is_one_of(word, words) || begins_with(word, beginnings);
}

/// True for the component that leaves the plane.
bool names_z(std::string_view word) {
    constexpr std::array<std::string_view, 6> words{"z", "dz", "uz", "heave", "fz", "pz"};
    return is_one_of(word, words);
}

geometry::UnreadPart unread_part(bool is_planar, bool is_force) {
    const auto names_it = [is_planar, is_force](std::string_view word) {
        return (is_force ? names_couple(word) : names_turn(word)) || (is_planar && names_z(word));
    };
    return {names_it,
            fmt::format("0 there, or no such column: {}{}",
                        is_force ? "a couple is two forces with points of their own, load = [ { force, at }, ... ]"
                                 : "a table does not turn a body, motion = { rotation = { ... } } does",
                        is_planar ? ", and a planar scene has no z" : "")};
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
    geometry::TableForm form = form_of(std::move(columns), limits::table_rows);
    form.unread = unread_part(is_planar, is_force);
    return form;
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
