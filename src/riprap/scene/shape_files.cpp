// SPDX-License-Identifier: Apache-2.0
// Shapes that need a hull or a file.
#include <fmt/format.h>

#include "riprap/geometry/convex_hull.hpp"
#include "riprap/scene/limits.hpp"
#include "riprap/scene/shape_library.hpp"

namespace riprap::scene {

using geometry::Polyhedron;

namespace {
double metres_per_unit(const std::string& unit) { return unit == "mm" ? 1e-3 : unit == "cm" ? 1e-2 : 1.0; }
}  // namespace

std::optional<Polyhedron> ShapeLibrary::make_hull(const Value& table) {
    std::vector<Vec3> points;
    if (const Value* file = table.find("file")) {
        const auto rows = files_.read_table(file->text, 3, limits::table_rows, file->place, problems_);
        if (!rows) {
            return std::nullopt;
        }
        const double unit = metres_per_unit(get_text(table, "units"));
        for (const std::vector<double>& row : *rows) {
            points.push_back(unit * Vec3{row[0], row[1], row[2]});
        }
    } else {
        for (const Value& point : get(table, "points").items) {
            points.push_back(to_vector(point));
        }
    }
    return accept(geometry::convex_hull(points), table.place);
}

std::optional<Polyhedron> ShapeLibrary::make_random_hull(const Value& table) {
    return accept(
        geometry::random_hull(static_cast<std::uint64_t>(get_integer(table, "seed")),
                              static_cast<int>(get_integer(table, "corners")), get_number(table, "circumradius")),
        table.place);
}

std::optional<std::vector<Polyhedron>> ShapeLibrary::make_surface(const Value& table, bool /*is_stl*/) {
    problems_.push_back({table.place, "surfaces from files are not implemented in this version", ""});
    return std::nullopt;
}

}  // namespace riprap::scene
